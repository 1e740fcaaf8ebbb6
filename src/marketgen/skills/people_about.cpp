#include "skills/people_about.h"

#include <algorithm>
#include <cmath>

namespace marketgen::skills {

std::vector<motion::MovingDisc> people_about(const agent::Observation& now) {
  std::vector<motion::MovingDisc> people = now.people;
  const double c = std::cos(now.base.heading), s = std::sin(now.base.heading);
  for (motion::MovingDisc& person : people) {
    const Vec2 at = person.position;
    person.position = {now.base.x_m + c * at.x - s * at.y, now.base.y_m + s * at.x + c * at.y};
    person.radius += clear_of_people_m;
  }
  return people;
}

bool is_in_way(const agent::Observation& now, bool back) {
  const motion::BaseOptions base;
  return std::ranges::any_of(now.people, [&](const motion::MovingDisc& person) {
    const double ahead = back ? -person.position.x : person.position.x;
    const double beside = base.base_radius + base.margin + person.radius;
    return ahead > 0 && ahead < beside + clear_of_people_m && std::abs(person.position.y) < beside;
  });
}

}  // namespace marketgen::skills
