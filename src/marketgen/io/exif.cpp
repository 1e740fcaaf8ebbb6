#include "io/exif.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace marketgen::io {
namespace {

constexpr std::string_view exif_mark{"Exif\0\0", 6};
constexpr std::size_t entry_bytes = 12;
constexpr std::uint32_t orientation_tag = 0x0112, short_type = 3;

// Numbers of a TIFF block; 0 beyond its end.
class Tiff {
 public:
  explicit Tiff(std::string_view block) : block_(block), little_(block.starts_with("II")) {}

  std::uint32_t number(std::size_t at, std::size_t bytes) const {
    if (at > block_.size() || block_.size() - at < bytes) return 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      const std::size_t from = little_ ? at + bytes - 1 - i : at + i;
      value = value << 8U | static_cast<std::uint8_t>(block_[from]);
    }
    return value;
  }

 private:
  std::string_view block_;
  bool little_;
};

// The TIFF block of the first Exif segment before the picture's data.
std::optional<std::string_view> tiff_block(std::string_view bytes) {
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); };
  std::size_t at = 2;  // behind the mark of the file's start
  while (at + 4 <= bytes.size() && byte(at) == 0xff) {
    constexpr std::uint8_t app1 = 0xe1, scan = 0xda;
    const std::uint8_t marker = byte(at + 1);
    const std::size_t length = std::size_t{byte(at + 2)} << 8U | byte(at + 3);
    if (marker == scan || length < 2) return std::nullopt;
    const std::string_view segment = bytes.substr(at + 4, length - 2);
    if (marker == app1 && segment.starts_with(exif_mark)) return segment.substr(exif_mark.size());
    at += 2 + length;
  }
  return std::nullopt;
}

}  // namespace

int jpeg_orientation(std::string_view bytes) {
  const auto block = tiff_block(bytes);
  if (!block) return 1;
  const Tiff tiff(*block);
  const std::size_t directory = tiff.number(4, 4);
  const std::uint32_t entries = tiff.number(directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + i * entry_bytes;
    if (entry > block->size()) return 1;
    if (tiff.number(entry, 2) != orientation_tag) continue;
    const std::uint32_t value = tiff.number(entry + 8, 2);
    const bool known = tiff.number(entry + 2, 2) == short_type && value >= 1 && value <= 8;
    return known ? static_cast<int>(value) : 1;
  }
  return 1;
}

}  // namespace marketgen::io
