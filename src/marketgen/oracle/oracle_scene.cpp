#include "oracle/oracle_scene.h"

#include <algorithm>
#include <cmath>

#include "episodes/checkout/checkout_goals.h"
#include "episodes/checkout/checkout_senses.h"
#include "geometry/box_extents.h"
#include "motion/shape_obstacles.h"

namespace marketgen::oracle {

Result<robots::GraspTool> load_checkout_tool(const episodes::CheckoutWorld& world,
                                             const std::filesystem::path& data) {
  return robots::load_grasp_tool(data, world.station().tools().picks_with);
}

Result<skills::ArmExecutor> make_checkout_arm(const episodes::CheckoutWorld& world,
                                              const robots::GraspTool& tool) {
  skills::ExecutorOptions options;
  if (tool.kind == robots::ToolKind::suction) options.acceleration = skills::cup_acceleration;
  return skills::ArmExecutor::make(world.robot(), options);
}

OracleScene::OracleScene(const episodes::CheckoutWorld& world, const robots::GraspTool& tool)
    : world_(world), tool_(tool), place_(episodes::workplace_of(world.station())), walls_(place_) {
  for (std::size_t i = 0; i < world.item_count(); ++i)
    surfaces_.emplace_back(world.goods(i).body.pieces);
}

agent::Workplace OracleScene::place() const {
  agent::Workplace place = place_;
  place.base_from_basket = world_.basket_pose();
  return place;
}

skills::PlacedBody OracleScene::body(std::size_t item) const {
  return {&surfaces_[item], world_.item_pose(item)};
}

std::vector<skills::PlacedBody> OracleScene::walls() const {
  return walls_.at(world_.basket_pose());
}

skills::LyingPack OracleScene::lying(std::size_t item) const {
  const episodes::EpisodeGoods& goods = world_.goods(item);
  return {goods.product, goods.body, goods.pad_friction, world_.item_pose(item)};
}

double OracleScene::item_overlap(std::size_t a, Vec3 by, std::size_t b) const {
  const Pose pose = world_.item_pose(a);
  double deepest = 0;
  const std::vector<Vec3>& points = world_.goods(a).volume;
  const skills::PlacedBody other = body(b);
  for (std::size_t i = 0; i < points.size(); i += 2)
    deepest = std::max(deepest,
                       skills::box_overlap(other, {pose * points[i] + by, {}}, {1e-6, 1e-6, 1e-6}));
  return deepest;
}

Vec3 OracleScene::half_extents_at(std::size_t item, const Quaternion& turned) const {
  const Bounds3& bounds = surfaces_[item].bounds();
  return box_half_extents(turned, (to_double(bounds.high) - to_double(bounds.low)) * 0.5);
}

Vec3 OracleScene::box_middle(std::size_t item, const Pose& pose) const {
  const Bounds3& bounds = surfaces_[item].bounds();
  return pose * ((to_double(bounds.high) + to_double(bounds.low)) * 0.5);
}

bool OracleScene::is_target(std::size_t item) const {
  const episodes::EpisodeSpec& spec = world_.spec();
  return std::ranges::count(spec.goals, spec.items[item].sku, &episodes::EpisodeGoal::sku) > 0;
}

bool OracleScene::in_basket(std::size_t item) const {
  const Vec3 at = inverse(world_.basket_pose()) * middle(item);
  const physics::OpenContainer c = world_.station().container();
  return std::abs(at.x) < c.top_x_m / 2 + c.wall_m && std::abs(at.y) < c.top_y_m / 2 + c.wall_m;
}

bool OracleScene::in_unloading(std::size_t item) const {
  const episodes::EpisodeGoods& goods = world_.goods(item);
  return episodes::is_inside(world_.region(),
                             {goods.product.sku,
                              world_.item_pose(item),
                              to_double(goods.body.center_of_mass),
                              goods.volume});
}

skills::Surroundings OracleScene::surroundings(const std::vector<std::size_t>& without,
                                               skills::HandAt hand) const {
  skills::Surroundings around = skills::counter_surroundings(place(), hand);
  for (std::size_t item = 0; item < items(); ++item) {
    if (std::ranges::find(without, item) == without.end())
      motion::add_pieces(world_.goods(item).body.pieces, world_.item_pose(item), around.way);
  }
  return around;
}

}  // namespace marketgen::oracle
