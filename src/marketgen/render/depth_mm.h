// Depth as whole millimetres, as 16-bit pictures hold it.
#pragma once
#include <cstdint>
#include <vector>

namespace marketgen::render {

// Rounded; 0 stays 0 (nothing hit), and what is farther than 65.535 m becomes 65,535.
std::vector<std::uint16_t> depth_in_mm(const std::vector<float>& depth_m);

}  // namespace marketgen::render
