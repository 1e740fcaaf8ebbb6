// The joints of a posed person, from which body and clothes are drawn. Person frame, metres.
#pragma once
#include <array>

#include "assets/people/person.h"

namespace marketgen::assets {

// Shares of stature (Drillis and Contini), and half widths of the trunk.
namespace share {
inline constexpr float ankle = 0.039F, shank = 0.246F, thigh = 0.245F, hip_height = 0.528F;
inline constexpr float upper_arm = 0.172F, forearm = 0.146F, hand = 0.108F;
// Of the joint; the acromion lies at 0.818, and the arm is as much shorter.
inline constexpr float shoulder_height = 0.797F;
inline constexpr float foot = 0.152F;
}  // namespace share

struct ArmJoints {
  Vec3f shoulder, elbow, wrist;
  Vec3f along;  // of the hand, from the wrist; unit
  Vec3f palm;   // where the palm looks; unit
};
struct LegJoints {
  Vec3f hip, knee, ankle, heel, ball, toe;  // heel, ball, toe: on the sole
};
struct PersonFrame {
  float unit;    // stature: shares times this are metres
  float broad;   // of limbs: their girth
  float wide;    // of the trunk
  float pelvis;  // height of the hips, over that of a person who stands upright: 0 or less
  float lean;    // tangent of the trunk's lean
  std::array<LegJoints, 2> legs;
  std::array<ArmJoints, 2> arms;
  Vec3f neck;       // its foot
  Vec3f head;       // between the ears
  float head_size;  // 1: of a person of 1.75 m
  float head_left_rad, head_down_rad;

  // A height (share of stature) on the trunk, at its middle.
  Vec3f spine(float height) const;
  float waist_height() const { return 0.6F * unit + pelvis; }
};

// Of feet at ease: half of their width, a share of stature; toes turned out by so much.
inline constexpr double standing_width = 0.062, standing_yaw = 0.14;

inline float side_of(std::size_t limb) {  // +1 left, -1 right
  return limb == 0 ? 1.0F : -1.0F;
}

PersonFrame frame_of(const PersonLook& look, const PersonPose& pose);

}  // namespace marketgen::assets
