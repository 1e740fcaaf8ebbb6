#include "skills/counter_obstacles.h"

#include <cmath>

namespace marketgen::skills {
namespace {

constexpr double skin_m = 0.002, below_rim_m = 0.015;
constexpr double counter_half_m = 0.03;  // of its thickness

motion::BoxObstacle counter_top(const agent::WorkArea& counter) {
  const auto& [low, high] = counter;
  return {{{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, -counter_half_m}, {}},
          {(high[0] - low[0]) / 2, (high[1] - low[1]) / 2, counter_half_m}};
}

}  // namespace

bool is_over_basket(const agent::Workplace& place, Vec3 base_point) {
  const Vec3 at = inverse(place.base_from_basket) * base_point;
  return std::abs(at.x) < place.inner_half.x && std::abs(at.y) < place.inner_half.y;
}

Surroundings counter_alone(const agent::Workplace& place) {
  Surroundings around;
  around.way.boxes.push_back(counter_top(place.counter));
  around.line = around.way;
  return around;
}

Surroundings counter_surroundings(const agent::Workplace& place, HandAt hand) {
  Surroundings around = counter_alone(place);
  for (const auto* boxes : {&place.walls, &place.ledges})
    for (const agent::WorkBox& box : *boxes)
      around.way.boxes.push_back({place.base_from_basket * box.pose, box.half_size});
  if (hand == HandAt::counter) {
    around.line = around.way;
    return around;
  }
  for (const agent::WorkBox& wall : place.walls) {
    // Boxes have their outer face towards their own +X.
    const Pose skin = place.base_from_basket * wall.pose *
                      Pose{{wall.half_size.x - skin_m / 2, 0, -below_rim_m / 2}, {}};
    around.line.boxes.push_back(
        {skin, {skin_m / 2, wall.half_size.y, wall.half_size.z - below_rim_m / 2}});
  }
  return around;
}

}  // namespace marketgen::skills
