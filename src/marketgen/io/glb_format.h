// Marks and numbers of binary glTF: glTF 2.0 specification, 3.6.2.2 and 4.4.
#pragma once
#include <cstdint>

namespace marketgen::io {

inline constexpr std::uint32_t glb_magic = 0x46546C67, glb_version = 2, json_chunk = 0x4E4F534A,
                               bin_chunk = 0x004E4942;

// Types of an accessor's numbers.
namespace glb_component {
inline constexpr int int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125,
                     f32 = 5126;
}

}  // namespace marketgen::io
