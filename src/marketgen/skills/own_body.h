// What of a measured scene is the robot itself: it knows where its links are.
#pragma once
#include <span>
#include <vector>

#include "robots/robot.h"

namespace marketgen::skills {

// Points that lie in none of the robot's links, which stand at `frame_from_link`; points are in
// that frame.
std::vector<Vec3f> outside_body(const std::vector<Vec3f>& points,
                                const robots::Robot& robot,
                                std::span<const Pose> frame_from_link);

}  // namespace marketgen::skills
