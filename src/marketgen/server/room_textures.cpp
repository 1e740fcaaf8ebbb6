#include "server/room_textures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "io/jpeg.h"

namespace marketgen::server {
namespace {

constexpr int max_tile_px = 512;  // of a material's repeat, half a metre to two
constexpr int max_print_px = 1024;
constexpr float over_the_edge = 1e-3F;  // of UVs of a print

PictureSize size_within(int width, int height, int max_px) {
  const double scale = std::min(1.0, static_cast<double>(max_px) / std::max(width, height));
  const auto scaled = [&](int px) {
    return std::max(1, static_cast<int>(std::lround(px * scale)));
  };
  return {scaled(width), scaled(height)};
}

Result<ViewFile> jpeg_file(std::size_t number, const Image& image) {
  MARKETGEN_TRY(std::string bytes, io::encode_jpeg(image));
  return ViewFile{fmt::format("textures/{}.jpg", number), "image/jpeg", std::move(bytes)};
}

bool within(Vec2f uv) {
  return uv.x >= -over_the_edge && uv.x <= 1 + over_the_edge && uv.y >= -over_the_edge &&
         uv.y <= 1 + over_the_edge;
}

}  // namespace

RoomTextures::RoomTextures(const render::raytrace::World& world)
    : world_(world),
      uses_(world.textures.size(), Use::none),
      file_of_(world.textures.size(), -1),
      prints_(world.textures.size()) {
  for (const render::raytrace::TriangleSet* set :
       {&world.shell, &world.shell_glass, &world.ceiling})
    look_at(*set);
  for (std::size_t i = 0; i < world.first_product_instance; ++i) {
    const render::raytrace::TracedMesh& mesh = world.meshes[world.instances[i].mesh];
    look_at(mesh.solid);
    look_at(mesh.glass);
  }
  for (std::size_t t = 0; t < uses_.size(); ++t) {
    if (uses_[t] == Use::print)
      prints_[t] = size_within(world.textures[t].width(), world.textures[t].height(), max_print_px);
    if (uses_[t] != Use::repeats) continue;
    file_of_[t] = static_cast<int>(repeating_.size());
    repeating_.push_back(static_cast<int>(t));
  }
  pages_ = lay_out(prints_);
  for (std::size_t t = 0; t < uses_.size(); ++t) {
    if (pages_.places[t].page >= 0)
      file_of_[t] = static_cast<int>(repeating_.size()) + pages_.places[t].page;
  }
}

int RoomTextures::texture_of(std::uint16_t material) const {
  return world_.materials[material].texture;
}

// Materials with a relief are those of the catalogue, which are tiled wherever they are used.
void RoomTextures::look_at(const render::raytrace::TriangleSet& set) {
  for (std::size_t i = 0; i < set.triangles.size(); ++i) {
    const render::raytrace::TriangleRecord& record = set.records[i];
    const int texture = texture_of(record.material);
    if (texture < 0) continue;
    Use& use = uses_[static_cast<std::size_t>(texture)];
    const bool tiled =
        world_.materials[record.material].relief >= 0 || !std::ranges::all_of(record.uvs, within);
    if (tiled)
      use = Use::repeats;
    else if (use == Use::none)
      use = Use::print;
  }
}

int RoomTextures::file_of(std::uint16_t material) const {
  const int texture = texture_of(material);
  return texture < 0 ? -1 : file_of_[static_cast<std::size_t>(texture)];
}

Vec2f RoomTextures::uv_in_file(std::uint16_t material, Vec2f uv) const {
  const int texture = texture_of(material);
  if (texture < 0) return {0, 0};
  const auto t = static_cast<std::size_t>(texture);
  if (uses_[t] != Use::print) return uv;
  const auto [u0, v0, u1, v1] = tile_of(pages_, t, prints_);
  const float u = std::clamp(uv.x, 0.0F, 1.0F), v = std::clamp(uv.y, 0.0F, 1.0F);
  return {u0 + u * (u1 - u0), v0 + v * (v1 - v0)};
}

PictureSize RoomTextures::tile_size(std::size_t texture) const {
  const auto whole = world_.whole_tiles.find(texture);
  if (whole != world_.whole_tiles.end())
    return size_within(whole->second.width, whole->second.height, max_tile_px);
  const render::raytrace::Texture& tile = world_.textures[texture];
  return size_within(tile.width(), tile.height(), max_tile_px);
}

// Tiles that the world has coarsely are drawn whole, one at a time.
Result<Image> RoomTextures::tile_picture(std::size_t texture) const {
  const auto whole = world_.whole_tiles.find(texture);
  if (whole == world_.whole_tiles.end())
    return picture_of(world_.textures[texture], tile_size(texture));
  MARKETGEN_TRY(const render::raytrace::Texture tile, whole->second.draw());
  return picture_of(tile, tile_size(texture));
}

Result<std::vector<ViewFile>> RoomTextures::files() const {
  std::vector<ViewFile> files;
  for (const int texture : repeating_) {
    MARKETGEN_TRY(const Image picture, tile_picture(static_cast<std::size_t>(texture)));
    MARKETGEN_TRY(ViewFile file, jpeg_file(files.size(), picture));
    files.push_back(std::move(file));
  }
  for (std::size_t p = 0; p < pages_.pages.size(); ++p) {
    const Image page =
        painted_page(pages_, p, prints_, [&](std::size_t t) -> const render::raytrace::Texture& {
          return world_.textures[t];
        });
    MARKETGEN_TRY(ViewFile file, jpeg_file(files.size(), page));
    files.push_back(std::move(file));
  }
  return files;
}

nlohmann::ordered_json RoomTextures::list() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  const auto add = [&](PictureSize size, bool repeats) {
    list.push_back({{"path", fmt::format("textures/{}.jpg", list.size())},
                    {"width", size.width},
                    {"height", size.height},
                    {"repeat", repeats},
                    {"kind", repeats ? "tile" : "print"}});
  };
  for (const int texture : repeating_)
    add(tile_size(static_cast<std::size_t>(texture)), true);
  for (const PictureSize& page : pages_.pages)
    add(page, false);
  return list;
}

}  // namespace marketgen::server
