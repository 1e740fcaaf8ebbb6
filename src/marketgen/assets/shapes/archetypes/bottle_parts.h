// Closures and necks that several bottles share.
#pragma once
#include <span>

#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"

namespace marketgen::assets {

// A screw cap on a neck with a support ring, from `low` up to `top`; the profile ends at the cap's
// middle. `radius_m` is the cap's, the neck under it is narrower.
void add_screw_cap(
    Profile& profile, float low, float top, float radius_m, std::uint16_t neck, std::uint16_t cap);
// Where that cap's skirt ends and the bare neck begins.
float cap_low_of(float low, float top);

// Of a bottle whose front and back labels have edges; `body` is seen beside them.
LoftStyle labelled_style(const LabelZone& zone,
                         std::uint16_t body,
                         int triangles = smooth_style.triangles);

// A level of a blow-moulded body: how far it reaches to the left and right of the axis and to the
// front, in shares of the half width and half depth, at a share of the height.
struct BodyLevel {
  float z, left, right, depth;
};

// The sections of such a body on a smooth curve through its levels, printed over the label's zone.
// A level's section is `roundness` up to the label; from there to the last level it becomes round.
std::vector<Section> blown_body(const PackBuilder& pack,
                                std::span<const BodyLevel> levels,
                                const LabelZone& zone,
                                std::uint16_t body,
                                std::uint16_t print);

}  // namespace marketgen::assets
