#include "render/picture_cache.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <optional>

#include "base/build_info.h"
#include "base/hash.h"
#include "io/file.h"
#include "render/art_fingerprint.h"
#include "render/texture.h"

namespace marketgen::raytrace {
namespace {

constexpr std::array<char, 4> picture_mark{'M', 'G', 'P', '2'};
constexpr std::array<char, 4> print_mark{'M', 'G', 'L', '1'};
constexpr int largest_side = 8192, most_channels = 8;

struct Header {
  std::array<char, 4> mark{};
  std::int32_t width = 0, height = 0;
  std::int32_t channels = 3;  // of a print: 1 with bars, 0 without
  std::uint64_t checksum =
      0;  // of what follows: a crash may leave a file of the right length and wrong content
};

// LabelBars as it lies in a file.
struct KeptBars {
  float u0 = 0, v0 = 0, u1 = 0, v1 = 0, foot = 0;
  std::int32_t ladder = 0;
  std::array<char, 96> modules{};  // 95, and a zero
};

template <class T>
std::string_view bytes_of(const std::vector<T>& items) {
  return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T)};
}

std::string file_of(Header header, std::string_view payload) {
  header.checksum = hash64(payload);
  std::string file(reinterpret_cast<const char*>(&header), sizeof(header));
  return file.append(payload);
}

// The header of a file that is whole and of this kind.
std::optional<Header> header_of(const std::string& file, std::array<char, 4> mark) {
  Header header;
  if (file.size() < sizeof(header)) return std::nullopt;
  std::memcpy(&header, file.data(), sizeof(header));
  const bool plausible = header.mark == mark && header.width > 0 && header.height > 0 &&
                         header.width <= largest_side && header.height <= largest_side &&
                         header.channels >= 0 && header.channels <= most_channels;
  if (!plausible) return std::nullopt;
  const std::string_view payload = std::string_view(file).substr(sizeof(header));
  if (hash64(payload) != header.checksum) return std::nullopt;
  return header;
}

std::optional<Image> decode_picture(const std::string& file) {
  const std::optional<Header> header = header_of(file, picture_mark);
  if (!header || header->channels == 0) return std::nullopt;
  Image image(header->width, header->height, header->channels);
  if (file.size() != sizeof(Header) + image.pixels.size()) return std::nullopt;
  std::memcpy(image.pixels.data(), file.data() + sizeof(Header), image.pixels.size());
  return image;
}

std::string encode_picture(const Image& image) {
  return file_of({picture_mark, image.width, image.height, image.channels, 0},
                 bytes_of(image.pixels));
}

LabelBars bars_of(const KeptBars& kept) {
  return {kept.u0, kept.v0, kept.u1, kept.v1, kept.foot, kept.ladder != 0, kept.modules.data()};
}

KeptBars kept(const LabelBars& bars) {
  KeptBars result{bars.u0, bars.v0, bars.u1, bars.v1, bars.foot, bars.ladder ? 1 : 0, {}};
  bars.modules.copy(result.modules.data(), result.modules.size() - 1);
  return result;
}

std::optional<Print> decode_print(const std::string& file) {
  const std::optional<Header> header = header_of(file, print_mark);
  if (!header) return std::nullopt;
  const std::size_t bars_size = header->channels == 0 ? 0 : sizeof(KeptBars);
  std::vector<std::uint64_t> blocks(BlockMips::block_count(header->width, header->height));
  const std::size_t blocks_size = blocks.size() * sizeof(blocks[0]);
  if (file.size() != sizeof(Header) + bars_size + blocks_size) return std::nullopt;
  Print print;
  if (bars_size > 0) {
    KeptBars bars;
    std::memcpy(&bars, file.data() + sizeof(Header), sizeof(bars));
    bars.modules.back() = 0;
    print.bars = bars_of(bars);
  }
  std::memcpy(blocks.data(), file.data() + sizeof(Header) + bars_size, blocks_size);
  print.blocks = BlockMips(header->width, header->height, std::move(blocks));
  return print;
}

std::string encode_print(const Print& print) {
  std::string payload;
  if (print.bars) {
    const KeptBars bars = kept(*print.bars);
    payload.assign(reinterpret_cast<const char*>(&bars), sizeof(bars));
  }
  payload.append(bytes_of(print.blocks.blocks()));
  return file_of({print_mark, print.blocks.width(), print.blocks.height(), print.bars ? 1 : 0, 0},
                 payload);
}

std::filesystem::path path_of(const std::string& content, std::string_view extension) {
  return cache_folder() / "labels" /
         (Hasher().add(art_fingerprint).add(program_version).add(content).hex() +
          std::string(extension));
}

void keep(const std::filesystem::path& path, const std::string& file) {
  std::error_code ignored;  // a cache that cannot be written costs time, nothing else
  std::filesystem::create_directories(path.parent_path(), ignored);
  (void)write_file(path, file).ok();
}

}  // namespace

Result<Image> cached_picture(const std::string& content,
                             const std::function<Result<Image>()>& draw) {
  const std::filesystem::path path = path_of(content, ".pic");
  if (const Result<std::string> file = read_file(path); file.ok()) {
    if (std::optional<Image> image = decode_picture(*file)) return *std::move(image);
  }
  MARKETGEN_TRY(Image image, draw());
  keep(path, encode_picture(image));
  return image;
}

Result<Print> cached_print(const std::string& content,
                           const std::function<Result<PrintedPicture>()>& draw) {
  const std::filesystem::path path = path_of(content, ".bc1");
  if (const Result<std::string> file = read_file(path); file.ok()) {
    if (std::optional<Print> print = decode_print(*file)) return *std::move(print);
  }
  MARKETGEN_TRY(const PrintedPicture drawn, draw());
  Print print{blocks_of(drawn.picture), drawn.bars, true};
  keep(path, encode_print(print));
  return print;
}

}  // namespace marketgen::raytrace
