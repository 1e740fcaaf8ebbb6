// Closures and necks that several bottles share.
#pragma once
#include "assets/archetypes/profile.h"

namespace marketgen {

// A screw cap on a neck with a support ring, from `low` up to `top`; the profile ends at the cap's
// middle. `radius_m` is the cap's, the neck under it is narrower.
void add_screw_cap(
    Profile& profile, float low, float top, float radius_m, std::uint16_t neck, std::uint16_t cap);

}  // namespace marketgen
