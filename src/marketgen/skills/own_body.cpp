#include "skills/own_body.h"

#include <algorithm>

namespace marketgen::skills {
namespace {

// Round the spheres of the robot: cameras and joints are a few millimetres off, and a depth camera
// shows what is near larger than it is.
constexpr double own_body_m = 0.02;

}  // namespace

std::vector<Vec3f> outside_body(const std::vector<Vec3f>& points,
                                const robots::Robot& robot,
                                std::span<const Pose> frame_from_link) {
  std::vector<robots::Sphere> body;
  for (std::size_t link = 0; link < frame_from_link.size(); ++link)
    for (const robots::Sphere& sphere : robot.links[link].spheres)
      body.push_back({frame_from_link[link] * sphere.center, sphere.radius + own_body_m});
  std::vector<Vec3f> kept;
  for (const Vec3f& point : points) {
    const bool own = std::ranges::any_of(body, [&](const robots::Sphere& sphere) {
      return length(to_double(point) - sphere.center) < sphere.radius;
    });
    if (!own) kept.push_back(point);
  }
  return kept;
}

}  // namespace marketgen::skills
