// Clothes, cut after the body: offsets of its shapes that end at hems, with folds where cloth
// bends.
#include <cmath>

#include "assets/people/part_fields.h"
#include "assets/people/soft_shapes.h"

namespace marketgen::assets {
namespace {

constexpr float trousers_over = 0.004F, skirt_over = 0.008F, skirt_flare = 0.09F;
constexpr float skirt_hem = 0.27F;  // height, share of stature

// How far over the skin, metres.
struct GarmentCut {
  float trunk, sleeve;
  float sleeve_end;  // share of the whole arm
  float hem;         // height, share of stature
  float flare;       // how much wider the hem is, metres a metre below the waist
};
GarmentCut cut_of(TopWear wear) {
  switch (wear) {
    case TopWear::t_shirt:
      return {0.009F, 0.014F, 0.34F, 0.485F, 0.02F};
    case TopWear::shirt:
      return {0.010F, 0.010F, 0.985F, 0.475F, 0.03F};
    case TopWear::jacket:
      return {0.021F, 0.016F, 1.0F, 0.462F, 0.02F};
    case TopWear::coat:
      break;
  }
  return {0.026F, 0.019F, 1.0F, 0.335F, 0.10F};
}

// Folds across a limb near its joint, as waves along it.
float folds(Vec3f p, Vec3f from, Vec3f joint, float depth, float reach) {
  const Vec3f axis = normalized(joint - from);
  const Vec3f d = p - joint;
  const float along = dot(d, axis);
  const float fade = std::max(1 - std::abs(along) / reach, 0.0F);
  const float turn = dot(d, Vec3f{axis.z, 0.3F, -axis.x});
  return depth * fade * fade * std::sin(along * 78 + turn * 40 + 2.2F * std::sin(turn * 23));
}

// The length of an arm up to where `p` lies beside it, share of the whole.
float way_down_arm(Vec3f p, const ArmJoints& arm) {
  const Vec3f upper = arm.elbow - arm.shoulder, fore = arm.wrist - arm.elbow;
  const float l1 = length(upper), l2 = length(fore);
  const float u = dot(p - arm.shoulder, upper) / l1;
  const float v = dot(p - arm.elbow, fore) / l2;
  const Vec3f bisector = normalized(upper / l1 + fore / l2);
  return (dot(p - arm.elbow, bisector) < 0 ? std::min(u, l1) : l1 + std::max(v, 0.0F)) / (l1 + l2);
}

float sleeve(Vec3f p, const PersonFrame& frame, std::size_t i, const GarmentCut& cut) {
  const ArmJoints& arm = frame.arms[i];
  const float whole = length(arm.elbow - arm.shoulder) + length(arm.wrist - arm.elbow);
  float d = arm_field(p, frame, i, cut.sleeve) + folds(p, arm.shoulder, arm.elbow, 0.0026F, 0.11F);
  const float past = (way_down_arm(p, arm) - cut.sleeve_end) * whole;
  return soft_max(d, past, 0.008F);
}

// The trunk's girths stand still below the hips; cloth falls straight from there.
float skirt_of(Vec3f p, const PersonFrame& frame, float over, float top, float hem, float flare) {
  const float unit = frame.unit;
  const float down = std::max(0.53F * unit + frame.pelvis - p.z, 0.0F);
  const float w = frame.wide;
  Vec3f low[2];
  for (std::size_t i = 0; i < 2; ++i)
    low[i] = frame.legs[i].knee;
  // What hangs follows the thighs half way.
  const float ahead = 0.5F * (low[0].x + low[1].x);
  const float spread = 0.5F * std::abs(low[0].x - low[1].x);
  const float share_down = down / (0.25F * unit);
  const float x = p.x - ahead * 0.7F * share_down + 0.006F * unit;
  const float a = 0.064F * unit * w + over + flare * down + 0.75F * spread * share_down;
  const float b = 0.095F * unit * w + over + flare * down;
  const float u = std::sqrt(x * x / (a * a) + p.y * p.y / (b * b));
  const float round = std::atan2(p.y, x);
  const float waves = flare > 0.05F ? 0.09F * down * flare * std::sin(round * 9) : 0;
  const float side = (u - 1) * std::min(a, b) + waves;
  const float ends = std::max(hem - p.z, p.z - top);
  return soft_max(side, ends, 0.010F);
}

float trouser_leg(Vec3f p, const PersonFrame& frame, std::size_t i) {
  const LegJoints& l = frame.legs[i];
  const float w = frame.unit * frame.broad;
  const Vec3f end = l.ankle + (l.ankle - l.knee) * 0.02F;
  float d = round_cone(p, l.hip, l.knee, 0.056F * w + 0.006F, 0.038F * w + 0.006F);
  d = soft_min(d, round_cone(p, l.knee, end, 0.038F * w + 0.006F, 0.034F * w + 0.010F), 0.03F);
  d += folds(p, l.hip, l.knee, 0.0022F, 0.12F) + folds(p, l.knee, l.ankle, 0.0040F, 0.11F) +
       folds(p, l.knee, l.hip, 0.0030F, 0.09F);
  const Vec3f down = normalized(l.ankle - l.knee);
  return soft_max(d, dot(p - end, down) - 0.012F, 0.006F);
}

// Without the waistband's end.
float trouser_cloth(Vec3f p, const PersonFrame& frame, const TrunkField& hips) {
  const float legs = std::min(trouser_leg(p, frame, 0), trouser_leg(p, frame, 1));
  return soft_min(hips(p), legs, 0.025F * frame.unit);
}

float trousers(Vec3f p, const PersonFrame& frame, const TrunkField& hips) {
  const float top = 0.575F * frame.unit + frame.pelvis;
  return soft_max(trouser_cloth(p, frame, hips), p.z - top, 0.01F);
}

// A skirt over thighs that push it out when they walk; heights in shares of stature.
float skirt(Vec3f p, const PersonFrame& frame, float top, float hem) {
  const float unit = frame.unit, low = hem * unit + frame.pelvis;
  float d = skirt_of(p, frame, skirt_over, top * unit + frame.pelvis, low, skirt_flare);
  for (std::size_t i = 0; i < 2; ++i) {
    const float thigh = soft_max(leg_field(p, frame, i, 0.010F), low - p.z, 0.010F);
    d = soft_min(d, thigh, 0.04F * unit);
  }
  return soft_max(d, low - p.z, 0.010F);
}

// What bulges under a shirt about the hips.
float hips_field(Vec3f p,
                 const PersonLook& look,
                 const PersonFrame& frame,
                 const TrunkField& hips) {
  if (look.legs == LegWear::trousers) return trouser_cloth(p, frame, hips);
  return skirt(p, frame, 0.60F, skirt_hem);
}

float collar_field(Vec3f p, const PersonLook& look, const PersonFrame& frame) {
  const float unit = frame.unit;
  const bool high = look.top != TopWear::t_shirt;
  const Vec3f at = frame.neck + Vec3f{0.002F * unit, 0, high ? 0.010F * unit : -0.001F * unit};
  const Vec3f level{p.x, p.y, p.z + 0.40F * (p.x - at.x)};  // lower in front
  const float neck = (look.form == BodyForm::woman ? 0.049F : 0.057F) * frame.broad;
  const float low = ring(level, at, neck + 0.006F, high ? 0.008F : 0.005F);
  if (!high) return low;
  return soft_min(low, ring(level, at + Vec3f{0, 0, 0.016F}, neck + 0.003F, 0.006F), 0.008F);
}

struct TopShapes {
  GarmentCut cut;
  TrunkField trunk, hips;
};

// Both sleeves; where neither is near, no more than the way to them.
float sleeves(float d, Vec3f p, const PersonFrame& frame, const GarmentCut& cut) {
  constexpr float near_m = 0.10F, thickest_m = 0.10F;
  for (std::size_t i = 0; i < 2; ++i) {
    const ArmJoints& arm = frame.arms[i];
    const float reach = std::max(length(arm.shoulder - arm.elbow), length(arm.wrist - arm.elbow));
    const float away = length(p - arm.elbow) - reach - thickest_m;
    d = away > near_m ? std::min(d, away)
                      : soft_min(d, sleeve(p, frame, i, cut), 0.014F * frame.unit);
  }
  return d;
}

float top_field(Vec3f p,
                const PersonLook& look,
                const PersonFrame& frame,
                const TopShapes& shapes) {
  const GarmentCut& cut = shapes.cut;
  const float unit = frame.unit;
  const float waist = frame.waist_height(), hem = cut.hem * unit + frame.pelvis;
  float d = shapes.trunk(p);
  const float hips = std::clamp((waist + 0.06F - p.z) / 0.12F, 0.0F, 1.0F);
  if (hips > 0)
    d = soft_min(d, hips_field(p, look, frame, shapes.hips) - 0.005F, 0.02F * unit * hips);
  if (look.top == TopWear::coat)
    d = soft_min(d, skirt_of(p, frame, cut.trunk, waist, hem - 0.02F, cut.flare), 0.05F * unit);
  d += 0.0016F * std::sin(p.z * 95 + 14 * p.y) * std::max(1 - std::abs(p.z - waist) / 0.14F, 0.0F);
  d = soft_max(sleeves(d, p, frame, cut), hem - p.z, 0.010F);
  return soft_min(d, collar_field(p, look, frame), 0.018F);
}

float shoe(Vec3f p, const PersonFrame& frame, std::size_t i) {
  const LegJoints& l = frame.legs[i];
  const float unit = frame.unit / 1.75F;
  const Vec3f up{0, 0, 1};
  const Vec3f fore = normalized(Vec3f{l.toe.x - l.ball.x, l.toe.y - l.ball.y, 0});
  const Vec3f rear = normalized(l.ball - l.heel);
  const Vec3f over = normalized(up - rear * dot(up, rear));
  const Vec3f aside = cross(up, fore);
  const auto rise = [&](Vec3f v, float h) { return v + over * (h * unit); };
  const float out = side_of(i) * 0.010F * unit;
  float d = round_cone(p,
                       rise(l.heel, 0.036F) + rear * (0.030F * unit),
                       rise(l.ball, 0.038F),
                       0.034F * unit,
                       0.036F * unit);
  d = soft_min(d,
               round_cone(p,
                          rise(l.ball, 0.036F) + aside * out,
                          l.toe + up * (0.028F * unit) - fore * (0.020F * unit),
                          0.034F * unit,
                          0.022F * unit),
               0.03F * unit);
  d = soft_min(d,
               round_cone(p,
                          rise(l.ball, 0.036F) - aside * (out * 1.2F),
                          l.toe + up * (0.028F * unit) - fore * (0.035F * unit),
                          0.033F * unit,
                          0.022F * unit),
               0.03F * unit);
  d = soft_min(d,
               round_cone(p,
                          rise(l.heel, 0.05F) + rear * (0.034F * unit),
                          l.ankle + up * 0.012F,
                          0.036F * unit,
                          0.037F * unit),
               0.04F * unit);
  // The sole is flat: before and behind the ball each along its own plane.
  const Vec3f toe_way = normalized(l.toe - l.ball);
  const Vec3f toe_over = normalized(up - toe_way * dot(up, toe_way));
  const float below_rear = -dot(p - l.ball, over), below_toe = -dot(p - l.ball, toe_over);
  const float below = dot(p - l.ball, fore) > 0 ? below_toe : below_rear;
  return soft_max(d, below, 0.008F * unit);
}

float apron_field(Vec3f p,
                  const PersonLook& look,
                  const PersonFrame& frame,
                  const TopShapes& shapes) {
  const float unit = frame.unit;
  const float top = 0.765F * unit + frame.pelvis, hem = 0.36F * unit + frame.pelvis;
  const float waist = frame.waist_height();
  const float dressed =
      soft_min(shapes.trunk(p), hips_field(p, look, frame, shapes.hips) - 0.006F, 0.02F * unit);
  const float body =
      soft_min(dressed,
               skirt_of(p, frame, 0.016F, 0.56F * unit + frame.pelvis, hem - 0.05F, 0.03F),
               0.03F * unit);
  const float sheet = body - 0.009F;  // what lies under the clothes is not seen
  // A bib above the waist, a skirt below that reaches round the sides.
  const float bib = std::abs(p.y) - 0.072F * unit - std::max(waist - p.z, 0.0F) * 0.10F;
  const float behind = frame.spine(0.7F).x - p.x;
  const float wrap = frame.spine(0.55F).x - 0.01F * unit - p.x;
  const float step = std::clamp((waist + 0.02F * unit - p.z) / (0.02F * unit), 0.0F, 1.0F);
  const float width = std::max(bib, behind) * (1 - step) + wrap * step;
  float d = soft_max(soft_max(sheet, width, 0.006F), std::max(p.z - top, hem - p.z), 0.006F);
  const float band = soft_max(sheet, std::abs(p.z - waist) - 0.014F * unit, 0.004F);
  return std::min(d, band);
}

// The line where a jacket or coat closes.
PartField closing(const PersonLook& look, const PersonFrame& frame, const TopShapes& shapes) {
  const float low = shapes.cut.hem * frame.unit + frame.pelvis + 0.012F, high = frame.neck.z;
  const auto field = [&look, &frame, shapes, low, high](Vec3f p) {
    const float depth = top_field(p, look, frame, shapes);
    const float strip = std::max({std::abs(p.y) - 0.0055F, low - p.z, p.z - high});
    return soft_max(std::max({depth - 0.0016F, -depth - 0.005F, 0.02F - p.x}), strip, 0.001F);
  };
  const float ahead = 0.14F * frame.unit;
  return {"closing",
          field,
          {{0.01F, -0.02F, low - 0.02F}, {ahead + 0.12F, 0.02F, high + 0.02F}},
          0.0027F,
          look.top_color * 0.45F,
          0.6F};
}

// Cloth on cloth, 2.8 mm thick, where `outline` is less than 0.
float on_cloth(float cloth, float outline) {
  return soft_max(std::max(cloth - 0.0028F, -cloth - 0.006F), outline, 0.002F);
}

float collar_leaves(Vec3f p, const PersonFrame& frame) {
  const Vec3f neck = frame.neck;
  const float x = p.x - neck.x + 0.004F * frame.unit, round = std::sqrt(x * x + p.y * p.y);
  const float front = std::max(x, 0.0F) / std::max(round, 1e-4F);
  // They are longest where they part in front.
  const float width = 0.056F * frame.unit + 0.018F * frame.unit * front * front;
  const float gap = 0.010F + 0.20F * std::max(neck.z + 0.01F - p.z, 0.0F) - std::abs(p.y);
  return std::max({round - width, x > 0 ? gap : -1, neck.z - 0.028F - 0.032F * front - p.z});
}

// A collar and cuffs.
float trim_field(Vec3f p,
                 const PersonLook& look,
                 const PersonFrame& frame,
                 const TopShapes& shapes) {
  constexpr float cuff_m = 0.055F, wrist_m = 0.12F;
  float d = on_cloth(top_field(p, look, frame, shapes), collar_leaves(p, frame));
  for (std::size_t i = 0; i < 2; ++i) {
    const ArmJoints& arm = frame.arms[i];
    const float away = length(p - arm.wrist) - wrist_m;
    if (away > wrist_m) {
      d = std::min(d, away);
      continue;
    }
    const float whole = length(arm.elbow - arm.shoulder) + length(arm.wrist - arm.elbow);
    const float past = (shapes.cut.sleeve_end - way_down_arm(p, arm)) * whole - cuff_m;
    d = std::min(d, on_cloth(sleeve(p, frame, i, shapes.cut), std::max(past, away)));
  }
  return d;
}

PartField shoe_part(const PersonLook& look, const PersonFrame& frame, std::size_t i) {
  const LegJoints& l = frame.legs[i];
  return {i == 0 ? "left shoe" : "right shoe",
          [&frame, i](Vec3f p) { return shoe(p, frame, i); },
          bounds_round({l.heel, l.toe, l.ankle, l.ball}, 0.10F),
          0.0055F,
          look.shoe_color,
          0.5F};
}

Bounds3 whole_body(const PersonFrame& frame) {
  Bounds3 bounds = bounds_round({frame.neck}, 0.20F);
  for (std::size_t i = 0; i < 2; ++i) {
    const ArmJoints& a = frame.arms[i];
    const LegJoints& l = frame.legs[i];
    const Bounds3 limb =
        bounds_round({a.shoulder, a.elbow, a.wrist, l.hip, l.knee, l.ankle}, 0.20F);
    bounds.include(limb.low);
    bounds.include(limb.high);
  }
  return bounds;
}

}  // namespace

std::vector<PartField> clothes_fields(const PersonLook& look, const PersonFrame& frame) {
  const GarmentCut cut = cut_of(look.top);
  const TopShapes shapes{cut, {look, frame, cut.trunk}, {look, frame, trousers_over}};
  const Bounds3 bounds = whole_body(frame);
  const bool soft = look.top == TopWear::t_shirt || look.top == TopWear::shirt;
  std::vector<PartField> parts{
      {"top",
       [&look, &frame, shapes](Vec3f p) { return top_field(p, look, frame, shapes); },
       bounds,
       0.0105F,
       look.top_color,
       soft ? 0.9F : 0.78F},
      shoe_part(look, frame, 0),
      shoe_part(look, frame, 1)};
  if (look.legs == LegWear::trousers) {
    parts.push_back({"trousers",
                     [&frame, hips = shapes.hips](Vec3f p) { return trousers(p, frame, hips); },
                     bounds,
                     0.0105F,
                     look.leg_color,
                     0.92F});
  } else {
    parts.push_back({"skirt",
                     [&frame](Vec3f p) { return skirt(p, frame, 0.56F, skirt_hem); },
                     bounds,
                     0.0105F,
                     look.leg_color,
                     0.9F});
  }
  if (look.top != TopWear::t_shirt) {
    parts.push_back(closing(look, frame, shapes));
    parts.push_back(
        {"trim",
         [&look, &frame, shapes](Vec3f p) { return trim_field(p, look, frame, shapes); },
         bounds,
         0.0055F,
         look.top_color * (soft ? 0.92F : 0.72F),
         0.9F});
  }
  if (look.apron)
    parts.push_back(
        {"apron",
         [&look, &frame, shapes](Vec3f p) { return apron_field(p, look, frame, shapes); },
         bounds,
         0.0075F,
         look.apron_color,
         0.88F});
  return parts;
}

}  // namespace marketgen::assets
