// A picture as it is shown to a language model.
#pragma once
#include <string>
#include <string_view>

#include "base/result.h"

namespace marketgen::drawing {

struct ShrunkPng {
  std::string bytes;
  int width = 0, height = 0;
};

// Of a PNG or JPEG: as it was seen, on white, its longer side no longer than that; nothing else of
// the file goes along (camera, place, date). Errors: those of io::decoded_picture().
Result<ShrunkPng> shrunk_png(std::string_view bytes, const std::string& where, int longest_side_px);

}  // namespace marketgen::drawing
