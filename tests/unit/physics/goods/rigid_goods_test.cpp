// Products as rigid bodies of their pieces: where their middle is, when they tip, that a neck can
// be held.
#include "physics/goods/rigid_goods.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "physics/goods/hull_meshes.h"
#include "scene/placements.h"
#include "scene/shelf_fill.h"
#include "support/committed_catalog.h"
#include "support/number_of_cases.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

constexpr char wine[] = "beverages-red-wine-tempranillo-0-75l";  // 75 mm, 300 mm high, 1.24 kg

// One product on the floor, in no facing.
scene::Scene floor_with_one(const std::string& sku) {
  HandMadeScene shop;
  shop.scene.catalog.push_back(*committed_catalog().product(sku));
  shop.add(static_cast<std::uint32_t>(shop.scene.catalog.size() - 1), {2, 1, 0});
  shop.scene.products[0].facing = scene::no_facing;
  return shop.scene;
}

std::string middle_that_is_wrong(const catalog::Product& product) {
  const auto goods = physics::rigid_goods(product, physics::GoodsUse::stocked);
  const auto body = assets::make_product_body(product);
  if (!goods.ok() || !body.ok()) return product.sku + ": no body";
  const mjModel& m = *(*goods)->model;
  const mjtNum *at = m.body_ipos + 3, *inertia = m.body_inertia + 3;
  const Vec3 middle = (*goods)->product_from_body * Vec3{at[0], at[1], at[2]};
  Vec3 expected = to_double(body->center_of_mass);
  const auto& of = body->inertia_kg_m2;
  double trace = of[0] + of[1] + of[2];
  const double has = inertia[0] + inertia[1] + inertia[2];
  if (scene::lies_as_balls(product)) {  // an ellipsoid of even density
    const assets::CollisionPrimitive ball = assets::collision_of(product).value();
    const Vec3 half = to_double(ball.half_size);
    expected = to_double(ball.center), trace = 0.4 * product.mass_kg * dot(half, half);
  }
  const double apart = length(middle - expected);
  if (apart < 1e-3 && std::abs(m.body_mass[1] - product.mass_kg) < 1e-9 &&
      std::abs(has - trace) < 1e-3 * trace)
    return "";
  return fmt::format("{}: {:.2f} mm, inertia {} for {}", product.sku, 1e3 * apart, has, trace);
}

// All rows take two minutes: MARKETGEN_GOODS_ROWS=3000.
TEST(RigidGoods, EveryRowHasTheMassMiddleAndInertiaOfItsBody) {
  const std::vector<catalog::Product>& rows = committed_catalog().products;
  const std::size_t wanted = std::min(rows.size(), number_of_cases("MARKETGEN_GOODS_ROWS", 200));
  for (const std::string& wrong : parallel_map(wanted, [&](std::size_t i) {
         return middle_that_is_wrong(rows[i * rows.size() / wanted]);
       }))
    EXPECT_EQ(wrong, "");
}

// The bottle stands on its edge, leaning so far, and is let go. Its lean after two seconds.
double lean_after(double lean_rad) {
  const scene::Scene scene = floor_with_one(wine);
  physics::World world = made(scene);
  const double radius = scene.catalog.back().width_m() / 2;
  const Pose edge{{2, 1 - radius, 0}, rotation_about({1, 0, 0}, lean_rad)};
  EXPECT_TRUE(world.place(0, edge * Pose{{0, radius, 0}, {}}).ok());
  run(world, 2 * second);
  return std::acos(std::clamp(rotate(world.product_pose(0).rotation, {0, 0, 1}).z, -1.0, 1.0));
}

// By its mass: its middle, 102 mm high, over the edge of its foot.
TEST(RigidGoods, AWineBottleTipsWhereItsMassSays) {
  const catalog::Product& bottle = *committed_catalog().product(wine);
  const double height = assets::make_product_body(bottle).value().center_of_mass.z;
  const double tips = std::atan(bottle.width_m() / 2 / height);
  EXPECT_NEAR(tips, 20.2 * std::numbers::pi / 180, 0.3 * std::numbers::pi / 180);
  const double degree = std::numbers::pi / 180;
  EXPECT_LT(lean_after(tips - degree), 2 * degree);
  EXPECT_GT(lean_after(tips + degree), 60 * degree);
}

mjsBody* add_slide(mjSpec& spec, mjsBody* parent, const char* name, Vec3 axis, double gain) {
  mjsBody* body = mjs_addBody(parent, nullptr);
  mjs_setName(body->element, name);
  body->mass = 0.5, body->explicitinertial = true, body->gravcomp = 1;
  body->inertia[0] = body->inertia[1] = body->inertia[2] = 1e-3;
  mjsJoint* joint = mjs_addJoint(body, nullptr);
  mjs_setName(joint->element, name);
  joint->type = mjJNT_SLIDE;
  joint->axis[0] = axis.x, joint->axis[1] = axis.y, joint->axis[2] = axis.z;
  joint->damping[0] = 200;
  mjsActuator* motor = mjs_addActuator(&spec, nullptr);
  mjs_setName(motor->element, name);
  mjs_setString(motor->target, name);
  motor->trntype = mjTRN_JOINT;
  motor->gainprm[0] = gain;
  return body;
}

// Two pads of 2 cm, 90 mm apart and 270 mm over the floor, under a lift.
physics::WorldOptions with_pads() {
  physics::WorldOptions options;
  options.add_actors = [](mjSpec_& spec) -> Result<void> {
    mjsBody* lift = add_slide(spec, mjs_findBody(&spec, "world"), "lift", {0, 0, 1}, 1);
    lift->pos[0] = 2, lift->pos[1] = 1, lift->pos[2] = 0.27;
    for (const double side : {-1.0, 1.0}) {
      mjsBody* finger = add_slide(spec, lift, side < 0 ? "left" : "right", {0, -side, 0}, 1);
      finger->pos[1] = side * 0.055;
      mjsGeom* pad = mjs_addGeom(finger, nullptr);
      pad->type = mjGEOM_BOX;
      pad->size[0] = pad->size[1] = pad->size[2] = 0.01;
      pad->friction[0] = 1;
    }
    return {};
  };
  return options;
}

TEST(RigidGoods, ABottleIsHeldByItsNeck) {
  const scene::Scene scene = floor_with_one(wine);
  physics::World world = made(scene, with_pads());
  for (const char* finger : {"left", "right"})
    ASSERT_TRUE(world.set_control(world.actuator(finger).value(), 40).ok());
  run(world, second);
  const mjModel& m = world.model();
  const auto at = [&](const char* body) {
    return world.data().xpos + 3 * mj_name2id(&m, mjOBJ_BODY, body);
  };
  EXPECT_LT(at("right")[1] - at("left")[1] - 0.02, 0.040);  // the neck; the bottle has 75 mm
  EXPECT_GT(at("right")[1] - at("left")[1] - 0.02, 0.020);
  ASSERT_TRUE(
      world.set_control(world.actuator("lift").value(), 60).ok());  // 0.2 m/s with 12 N on it
  run(world, second);
  ASSERT_TRUE(world.set_control(world.actuator("lift").value(), 12.16).ok());
  run(world, second);
  EXPECT_GT(world.product_pose(0).position.z, 0.1);
  EXPECT_NEAR(world.product_pose(0).position.z, at("lift")[2] - 0.27, 0.005);
}

// What the program says of its model goes on: names, and its size in memory.
TEST(HullMeshes, AModelIsSavedAndReadWithThem) {
  const scene::Scene scene = floor_with_one(wine);
  physics::World world = made(scene, with_pads());
  const mjtSize bytes = mj_sizeModel(&world.model());
  ASSERT_TRUE(world.wake(0).ok());
  const mjModel& m = world.model();
  ASSERT_GT(m.nmesh, 0);
  EXPECT_GT(mj_sizeModel(&m), bytes);
  std::vector<char> saved(static_cast<std::size_t>(mj_sizeModel(&m)));
  ASSERT_TRUE(physics::guarded("test", [&] {
                mj_saveModel(&m, nullptr, saved.data(), static_cast<int>(saved.size()));
              }).ok());
  const physics::MujocoModel read(mj_loadModelBuffer(saved.data(), static_cast<int>(saved.size())),
                                  mj_deleteModel);
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(read->nbuffer, m.nbuffer);
  EXPECT_EQ(mj_name2id(read.get(), mjOBJ_ACTUATOR, "lift"), world.actuator("lift").value());
  EXPECT_EQ(read->mesh_vert[3 * read->nmeshvert - 1], m.mesh_vert[3 * m.nmeshvert - 1]);
}

}  // namespace
}  // namespace marketgen
