#include "io/jpeg.h"

#include <csetjmp>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <jpeglib.h>

namespace marketgen::io {
namespace {

constexpr std::uint64_t max_pixels = 64'000'000;

struct Fault {
  jpeg_error_mgr manager{};
  std::jmp_buf back{};
  char message[JMSG_LENGTH_MAX] = "";
};

void leave(j_common_ptr jpeg) {
  auto* fault = reinterpret_cast<Fault*>(jpeg->err);  // the manager is its first member
  jpeg->err->format_message(jpeg, fault->message);
  std::longjmp(fault->back, 1);
}

// A warning means missing or damaged data: such a picture is refused.
void refuse_warnings(j_common_ptr jpeg, int level) {
  if (level < 0) leave(jpeg);
}

void begin_jpeg(jpeg_decompress_struct& jpeg, std::string_view bytes) {
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg,
               reinterpret_cast<const unsigned char*>(bytes.data()),
               static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&jpeg, TRUE);
}

// libjpeg leaves by longjmp on errors: nothing with a destructor may live in the next functions.
// False: damaged.
bool read_head(std::string_view bytes, Fault& fault, PictureSize& size) {
  jpeg_decompress_struct jpeg{};
  jpeg.err = jpeg_std_error(&fault.manager);
  fault.manager.error_exit = leave;
  fault.manager.emit_message = refuse_warnings;
  if (setjmp(fault.back) != 0) {
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  begin_jpeg(jpeg, bytes);
  size = {static_cast<int>(jpeg.image_width), static_cast<int>(jpeg.image_height)};
  jpeg_destroy_decompress(&jpeg);
  return true;
}

bool decode(std::string_view bytes, Fault& fault, Image& image) {
  jpeg_decompress_struct jpeg{};
  jpeg.err = jpeg_std_error(&fault.manager);
  fault.manager.error_exit = leave;
  fault.manager.emit_message = refuse_warnings;
  if (setjmp(fault.back) != 0) {
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  begin_jpeg(jpeg, bytes);
  jpeg.out_color_space = JCS_RGB;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = image.at(0, static_cast<int>(jpeg.output_scanline));
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  jpeg_destroy_decompress(&jpeg);
  return true;
}

Error damaged_jpeg(const std::string& where, const Fault& fault) {
  return {"image.bad_file", where, fmt::format("is not a readable JPEG file ({})", fault.message)};
}

// Of 100; above it files grow and pictures look the same.
constexpr int picture_quality = 92, texture_quality = 85;

// No object with a destructor may live here either. `bytes` is malloc's.
bool encode(
    const Image& image, JpegUse use, Fault& fault, unsigned char** bytes, unsigned long* size) {
  jpeg_compress_struct jpeg{};
  jpeg.err = jpeg_std_error(&fault.manager);
  fault.manager.error_exit = leave;
  if (setjmp(fault.back) != 0) {
    jpeg_destroy_compress(&jpeg);
    return false;
  }
  jpeg_create_compress(&jpeg);
  jpeg_mem_dest(&jpeg, bytes, size);
  jpeg.image_width = static_cast<JDIMENSION>(image.width);
  jpeg.image_height = static_cast<JDIMENSION>(image.height);
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  const bool texture = use == JpegUse::texture;
  jpeg_set_quality(&jpeg, texture ? texture_quality : picture_quality, TRUE);
  jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor =
      texture ? 2 : 1;  // 1: colour as sharp as light
  if (texture)
    jpeg.optimize_coding = TRUE;  // a twelfth of the bytes, at the price of a second pass
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    // libjpeg takes rows without const, and does not write to them.
    auto* row = const_cast<JSAMPROW>(image.at(0, static_cast<int>(jpeg.next_scanline)));
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  return true;
}

}  // namespace

Result<std::string> encode_jpeg(const Image& image, JpegUse use) {
  if (image.channels != 3)
    return Error{"image.bad_file", "JPEG", fmt::format("{} channels, not 3", image.channels)};
  Fault fault;
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const bool done = encode(image, use, fault, &bytes, &size);
  std::string file(reinterpret_cast<const char*>(bytes), done ? size : 0);
  std::free(bytes);
  if (done) return file;
  return Error{"image.bad_file",
               fmt::format("{} x {} pixels", image.width, image.height),
               fmt::format("cannot be written as JPEG ({})", fault.message)};
}

Result<PictureSize> jpeg_size(std::string_view bytes, const std::string& where) {
  Fault fault;
  PictureSize size;
  if (!read_head(bytes, fault, size)) return damaged_jpeg(where, fault);
  if (std::uint64_t(size.width) * std::uint64_t(size.height) <= max_pixels) return size;
  return Error{
      "input.too_large",
      where,
      fmt::format("has {} x {} pixels; at most 64 megapixels are read", size.width, size.height)};
}

Result<Image> decode_jpeg(std::string_view bytes, const std::string& where) {
  MARKETGEN_TRY(const PictureSize size, jpeg_size(bytes, where));
  Fault fault;
  Image image(size.width, size.height);
  if (!decode(bytes, fault, image)) return damaged_jpeg(where, fault);
  return image;
}

}  // namespace marketgen::io
