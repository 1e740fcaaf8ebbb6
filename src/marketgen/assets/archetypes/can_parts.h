// The upper end of drink cans: neck, rolled rim, lid and tab.
#pragma once
#include "assets/archetypes/profile.h"

namespace marketgen {

// From the wall up; the profile ends at the lid's middle. `neck` is the neck's share of the body's
// radius, `height` the can's.
void add_can_end(Profile& profile, float height, float neck, std::uint16_t metal);

// Lies on the lid of a can of that height and radius.
void add_can_tab(
    PackBuilder& pack, float height, float radius, std::uint16_t metal, const PartFrame& can = {});

}  // namespace marketgen
