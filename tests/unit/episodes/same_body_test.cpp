// The same body by every door: what MuJoCo has of a product once the models are compiled, at the
// checkout, in a World, in the grasp study, in settling and in the exported MJCF file.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/parallel.h"
#include "episodes/checkout/checkout_world.h"
#include "export/mjcf.h"
#include "grasping/grasp_scene.h"
#include "physics/settle/settle_model.h"
#include "physics/world/world.h"
#include "scene/placements.h"
#include "scene/shelf_fill.h"
#include "support/drawn_checkout.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

// Files hold single precision.
constexpr double tolerance = 1e-6;

// All in the product frame.
struct MadeGeom {
  int type = 0, dimensions = 0;
  std::vector<double>
      numbers;  // size, of a hull its corners; place; sliding and torsional friction
  double rolling_m = 0;
};
struct MadeBody {
  double mass_kg = 0;
  Vec3 middle;
  std::vector<double> inertia;  // nine, about the middle
  std::vector<MadeGeom> geoms;
};

Pose pose_at(const mjtNum* p, const mjtNum* q) {
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

void append(std::vector<double>& to, Vec3 v) {
  to.insert(to.end(), {v.x, v.y, v.z});
}

MadeGeom geom_of(const mjModel& m, int geom, const Pose& product_from_body) {
  MadeGeom made{m.geom_type[geom], m.geom_condim[geom], {}, 0};
  const Pose pose = product_from_body * pose_at(m.geom_pos + 3 * geom, m.geom_quat + 4 * geom);
  if (made.type == mjGEOM_MESH) {
    const int mesh = m.geom_dataid[geom];
    for (int v = m.mesh_vertadr[mesh]; v < m.mesh_vertadr[mesh] + m.mesh_vertnum[mesh]; ++v) {
      const float* at = m.mesh_vert + 3 * v;
      append(made.numbers, pose * Vec3{at[0], at[1], at[2]});
    }
  } else {
    append(made.numbers, pose.position);
    append(made.numbers, rotate(pose.rotation, {0, 0, 1}));
    const mjtNum* size = m.geom_size + 3 * geom;
    append(made.numbers, {size[0], size[1], made.type == mjGEOM_CYLINDER ? 0 : size[2]});
  }
  const mjtNum* friction = m.geom_friction + 3 * geom;
  made.numbers.insert(made.numbers.end(), {friction[0], friction[1]});
  made.rolling_m = friction[2];
  return made;
}

MadeBody body_of(const mjModel& m, int body, const Pose& product_from_body) {
  MadeBody made;
  made.mass_kg = m.body_mass[body];
  const Pose frame = product_from_body * pose_at(m.body_ipos + 3 * body, m.body_iquat + 4 * body);
  made.middle = frame.position;
  const std::array<Vec3, 3> axes{rotate(frame.rotation, {1, 0, 0}),
                                 rotate(frame.rotation, {0, 1, 0}),
                                 rotate(frame.rotation, {0, 0, 1})};
  Vec3 rows[3];
  for (int i = 0; i < 3; ++i) {
    const Vec3& a = axes[static_cast<std::size_t>(i)];
    const double moment = m.body_inertia[3 * body + i];
    rows[0] += a * (moment * a.x), rows[1] += a * (moment * a.y), rows[2] += a * (moment * a.z);
  }
  for (const Vec3& row : rows)
    append(made.inertia, row);
  for (int i = 0; i < m.body_geomnum[body]; ++i)
    made.geoms.push_back(geom_of(m, m.body_geomadr[body] + i, product_from_body));
  return made;
}

double far_apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

bool same_geoms(const MadeBody& a, const MadeBody& b) {
  return std::ranges::equal(a.geoms, b.geoms, [](const MadeGeom& x, const MadeGeom& y) {
    return x.type == y.type && far_apart(x.numbers, y.numbers) < tolerance;
  });
}

bool same_rolling(const MadeBody& a, const MadeBody& b) {
  return std::ranges::equal(a.geoms, b.geoms, [](const MadeGeom& x, const MadeGeom& y) {
    return x.dimensions == y.dimensions && std::abs(x.rolling_m - y.rolling_m) < tolerance;
  });
}

bool same_inertia(const MadeBody& a, const MadeBody& b) {
  const double largest = *std::ranges::max_element(a.inertia);
  return std::abs(a.mass_kg - b.mass_kg) < 1e-12 && length(a.middle - b.middle) < tolerance &&
         far_apart(a.inertia, b.inertia) < 1e-5 * largest;
}

// ---- The doors ----

scene::Scene scene_with(const catalog::Product& product) {
  HandMadeScene shop;
  shop.scene.catalog.push_back(product);
  shop.add(static_cast<std::uint32_t>(shop.scene.catalog.size() - 1), {2, 1, 0});
  shop.scene.products[0].facing = scene::no_facing;
  return shop.scene;
}

// The body that stands in for the first product that moves.
MadeBody first_in_pool(const mjModel& m, const mjData& d, const Pose& world_from_product) {
  const int body = mj_name2id(&m, mjOBJ_BODY, "pool-0");
  const mjtNum* q = d.qpos + m.jnt_qposadr[m.body_jntadr[body]];
  return body_of(m, body, inverse(world_from_product) * pose_at(q, q + 3));
}

// Rigid, also where it would bend.
Result<MadeBody> in_world(const scene::Scene& scene) {
  physics::WorldOptions options;
  options.pool = 1, options.soft_pool = 0;
  MARKETGEN_TRY(physics::World world, physics::World::create(scene, options));
  MARKETGEN_CHECK(world.wake(0));
  MARKETGEN_CHECK(world.step());
  return first_in_pool(world.model(), world.data(), world.product_pose(0));
}

Result<MadeBody> in_settling(const scene::Scene& scene) {
  MARKETGEN_TRY(const physics::SettleModel made, physics::settle_model(scene, {0}, 1));
  return body_of(*made.model, 1, {});
}

Result<MadeBody> in_mjcf(const scene::Scene& scene) {
  exporters::ExportOptions options;
  options.free_region_m = {0, 0, 6, 4};
  MARKETGEN_TRY(const exporters::ExportFiles files, exporters::write_mjcf(scene, options));
  char fault[500] = "";
  const physics::MujocoSpec spec(
      mj_parseXMLString(files.main.c_str(), nullptr, fault, sizeof fault), mj_deleteSpec);
  if (spec == nullptr) return Error{"physics.failed", "mjcf", fault};
  MARKETGEN_TRY(const physics::MujocoModel model, physics::compile(*spec, "mjcf"));
  return body_of(*model, 1, {});
}

Result<MadeBody> in_study(const catalog::Product& product,
                          const robots::GraspTool& tool,
                          grasping::GraspSetting setting) {
  MARKETGEN_TRY(const physics::SharedGoodsBody goods,
                physics::goods_body(product, grasping::use_of(setting)));
  const grasping::BasketOfLikes basket{physics::checkout_basket, {{}}};
  MARKETGEN_TRY(
      const grasping::GraspScene made,
      grasping::grasp_scene({*goods, tool, robots::Grasp{}, 0.5, setting, Seed(1), &basket}));
  return body_of(*made.model, made.products[0], {});
}

Result<MadeBody> at_checkout(const catalog::Product& product) {
  MARKETGEN_TRY(episodes::CheckoutWorld world,
                episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions));
  episodes::EpisodeSpec spec;
  spec.robot = world.station().robot;
  spec.items.emplace_back().sku = product.sku;
  MARKETGEN_CHECK(world.reset(spec, {product}));
  MARKETGEN_CHECK(world.step(episodes::still_action(world.observe())));
  return first_in_pool(
      world.model(), world.data(), world.store_from_station() * world.item_pose(0));
}

// ---- What must be the same ----

struct Doors {
  MadeBody world, settling, mjcf, shelf_trial;  // in a store
  MadeBody checkout, basket_trial;              // in a basket
  MadeBody table_trial;
};

class Sample {
 public:
  Sample() : tool_(robots::load_grasp_tool(data_rows(), "panda-hand").value()) {}

  Result<Doors> doors(const catalog::Product& product) const {
    const scene::Scene scene = scene_with(product);
    Doors doors;
    MARKETGEN_TRY(doors.world, in_world(scene));
    MARKETGEN_TRY(doors.settling, in_settling(scene));
    MARKETGEN_TRY(doors.mjcf, in_mjcf(scene));
    MARKETGEN_TRY(doors.shelf_trial, in_study(product, tool_, grasping::GraspSetting::stocked));
    MARKETGEN_TRY(doors.checkout, at_checkout(product));
    MARKETGEN_TRY(doors.basket_trial, in_study(product, tool_, grasping::GraspSetting::basket));
    MARKETGEN_TRY(doors.table_trial, in_study(product, tool_, grasping::GraspSetting::free));
    return doors;
  }

  std::string fault(const catalog::Product& product) const {
    const Result<Doors> made = doors(product);
    if (!made.ok()) return product.sku + ": " + to_string(made.error());
    const Doors& d = *made;
    const auto differs = [&](const char* what) { return product.sku + ": " + what; };
    for (const MadeBody* other : {&d.settling, &d.mjcf, &d.shelf_trial}) {
      if (!same_inertia(d.world, *other)) return differs("inertia in a store");
      if (!same_geoms(d.world, *other)) return differs("geoms in a store");
      if (!same_rolling(d.world, *other)) return differs("rolling in a store");
    }
    if (!same_inertia(d.checkout, d.basket_trial)) return differs("inertia in a basket");
    if (!same_geoms(d.checkout, d.basket_trial)) return differs("geoms in a basket");
    if (!same_rolling(d.checkout, d.basket_trial)) return differs("rolling in a basket");
    if (!same_inertia(d.checkout, d.table_trial)) return differs("inertia on a table");
    if (!same_geoms(d.checkout, d.table_trial)) return differs("geoms on a table");
    return fault_between(product, d);
  }

 private:
  // A store and a basket differ where goods_body.h says, and nowhere else.
  static std::string fault_between(const catalog::Product& product, const Doors& d) {
    const physics::GoodsForm form =
        physics::goods_body(product, physics::GoodsUse::stocked).value()->form;
    const std::string where = product.sku + ": store and basket: ";
    if (form != physics::GoodsForm::ball && !same_inertia(d.world, d.checkout))
      return where + "inertia";
    if (form == physics::GoodsForm::pieces && !same_geoms(d.world, d.checkout))
      return where + "geoms";
    if (std::abs(d.world.mass_kg - d.checkout.mass_kg) > 1e-12) return where + "mass";
    return "";
  }

  robots::GraspTool tool_;
};

// One of each shape, the first that may be stacked, the first that may not.
std::vector<const catalog::Product*> sample() {
  std::vector<const catalog::Product*> chosen;
  std::set<std::pair<std::string, bool>> seen;
  for (const catalog::Product& product : committed_catalog().products)
    if (seen.emplace(product.archetype, product.stack_max > 1).second) chosen.push_back(&product);
  return chosen;
}

TEST(SameBody, ByEveryDoor) {
  const Sample doors;
  const std::vector<const catalog::Product*> products = sample();
  ASSERT_GT(products.size(), 90U);
  for (const std::string& fault :
       parallel_map(products.size(), [&](std::size_t i) { return doors.fault(*products[i]); }))
    EXPECT_EQ(fault, "");
}

// Of a bottle by hand: its mass and middle are what the row and its shape say, whichever the door.
TEST(SameBody, IsThatOfTheRow) {
  const catalog::Product& wine =
      *committed_catalog().product("beverages-red-wine-tempranillo-0-75l");
  const Doors d = Sample().doors(wine).value();
  for (const MadeBody* body : {&d.world, &d.mjcf, &d.checkout}) {
    EXPECT_NEAR(body->mass_kg, wine.mass_kg, 1e-9);
    EXPECT_NEAR(body->middle.z, 0.102, 0.002);  // of a bottle drawn by hand
    EXPECT_GE(body->geoms.size(), 3U);          // body, shoulder and neck
    for (const MadeGeom& geom : body->geoms)
      EXPECT_NEAR(geom.numbers[geom.numbers.size() - 2], wine.friction, 1e-6);
  }
}

}  // namespace
}  // namespace marketgen
