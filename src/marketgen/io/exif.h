// How a camera was held: the one value of Exif that a picture cannot be looked at without.
#pragma once
#include <string_view>

namespace marketgen::io {

// Exif 2.32, tag 0x0112 of the first directory: 1 as it is, 2 mirrored, 3 turned by half, 4 upside
// down, 5 transposed, 6 to be turned right by a quarter, 7 transposed the other way, 8 to be turned
// left. 1 where a JPEG says nothing or nonsense.
int jpeg_orientation(std::string_view bytes);

}  // namespace marketgen::io
