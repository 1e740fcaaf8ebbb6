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

// By how it begins.
bool is_png(std::string_view bytes);

Result<std::string> encode_png(const Image& image);
Result<void> write_png(const std::filesystem::path& path, const Image& image);
// One 16-bit grey value a pixel, row-major from the top left.
Result<std::string> encode_png16(int width, int height, const std::vector<std::uint16_t>& pixels);
Result<void> write_png16(const std::filesystem::path& path,
                         int width,
                         int height,
                         const std::vector<std::uint16_t>& pixels);
// `where` names the bytes in errors: image.bad_file, input.too_large (more than 64 megapixels).
Result<Image> decode_png(std::string_view bytes, const std::string& where);
struct Png16 {
  int width = 0, height = 0;
  std::vector<std::uint16_t> pixels;  // as encode_png16() takes them
};
// Of one 16-bit grey value a pixel. Errors: as decode_png; image.bad_file for another kind of PNG.
Result<Png16> decode_png16(std::string_view bytes, const std::string& where);
// What its head says. Errors: as decode_png.
Result<PictureSize> png_size(std::string_view bytes, const std::string& where);
// As decode_png; also input.not_found.
Result<Image> read_png(const std::filesystem::path& path);

}  // namespace marketgen::io
