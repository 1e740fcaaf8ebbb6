// PNG files by libpng. 8-bit RGB, RGBA and grey; 16-bit grey for depth in millimetres.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/image.h"

namespace marketgen::io {

Result<std::string> encode_png(const Image& image);
Result<void> write_png(const std::filesystem::path& path, const Image& image);
// One 16-bit grey value a pixel, row-major from the top left.
Result<void> write_png16(const std::filesystem::path& path,
                         int width,
                         int height,
                         const std::vector<std::uint16_t>& pixels);
// `where` names the bytes in errors: image.bad_file, input.too_large (more than 64 megapixels).
Result<Image> decode_png(std::string_view bytes, const std::string& where);
// As decode_png; also input.not_found.
Result<Image> read_png(const std::filesystem::path& path);

}  // namespace marketgen::io
