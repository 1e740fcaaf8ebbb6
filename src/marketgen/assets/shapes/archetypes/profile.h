// Profiles of round and oval packs, written from the ground up as one reads a bottle:
//
//   profile.use(metal).pole(0.004F).body(0, 0.7F).curve_to_body(Curve::dome, low, 1, 3)
//          .use(print).body(high, 1).use(metal)...
#pragma once
#include <vector>

#include "assets/shapes/archetypes/loft.h"

namespace marketgen::assets {

// How the outline goes from the last section to the next.
enum class Curve {
  swell,  // leaves flat, arrives upright: a rounded foot
  dome,   // leaves upright, arrives flat: a round shoulder
  slope   // leaves and arrives upright: a long shoulder
};

class Profile {
 public:
  // Of a pack with that footprint; `roundness` is the body's.
  Profile(const PackBuilder& pack, float roundness);
  // Of one piece of a pack, round.
  explicit Profile(float radius_m);

  // The surface from the last section on.
  Profile& use(std::uint16_t surface);
  Profile& pole(float z);
  // A section of the body: `share` of the pack's width and depth.
  Profile& body(float z, float share);
  Profile& wavy_body(float z, float share, float lobe);
  // A circular section.
  Profile& neck(float z, float radius_m);
  Profile& curve_to_body(Curve curve, float z, float share, int steps);
  Profile& curve_to_neck(Curve curve, float z, float radius_m, int steps);

  // Half of the lesser of width and depth: what a neck's radius is measured against.
  float min_half() const { return min_half_; }
  const std::vector<Section>& sections() const { return sections_; }

 private:
  Section body_section(float z, float share) const;
  Section neck_section(float z, float radius_m) const;
  Profile& add(Section section);
  Profile& curve_to(Curve curve, Section target, int steps);

  float half_width_, half_depth_, roundness_, min_half_;
  std::uint16_t surface_ = 0;
  std::vector<Section> sections_;
};

}  // namespace marketgen::assets
