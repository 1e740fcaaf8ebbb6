// Soft packs in a World: they stand, bend, come back, and repeat bit for bit.
#include <fmt/format.h>

#include "base/parallel.h"
#include "physics/goods/slot.h"
#include "physics/goods/spec_geoms.h"
#include "physics/soft/soft_body.h"
#include "unit/physics/small_worlds.h"
#include "unit/physics/soft_packs.h"

namespace marketgen {
namespace {

constexpr char almonds[] = "snacks-almonds-natural-500g";     // a pouch that stands, 150 x 65 x 215
constexpr char salmon[] = "dairy-smoked-salmon-sliced-200g";  // its seam is at its left

// On the floor, so that they are in no facing and on no peg.
scene::Scene floor_of(std::span<const catalog::Product* const> products, float pitch_m) {
  HandMadeScene shop;
  scene::Scene& scene = shop.scene;
  const int columns = static_cast<int>(4.4F / pitch_m);
  int i = 0;
  for (const catalog::Product* product : products) {
    const auto sku = static_cast<std::uint32_t>(scene.catalog.size());
    scene.catalog.push_back(*product);
    const float x = 1.2F + pitch_m * static_cast<float>(i % columns);
    const float y = 0.3F + pitch_m * static_cast<float>(i / columns);
    shop.add(sku, {x, y, 0});
    ++i;
  }
  return scene;
}

scene::Scene floor_with(const std::string& sku) {
  const std::array<const catalog::Product*, 1> one{soft_row(sku).product};
  return floor_of(one, 0.5F);
}

int slot_body(const physics::World& world, const std::string& name) {
  return mj_name2id(&world.model(), mjOBJ_BODY, name.c_str());
}
double angle_of(const physics::World& world, const std::string& body) {
  const mjModel& m = world.model();
  return world.data().qpos[m.jnt_qposadr[m.body_jntadr[slot_body(world, body)]]];
}

std::string drifted(const scene::Scene& scene) {
  physics::World world = made(scene, {.soft_pool = 100});
  std::string wrong;
  for (std::uint32_t product = 0; product < scene.products.size(); ++product) {
    if (!world.wake(product).ok()) wrong += " not-woken";
  }
  if (world.counts().soft_in_pool != static_cast<int>(scene.products.size())) wrong += " not-soft";
  if (!world.step(10 * second).ok()) return "failed";
  for (std::uint32_t product = 0; product < scene.products.size(); ++product) {
    const double drift =
        distance(world.product_pose(product), scene::world_from_product(scene.products[product]));
    if (drift < 0.001 && !world.awake(product)) continue;
    wrong += fmt::format(" {}: {:.2f} mm{}",
                         scene.catalog[scene.products[product].sku].sku,
                         1e3 * drift,
                         world.awake(product) ? ", awake" : "");
  }
  return wrong;
}

TEST(SoftWorld, EverySoftPackStandsStillWhereItsRowSays) {
  std::vector<scene::Scene> scenes;
  const std::vector<SoftRow>& rows = soft_rows();
  constexpr std::size_t batch = 60;
  for (std::size_t first = 0; first < rows.size(); first += batch) {
    std::vector<const catalog::Product*> products;
    for (std::size_t i = first; i < std::min(first + batch, rows.size()); ++i)
      products.push_back(rows[i].product);
    scenes.push_back(floor_of(products, 0.44F));
  }
  for (const std::string& wrong :
       parallel_map(scenes.size(), [&](std::size_t i) { return drifted(scenes[i]); }))
    EXPECT_EQ(wrong, "");
}

TEST(SoftWorld, FlapBendsUnderAFingerAndComesBack) {
  const scene::Scene scene = floor_with(almonds);
  physics::World world = made(scene, with_finger());
  const Pose pouch = world.product_pose(0);
  const auto finger_at = [&](double y) {
    const Pose at{pouch.position + Vec3{0, y, 0.207}, {}};
    ASSERT_TRUE(world.move_mocap("finger", at).ok());
  };
  for (int i = 0; i <= 100; ++i) {
    finger_at(-0.05 + 0.0005 * i);
    run(world, 10);
  }
  EXPECT_TRUE(world.awake(0));
  EXPECT_GT(std::abs(angle_of(world, "soft-0-flap")), 0.3);
  EXPECT_LT(distance(world.product_pose(0), pouch), 0.001);  // it bends, and does not push
  finger_at(-0.5);
  run(world, 2 * second);
  EXPECT_LT(std::abs(angle_of(world, "soft-0-flap")), 0.005);
  EXPECT_FALSE(world.awake(0));
  EXPECT_LT(distance(world.product_pose(0), pouch), 0.001);
  const std::vector<physics::WorldEvent> events = world.take_events();
  EXPECT_LE(count(events, physics::EventKind::woke),
            3);  // a finger beside it does not wake it again and again
}

// From its flap, until a pull of five times its weight takes it off.
TEST(SoftWorld, APouchHangsByItsSealUntilItIsPulled) {
  HandMadeScene shop;
  shop.scene.shelves[1].use = assets::ShelfUse::hang;
  shop.scene.catalog.push_back(*soft_row(almonds).product);
  shop.add(3, {3, on_shelf_y, 0.8F});
  physics::World world = made(shop.scene);
  const Pose first = world.product_pose(0);
  ASSERT_TRUE(world.wake(0).ok());
  run(world, 10 * second);
  EXPECT_FALSE(world.awake(0));
  EXPECT_LT(distance(world.product_pose(0), first), 0.001);

  physics::World pulled = made(shop.scene);
  ASSERT_TRUE(pulled.push(0, {{0, 0.5, 0}, {}}).ok());
  run(pulled, second);
  EXPECT_EQ(pulled.counts().soft_in_pool, 1);
  EXPECT_GT(pulled.product_pose(0).position.z, 0.78);  // swings, and hangs
  EXPECT_GT(std::abs(angle_of(pulled, "soft-0-flap") + angle_of(pulled, "soft-0-top")), 1e-3);
  ASSERT_TRUE(pulled.push(0, {{0, -20, -15}, {}}).ok());
  run(pulled, second);
  EXPECT_LT(pulled.product_pose(0).position.z, 0.6);
}

// Two smooth supports under its ends.
physics::WorldOptions with_supports(double apart_m) {
  physics::WorldOptions options;
  options.add_actors = [apart_m](mjSpec_& spec) -> Result<void> {
    for (const double side : {-0.5, 0.5}) {
      mjsGeom* support = mjs_addGeom(mjs_findBody(&spec, "world"), nullptr);
      support->type = mjGEOM_BOX;
      support->pos[0] = 3, support->pos[1] = 2 + side * apart_m, support->pos[2] = 0.1;
      support->friction[0] = 0.05;
      support->size[0] = 0.2, support->size[1] = 0.01, support->size[2] = 0.1;
    }
    return {};
  };
  return options;
}

// The foot's support bears 3.35 N 75 mm from the hinge, 0.251 N m; the half over it weighs 3.54 N
// at 49 mm, 0.173 N m; the spring has 0.69 N m a radian. Without friction at the supports (0.016 N
// m) that is 0.113 radians. It then rests bent, in its slot, and gives it back when it stands
// again.
TEST(SoftWorld, SagsOverAGapAndKeepsItsSlotThere) {
  const scene::Scene scene = floor_with(almonds);
  physics::World world = made(scene, with_supports(0.19));
  const Quaternion on_its_back = rotation_from_half_tangent({1, 0, 0}, -1.0);
  const Vec3 lying{3, 2 - 0.215 / 2, 0.2 + 0.065 / 2 + 0.001};
  ASSERT_TRUE(world.place(0, {lying, on_its_back}).ok());
  run(world, 10 * second);
  const double sag = std::abs(angle_of(world, "soft-0-top"));
  EXPECT_NEAR(sag, 0.113, 0.03);
  EXPECT_GT(world.product_pose(0).position.z, 0.2);
  physics::WorldCounts counts = world.counts();
  EXPECT_EQ(counts.soft_in_pool, 1);
  EXPECT_EQ(counts.awake, 0);
  EXPECT_EQ(count(world.take_events(), physics::EventKind::fell_asleep), 1);

  ASSERT_TRUE(world.place(0, scene::world_from_product(scene.products[0])).ok());
  run(world, second);
  counts = world.counts();
  EXPECT_EQ(counts.soft_in_pool, 0);
  EXPECT_FALSE(world.awake(0));
}

TEST(SoftWorld, SnapshotInTheMiddleOfMotionAndReplayAreExact) {
  const std::array<const catalog::Product*, 3> three{
      soft_row(almonds).product, soft_row(salmon).product, soft_row(almonds).product};
  const scene::Scene scene = floor_of(three, 0.3F);
  physics::World world = made(scene);
  for (std::uint32_t product = 0; product < 3; ++product)
    ASSERT_TRUE(world.push(product, {{4.0 - product, 3, 2.0 * product}, {0, 0.1, 0.2}}).ok());
  run(world, 60);
  EXPECT_EQ(world.counts().soft_in_pool, 3);
  EXPECT_NE(angle_of(world, "soft-0-top"), 0);
  EXPECT_NE(angle_of(world, "soft-1-flap"), 0);
  const physics::WorldSnapshot moving = world.snapshot();
  run(world, 5 * second);
  const std::string end = world.state_hash();
  EXPECT_EQ(world.counts().soft_in_pool, 0);  // all have come to rest

  physics::World other = made(scene);
  ASSERT_TRUE(other.wake(2).ok());  // the first soft body is another pack there
  run(other, 3);
  ASSERT_TRUE(other.restore(moving).ok());
  run(other, 5 * second);
  EXPECT_EQ(other.state_hash(), end);
  physics::World told = made(scene);
  ASSERT_TRUE(physics::replay(told, world.commands()).ok());
  EXPECT_EQ(told.state_hash(), end);
}

// On a floor, thrown, for a second.
std::vector<double> thrown(mjModel& m) {
  const physics::MujocoData d = physics::make_data(m, "test").value();
  d->qpos[2] = 0.3;
  d->qvel[0] = 0.5, d->qvel[3] = 2, d->qvel[5] = -3;
  std::vector<double> path;
  for (int i = 0; i < second; ++i) {
    mj_step(&m, d.get());
    path.insert(path.end(), d->qpos, d->qpos + m.nq);
  }
  return path;
}

physics::MujocoModel on_floor(const physics::SoftPack& pack, const physics::GoodsContact& contact) {
  const physics::MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
  spec->compiler.degree = false;
  physics::set_contact_options(*spec, 1e-3);
  mjsBody* world = mjs_findBody(spec.get(), "world");
  physics::add_floor(world);
  for (mjsGeom* geom : physics::add_soft_body(world, pack, "pack").geoms)
    physics::set_goods_contact(geom, contact);
  return physics::compile(*spec, "test").value();
}

TEST(SoftBody, ASlotMovesBitForBitAsIfCompiled) {
  const physics::GoodsContact one{4, 0.3, 0.005, 1e-4}, other{4, 0.5, 0.005, 1e-4};
  for (const char* sku : {salmon, "produce-apples-basiko-2-kg"}) {
    const physics::MujocoModel straight = on_floor(soft_row(sku).pack, one);
    const physics::MujocoModel slot = on_floor(soft_row(almonds).pack, other);
    EXPECT_NE(thrown(*straight), thrown(*slot));
    physics::copy_tree(*slot, 1, *physics::soft_model(soft_row(sku).pack, one, "test").value());
    EXPECT_EQ(thrown(*straight), thrown(*slot)) << sku;
  }
}

TEST(SoftWorld, AFullSoftPoolFallsBackOnRigidBoxesAndCountsThem) {
  const std::array<const catalog::Product*, 3> three{
      soft_row(almonds).product, soft_row(almonds).product, soft_row(salmon).product};
  const scene::Scene scene = floor_of(three, 0.3F);
  physics::World world = made(scene, {.pool = 1, .soft_pool = 1});
  ASSERT_TRUE(world.wake(0).ok());
  ASSERT_TRUE(world.wake(1).ok());
  EXPECT_EQ(world.counts().soft_in_pool, 1);
  EXPECT_EQ(world.counts().stiffened, 1);
  EXPECT_EQ(world.wake(2).error().code, "physics.bad_command");
  run(world, second);
  EXPECT_EQ(world.counts().in_pool, 0);
  EXPECT_TRUE(world.wake(2).ok());
  EXPECT_EQ(world.counts().soft_in_pool, 1);

  physics::World rigid = made(scene, {.soft_pool = 0});
  ASSERT_TRUE(rigid.wake(0).ok());
  EXPECT_EQ(rigid.counts().in_pool, 1);
  EXPECT_EQ(rigid.counts().soft_in_pool, 0);
  EXPECT_EQ(rigid.counts().stiffened, 0);
}

TEST(SoftWorld, ABadRowOrOptionIsAnError) {
  scene::Scene scene = floor_with(almonds);
  EXPECT_EQ(physics::World::create(scene, {.soft_pool = -1}).error().where,
            "WorldOptions.soft_pool");
  EXPECT_EQ(physics::World::create(scene, {.soft_pool = 300}).error().code, "physics.bad_command");
  scene.catalog.back().label.primary = "no colour";  // of which only its mesh takes notice
  physics::World world = made(scene);
  const std::string before = world.state_hash();
  const Result<void> woken = world.wake(0);
  ASSERT_FALSE(woken.ok());
  EXPECT_NE(woken.error().where.find(almonds), std::string::npos) << to_string(woken.error());
  EXPECT_EQ(world.state_hash(), before);
  scene.catalog.back().mass_kg = 0;
  EXPECT_EQ(physics::World::create(scene, {}).error().code, "catalog.bad_row");
}

// ---- A hand with two pads, which closes along Y, lifts and shakes ----

constexpr double pad_half_m = 0.008, pad_force_n = 25, open_m = 0.03;
constexpr std::size_t one_in = 20;
constexpr double weak_force_n = 1;  // of rubber on film: bears 80 g

mjsJoint* add_slide(mjsBody* body, const char* name, std::array<double, 3> axis) {
  mjsJoint* joint = mjs_addJoint(body, nullptr);
  mjs_setName(joint->element, name);
  joint->type = mjJNT_SLIDE;
  std::ranges::copy(axis, joint->axis);
  return joint;
}

mjsActuator* add_motor(mjSpec_& spec, const char* joint) {
  mjsActuator* motor = mjs_addActuator(&spec, nullptr);
  mjs_setName(motor->element, joint);
  mjs_setString(motor->target, joint);
  motor->trntype = mjTRN_JOINT;
  motor->gaintype = mjGAIN_FIXED;
  motor->gainprm[0] = 1;
  return motor;
}

void add_servo(mjSpec_& spec, const char* joint, double kp, double kv) {
  mjsActuator* servo = add_motor(spec, joint);
  servo->gainprm[0] = kp;
  servo->biastype = mjBIAS_AFFINE;
  servo->biasprm[1] = -kp, servo->biasprm[2] = -kv;
}

// Open round `at`, the middle of what it is to pinch.
Result<void> add_hand(mjSpec_& spec, Vec3 at) {
  mjsBody* hand = mjs_addBody(mjs_findBody(&spec, "world"), nullptr);
  mjs_setName(hand->element, "hand");
  hand->pos[0] = at.x, hand->pos[1] = at.y, hand->pos[2] = at.z;
  hand->mass = 1, hand->explicitinertial = 1, hand->gravcomp = 1;
  hand->inertia[0] = hand->inertia[1] = hand->inertia[2] = 1e-3;
  add_slide(hand, "hand-x", {1, 0, 0});
  add_slide(hand, "hand-y", {0, 1, 0});
  add_slide(hand, "hand-z", {0, 0, 1});
  for (const char* axis : {"hand-x", "hand-y", "hand-z"})
    add_servo(spec, axis, 2e4, 400);
  for (const double side : {-1.0, 1.0}) {
    const char* name = side < 0 ? "pad-left" : "pad-right";
    mjsBody* finger = mjs_addBody(hand, nullptr);
    mjs_setName(finger->element, name);
    finger->pos[1] = side * open_m;
    finger->gravcomp = 1;
    add_slide(finger, name, {0, -side, 0})->damping[0] = pad_force_n / 0.06;  // 60 mm/s at most
    add_motor(spec, name);
    mjsGeom* pad = physics::add_shape(
        finger, {assets::CollisionShape::box, {}, {pad_half_m, 0.004, pad_half_m}});
    mjs_setName(pad->element, name);
    pad->mass = 0.1;
    pad->condim = 4;
  }
  return {};
}

struct Hold {
  double slip_m = 0, lifted_m = 0;
};

// Pinches the first soft pack, lifts it by 10 cm and shakes it by 8 mm at 2 m/s^2 along each axis.
Hold held(physics::World& world, double force_n) {
  const auto pose = [&](const char* name) {
    const int body = slot_body(world, name);
    const mjtNum *p = world.data().xpos + 3 * body, *q = world.data().xquat + 4 * body;
    return Pose{{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
  };
  const auto between_pads = [&] {
    return (pose("pad-left").position + pose("pad-right").position) * 0.5;
  };
  const auto drive = [&](const char* name, double value) {
    EXPECT_TRUE(world.set_control(world.actuator(name).value(), value).ok());
  };
  drive("pad-left", force_n), drive("pad-right", force_n);
  run(world, second);
  const Vec3 grasped = inverse(pose("soft-0-flap")) * between_pads();  // on the flap
  Hold hold;
  const auto go = [&](Vec3 to) {
    drive("hand-x", to.x), drive("hand-y", to.y), drive("hand-z", to.z);
    run(world, 1);
    hold.slip_m = std::max(hold.slip_m, length(pose("soft-0-flap") * grasped - between_pads()));
  };
  const double before = world.product_pose(0).position.z;
  for (int i = 0; i <= second; ++i)
    go({0, 0, 0.1 * i / second});
  for (int i = 0; i < second; ++i)
    go({0, 0, 0.1});
  hold.lifted_m = world.product_pose(0).position.z - before;
  constexpr double rate = 15.8;  // a second: 8 mm at 2 m/s^2
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    for (int i = 0; i < second; ++i)
      go(Vec3{0, 0, 0.1} + axis * (0.008 * std::sin(rate * i / second)));
  }
  return hold;
}

Hold pinched(const catalog::Product& product, double force_n) {
  const scene::Scene scene = floor_with(product.sku);
  const Vec3 seam = scene::world_from_product(scene.products[0]).position +
                    Vec3{0, 0, product.height_m() - pad_half_m - 0.001};
  physics::WorldOptions options;
  options.frictions = committed_catalog().frictions;
  options.actor_materials = {{"pad-left", "rubber"}, {"pad-right", "rubber"}};
  options.add_actors = [&](mjSpec_& spec) { return add_hand(spec, seam); };
  physics::World world = made(scene, options);
  return held(world, force_n);
}

// One in twenty of those with the seam on top and of up to 1.1 kg.
TEST(SoftWorld, APinchedSeamHoldsWhileItIsLiftedAndShaken) {
  std::vector<const catalog::Product*> upright, some;
  for (const SoftRow& row : soft_rows()) {
    if (row.pack.parts[2].center.z > 0.01 && row.product->mass_kg < 1.1)
      upright.push_back(row.product);
  }
  ASSERT_GT(upright.size(), 250U);
  for (std::size_t i = 0; i < upright.size(); i += one_in)
    some.push_back(upright[i]);
  const auto holds =
      parallel_map(some.size(), [&](std::size_t i) { return pinched(*some[i], pad_force_n); });
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_LT(holds[i].slip_m, 0.001) << some[i]->sku;
    EXPECT_NEAR(holds[i].lifted_m, 0.1, 0.001) << some[i]->sku;
  }
}

TEST(SoftWorld, AWeakPinchLetsGo) {
  const Hold hold = pinched(*soft_row(almonds).product, weak_force_n);
  EXPECT_LT(hold.lifted_m, 0.05);
  EXPECT_GT(hold.slip_m, 0.02);
}

}  // namespace
}  // namespace marketgen
