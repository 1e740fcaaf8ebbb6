#include "policy/aisle_tour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen::policy {
namespace {

// From a shelf's front to the base's middle: all boards are seen well from the first of them.
constexpr std::array view_distances_m{1.05, 0.95, 1.15, 0.85, 0.75, 0.66};
constexpr double same_front_m = 0.25;
constexpr double of_way = 0.25;  // metres off the category's place that a metre of way is worth
constexpr std::size_t max_ways = 12;  // that are measured, of the stops nearest to the hint

}  // namespace

std::optional<robots::BasePlace> view_place(const agent::AisleMap& map, const Pose& faced) {
  const Vec3 out = rotate(faced.rotation, {0, -1, 0});
  const double heading = std::atan2(-out.y, -out.x);
  for (const double distance : view_distances_m) {
    const Vec3 at = faced.position + out * distance;
    const robots::BasePlace place{at.x, at.y, heading};
    if (map.has_room(place)) return place;
  }
  return std::nullopt;
}

std::vector<ViewStop> view_stops(const agent::AisleMap& map) {
  std::vector<ViewStop> stops;
  for (const agent::ShelfBoard& board : map.boards()) {
    if (!can_be_fetched_from(board)) continue;
    const auto place = view_place(map, board.store_from_board);
    if (!place) continue;
    const Vec2 front{board.store_from_board.position.x, board.store_from_board.position.y};
    const bool known = std::ranges::any_of(stops, [&](const ViewStop& stop) {
      return distance(stop.front, front) < same_front_m &&
             std::abs(std::remainder(stop.place.heading - place->heading, 2 * M_PI)) < 0.1;
    });
    if (!known) stops.push_back({*place, front});
  }
  return stops;
}

std::optional<std::size_t> next_stop(const agent::AisleMap& map,
                                     const std::vector<ViewStop>& stops,
                                     const std::vector<bool>& seen,
                                     const robots::BasePlace& from,
                                     Vec2 hint,
                                     double max_m) {
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t i = 0; i < stops.size(); ++i)
    if (const double off = distance(stops[i].front, hint); !seen[i] && off <= max_m)
      near.emplace_back(off, i);
  std::ranges::stable_sort(near);
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t i = 0, measured = 0; i < near.size() && measured < max_ways; ++i) {
    const auto& [off, stop] = near[i];
    const auto way = map.way_m(from, stops[stop].place);
    if (!way) continue;
    ++measured;
    if (const double cost = off + of_way * *way; !best || cost < least) {
      best = stop;
      least = cost;
    }
  }
  return best;
}

}  // namespace marketgen::policy
