#include "grasping/grasp_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "physics/goods/product_bodies.h"
#include "physics/goods/spec_geoms.h"
#include "physics/settle/bulk_model.h"
#include "physics/world/pad_balls.h"
#include "scene/planogram.h"

namespace marketgen::grasping {
namespace {

constexpr char grasp_where[] = "grasp";
constexpr int product_geom_group = 1;  // what touches of products: rays look for it
constexpr mjtSize grasp_arena_bytes = 16 << 20;
constexpr double shelf_thick_m = 0.02, board_half_width_m = 1.5, board_depth_m = 0.6;
constexpr double set_back_m = 0.010;  // of the front row behind the shelf's edge
constexpr double floor_under_shelf_m = 1.5;
constexpr double max_headroom_m = 0.050;
// Neighbours on either side in the front row, one behind each of the three in the middle. Beyond
// them the shelf is full: of as many more facings to a divider, and of the rows to the back panel,
// only the gaps are there to be closed up.
constexpr int beside = 2, beside_still = 4;
constexpr double stocked_depth_m = 0.45;  // of a gondola's board
constexpr double block_half_m = 0.02;

// The arm behind the tool, and the motor and gears behind a finger. Pads are as soft as MuJoCo
// makes them (impedance 0.9 to 0.95: 0.4 mm at 70 N on 0.35 kg): at 0.99 they lost contact in turns
// when shaken across, and a litre carton crept by 2 mm.
constexpr double base_inertia_kg = 1e4, finger_inertia_kg = 0.5;

constexpr double close_m_s = 0.06;  // of each finger, at most

// Which geoms look for contact with which: all but the tool's with one another. A pad's balls,
// which stand out beyond it, meet goods only, and its box what stands still.
constexpr int others_bit = 1, tool_bit = 2, ball_bit = 4, pad_box_bit = 8;
constexpr int goods_meet = others_bit | tool_bit | ball_bit;
constexpr int still_meets = others_bit | tool_bit | pad_box_bit;
// What lies further ahead of the cup's body is bellows, which the lip's equalities stand for.
constexpr double cup_bellows_m = 0.03;

class GraspSceneBuilder {
 public:
  GraspSceneBuilder(const GraspTrial& trial, Vec3 middle)
      : trial_(trial),
        middle_(middle),
        spec_(mj_makeSpec(), mj_deleteSpec),
        world_(mjs_findBody(spec_.get(), "world")),
        products_(*spec_) {
    physics::set_contact_options(*spec_, 0);
    spec_->option.enableflags &= ~mjENBL_SLEEP;
    spec_->memory = grasp_arena_bytes;
    spec_->compiler.balanceinertia = true;
    spec_->compiler.degree = false;
  }

  void add_surroundings() {
    switch (trial_.setting) {
      case GraspSetting::free:
        add_product({});
        return add_floor(0);
      case GraspSetting::basket:
        return add_basket();
      default:
        add_shelf();
    }
  }

  void add_tool() {
    mjsBody* base = mjs_addBody(world_, nullptr);
    mjs_setName(base->element, "base");
    base->pos[2] = floor_under_shelf_m;
    base->mass = trial_.tool.mass_kg;
    base->inertia[0] = base->inertia[1] = base->inertia[2] = 1e-3;
    base->explicitinertial = true;
    base->gravcomp = 1;
    const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const auto& axis : axes)
      add_slide(base, axis, base_inertia_kg, 0);
    mjsBody* tool = mjs_addBody(base, nullptr);
    mjs_setName(tool->element, "tool");
    for (const robots::ToolSolid& solid : trial_.tool.body)
      add_solid(tool, solid, tool_bit);
    if (trial_.tool.kind == robots::ToolKind::suction) {
      physics::add_lip(*spec_, "tool", {}, trial_.tool.cup_radius_m, "product0");
      return;
    }
    add_finger(tool, trial_.tool.left, 1);
    add_finger(tool, trial_.tool.right, -1);
    mjsEquality* pair = mjs_addEquality(spec_.get(), nullptr);
    pair->type = mjEQ_JOINT;
    mjs_setString(pair->name1, "left");
    mjs_setString(pair->name2, "right");
    std::fill(pair->data, pair->data + mjNEQDATA, 0.0);
    pair->data[1] = 1;
    pair->solref[0] = physics::contact_time_s;
  }

  Result<GraspScene> finish() {
    GraspScene scene;
    MARKETGEN_TRY(scene.model, physics::compile(*spec_, grasp_where));
    const mjModel& m = *scene.model;
    const auto body = [&](const std::string& name) {
      return mj_name2id(&m, mjOBJ_BODY, name.c_str());
    };
    scene.tool_body = body("tool");
    scene.base_dof = m.body_dofadr[body("base")];
    if (trial_.tool.kind == robots::ToolKind::gripper)
      scene.finger_dof = m.body_dofadr[body("left")];
    for (int i = 0; i < product_count_; ++i)
      scene.products.push_back(body(fmt::format("product{}", i)));
    if (trial_.tool.kind == robots::ToolKind::suction) scene.lip = physics::lip_points(m, "tool");
    scene.headroom_m = headroom_;
    scene.target.push_back(scene.products[0]);
    if (trial_.soft != nullptr) {
      scene.target_origin = middle_;
      while (m.body_rootid[scene.target.back() + 1] == scene.products[0])
        scene.target.push_back(scene.target.back() + 1);
    }
    name_owners(m, scene);
    return scene;
  }

 private:
  // Geoms are told apart by their bodies, and pads by their priority.
  void name_owners(const mjModel& m, GraspScene& scene) const {
    for (int geom = 0; geom < m.ngeom; ++geom) {
      const int body = m.geom_bodyid[geom];
      const auto product = std::ranges::find(scene.products, m.body_rootid[body]);
      GraspOwner owner = GraspOwner::still;
      int index = 0;
      if (m.geom_group[geom] == product_geom_group) scene.product_geoms.push_back(geom);
      if (product != scene.products.end()) {
        owner = GraspOwner::product;
        index = static_cast<int>(product - scene.products.begin());
      } else if (body != 0) {
        owner = m.geom_priority[geom] > 0 ? GraspOwner::pad : GraspOwner::tool;
        index = std::string_view(mj_id2name(&m, mjOBJ_BODY, body)) == "right" ? 1 : 0;
      }
      scene.owners.push_back(owner);
      scene.owner_index.push_back(index);
    }
  }

  void add_shelf() {
    Stream draw = trial_.seed.child("shelf").stream();
    const double width = trial_.goods.product.width_m(), depth = trial_.goods.product.depth_m();
    const auto gap = [&] {
      return trial_.setting == GraspSetting::spaced ? spaced_gap_m : draw.uniform(0.002, 0.008);
    };
    headroom_ = draw.uniform(min_headroom_m, max_headroom_m);
    add_product({});
    for (const double side : {-1.0, 1.0}) {
      double x = 0;
      for (int i = 0; i < beside; ++i) {
        x += side * (width + gap());
        add_product({{x, 0, 0}, {}});
      }
      double slack = 0;
      for (int i = 0; i < beside_still; ++i)
        slack += gap();
      add_row_end(x + side * (width / 2 + slack + block_half_m));
    }
    const double behind = depth + scene::depth_gap_m;
    add_product({{0, behind, 0}, {}});
    for (const double side : {-1.0, 1.0})
      add_product({{side * (width + gap()), behind, 0}, {}});
    add_back(behind);
    add_board(0);
    add_board(trial_.goods.product.height_m() + headroom_ + shelf_thick_m);
    add_floor(-floor_under_shelf_m);
  }

  void add_basket() {
    for (const Pose& pose : trial_.basket->container_from_product)
      add_product(pose);
    for (mjsGeom* geom : physics::add_container(world_, trial_.basket->container))
      set_meeting(geom, others_bit, still_meets);
  }

  static void set_meeting(mjsGeom* geom, int own_bit, int meets) {
    geom->contype = own_bit;
    geom->conaffinity = meets;
  }

  void add_floor(double z) {
    mjsGeom* floor = mjs_addGeom(world_, nullptr);
    floor->type = mjGEOM_PLANE;
    floor->size[2] = 1;
    floor->pos[2] = z;
    floor->friction[0] = physics::still_friction;
    floor->solref[0] = physics::contact_time_s;
    set_meeting(floor, others_bit, still_meets);
  }

  void add_board(double top_z) {
    const double front = -trial_.goods.product.depth_m() / 2 - set_back_m;
    add_block({0, front + board_depth_m / 2, top_z - shelf_thick_m / 2},
              {board_half_width_m, board_depth_m / 2, shelf_thick_m / 2});
  }

  void add_block(Vec3 at, Vec3 half) {
    set_meeting(physics::add_shape(world_, {assets::CollisionShape::box, {at, {}}, half}),
                others_bit,
                still_meets);
  }

  void add_row_end(double x) {
    const double height = trial_.goods.product.height_m();
    add_block({x, 0, height / 2}, {block_half_m, trial_.goods.product.depth_m() / 2, height / 2});
  }

  // Where the second row stands when all rows behind it have been pushed together.
  void add_back(double second_row_y) {
    const double depth = trial_.goods.product.depth_m();
    const double rows =
        std::floor((stocked_depth_m + scene::depth_gap_m) / (depth + scene::depth_gap_m));
    const double slack = scene::depth_gap_m * std::max(1.0, rows - 1);
    add_block(
        {0, second_row_y + depth / 2 + slack + block_half_m, trial_.goods.product.height_m() / 2},
        {board_half_width_m, block_half_m, trial_.goods.product.height_m() / 2});
  }

  void add_product(const Pose& world_from_product) {
    const physics::ProductGeoms geoms{product_geom_group, others_bit, goods_meet};
    const bool bends = trial_.soft != nullptr && product_count_ == 0;
    const std::string name = fmt::format("product{}", product_count_++);
    if (bends)
      products_.add_soft(name, *trial_.soft, trial_.goods, world_from_product, middle_, geoms);
    else
      products_.add(name, trial_.goods, world_from_product, geoms);
  }

  mjsJoint* add_slide(mjsBody* body, const double axis[3], double inertia_kg, double damping) {
    mjsJoint* joint = mjs_addJoint(body, nullptr);
    joint->type = mjJNT_SLIDE;
    std::copy(axis, axis + 3, joint->axis);
    joint->armature = inertia_kg;
    joint->damping[0] = damping;
    return joint;
  }

  void add_solid(mjsBody* body, const robots::ToolSolid& solid, int bit) {
    const Pose& pose = solid.tool_from_solid;
    const Vec3& h = solid.half_size;
    const bool bellows =
        trial_.tool.kind == robots::ToolKind::suction && pose.position.z + h.z > -cup_bellows_m;
    if (bellows) return;
    mjsGeom* geom = physics::add_shape(
        body,
        {solid.round ? assets::CollisionShape::cylinder : assets::CollisionShape::box,
         pose,
         solid.round ? Vec3{h.x, h.z, 0} : h});
    set_meeting(geom, bit, 0);
    geom->mass = 0;
  }

  void add_pad(mjsBody* body, const robots::ToolSolid& pad, double side) {
    for (mjsGeom* ball :
         physics::add_pad_balls(body, pad.tool_from_solid.position, pad.half_size, side)) {
      set_meeting(ball, ball_bit, 0);
      ball->priority = 1;
      ball->friction[0] = trial_.pad_friction;
    }
  }

  // Shut at 0, apart along `side`; its damping is what holds it to its speed at the grasp's force.
  void add_finger(mjsBody* tool, const std::vector<robots::ToolSolid>& solids, double side) {
    mjsBody* finger = mjs_addBody(tool, nullptr);
    const char* name = side > 0 ? "left" : "right";
    mjs_setName(finger->element, name);
    finger->mass = trial_.tool.finger_kg;
    finger->inertia[0] = finger->inertia[1] = finger->inertia[2] = 1e-5;
    finger->explicitinertial = true;
    finger->gravcomp = 1;
    const double axis[3] = {0, side, 0};
    mjsJoint* joint =
        add_slide(finger,
                  axis,
                  finger_inertia_kg,
                  trial_.grasp.force_n / std::min(close_m_s, trial_.tool.finger_speed_m_s));
    mjs_setName(joint->element, name);
    add_pad(finger, solids[0], side);
    for (std::size_t i = 0; i < solids.size(); ++i)
      add_solid(finger, solids[i], i == 0 ? pad_box_bit : tool_bit);
  }

  const GraspTrial& trial_;
  Vec3 middle_;  // of the row's box
  physics::MujocoSpec spec_;
  mjsBody* world_;
  physics::ProductBodies products_;
  int product_count_ = 0;
  double headroom_ = 0;
};

Result<void> check_trial(const GraspTrial& trial) {
  const catalog::Product& p = trial.goods.product;
  MARKETGEN_CHECK(physics::check_has_body(p, trial.goods.body));
  const robots::Grasp& g = trial.grasp;
  const Vec3& at = g.product_from_tool.position;
  const bool finite = std::isfinite(at.x + at.y + at.z) && std::isfinite(g.force_n + g.opening_m);
  if (!finite || !(trial.pad_friction >= 0))
    return Error{"motion.bad_configuration", p.sku, "expected a grasp of finite numbers"};
  if (trial.tool.kind == robots::ToolKind::gripper && g.opening_m > trial.tool.opening_m + 1e-9)
    return Error{"motion.bad_configuration",
                 p.sku,
                 fmt::format("the grasp needs {:.0f} mm between the pads; {} opens {:.0f} mm",
                             g.opening_m * 1e3,
                             trial.tool.id,
                             trial.tool.opening_m * 1e3)};
  if (trial.soft != nullptr && trial.tool.kind == robots::ToolKind::suction)
    return Error{"motion.bad_configuration", p.sku, "a cup is tried on rigid packs only"};
  if (g.force_n < 0 || g.force_n > trial.tool.force_n + 1e-9)
    return Error{"motion.bad_configuration",
                 p.sku,
                 fmt::format("the grasp needs {:.0f} N; {} has {:.0f} N",
                             g.force_n,
                             trial.tool.id,
                             trial.tool.force_n)};
  return {};
}

Result<void> check_basket(const GraspTrial& trial) {
  if (trial.setting != GraspSetting::basket) return {};
  if (trial.basket == nullptr || trial.basket->container_from_product.empty())
    return Error{"motion.bad_configuration",
                 trial.goods.product.sku,
                 "a grasp in a basket needs the basket and where the packs lie in it"};
  for (const Pose& pose : trial.basket->container_from_product) {
    const Quaternion& q = pose.rotation;
    if (!is_finite(pose.position) || !std::isfinite(q.w + q.x + q.y + q.z))
      return Error{
          "motion.bad_configuration", trial.goods.product.sku, "expected packs at finite places"};
  }
  return physics::check_container(trial.basket->container);
}

}  // namespace

Result<GraspScene> grasp_scene(const GraspTrial& trial) {
  MARKETGEN_CHECK(check_trial(trial));
  MARKETGEN_CHECK(check_basket(trial));
  MARKETGEN_TRY(const assets::CollisionPrimitive solid, assets::collision_of(trial.goods.product));
  GraspSceneBuilder builder(trial, to_double(solid.center));
  builder.add_surroundings();
  builder.add_tool();
  return builder.finish();
}

}  // namespace marketgen::grasping
