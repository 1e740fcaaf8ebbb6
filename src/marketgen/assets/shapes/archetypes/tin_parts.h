// Parts of food tins: the seamed ends and the ring pull.
#pragma once
#include "assets/shapes/archetypes/profile.h"

namespace marketgen::assets {

// A lower end with its seam, `seam` high, up to the wall at `wall` of the radius.
void add_tin_foot(Profile& profile, float seam, float wall_low, float wall, std::uint16_t metal);

// The upper seam and the recessed lid from the wall on; returns the height of the lid's panel. The
// profile ends with the panel's edge at `panel` of the radius: the caller closes it.
float add_tin_lid(Profile& profile, float height, float seam, float panel, std::uint16_t metal);

// A ring on its tongue, lying on a lid at height `lid`, its rivet towards the back. `radius_m` is
// the lid's.
void add_ring_pull(
    PackBuilder& pack, float lid, float radius_m, std::uint16_t metal, const PartFrame& tin = {});

}  // namespace marketgen::assets
