#include "render/picture_cache.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <optional>

#include "base/build_info.h"
#include "base/hash.h"
#include "io/cache_entry.h"
#include "io/file.h"
#include "render/art_fingerprint.h"
#include "render/stage/texture.h"

namespace marketgen::render::raytrace {
namespace {

constexpr std::string_view picture_kind = "picture/3", print_kind = "print/2";
constexpr int largest_side = 8192, max_channels = 8;

// Before the pixels.
struct Header {
  std::int32_t width = 0, height = 0;
  std::int32_t channels = 3;  // of a print: 1 with bars, 0 without
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

std::string content_of(const Header& header, std::string_view payload) {
  std::string content(reinterpret_cast<const char*>(&header), sizeof(header));
  return content.append(payload);
}

std::optional<Header> header_of(const std::string& content) {
  Header header;
  if (content.size() < sizeof(header)) return std::nullopt;
  std::memcpy(&header, content.data(), sizeof(header));
  const bool plausible = header.width > 0 && header.height > 0 && header.width <= largest_side &&
                         header.height <= largest_side && header.channels >= 0 &&
                         header.channels <= max_channels;
  return plausible ? std::optional(header) : std::nullopt;
}

std::optional<Image> decode_picture(const std::string& file) {
  const std::optional<Header> header = header_of(file);
  if (!header || header->channels == 0) return std::nullopt;
  Image image(header->width, header->height, header->channels);
  if (file.size() != sizeof(Header) + image.pixels.size()) return std::nullopt;
  std::memcpy(image.pixels.data(), file.data() + sizeof(Header), image.pixels.size());
  return image;
}

std::string encode_picture(const Image& image) {
  return content_of({image.width, image.height, image.channels}, bytes_of(image.pixels));
}

assets::LabelBars bars_of(const KeptBars& kept) {
  return {kept.u0, kept.v0, kept.u1, kept.v1, kept.foot, kept.ladder != 0, kept.modules.data()};
}

KeptBars kept_bars(const assets::LabelBars& bars) {
  KeptBars result{bars.u0, bars.v0, bars.u1, bars.v1, bars.foot, bars.ladder ? 1 : 0, {}};
  bars.modules.copy(result.modules.data(), result.modules.size() - 1);
  return result;
}

std::optional<Print> decode_print(const std::string& file) {
  const std::optional<Header> header = header_of(file);
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
    const KeptBars bars = kept_bars(*print.bars);
    payload.assign(reinterpret_cast<const char*>(&bars), sizeof(bars));
  }
  payload.append(bytes_of(print.blocks.blocks()));
  return content_of({print.blocks.width(), print.blocks.height(), print.bars ? 1 : 0}, payload);
}

std::filesystem::path path_of(std::string_view kind, const std::string& content) {
  const std::string name =
      Hasher().add(art_fingerprint).add(program_version).add(kind).add(content).hex();
  return io::cache_folder() / "labels" / (name + (kind == print_kind ? ".bc1" : ".pic"));
}

// What `decode` makes of the entry.
template <class Decode>
auto kept(const std::filesystem::path& path, std::string_view kind, const Decode& decode)
    -> decltype(decode(std::string())) {
  const std::optional<std::string> content = io::kept_entry(path, kind);
  if (!content) return std::nullopt;
  auto decoded = decode(*content);
  if (!decoded) io::drop_entry(path, "cannot be understood");
  return decoded;
}

}  // namespace

Result<Image> cached_picture(const std::string& content,
                             const std::function<Result<Image>()>& draw) {
  const std::filesystem::path path = path_of(picture_kind, content);
  if (std::optional<Image> image = kept(path, picture_kind, decode_picture))
    return *std::move(image);
  MARKETGEN_TRY(Image image, draw());
  (void)io::keep_entry(path, picture_kind, encode_picture(image)).ok();
  return image;
}

Result<Print> cached_print(const std::string& content,
                           const std::function<Result<assets::PrintedPicture>()>& draw) {
  const std::filesystem::path path = path_of(print_kind, content);
  if (std::optional<Print> print = kept(path, print_kind, decode_print)) return *std::move(print);
  MARKETGEN_TRY(const assets::PrintedPicture drawn, draw());
  Print print{blocks_of(drawn.picture), drawn.bars, true, std::nullopt};
  if (const auto put = io::keep_entry(path, print_kind, encode_print(print)); !put.ok())
    print.unkept = put.error();
  return print;
}

}  // namespace marketgen::render::raytrace
