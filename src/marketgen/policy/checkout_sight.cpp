#include "policy/checkout_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "skills/own_body.h"

namespace marketgen::policy {
namespace {

constexpr double point_spacing_m = 0.003, highest_goods_m = 0.33;
constexpr double column_m = 0.02, min_column_m = 0.012;  // of what stands about, as boxes
constexpr std::size_t stray_points = 2;                  // in a column that do not count
constexpr double round_basket_m = 0.03;

// Goods in the basket, and what stands on the counter beside it.
std::vector<std::uint8_t> goods_pixels(const perception::ViewCloud& cloud,
                                       const agent::Workplace& place) {
  std::vector<std::uint8_t> wanted =
      perception::goods_in_basket(cloud, place, place.base_from_basket);
  agent::WorkArea before_arm = place.counter;
  before_arm.low_m[0] = place.set_aside.low_m[0];
  const std::vector<std::uint8_t> beside = perception::goods_over(cloud, before_arm);
  const Vec3 at = place.base_from_basket.position, half = place.inner_half;
  const agent::WorkArea basket{{at.x - half.x - round_basket_m, at.y - half.y - round_basket_m},
                               {at.x + half.x + round_basket_m, at.y + half.y + round_basket_m}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Vec3f p = cloud.point(i);
    if (beside[i] != 0 && !basket.holds(p.x, p.y)) wanted[i] = 1;
  }
  return wanted;
}

// Upright boxes under the points, but for a few strays.
void add_columns(const std::vector<Vec3f>& points, std::vector<motion::BoxObstacle>& boxes) {
  // The highest of each cell, highest first.
  std::map<std::pair<int, int>, std::array<float, stray_points + 1>> tops;
  for (const Vec3f& p : points) {
    if (p.z < static_cast<float>(min_column_m)) continue;
    const auto cell = [](float v) {
      return static_cast<int>(std::floor(static_cast<double>(v) / column_m));
    };
    float lower = p.z;
    for (float& top : tops[{cell(p.x), cell(p.y)}])
      if (lower > top) std::swap(lower, top);
  }
  for (const auto& [cell, highest] : tops) {
    const double half = static_cast<double>(highest.back()) / 2;
    if (half <= 0) continue;
    boxes.push_back({{{(cell.first + 0.5) * column_m, (cell.second + 0.5) * column_m, half}, {}},
                     {column_m / 2, column_m / 2, half}});
  }
}

}  // namespace

std::vector<Vec3f> without_robot(const std::vector<Vec3f>& points,
                                 const robots::Robot& robot,
                                 const agent::Observation& now) {
  const robots::JointGroup& arm = *robot.find_group("arm");
  std::vector<double> q = robots::neutral_state(robot);
  for (std::size_t j = 0; j < arm.dofs.size(); ++j)
    q[static_cast<std::size_t>(arm.dofs[j])] = now.position[j];
  if (const robots::JointGroup* fingers = robot.find_group("fingers"))
    for (const int dof : fingers->dofs)
      q[static_cast<std::size_t>(dof)] = now.openings_m.front() / 2;
  std::vector<Pose> links = robots::link_poses(robot, robots::with_followers(robot, q));
  const Pose base_from_robot = inverse(links[static_cast<std::size_t>(arm.base)]);
  for (Pose& link : links)
    link = base_from_robot * link;
  return skills::outside_body(points, robot, links);
}

Sight sight_of(std::vector<perception::ViewCloud> views,
               const agent::Workplace& place,
               const perception::MaskSource& masks,
               const perception::TargetChoice& targets,
               const std::vector<perception::WantedProduct>& wanted) {
  Sight sight;
  sight.views = std::move(views);
  for (std::size_t v = 0; v < sight.views.size(); ++v)
    sight.masked.push_back({v, masks.masks(sight.views[v], goods_pixels(sight.views[v], place))});
  sight.found = targets.find(wanted, sight.views, sight.masked);
  sight.points = perception::thinned_points(sight.views, point_spacing_m, highest_goods_m);
  return sight;
}

skills::Surroundings seen_surroundings(const agent::Workplace& place,
                                       const std::vector<Vec3f>& points,
                                       skills::HandAt hand) {
  skills::Surroundings around = skills::counter_surroundings(place, hand);
  add_columns(points, around.way.boxes);
  return around;
}

}  // namespace marketgen::policy
