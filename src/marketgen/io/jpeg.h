// JPEG pictures by libjpeg.
#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "geometry/image.h"

namespace marketgen::io {

// Three channels, sRGB. `where` names the bytes in errors: image.bad_file (damaged pictures too),
// input.too_large (more than 64 megapixels).
Result<Image> decode_jpeg(std::string_view bytes, const std::string& where);

// What its head says, however the camera was held. Errors: as decode_jpeg.
Result<PictureSize> jpeg_size(std::string_view bytes, const std::string& where);

enum class JpegUse {
  picture,  // a person sees no loss
  texture   // half the bytes: sharp, colours at half the resolution
};

// Three channels, sRGB. Same picture, same bytes. Errors: image.bad_file for a side longer than
// JPEG's 65,535 pixels.
Result<std::string> encode_jpeg(const Image& image, JpegUse use = JpegUse::picture);

}  // namespace marketgen::io
