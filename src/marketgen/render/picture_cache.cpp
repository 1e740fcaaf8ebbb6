#include "render/picture_cache.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <optional>

#include "base/build_info.h"
#include "base/hash.h"
#include "io/file.h"

namespace marketgen::raytrace {
namespace {

// Goes up whenever the drawing code changes what it draws.
constexpr std::string_view art_version = "art-1";
constexpr std::array<char, 4> file_mark{'M', 'G', 'P', '1'};
constexpr int largest_side = 8192;

struct Header {
  std::array<char, 4> mark = file_mark;
  std::int32_t width = 0, height = 0;
  std::uint64_t checksum =
      0;  // of the pixels: a crash may leave a file of the right length and wrong content
};

std::string_view bytes_of(const Image& image) {
  return {reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size()};
}

std::optional<Image> decode(const std::string& file) {
  Header header;
  if (file.size() < sizeof(header)) return std::nullopt;
  std::memcpy(&header, file.data(), sizeof(header));
  const bool plausible = header.mark == file_mark && header.width > 0 && header.height > 0 &&
                         header.width <= largest_side && header.height <= largest_side;
  if (!plausible) return std::nullopt;
  Image image(header.width, header.height, 3);
  if (file.size() != sizeof(header) + image.pixels.size()) return std::nullopt;
  std::memcpy(image.pixels.data(), file.data() + sizeof(header), image.pixels.size());
  if (hash64(bytes_of(image)) != header.checksum) return std::nullopt;
  return image;
}

std::string encode(const Image& image) {
  const Header header{file_mark, image.width, image.height, hash64(bytes_of(image))};
  std::string file(reinterpret_cast<const char*>(&header), sizeof(header));
  file.append(bytes_of(image));
  return file;
}

}  // namespace

Result<Image> cached_picture(const std::string& content,
                             const std::function<Result<Image>()>& draw) {
  const std::string name =
      Hasher().add(art_version).add(program_version).add(content).hex() + ".rgb";
  const std::filesystem::path folder = cache_folder() / "labels";
  if (const Result<std::string> file = read_file(folder / name); file.ok()) {
    if (std::optional<Image> image = decode(*file)) return *std::move(image);
  }
  MARKETGEN_TRY(Image image, draw());
  if (image.channels != 3) return image;
  std::error_code ignored;  // a cache that cannot be written costs time, nothing else
  std::filesystem::create_directories(folder, ignored);
  (void)write_file(folder / name, encode(image)).ok();
  return image;
}

}  // namespace marketgen::raytrace
