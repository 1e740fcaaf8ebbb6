#include "io/exr.h"

#include <fmt/format.h>
#include <tinyexr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "io/file.h"

namespace marketgen::io {
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

namespace {

// TinyEXR's reader step by step: its one-call form loses memory when a file is cut off.
class ExrReader {
 public:
  ExrReader(std::string_view bytes, std::string where)
      : data_(reinterpret_cast<const unsigned char*>(bytes.data())),
        size_(bytes.size()),
        where_(std::move(where)) {
    InitEXRHeader(&header_);
    InitEXRImage(&image_);
  }
  ~ExrReader() {
    FreeEXRImage(&image_);
    FreeEXRHeader(&header_);
  }
  ExrReader(const ExrReader&) = delete;
  ExrReader& operator=(const ExrReader&) = delete;

  Result<FloatImage> read() {
    EXRVersion version{};
    if (ParseEXRVersionFromMemory(&version, data_, size_) != TINYEXR_SUCCESS)
      return unreadable("it does not start as one");
    if (version.multipart != 0 || version.tiled != 0 || version.non_image != 0)
      return unreadable("only pictures of one part, in lines, are read");
    const char* message = nullptr;
    if (ParseEXRHeaderFromMemory(&header_, &version, data_, size_, &message) != TINYEXR_SUCCESS)
      return unreadable(taken_message(message));
    for (int c = 0; c < header_.num_channels; ++c)
      header_.requested_pixel_types[c] = TINYEXR_PIXELTYPE_FLOAT;
    if (LoadEXRImageFromMemory(&image_, &header_, data_, size_, &message) != TINYEXR_SUCCESS)
      return unreadable(taken_message(message));
    return colors();
  }

 private:
  Error unreadable(const std::string& why) const {
    return {"image.bad_file", where_, fmt::format("is not a readable EXR file ({})", why)};
  }

  const float* channel(std::string_view name) const {
    for (int c = 0; c < header_.num_channels; ++c) {
      if (name == header_.channels[c].name) return reinterpret_cast<const float*>(image_.images[c]);
    }
    return nullptr;
  }

  Result<FloatImage> colors() const {
    FloatImage result;
    result.width = image_.width;
    result.height = image_.height;
    const auto count =
        static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height);
    result.pixels.resize(3 * count);
    constexpr std::array<std::string_view, 3> names{"R", "G", "B"};
    for (std::size_t k = 0; k < names.size(); ++k) {
      const float* values = channel(names[k]);
      if (values == nullptr) return unreadable("it has no R, G and B");
      for (std::size_t i = 0; i < count; ++i)
        result.pixels[3 * i + k] = values[i];
    }
    return result;
  }

  const unsigned char* data_;
  std::size_t size_;
  std::string where_;
  EXRHeader header_;
  EXRImage image_;
};

}  // namespace

Result<FloatImage> decode_exr(std::string_view bytes, const std::string& where) {
  return ExrReader(bytes, where).read();
}

}  // namespace marketgen::io
