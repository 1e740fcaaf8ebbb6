#include "assets/shapes/archetypes/profile.h"

#include <algorithm>

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

// How far a curve has come across (from one size to the next) and up, at share t of the way.
struct CurveShare {
  float across, up;
};

CurveShare share_at(Curve curve, float t) {
  const Vec2 quarter = unit_circle(0.25 * static_cast<double>(t));
  const auto cosine = static_cast<float>(quarter.x), sine = static_cast<float>(quarter.y);
  switch (curve) {
    case Curve::swell:
      return {sine, 1 - cosine};
    case Curve::dome:
      return {1 - cosine, sine};
    case Curve::slope:
      return {t * t * (3 - 2 * t), t};
  }
  return {t, t};
}

float between(float a, float b, float share) {
  return a + (b - a) * share;
}

}  // namespace

Profile::Profile(const PackBuilder& pack, float roundness)
    : half_width_(pack.width() / 2),
      half_depth_(pack.depth() / 2),
      roundness_(roundness),
      min_half_(std::min(half_width_, half_depth_)) {}

Profile::Profile(float radius_m)
    : half_width_(radius_m), half_depth_(radius_m), roundness_(1), min_half_(radius_m) {}

Profile& Profile::use(std::uint16_t surface) {
  surface_ = surface;
  if (!sections_.empty()) sections_.back().surface = surface;
  return *this;
}

Profile& Profile::pole(float z) {
  return add(neck_section(z, 0));
}
Profile& Profile::body(float z, float share) {
  return add(body_section(z, share));
}

Profile& Profile::wavy_body(float z, float share, float lobe) {
  Section section = body_section(z, share);
  section.lobe = lobe;
  return add(section);
}

Profile& Profile::neck(float z, float radius_m) {
  return add(neck_section(z, radius_m));
}

Profile& Profile::curve_to_body(Curve curve, float z, float share, int steps) {
  return curve_to(curve, body_section(z, share), steps);
}

Profile& Profile::curve_to_neck(Curve curve, float z, float radius_m, int steps) {
  return curve_to(curve, neck_section(z, radius_m), steps);
}

Section Profile::body_section(float z, float share) const {
  return {.z = z,
          .half_width = share * half_width_,
          .half_depth = share * half_depth_,
          .roundness = roundness_};
}

Section Profile::neck_section(float z, float radius_m) const {
  return {.z = z, .half_width = radius_m, .half_depth = radius_m, .roundness = 1};
}

Profile& Profile::add(Section section) {
  section.surface = surface_;
  sections_.push_back(section);
  return *this;
}

Profile& Profile::curve_to(Curve curve, Section target, int steps) {
  const Section start = sections_.back();
  for (int i = 1; i <= steps; ++i) {
    const CurveShare share = share_at(curve, static_cast<float>(i) / static_cast<float>(steps));
    Section s = target;
    s.z = between(start.z, target.z, share.up);
    s.half_width = between(start.half_width, target.half_width, share.across);
    s.half_depth = between(start.half_depth, target.half_depth, share.across);
    s.roundness = between(start.roundness, target.roundness, share.across);
    s.lobe = between(start.lobe, target.lobe, share.across);
    add(s);
  }
  return *this;
}

}  // namespace marketgen::assets
