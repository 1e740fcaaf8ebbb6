// OpenEXR files by TinyEXR: linear light as half floats.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace marketgen::io {

// Linear RGB (Rec. 709 primaries), row-major from the top left, 3 a pixel.
struct FloatImage {
  int width = 0, height = 0;
  std::vector<float> pixels;
};

// One scan-line part, channels B, G, R as half floats, ZIP compression; values beyond 65,504 are
// cut there. Precondition: `image` has as many pixels as it says, and at least one.
Result<std::string> encode_exr(const FloatImage& image);
Result<void> write_exr(const std::filesystem::path& path, const FloatImage& image);
// Of files with channels R, G and B. `where` names the bytes in errors: image.bad_file.
Result<FloatImage> decode_exr(std::string_view bytes, const std::string& where);

}  // namespace marketgen::io
