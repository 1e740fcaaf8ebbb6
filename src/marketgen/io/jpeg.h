// JPEG pictures by libjpeg: reading only.
#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "geometry/image.h"

namespace marketgen {

// Three channels, sRGB. `where` names the bytes in errors: image.bad_file (damaged pictures too),
// input.too_large (more than 64 megapixels).
Result<Image> decode_jpeg(std::string_view bytes, const std::string& where);

}  // namespace marketgen
