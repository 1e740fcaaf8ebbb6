// The colours that a photo is made of.
#pragma once
#include <vector>

#include "photo/looked.h"
#include "photo/read_photo.h"

namespace marketgen::photo {

// At most 6, largest share first; colours that an eye hardly tells apart are one.
std::vector<PaletteColor> palette_of(const Looked& photo);

}  // namespace marketgen::photo
