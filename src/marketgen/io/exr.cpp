#include "io/exr.h"

#include <fmt/format.h>
#include <tinyexr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "io/file.h"

namespace marketgen {
namespace {

constexpr float largest_half = 65504;

std::string taken_message(const char* message) {
  std::string text = message == nullptr ? "no reason given" : message;
  FreeEXRErrorMessage(message);
  return text;
}

struct Freed {
  void operator()(void* memory) const { std::free(memory); }
};

// The three planes in the order of their names, as the format wants them: B, G, R.
std::array<std::vector<float>, 3> planes_of(const FloatImage& image) {
  std::array<std::vector<float>, 3> planes;
  for (std::size_t k = 0; k < 3; ++k) {
    planes[k].resize(image.pixels.size() / 3);
    for (std::size_t i = 0; i < planes[k].size(); ++i)
      planes[k][i] = std::clamp(image.pixels[3 * i + 2 - k], -largest_half, largest_half);
  }
  return planes;
}

}  // namespace

Result<std::string> encode_exr(const FloatImage& image) {
  std::array<std::vector<float>, 3> planes = planes_of(image);
  std::array<float*, 3> pointers{planes[0].data(), planes[1].data(), planes[2].data()};
  std::array<EXRChannelInfo, 3> channels{};
  constexpr std::array<char, 3> names{'B', 'G', 'R'};
  for (std::size_t k = 0; k < 3; ++k)
    channels[k].name[0] = names[k];
  std::array<int, 3> given, stored;
  given.fill(TINYEXR_PIXELTYPE_FLOAT);
  stored.fill(TINYEXR_PIXELTYPE_HALF);

  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = 3;
  header.channels = channels.data();
  header.pixel_types = given.data();
  header.requested_pixel_types = stored.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  EXRImage pixels;
  InitEXRImage(&pixels);
  pixels.num_channels = 3;
  pixels.images = reinterpret_cast<unsigned char**>(pointers.data());
  pixels.width = image.width;
  pixels.height = image.height;

  unsigned char* memory = nullptr;
  const char* message = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&pixels, &header, &memory, &message);
  const std::unique_ptr<unsigned char, Freed> owned(memory);
  if (size == 0) return Error{"internal.bug", "exr", taken_message(message)};
  return std::string(reinterpret_cast<const char*>(memory), size);
}

Result<void> write_exr(const std::filesystem::path& path, const FloatImage& image) {
  MARKETGEN_TRY(const std::string bytes, encode_exr(image));
  return write_file(path, bytes);
}

Result<FloatImage> decode_exr(std::string_view bytes, const std::string& where) {
  float* rgba = nullptr;
  const char* message = nullptr;
  FloatImage image;
  const int state = LoadEXRFromMemory(&rgba,
                                      &image.width,
                                      &image.height,
                                      reinterpret_cast<const unsigned char*>(bytes.data()),
                                      bytes.size(),
                                      &message);
  const std::unique_ptr<float, Freed> owned(rgba);
  if (state != TINYEXR_SUCCESS) {
    return Error{"image.bad_file",
                 where,
                 fmt::format("is not a readable EXR file ({})", taken_message(message))};
  }
  const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.pixels.resize(3 * count);
  for (std::size_t i = 0; i < count; ++i)
    std::copy_n(rgba + 4 * i, 3, &image.pixels[3 * i]);
  return image;
}

}  // namespace marketgen
