#include "assets/people/part_fields.h"

#include "assets/people/soft_shapes.h"

namespace marketgen::assets {
namespace {

// Half depths and half widths of the trunk, shares of stature (ANSUR II: breadths and depths of
// chest, waist and hips over stature). The spine's curve lies in their middles.
struct TrunkRow {
  float height, middle;
  float man_depth, man_width, woman_depth, woman_width;
};
constexpr std::array<TrunkRow, 8> trunk_rows{{{0.455F, -0.004F, 0.048F, 0.060F, 0.048F, 0.064F},
                                              {0.505F, -0.010F, 0.066F, 0.097F, 0.068F, 0.103F},
                                              {0.555F, -0.004F, 0.063F, 0.094F, 0.061F, 0.096F},
                                              {0.615F, 0.004F, 0.060F, 0.086F, 0.053F, 0.077F},
                                              {0.680F, 0.003F, 0.064F, 0.092F, 0.057F, 0.080F},
                                              {0.745F, -0.002F, 0.067F, 0.095F, 0.058F, 0.084F},
                                              {0.795F, -0.012F, 0.054F, 0.080F, 0.047F, 0.071F},
                                              {0.836F, -0.014F, 0.036F, 0.042F, 0.033F, 0.037F}}};

}  // namespace

TrunkField::TrunkField(const PersonLook& look, const PersonFrame& frame, float over)
    : unit_(frame.unit),
      neck_radius_(0.022F * frame.unit + over),
      shoulder_radius_(0.0265F * frame.unit * frame.broad + over),
      bust_radius_(0) {
  const bool woman = look.form == BodyForm::woman;
  for (const TrunkRow& row : trunk_rows) {
    // What a body puts on, it puts on about the waist first.
    const bool belly = row.height > 0.53F && row.height < 0.7F;
    const float more = 1 + (frame.wide - 1) * (belly ? 1.35F : 1.0F);
    const float ahead = belly ? 0.03F * std::max(frame.wide - 1, 0.0F) : 0.0F;
    const Vec3f middle = frame.spine(row.height) + Vec3f{(row.middle + ahead) * unit_, 0, 0};
    girths_.push_back({middle.z,
                       middle.x,
                       (woman ? row.woman_depth : row.man_depth) * unit_ * more + over,
                       (woman ? row.woman_width : row.man_width) * unit_ * more + over});
  }
  girths_.back().z += over * 0.5F;
  for (std::size_t i = 0; i < 2; ++i) {
    shoulder_[i] = frame.arms[i].shoulder;
    neck_[i] = frame.spine(0.834F) + Vec3f{-0.014F * unit_, side_of(i) * 0.022F * unit_, 0};
    bust_[i] = frame.spine(0.722F) +
               Vec3f{0.036F * unit_ * frame.wide, side_of(i) * 0.042F * unit_ * frame.wide, 0};
  }
  if (woman) bust_radius_ = 0.032F * unit_ * frame.wide + over;
}

float TrunkField::operator()(Vec3f p) const {
  float d = trunk(p, girths_, 0.02F * unit_);
  for (std::size_t i = 0; i < 2; ++i) {
    d = soft_min(
        d, round_cone(p, neck_[i], shoulder_[i], neck_radius_, shoulder_radius_), 0.03F * unit_);
    const float r = bust_radius_;
    if (r > 0) d = soft_min(d, ellipsoid(p, bust_[i], {r, r * 1.1F, r * 1.05F}), 0.035F * unit_);
  }
  return d;
}

float arm_field(Vec3f p, const PersonFrame& frame, std::size_t arm, float over) {
  const ArmJoints& a = frame.arms[arm];
  const float w = frame.unit * frame.broad;
  const Vec3f muscle = a.elbow + (a.wrist - a.elbow) * 0.28F;
  float d = round_cone(p, a.shoulder, a.elbow, 0.0290F * w + over, 0.0205F * w + over);
  d = soft_min(d, round_cone(p, a.elbow, muscle, 0.0200F * w + over, 0.0235F * w + over), 0.012F);
  return soft_min(
      d, round_cone(p, muscle, a.wrist, 0.0235F * w + over, 0.0155F * w + over), 0.012F);
}

float leg_field(Vec3f p, const PersonFrame& frame, std::size_t leg, float over) {
  const LegJoints& l = frame.legs[leg];
  const float w = frame.unit * frame.broad;
  const Vec3f back = normalized(cross(l.knee - l.ankle, Vec3f{0, 1, 0}));
  const Vec3f calf = l.knee + (l.ankle - l.knee) * 0.30F - back * (0.006F * w);
  float d = round_cone(p, l.hip, l.knee, 0.052F * w + over, 0.0325F * w + over);
  d = soft_min(d, round_cone(p, l.knee, calf, 0.0315F * w + over, 0.0325F * w + over), 0.03F);
  return soft_min(d, round_cone(p, calf, l.ankle, 0.0325F * w + over, 0.0195F * w + over), 0.03F);
}

Bounds3 bounds_round(std::initializer_list<Vec3f> points, float margin) {
  Bounds3 bounds;
  for (const Vec3f& p : points)
    bounds.include(p);
  bounds.low = bounds.low - Vec3f{margin, margin, margin};
  bounds.high = bounds.high + Vec3f{margin, margin, margin};
  return bounds;
}

}  // namespace marketgen::assets
