#include "assets/people/person_frame.h"

#include <algorithm>
#include <cmath>

namespace marketgen::assets {
namespace {

constexpr double sole_m = 0.022;       // of a shoe under the foot
constexpr double straight = 0.995;     // a leg is never longer than so much of its bones
constexpr float head_middle = 0.933F;  // height between the ears, share of stature

// The middle joint of two bones from `root` to `end`, bent towards `bend`.
Vec3f middle_joint(Vec3f root, Vec3f end, float first, float second, Vec3f bend) {
  const Vec3f way = end - root;
  const float far = std::clamp(length(way), 0.2F * first, (first + second) * 0.9999F);
  const Vec3f along = normalized(way);
  const float at = (first * first - second * second + far * far) / (2 * far);
  const float out = std::sqrt(std::max(first * first - at * at, 0.0F));
  return root + along * at + normalized(bend - along * dot(bend, along)) * out;
}

// Sole and ankle of a foot.
LegJoints foot_of(const FootPlace& place, const FootMeasures& foot) {
  const double c = std::cos(place.yaw_rad), s = std::sin(place.yaw_rad);
  const auto at = [&](double ahead, double up) {
    return to_float(place.ball + Vec3{c * ahead, s * ahead, up});
  };
  const double cp = std::cos(place.pitch_rad), sp = std::sin(place.pitch_rad);
  const auto on_rear = [&](double behind, double height) {
    return at(-behind * cp + height * sp, behind * sp + height * cp);
  };
  const double toe = place.toe_rad - place.pitch_rad;
  LegJoints leg{};
  leg.ball = to_float(place.ball);
  leg.heel = on_rear(foot.heel_behind_ball_m, 0);
  leg.ankle = on_rear(foot.ankle_behind_ball_m, foot.ankle_height_m);
  leg.toe = at(foot.toes_before_ball_m * std::cos(toe), foot.toes_before_ball_m * std::sin(toe));
  return leg;
}

// How high the hips may be so that both legs reach their ankles.
double hip_height(const std::array<LegJoints, 2>& legs, double hip_y, double unit, double upright) {
  const double reach = straight * (share::thigh + share::shank) * unit;
  double height = upright;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 ankle = to_double(legs[i].ankle);
    const double dy = ankle.y - static_cast<double>(side_of(i)) * hip_y;
    const double across = ankle.x * ankle.x + dy * dy;
    height = std::min(height, ankle.z + std::sqrt(std::max(reach * reach - across, 0.01)));
  }
  return height;
}

Vec3f wrist_target(ArmUse use, float side, float unit, Vec3f chest) {
  if (use == ArmUse::rest) return {chest.x + 0.108F * unit, side * 0.03F * unit, 0.59F * unit};
  return {chest.x + 0.125F * unit, side * 0.085F * unit, 0.62F * unit};
}

ArmJoints hanging_arm(Vec3f shoulder, float side, double forward, bool loaded, float unit) {
  const double spread = loaded ? 0.24 : 0.13;
  const double bend = loaded ? 0.06 : 0.20 + 0.55 * std::max(forward, 0.0);
  const auto pointing = [&](double angle, double out) {
    return normalized(Vec3f{static_cast<float>(std::sin(angle)),
                            side * static_cast<float>(out),
                            -static_cast<float>(std::cos(angle))});
  };
  ArmJoints arm{};
  arm.shoulder = shoulder;
  arm.elbow = shoulder + pointing(forward - 0.06, spread) * (share::upper_arm * unit);
  const Vec3f fore = pointing(forward + bend, loaded ? 0.10 : 0.02);
  arm.wrist = arm.elbow + fore * (share::forearm * unit);
  arm.along = fore;
  arm.palm = Vec3f{0, -side, 0};
  return arm;
}

ArmJoints arm_of(Vec3f shoulder, float side, ArmUse use, double forward, float unit, Vec3f chest) {
  if (use == ArmUse::hang || use == ArmUse::basket)
    return hanging_arm(shoulder, side, forward, use == ArmUse::basket, unit);
  ArmJoints arm{};
  arm.shoulder = shoulder;
  arm.wrist = wrist_target(use, side, unit, chest);
  arm.elbow = middle_joint(shoulder,
                           arm.wrist,
                           share::upper_arm * unit,
                           share::forearm * unit,
                           {-0.5F, side * 0.55F, -0.7F});
  arm.along = normalized(arm.wrist - arm.elbow);
  arm.palm = use == ArmUse::rest ? Vec3f{-1, 0, 0} : Vec3f{0, -side, 0};
  return arm;
}

}  // namespace

FootMeasures foot_measures(const PersonLook& look) {
  const double foot = share::foot * look.stature_m;
  return {.ankle_behind_ball_m = 0.46 * foot,
          .heel_behind_ball_m = 0.70 * foot,
          .toes_before_ball_m = 0.30 * foot,
          .ankle_height_m = share::ankle * look.stature_m + sole_m,
          .hip_height_m = share::hip_height * look.stature_m + sole_m};
}

Vec3f PersonFrame::spine(float height) const {
  const float z = height * unit + pelvis;
  return {lean * (height - share::hip_height) * unit, 0, z};
}

PersonFrame frame_of(const PersonLook& look, const PersonPose& pose) {
  const FootMeasures foot = foot_measures(look);
  const bool woman = look.form == BodyForm::woman;
  PersonFrame frame{};
  const auto unit = static_cast<float>(look.stature_m);
  frame.unit = unit;
  frame.wide = static_cast<float>(look.girth);
  frame.broad = static_cast<float>(0.45 + 0.55 * look.girth) * (woman ? 0.92F : 1.0F);
  for (std::size_t i = 0; i < 2; ++i)
    frame.legs[i] = foot_of(pose.feet[i], foot);
  const double hip_y = 0.050 * look.stature_m;
  const double hips = hip_height(frame.legs, hip_y, look.stature_m, foot.hip_height_m);
  frame.pelvis = static_cast<float>(hips - share::hip_height * look.stature_m);
  frame.lean = static_cast<float>(std::tan(pose.lean_rad));
  for (std::size_t i = 0; i < 2; ++i) {
    LegJoints& leg = frame.legs[i];
    leg.hip = {0, side_of(i) * static_cast<float>(hip_y), static_cast<float>(hips)};
    const double yaw = pose.feet[i].yaw_rad;
    leg.knee = middle_joint(leg.hip,
                            leg.ankle,
                            share::thigh * unit,
                            share::shank * unit,
                            to_float(Vec3{std::cos(yaw), std::sin(yaw), 0}));
    const float shoulder_y = (woman ? 0.090F : 0.101F) * unit * (0.8F + 0.2F * frame.wide);
    Vec3f shoulder = frame.spine(share::shoulder_height);
    shoulder.x -= 0.010F * unit;
    shoulder.y = side_of(i) * shoulder_y;
    frame.arms[i] = arm_of(
        shoulder, side_of(i), pose.arms[i], pose.arm_forward_rad[i], unit, frame.spine(0.7F));
  }
  frame.neck = frame.spine(0.835F) + Vec3f{-0.012F * unit, 0, 0};
  frame.head = frame.spine(head_middle) + Vec3f{0.012F * unit, 0, 0};
  frame.head_size = 0.7F + 0.3F * unit / 1.75F;
  frame.head_left_rad = static_cast<float>(pose.head_left_rad);
  frame.head_down_rad = static_cast<float>(pose.head_down_rad);
  return frame;
}

PersonPose standing_pose(const PersonLook& look) {
  const FootMeasures foot = foot_measures(look);
  PersonPose pose;
  for (std::size_t i = 0; i < 2; ++i) {
    const double side = static_cast<double>(side_of(i));
    pose.feet[i].ball = {foot.ankle_behind_ball_m, side * standing_width * look.stature_m, 0};
    pose.feet[i].yaw_rad = side * standing_yaw;
  }
  return pose;
}

}  // namespace marketgen::assets
