// Colours as people write them: "#rrggbb" in sRGB, turned into the linear RGB that surfaces carry.
#pragma once
#include <cstdint>
#include <string_view>

#include "base/result.h"
#include "geometry/vector.h"

namespace marketgen::assets {

// One sRGB channel to linear light, 0..1 (IEC 61966-2-1). Same bits on every machine.
float linear_from_srgb(std::uint8_t channel);

// "#2e7d32", upper or lower case. Error: assets.bad_row when it is written in any other way.
Result<Vec3f> linear_from_hex(std::string_view text);

}  // namespace marketgen::assets
