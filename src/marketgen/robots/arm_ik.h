// Analytic inverse kinematics of the three arm families: RM65 (6R, spherical wrist), RM75 (7R,
// spherical shoulder and wrist) and Panda (7R with elbow and wrist offsets).
//
// The seven-joint arms have one free parameter, the redundancy: for RM75 the swivel of the elbow
// about the line from shoulder to wrist, -pi..pi, 0 = elbow as high as it can be; for Panda the
// value of joint 7. RM65 ignores it.
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "robots/robot.h"

namespace marketgen::robots {

using ArmJoints = std::array<double, 7>;  // RM65 leaves the last at 0

enum class ArmFamily { rm65, rm75, panda };
constexpr std::array<std::string_view, 3> names_of(ArmFamily) {
  return {"rm65", "rm75", "panda"};
}

// What the solver needs of a group; made once.
struct ArmIk {
  ArmFamily family = ArmFamily::rm65;
  int joints = 6;
  double shoulder = 0;         // height of the shoulder over the arm's base, m
  double upper = 0, fore = 0;  // shoulder to elbow, elbow to wrist along the arm, m
  double elbow = 0;            // Panda: offset of the elbow, m
  double wrist = 0;            // Panda: offset of joint 7 from the wrist; m
  double hand = 0;             // RM: wrist to last joint frame, m
  Pose last_from_tip;          // the tip in the last link's frame
  ArmJoints lower{}, upper_limit{};
};

// Errors: robot.unknown when the group has no tip or no analytic solver, or its joints are not laid
// out as the solver's family is.
Result<ArmIk> make_arm_ik(const Robot& robot, const JointGroup& group);

// Every joint vector within the limits that brings the tip to `base_from_tip` (base: the group's
// base link), turns by whole revolutions included; at most 1e-9 m and rad off. Empty when the pose
// is out of reach at this redundancy. Deterministic order.
std::vector<ArmJoints> solve_arm(const ArmIk& arm, const Pose& base_from_tip, double redundancy);

struct SweepOptions {
  int steps = 24;  // values of the redundancy that are tried
};
// The values that a sweep tries, ascending; one for an arm without redundancy.
std::vector<double> redundancies(const ArmIk& arm, const SweepOptions& options = {});
// The solution nearest to `seed` (largest joint difference) over a sweep of the redundancy, the
// seed's own value first. Error: robot.unreachable.
Result<ArmJoints> nearest_arm_solution(const ArmIk& arm,
                                       const Pose& base_from_tip,
                                       const ArmJoints& seed,
                                       const SweepOptions& options = {});

}  // namespace marketgen::robots
