// The upper end of drink cans: neck, rolled rim, lid and tab.
#pragma once
#include "assets/shapes/archetypes/profile.h"

namespace marketgen::assets {

// From the wall up; the profile ends at the lid's middle. `neck` is the neck's share of the body's
// radius, `height` the can's.
void add_can_end(Profile& profile, float height, float neck, std::uint16_t metal);

// Surfaces and measures of a can that stands by itself.
struct CanForm {
  std::uint16_t metal = 0, print = 0;
  float print_to_m = 0;  // height at which the printed wall ends
  float neck = 0;        // as for add_can_end
};

// Lies on the lid of a can of that height and radius.
void add_can_tab(
    PackBuilder& pack, float height, float radius, std::uint16_t metal, const PartFrame& can = {});

// All of a standing can above its foot, which `profile` holds already: wall with print, end, tab.
Result<ProductModel> finish_can(PackBuilder& pack,
                                Profile& profile,
                                const CanForm& form,
                                const LoftStyle& style);

}  // namespace marketgen::assets
