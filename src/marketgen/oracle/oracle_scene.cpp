#include "oracle/oracle_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "episodes/checkout/checkout_goals.h"
#include "geometry/box_extents.h"
#include "physics/goods/contact_shape.h"

namespace marketgen {
namespace {

// Where the open tool is looked at on its way: so far back.
constexpr std::array on_the_way_m{0.0, 0.02, 0.04, 0.07, 0.1, 0.14};
// Of the basket's walls, what arms keep clear of on lines: the spheres of a hand are larger than
// it.
constexpr double skin_m = 0.002, below_rim_m = 0.015;
constexpr double counter_half_m = 0.03;

}  // namespace

double tilt_deg(const Quaternion& station_from_tip) {
  const Vec3 ahead = rotate(station_from_tip, {0, 0, 1});
  return std::acos(std::clamp(-ahead.z, -1.0, 1.0)) * 180 / std::numbers::pi;
}

Result<GraspTool> load_checkout_tool(const CheckoutWorld& world,
                                     const std::filesystem::path& data) {
  const std::vector<ToolChoiceRow>& tools = world.station().tools;
  return load_grasp_tool(data, tools.empty() ? world.robot().tools.front().row : tools.front().row);
}

OracleScene::OracleScene(const CheckoutWorld& world, const GraspTool& tool)
    : world_(world), tool_(tool) {
  for (std::size_t i = 0; i < world.item_count(); ++i)
    surfaces_.emplace_back(world.goods(i).body.pieces);
  for (const ContainerBox& box : boxes_of(world.station().container())) {
    ContactPiece piece;
    piece.half_size = to_float(box.half_size);
    walls_.emplace_back(box.container_from_box, GraspSurface({piece}));
  }
}

std::vector<ToolSolid> OracleScene::tool_solids(double opening_m) const {
  std::vector<ToolSolid> solids = opened(tool_, opening_m);
  solids.insert(solids.end(), tool_.body.begin(), tool_.body.end());
  return solids;
}

bool OracleScene::tool_meets_basket(const Pose& station_from_tip,
                                    double opening_m,
                                    double gap_m) const {
  const Pose basket_from_tip = inverse(world_.basket_pose()) * station_from_tip;
  const std::vector<ToolSolid> solids = tool_solids(opening_m);
  return std::ranges::any_of(walls_, [&](const auto& wall) {
    const Pose wall_from_tip = inverse(wall.first) * basket_from_tip;
    return std::ranges::any_of(solids, [&](const ToolSolid& solid) {
      return wall.second.gap_to_box(wall_from_tip * solid.tool_from_solid, solid.half_size, gap_m) <
             gap_m;
    });
  });
}

double OracleScene::overlap(std::size_t item, const Pose& station_from_box, Vec3 half) const {
  const Pose pose = inverse(world_.item_pose(item)) * station_from_box;
  const Bounds3& bounds = surfaces_[item].bounds();
  const double reach = length(half);
  const Vec3 low = to_double(bounds.low), high = to_double(bounds.high), at = pose.position;
  if (at.x < low.x - reach || at.x > high.x + reach || at.y < low.y - reach ||
      at.y > high.y + reach || at.z < low.z - reach || at.z > high.z + reach)
    return 0;
  return std::max(0.0, -surfaces_[item].gap_to_box(pose, half, 0));
}

double OracleScene::tool_overlap(std::size_t item,
                                 const Pose& station_from_tip,
                                 double opening_m) const {
  const std::vector<ToolSolid> solids = tool_solids(opening_m);
  double most = 0;
  for (const double back : on_the_way_m) {
    const Pose tip = station_from_tip * Pose{{0, 0, -back}, {}};
    for (const ToolSolid& solid : solids)
      most = std::max(most, overlap(item, tip * solid.tool_from_solid, solid.half_size));
  }
  return most;
}

double OracleScene::item_overlap(std::size_t a, Vec3 by, std::size_t b) const {
  const Pose pose = world_.item_pose(a);
  double most = 0;
  const std::vector<Vec3>& points = world_.goods(a).volume;
  for (std::size_t i = 0; i < points.size(); i += 2)
    most = std::max(most, overlap(b, {pose * points[i] + by, {}}, {1e-6, 1e-6, 1e-6}));
  return most;
}

Vec3 OracleScene::middle(std::size_t item) const {
  return world_.item_pose(item) * to_double(world_.goods(item).body.center_of_mass);
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
  const EpisodeSpec& spec = world_.spec();
  return std::ranges::count(spec.goals, spec.items[item].sku, &EpisodeGoal::sku) > 0;
}

bool OracleScene::in_basket(std::size_t item) const {
  const Vec3 at = inverse(world_.basket_pose()) * middle(item);
  const OpenContainer c = world_.station().container();
  return std::abs(at.x) < c.top_x_m / 2 + c.wall_m && std::abs(at.y) < c.top_y_m / 2 + c.wall_m;
}

bool OracleScene::in_unloading(std::size_t item) const {
  const CheckoutGoods& goods = world_.goods(item);
  return is_inside(world_.region(),
                   {goods.product.sku,
                    world_.item_pose(item),
                    to_double(goods.body.center_of_mass),
                    goods.volume});
}

std::vector<GraspObstacle> OracleScene::walls() const {
  std::vector<GraspObstacle> walls;
  for (const ContainerBox& box : boxes_of(world_.station().container()))
    walls.push_back({world_.basket_pose() * box.container_from_box, box.half_size});
  return walls;
}

void OracleScene::add_item(std::size_t item, Obstacles& obstacles) const {
  const Pose pose = world_.item_pose(item);
  for (const ContactPiece& piece : world_.goods(item).body.pieces) {
    if (piece.shape == PieceShape::hull) {
      obstacles.convex.push_back({pose, piece.points});
      continue;
    }
    const ContactShape shape = pose * contact_shape_of(piece);
    if (shape.shape == CollisionShape::cylinder)
      obstacles.cylinders.push_back({shape.pose, shape.size.x, shape.size.y});
    else  // an ellipsoid is taken for its box
      obstacles.boxes.push_back({shape.pose, shape.size});
  }
}

BoxObstacle OracleScene::counter_top() const {
  const CounterRow& c = world_.station().counter;
  return {{{(c.low_m[0] + c.high_m[0]) / 2, (c.low_m[1] + c.high_m[1]) / 2, -counter_half_m}, {}},
          {(c.high_m[0] - c.low_m[0]) / 2, (c.high_m[1] - c.low_m[1]) / 2, counter_half_m}};
}

Surroundings OracleScene::counter_alone() const {
  Surroundings around;
  around.way.boxes.push_back(counter_top());
  around.line = around.way;
  return around;
}

Surroundings OracleScene::surroundings(const std::vector<std::size_t>& without, Hand hand) const {
  Surroundings around;
  const BoxObstacle counter = counter_top();
  around.way.boxes.push_back(counter);
  around.line.boxes.push_back(counter);
  const double wall = world_.station().basket.wall_m;
  for (const ContainerBox& box : boxes_of(world_.station().container())) {
    const Pose pose = world_.basket_pose() * box.container_from_box;
    around.way.boxes.push_back({pose, box.half_size});
    if (hand == Hand::outside) around.line.boxes.push_back({pose, box.half_size});
    const bool is_wall = std::abs(box.half_size.x - wall / 2) < 1e-9;
    if (!is_wall || hand == Hand::outside) continue;  // a ledge, or there already
    // Boxes have their outer face towards their own +X.
    const Pose skin = pose * Pose{{box.half_size.x - skin_m / 2, 0, -below_rim_m / 2}, {}};
    around.line.boxes.push_back(
        {skin, {skin_m / 2, box.half_size.y, box.half_size.z - below_rim_m / 2}});
  }
  for (std::size_t item = 0; item < items(); ++item) {
    if (std::ranges::find(without, item) == without.end()) add_item(item, around.way);
  }
  return around;
}

}  // namespace marketgen
