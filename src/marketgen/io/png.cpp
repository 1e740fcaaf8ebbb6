#include "io/png.h"

#include <csetjmp>
#include <cstring>

#include <fmt/format.h>
#include <png.h>

#include "io/file.h"

namespace marketgen::io {
namespace {

constexpr std::uint64_t max_png_pixels = 64'000'000;

// All that is needed to write one PNG; 16-bit samples are big-endian already.
struct Raster {
  int width, height, bit_depth, color_type;
  std::size_t row_bytes;
  const std::uint8_t* pixels;
};

void append_bytes(png_structp png, png_bytep data, png_size_t length) {
  static_cast<std::string*>(png_get_io_ptr(png))
      ->append(reinterpret_cast<const char*>(data), length);
}

// libpng leaves by longjmp on errors: nothing with a destructor may live in this function.
bool encode(const Raster& raster, std::string* out) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_write_fn(png, out, append_bytes, nullptr);
  png_set_compression_level(png,
                            3);  // 4 % larger than level 6 on our pictures, three times as fast
  png_set_filter(png, 0, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_set_IHDR(png,
               info,
               static_cast<png_uint_32>(raster.width),
               static_cast<png_uint_32>(raster.height),
               raster.bit_depth,
               raster.color_type,
               PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (int y = 0; y < raster.height; ++y) {
    png_write_row(
        png, const_cast<png_bytep>(raster.pixels + static_cast<std::size_t>(y) * raster.row_bytes));
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

// What is left to be read of a PNG in memory.
struct PngBytes {
  const std::uint8_t* next;
  std::size_t left;
};

void take_bytes(png_structp png, png_bytep data, png_size_t length) {
  auto* from = static_cast<PngBytes*>(png_get_io_ptr(png));
  if (length > from->left) png_error(png, "it ends too early");
  std::memcpy(data, from->next, length);
  from->next += length;
  from->left -= length;
}

enum class Png16Fault { none, damaged, other_kind, too_large };

// Leaves by longjmp as encode() does: nothing with a destructor may live here. Samples come in this
// machine's byte order.
Png16Fault decode16(PngBytes* from, Png16* into) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  if (png == nullptr) return Png16Fault::damaged;
  png_infop info = png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_read_struct(&png, &info, nullptr);
    return Png16Fault::damaged;
  }
  png_set_read_fn(png, from, take_bytes);
  png_read_info(png, info);
  const std::uint64_t width = png_get_image_width(png, info),
                      height = png_get_image_height(png, info);
  const bool fits = width * height <= max_png_pixels;
  const bool is_grey16 = png_get_bit_depth(png, info) == 16 &&
                         png_get_color_type(png, info) == PNG_COLOR_TYPE_GRAY &&
                         png_get_interlace_type(png, info) == PNG_INTERLACE_NONE;
  if (fits && is_grey16) {
    into->width = static_cast<int>(width), into->height = static_cast<int>(height);
    into->pixels.resize(width * height);
    png_set_swap(png);
    for (std::uint64_t y = 0; y < height; ++y)
      png_read_row(png, reinterpret_cast<png_bytep>(into->pixels.data() + y * width), nullptr);
    png_read_end(png, nullptr);
  }
  png_destroy_read_struct(&png, &info, nullptr);
  if (!fits) return Png16Fault::too_large;
  return is_grey16 ? Png16Fault::none : Png16Fault::other_kind;
}

// Reads the head; whoever goes on frees `png`.
Result<void> begin_png(png_image& png, std::string_view bytes, const std::string& where) {
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    return Error{
        "image.bad_file", where, fmt::format("is not a readable PNG file ({})", png.message)};
  }
  if (std::uint64_t{png.width} * png.height <= max_png_pixels) return {};
  png_image_free(&png);
  return Error{
      "input.too_large",
      where,
      fmt::format("has {} x {} pixels; at most 64 megapixels are read", png.width, png.height)};
}

}  // namespace

bool is_png(std::string_view bytes) {
  return bytes.starts_with("\x89PNG");
}

Result<std::string> encode_png(const Image& image) {
  const int type = image.channels == 4
                       ? PNG_COLOR_TYPE_RGB_ALPHA
                       : (image.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY);
  const auto row_bytes =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  std::string bytes;
  if (!encode({image.width, image.height, 8, type, row_bytes, image.pixels.data()}, &bytes)) {
    return Error{"internal.bug", "png", "libpng refused the picture"};
  }
  return bytes;
}

Result<void> write_png(const std::filesystem::path& path, const Image& image) {
  MARKETGEN_TRY(const std::string bytes, encode_png(image));
  return write_file(path, bytes);
}

Result<std::string> encode_png16(int width, int height, const std::vector<std::uint16_t>& pixels) {
  std::vector<std::uint8_t> big_endian(pixels.size() * 2);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    big_endian[2 * i] = static_cast<std::uint8_t>(pixels[i] >> 8);
    big_endian[2 * i + 1] = static_cast<std::uint8_t>(pixels[i] & 255);
  }
  std::string bytes;
  if (!encode({width,
               height,
               16,
               PNG_COLOR_TYPE_GRAY,
               static_cast<std::size_t>(width) * 2,
               big_endian.data()},
              &bytes)) {
    return Error{"internal.bug", "png", "libpng refused the picture"};
  }
  return bytes;
}

Result<void> write_png16(const std::filesystem::path& path,
                         int width,
                         int height,
                         const std::vector<std::uint16_t>& pixels) {
  MARKETGEN_TRY(const std::string bytes, encode_png16(width, height, pixels));
  return write_file(path, bytes);
}

Result<PictureSize> png_size(std::string_view bytes, const std::string& where) {
  png_image png{};
  MARKETGEN_CHECK(begin_png(png, bytes, where));
  const PictureSize size{static_cast<int>(png.width), static_cast<int>(png.height)};
  png_image_free(&png);
  return size;
}

Result<Image> decode_png(std::string_view bytes, const std::string& where) {
  png_image png{};
  MARKETGEN_CHECK(begin_png(png, bytes, where));
  const bool alpha = (png.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  png.format = alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height), alpha ? 4 : 3);
  if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) {
    const Error error{
        "image.bad_file", where, fmt::format("is a damaged PNG file ({})", png.message)};
    png_image_free(&png);
    return error;
  }
  return image;
}

Result<Png16> decode_png16(std::string_view bytes, const std::string& where) {
  Png16 picture;
  PngBytes from{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  switch (decode16(&from, &picture)) {
    case Png16Fault::none:
      return picture;
    case Png16Fault::other_kind:
      return Error{"image.bad_file", where, "is no PNG of one 16-bit grey value a pixel"};
    case Png16Fault::too_large:
      return Error{"input.too_large", where, "has more than the 64 megapixels that are read"};
    case Png16Fault::damaged:
      break;
  }
  return Error{"image.bad_file", where, "is not a readable PNG file"};
}

Result<Image> read_png(const std::filesystem::path& path) {
  MARKETGEN_TRY(const std::string bytes, read_file(path));
  return decode_png(bytes, path.string());
}

}  // namespace marketgen::io
