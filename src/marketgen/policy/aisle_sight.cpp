#include "policy/aisle_sight.h"

#include <algorithm>
#include <cmath>

#include "perception/placed_surface.h"
#include "policy/aisle_tour.h"
#include "skills/own_body.h"

namespace marketgen::policy {
namespace {

constexpr double ahead_m = 2.0;  // boards whose middle is farther are seen too small
constexpr double cloud_spacing_m = 0.008, highest_point_m = 2.5;
constexpr float hidden_m = 0.03F;    // behind what is seen: something else
constexpr float min_facing = 0.25F;  // cosine; of surface that is turned to a camera
constexpr double min_shown = 0.3;    // of that

// Whether a picture shows what is there, in the base's frame.
bool is_seen(const std::vector<perception::ViewCloud>& views, Vec3f point) {
  return std::ranges::any_of(views, [&](const perception::ViewCloud& view) {
    const auto at = view.project(point);
    return at && view.has(at->pixel) && at->depth_m < view.view().depth_m[at->pixel] + hidden_m;
  });
}

}  // namespace

std::vector<perception::BoardAhead> ShelfSight::boards_ahead(const agent::AisleMap& map) const {
  const Pose base_from_store = inverse(agent::store_from_base(place_));
  std::vector<perception::BoardAhead> ahead;
  for (const agent::ShelfBoard& board : map.boards()) {
    if (!can_be_fetched_from(board)) continue;
    const Pose pose = base_from_store * board.store_from_board;
    const bool near = std::hypot(pose.position.x, pose.position.y) < ahead_m;
    const bool faces = dot(rotate(pose.rotation, {0, 1, 0}), pose.position) > 0;
    if (near && faces) ahead.push_back({pose, board.width_m, board.depth_m, board.clearance_m});
  }
  return ahead;
}

std::vector<ShelfFind> ShelfSight::find(std::size_t goal,
                                        const perception::WantedProduct& wanted,
                                        const agent::AisleMap& map,
                                        const perception::SpotSource& spots,
                                        const perception::ShelfChoice& choice) const {
  const std::vector<perception::BoardAhead> boards = boards_ahead(map);
  const Vec3f size = wanted.look->high() - wanted.look->low();
  const Pose store = agent::store_from_base(place_);
  std::vector<ShelfFind> finds;
  for (const perception::FoundOnShelf& found :
       choice.find(wanted, views_, boards, spots.spots(views_, boards, size)))
    finds.push_back({goal, store * found.pose.base_from_product, found.pose.evidence.score});
  return finds;
}

ShelfFind ShelfSight::again(const ShelfFind& known,
                            const perception::WantedProduct& wanted,
                            const perception::ShelfChoice& choice) const {
  const Pose store = agent::store_from_base(place_);
  const perception::FittedPose seen =
      choice.again(wanted, views_, inverse(store) * known.store_from_product);
  return {known.goal, store * seen.base_from_product, seen.evidence.score};
}

bool ShelfSight::shows(const ShelfFind& known, const perception::ProductLook& look) const {
  const perception::Placed placed(inverse(agent::store_from_base(place_)) *
                                  known.store_from_product);
  double turned_here = 0, seen = 0;
  for (const perception::Surfel& surfel : look.surfels()) {
    const Vec3f point = placed(surfel.point), normal = placed.turned(surfel.normal);
    const auto faces = [&](const perception::ViewCloud& view) {
      return dot(normal, normalized(view.eye() - point)) > min_facing;
    };
    if (std::ranges::none_of(views_, faces)) continue;
    ++turned_here;
    if (is_seen(views_, point)) ++seen;
  }
  return seen >= min_shown * turned_here && seen > 0;
}

std::vector<agent::LookedAt> ShelfSight::looked_at(std::vector<FoundShape> found) const {
  const Pose base_from_store = inverse(agent::store_from_base(place_));
  for (FoundShape& each : found)
    each.base_from_product = base_from_store * each.base_from_product;
  return policy::looked_at(views_, {}, found);
}

std::vector<Vec3f> ShelfSight::points(const robots::Robot& robot,
                                      const std::vector<double>& state) const {
  const std::vector<Vec3f> kept =
      skills::outside_body(perception::thinned_points(views_, cloud_spacing_m, highest_point_m),
                           robot,
                           robots::link_poses(robot, state));
  const Pose store = agent::store_from_base(place_);
  std::vector<Vec3f> points;
  for (const Vec3f& point : kept)
    points.push_back(to_float(store * to_double(point)));
  return points;
}

std::vector<Vec3f> ShelfSight::points_beside(const std::vector<Vec3f>& before,
                                             const robots::Robot& robot,
                                             const std::vector<double>& state) const {
  std::vector<Vec3f> all = points(robot, state);
  const Pose base_from_store = inverse(agent::store_from_base(place_));
  for (const Vec3f& point : before)
    if (!is_seen(views_, to_float(base_from_store * to_double(point)))) all.push_back(point);
  return all;
}

}  // namespace marketgen::policy
