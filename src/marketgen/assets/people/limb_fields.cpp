// Hands, bare forearms and bare legs; baskets and boxes in hands.
#include <cmath>

#include "assets/people/part_fields.h"
#include "assets/people/soft_shapes.h"

namespace marketgen::assets {
namespace {

constexpr float skin_depth_m = 0.004F;
constexpr float basket_length_m = 0.42F, basket_width_m = 0.28F, basket_height_m = 0.22F;

struct Hand {
  Vec3f wrist, along, palm, thumb_side;
  float unit;  // length of the hand
  float curl;  // of the fingers, radians a joint
  float broad;

  Vec3f at(float ahead, float aside, float in) const {
    return wrist + along * (ahead * unit) + thumb_side * (aside * unit) + palm * (in * unit);
  }
};

Hand hand_of(const PersonFrame& frame, std::size_t side, ArmUse use) {
  const ArmJoints& arm = frame.arms[side];
  Hand hand{};
  hand.wrist = arm.wrist;
  hand.along = arm.along;
  hand.palm = normalized(arm.palm - arm.along * dot(arm.palm, arm.along));
  const Vec3f across = cross(hand.palm, hand.along);
  hand.thumb_side = side == 0 ? across : -across;
  if (hand.thumb_side.x + hand.thumb_side.z < 0) hand.thumb_side = -hand.thumb_side;
  hand.unit = share::hand * frame.unit;
  hand.curl = use == ArmUse::basket ? 1.25F : use == ArmUse::carry ? 0.15F : 0.42F;
  hand.broad = frame.broad;
  return hand;
}

float finger(Vec3f p, const Hand& hand, float aside, float length_share, float thick) {
  const float r = thick * hand.unit * hand.broad;
  Vec3f from = hand.at(0.50F, aside, 0.0F);
  float d = 1;
  float angle = hand.curl * 0.5F;
  for (const float piece : {0.45F, 0.32F, 0.23F}) {
    const Vec3f along = hand.along * std::cos(angle) + hand.palm * std::sin(angle);
    const Vec3f to = from + along * (piece * length_share * hand.unit);
    d = std::min(d, round_cone(p, from, to, r, r * 0.92F));
    from = to;
    angle += hand.curl;
  }
  return d;
}

float hand_field(Vec3f p, const Hand& hand) {
  const float b = hand.broad;
  float palm = 1;
  for (const float aside : {-0.14F, -0.045F, 0.05F, 0.145F})
    palm = soft_min(palm,
                    round_cone(p,
                               hand.at(0.10F, aside * 0.62F, 0),
                               hand.at(0.48F, aside, 0),
                               0.075F * hand.unit * b,
                               0.062F * hand.unit * b),
                    0.012F);
  float d = soft_min(palm, finger(p, hand, -0.148F, 0.36F, 0.043F), 0.008F);
  d = soft_min(d, finger(p, hand, -0.05F, 0.46F, 0.047F), 0.008F);
  d = soft_min(d, finger(p, hand, 0.05F, 0.49F, 0.048F), 0.008F);
  d = soft_min(d, finger(p, hand, 0.148F, 0.45F, 0.046F), 0.008F);
  const Vec3f root = hand.at(0.14F, 0.12F, 0.05F), knuckle = hand.at(0.36F, 0.27F, 0.10F);
  d = soft_min(
      d, round_cone(p, root, knuckle, 0.075F * hand.unit * b, 0.052F * hand.unit * b), 0.016F);
  return soft_min(
      d,
      round_cone(
          p, knuckle, hand.at(0.56F, 0.27F, 0.16F), 0.052F * hand.unit * b, 0.042F * hand.unit * b),
      0.006F);
}

PartField bare_leg(const PersonLook& look, const PersonFrame& frame, std::size_t leg) {
  const LegJoints& l = frame.legs[leg];
  return {leg == 0 ? "left leg" : "right leg",
          [&frame, leg](Vec3f p) { return leg_field(p, frame, leg, 0); },
          bounds_round({l.hip, l.knee, l.ankle}, 0.16F),
          0.008F,
          look.skin,
          0.5F,
          skin_depth_m};
}

PartField hand_part(const PersonLook& look,
                    const PersonPose& pose,
                    const PersonFrame& frame,
                    std::size_t arm) {
  const Hand hand = hand_of(frame, arm, pose.arms[arm]);
  const bool bare = look.top == TopWear::t_shirt;
  const Vec3f from = bare ? frame.arms[arm].elbow : frame.arms[arm].wrist;
  const float reach = 0.03F * frame.unit;
  return {arm == 0 ? "left hand" : "right hand",
          [&frame, hand, arm, bare, reach](Vec3f p) {
            const ArmJoints& a = frame.arms[arm];
            // A stump of the forearm, hidden in the sleeve.
            const Vec3f back = a.wrist - a.along * (1.3F * reach);
            const float w = 0.0155F * frame.unit * frame.broad;
            const float fore =
                bare ? arm_field(p, frame, arm, 0) : round_cone(p, back, a.wrist, w * 1.05F, w);
            return soft_min(fore, hand_field(p, hand), 0.014F);
          },
          bounds_round({frame.arms[arm].wrist + frame.arms[arm].along * (0.6F * hand.unit),
                        from,
                        bare ? frame.arms[arm].shoulder : from},
                       0.16F),
          0.0042F,
          look.skin,
          0.5F,
          skin_depth_m};
}

// Beneath the hand, as wide as its handles let it hang.
PartField basket(const PersonLook& look, const PersonFrame& frame, std::size_t arm) {
  const ArmJoints& a = frame.arms[arm];
  const Vec3f grip = a.wrist + a.along * (0.062F * frame.unit) + a.palm * (0.012F * frame.unit);
  const Vec3f rim = grip - Vec3f{0, 0, 0.13F};
  const auto field = [grip, rim](Vec3f p) {
    const float height = basket_height_m;
    const float down = std::clamp((rim.z - p.z) / height, 0.0F, 1.0F);
    const float shrink = 1 - 0.14F * down;
    const Vec3f half{basket_length_m / 2 * shrink, basket_width_m / 2 * shrink, height / 2};
    const Vec3f middle = rim - Vec3f{0, 0, height / 2};
    const float outer = round_box(p, middle, half, 0.03F);
    const float inner =
        round_box(p, middle + Vec3f{0, 0, 0.03F}, half - Vec3f{0.005F, 0.005F, -0.02F}, 0.028F);
    float d = soft_max(outer, -inner, 0.003F);
    const float lip = round_box(p, rim, {half.x + 0.009F, half.y + 0.009F, 0.012F}, 0.011F);
    const float hole = round_box(p, rim, {half.x - 0.004F, half.y - 0.004F, 0.05F}, 0.03F);
    d = std::min(d, soft_max(lip, -hole, 0.003F));
    for (const float s : {-1.0F, 1.0F}) {  // the handle
      const Vec3f end{rim.x + s * 0.19F, rim.y, rim.z}, bow{grip.x + s * 0.07F, grip.y, grip.z};
      d = std::min(d, round_cone(p, end, bow, 0.007F, 0.007F));
      d = std::min(d, round_cone(p, bow, grip, 0.007F, 0.011F));
    }
    return d;
  };
  return {"basket",
          field,
          bounds_round({grip, rim - Vec3f{0, 0, basket_height_m}}, 0.30F),
          0.0045F,
          look.basket_color,
          0.45F};
}

PartField box_between(const PersonFrame& frame) {
  const Vec3f l = frame.arms[0].wrist + frame.arms[0].along * (0.05F * frame.unit);
  const Vec3f r = frame.arms[1].wrist + frame.arms[1].along * (0.05F * frame.unit);
  const Vec3f middle = (l + r) * 0.5F + Vec3f{0.03F, 0, 0.01F};
  const Vec3f half{0.11F, std::max(std::abs(l.y - r.y) * 0.5F - 0.018F, 0.04F), 0.09F};
  return {"box",
          [=](Vec3f p) { return round_box(p, middle, half, 0.004F); },
          bounds_round({middle - half, middle + half}, 0.05F),
          0.007F,
          {0.42F, 0.27F, 0.14F},
          0.85F};
}

}  // namespace

std::vector<PartField> limb_fields(const PersonLook& look,
                                   const PersonPose& pose,
                                   const PersonFrame& frame) {
  std::vector<PartField> parts{hand_part(look, pose, frame, 0), hand_part(look, pose, frame, 1)};
  if (look.legs == LegWear::skirt) {
    parts.push_back(bare_leg(look, frame, 0));
    parts.push_back(bare_leg(look, frame, 1));
  }
  return parts;
}

std::vector<PartField> carried_fields(const PersonLook& look,
                                      const PersonPose& pose,
                                      const PersonFrame& frame) {
  std::vector<PartField> parts;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    if (pose.arms[arm] == ArmUse::basket) parts.push_back(basket(look, frame, arm));
  }
  if (pose.arms[0] == ArmUse::carry && pose.arms[1] == ArmUse::carry)
    parts.push_back(box_between(frame));
  return parts;
}

}  // namespace marketgen::assets
