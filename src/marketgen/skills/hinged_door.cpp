#include "skills/hinged_door.h"

namespace marketgen::skills {

Quaternion HingedDoor::turned(double position_rad) const {
  return rotation_about({0, 0, 1}, turn() * position_rad);
}

Vec3 HingedDoor::point_at(double position_rad,
                          double along_m,
                          double out_m,
                          double height_m) const {
  Vec3 point = hinge + rotate(turned(position_rad), along * along_m + out * out_m);
  point.z = height_m;
  return point;
}

motion::Obstacles HingedDoor::leaf_at(double position_rad) const {
  const Quaternion by = turned(position_rad);
  const Pose moved{hinge - rotate(by, hinge), by};
  motion::Obstacles there = leaf;
  for (motion::BoxObstacle& box : there.boxes)
    box.pose = moved * box.pose;
  for (motion::CylinderObstacle& cylinder : there.cylinders)
    cylinder.pose = moved * cylinder.pose;
  return there;
}

std::array<Vec3, 4> HingedDoor::outline_at(double position_rad) const {
  const double front_m = bar.out_m + bar.radius_m;
  return {point_at(position_rad, 0, back_m, 0),
          point_at(position_rad, length_m, back_m, 0),
          point_at(position_rad, length_m, front_m, 0),
          point_at(position_rad, 0, front_m, 0)};
}

}  // namespace marketgen::skills
