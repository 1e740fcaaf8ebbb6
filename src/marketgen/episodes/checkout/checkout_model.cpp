#include "episodes/checkout/checkout_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "grasping/grasp_study.h"
#include "io/json.h"
#include "motion/grasp_surface.h"
#include "physics/goods/product_bodies.h"
#include "physics/goods/spec_geoms.h"
#include "physics/world/pad_balls.h"
#include "physics/world/robot_actor.h"

namespace marketgen::episodes {
namespace {

constexpr char checkout_where[] = "checkout";
constexpr mjtSize checkout_arena_bytes = 64U << 20;
constexpr int volume_points_a_side = 8;
constexpr double basket_feet_friction =
    0.5;                                 // moulded plastic on a rubber belt: data/friction.json
constexpr double finger_friction = 0.5;  // of its metal; pads have that of their pairs

// Which geoms look for contact with which: pad boxes meet what stands still and the basket; their
// balls meet goods, as pairs with a friction of their own.
constexpr int all_bit = 1, pad_box_bit = 2;

class CheckoutModelBuilder {
 public:
  CheckoutModelBuilder(const CheckoutStation& station, const robots::Robot& robot)
      : station_(station),
        robot_(robot),
        spec_(mj_makeSpec(), mj_deleteSpec),
        world_(mjs_findBody(spec_.get(), "world")),
        goods_(*spec_) {
    physics::set_contact_options(*spec_, 1e-3);
    spec_->option.disableflags |= mjDSBL_AUTORESET;
    spec_->memory = checkout_arena_bytes;
    spec_->compiler.balanceinertia = true;
    spec_->compiler.degree = false;
  }

  void add_counter() {
    const CounterRow& c = station_.counter;
    const double x = (c.low_m[0] + c.high_m[0]) / 2, y = (c.low_m[1] + c.high_m[1]) / 2;
    const Vec3 half{
        (c.high_m[0] - c.low_m[0]) / 2, (c.high_m[1] - c.low_m[1]) / 2, c.thickness_m / 2};
    add_still({x, y, -half.z}, half);
    mjsGeom* floor = physics::add_floor(world_);
    floor->pos[2] = -c.height_m;
    floor->conaffinity = all_bit | pad_box_bit;
    for (const physics::ContainerBox& box : station_.lip())
      add_still(box.container_from_box.position, box.half_size);
  }

  void add_basket() {
    mjsBody* body = mjs_addBody(world_, nullptr);
    mjs_setName(body->element, "basket");
    physics::set_pose(body->pos, body->quat, station_.basket_pose());
    mjs_addFreeJoint(body);
    const BasketRow& b = station_.basket;
    const std::vector<physics::ContainerBox> boxes = station_.basket_boxes();
    double volume = 0;
    for (const physics::ContainerBox& box : boxes)
      volume += 8 * box.half_size.x * box.half_size.y * box.half_size.z;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Vec3& h = boxes[i].half_size;
      mjsGeom* geom =
          physics::add_shape(body, {assets::CollisionShape::box, boxes[i].container_from_box, h});
      geom->mass = b.mass_kg * 8 * h.x * h.y * h.z / volume;
      geom->conaffinity = all_bit | pad_box_bit;
      if (i + 1 == boxes.size()) geom->friction[0] = basket_feet_friction;
    }
  }

  void add_items(const std::vector<EpisodeItem>& items, const std::vector<SharedGoods>& goods) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::string name = item_name(i);
      goods_.add(name, *goods[i]->made, station_.basket_pose() * items[i].pose());
      name_geoms(name, goods[i]->pad_friction);
    }
  }

  Result<void> add_arm(const std::vector<double>& state) {
    physics::RobotActorOptions options;
    options.state = state;
    MARKETGEN_CHECK(physics::add_robot(*spec_, robot_, options));
    std::set<int> hands;
    for (const robots::Joint& joint : robot_.joints) {
      if (joint.kind != robots::JointType::prismatic || joint.dof < 0) continue;
      add_finger(joint);
      hands.insert(joint.parent);
    }
    for (const int hand : hands)
      shape_hand(robot_.links[static_cast<std::size_t>(hand)]);
    add_pairs();
    return {};
  }

  Result<CheckoutModel> finish(std::size_t items) {
    CheckoutModel made;
    MARKETGEN_TRY(made.model, physics::compile(*spec_, checkout_where));
    const mjModel& m = *made.model;
    made.basket = mj_name2id(&m, mjOBJ_BODY, "basket");
    for (std::size_t i = 0; i < items; ++i)
      made.items.push_back(mj_name2id(&m, mjOBJ_BODY, item_name(i).c_str()));
    for (int geom = 0; geom < m.ngeom; ++geom)
      name_owner(m, m.geom_bodyid[geom], made);
    return made;
  }

 private:
  static std::string item_name(std::size_t item) { return fmt::format("item{}", item); }

  static void name_owner(const mjModel& m, int body, CheckoutModel& made) {
    const auto item = std::ranges::find(made.items, body);
    const char* name = mj_id2name(&m, mjOBJ_BODY, body);
    const std::string_view called = name == nullptr ? "" : name;
    CheckoutOwner owner = CheckoutOwner::arm;
    int index = 0;
    if (body == 0) {
      owner = CheckoutOwner::still;
    } else if (body == made.basket) {
      owner = CheckoutOwner::basket;
    } else if (item != made.items.end()) {
      owner = CheckoutOwner::item;
      index = static_cast<int>(item - made.items.begin());
    } else if (called.starts_with("finger")) {
      owner = CheckoutOwner::finger;
      index = called == "finger_right" ? 1 : 0;
    }
    made.owners.push_back(owner);
    made.owner_index.push_back(index);
  }

  void add_still(Vec3 at, Vec3 half) {
    mjsGeom* geom = physics::add_shape(world_, {assets::CollisionShape::box, {at, {}}, half});
    geom->conaffinity = all_bit | pad_box_bit;
  }

  void name_geoms(const std::string& name, double friction) {
    mjsBody* body = mjs_findBody(spec_.get(), name.c_str());
    int count = 0;
    for (mjsElement* e = mjs_firstChild(body, mjOBJ_GEOM, 0); e != nullptr;
         e = mjs_nextChild(body, e, 0)) {
      item_geoms_.emplace_back(fmt::format("{}/{}", name, count++), friction);
      mjs_setName(e, item_geoms_.back().first.c_str());
    }
  }

  // A hand is the boxes of its look, as grasps know it: capsules stand out beyond them by a
  // centimetre, which is more than there is between hand and rim.
  void shape_hand(const robots::Link& link) {
    const auto boxes = [](const robots::BodyShape& shape) {
      return shape.kind == robots::ShapeKind::box;
    };
    if (std::ranges::none_of(link.look, boxes)) return;
    mjsBody* body = mjs_findBody(spec_.get(), link.name.c_str());
    for (mjsElement* e = mjs_firstChild(body, mjOBJ_GEOM, 0); e != nullptr;
         e = mjs_nextChild(body, e, 0))
      mjs_asGeom(e)->contype = mjs_asGeom(e)->conaffinity = 0;
    for (const robots::BodyShape& shape : link.look) {
      if (!boxes(shape)) continue;
      mjsGeom* geom = physics::add_shape(
          body, {assets::CollisionShape::box, shape.link_from_shape, shape.size * 0.5});
      geom->mass = 0;
      geom->friction[0] = finger_friction;
    }
  }

  // Its solids meet what they did, but the pad: the balls in front of it meet goods in its place.
  void add_finger(const robots::Joint& joint) {
    const robots::Link& link = robot_.links[static_cast<std::size_t>(joint.link)];
    mjsBody* body = mjs_findBody(spec_.get(), link.name.c_str());
    const double side = joint.axis.y;
    const auto inner = [&](const robots::BodyShape& s) {
      return side * s.link_from_shape.position.y - s.size.y / 2;
    };
    const robots::BodyShape& pad = *std::ranges::min_element(
        link.look, [&](const robots::BodyShape& a, const robots::BodyShape& b) {
          return inner(a) < inner(b);
        });
    std::size_t index = 0;
    for (mjsElement* e = mjs_firstChild(body, mjOBJ_GEOM, 0); e != nullptr;
         e = mjs_nextChild(body, e, 0)) {
      mjsGeom* geom = mjs_asGeom(e);
      geom->friction[0] = finger_friction;
      if (&link.look[index++] != &pad) continue;
      geom->contype = pad_box_bit;
      geom->conaffinity = 0;
    }
    int count = 0;
    for (mjsGeom* ball :
         physics::add_pad_balls(body, pad.link_from_shape.position, pad.size * 0.5, side)) {
      ball->contype = ball->conaffinity = 0;
      balls_.push_back(fmt::format("{}/ball{}", link.name, count++));
      mjs_setName(ball->element, balls_.back().c_str());
    }
  }

  void add_pairs() {
    for (const std::string& ball : balls_) {
      for (const auto& [geom, friction] : item_geoms_) {
        mjsPair* pair = mjs_addPair(spec_.get(), nullptr);
        mjs_setString(pair->geomname1, ball.c_str());
        mjs_setString(pair->geomname2, geom.c_str());
        pair->condim = 4;
        pair->solref[0] = physics::contact_time_s;
        pair->solref[1] = 1;
        const double f[5] = {friction, friction, physics::torsional_friction_m, 0.0001, 0.0001};
        std::copy_n(f, 5, pair->friction);
      }
    }
  }

  const CheckoutStation& station_;
  const robots::Robot& robot_;
  physics::MujocoSpec spec_;
  mjsBody* world_;
  physics::ProductBodies goods_;
  std::vector<std::pair<std::string, double>> item_geoms_;  // and the pads' friction on them
  std::vector<std::string> balls_;
};

std::vector<Vec3> points_within(const assets::ProductBody& body) {
  const motion::GraspSurface surface(body.pieces);
  const Vec3 low = to_double(surface.bounds().low), high = to_double(surface.bounds().high);
  const Vec3 step = (high - low) / volume_points_a_side;
  std::vector<Vec3> points;
  for (int i = 0; i < volume_points_a_side; ++i) {
    for (int j = 0; j < volume_points_a_side; ++j) {
      for (int k = 0; k < volume_points_a_side; ++k) {
        const Vec3 at = low + step * Vec3{i + 0.5, j + 0.5, k + 0.5};
        if (surface.gap_to_box({at, {}}, {1e-6, 1e-6, 1e-6}, 0) < 0) points.push_back(at);
      }
    }
  }
  if (points.empty()) points.push_back(to_double(body.center_of_mass));
  return points;
}

Result<SharedGoods> made_goods(const catalog::Product& product, double pad_friction) {
  MARKETGEN_TRY(const physics::SharedGoodsBody made,
                physics::goods_body(product, physics::GoodsUse::bulk));
  return SharedGoods(std::make_shared<CheckoutGoods>(
      CheckoutGoods{made, made->product, made->body, points_within(made->body), pad_friction}));
}

}  // namespace

Result<SharedGoods> checkout_goods(const catalog::Product& product,
                                   const std::vector<catalog::FrictionRow>& frictions) {
  static std::mutex changing;
  static std::map<std::string, SharedGoods> made;  // by all that they are made from
  const double pad_friction = grasping::rubber_friction(frictions, product);
  const std::string key = fmt::format("{} {}", io::write_json_line(product), pad_friction);
  {
    const std::scoped_lock lock(changing);
    if (const auto known = made.find(key); known != made.end()) return known->second;
  }
  MARKETGEN_TRY(SharedGoods goods, made_goods(product, pad_friction));
  const std::scoped_lock lock(changing);
  return made.emplace(key, std::move(goods)).first->second;
}

std::vector<double> ready_state(const CheckoutStation& station, const robots::Robot& robot) {
  std::vector<double> q = robots::neutral_state(robot);
  if (const robots::JointGroup* arm = robot.find_group("arm")) {
    for (std::size_t j = 0; j < std::min(arm->dofs.size(), station.ready_deg.size()); ++j)
      q[static_cast<std::size_t>(arm->dofs[j])] = station.ready_deg[j] * std::numbers::pi / 180;
  }
  if (const robots::JointGroup* fingers = robot.find_group("fingers")) {
    for (const int dof : fingers->dofs)
      q[static_cast<std::size_t>(dof)] = robot.joint_of_dof(static_cast<std::size_t>(dof)).upper;
  }
  return robots::with_followers(robot, std::move(q));
}

Result<CheckoutModel> checkout_model(const CheckoutStation& station,
                                     const robots::Robot& robot,
                                     const std::vector<double>& robot_state,
                                     const std::vector<EpisodeItem>& items,
                                     const std::vector<SharedGoods>& goods) {
  CheckoutModelBuilder builder(station, robot);
  builder.add_counter();
  builder.add_basket();
  builder.add_items(items, goods);
  MARKETGEN_CHECK(builder.add_arm(robot_state));
  return builder.finish(items.size());
}

}  // namespace marketgen::episodes
