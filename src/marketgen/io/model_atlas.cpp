#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "geometry/srgb.h"
#include "io/model_glb.h"

namespace marketgen::io {
namespace {

constexpr int widest_atlas = 4096, highest_atlas = 8192;  // pixels; larger pictures are thinned out

// sRGB of IEC 61966-2-1, and back, for factors that are given in linear light.
double linear_of(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
std::uint8_t encoded(double linear) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(srgb_encoded(linear), 0.0, 1.0)));
}

// One picture under one factor.
struct Tile {
  int picture = 0;
  Vec3f factor;
  friend bool operator<(const Tile& a, const Tile& b) {
    return std::tie(a.picture, a.factor.x, a.factor.y, a.factor.z) <
           std::tie(b.picture, b.factor.x, b.factor.y, b.factor.z);
  }
};

// `source` under `factor`, without its alpha: nearest pixels, as sizes hardly differ.
Image painted(const Image& source, Vec3f factor, int width, int height) {
  Image image(width, height);
  const std::array<double, 3> factors{factor.x, factor.y, factor.z};
  std::array<std::array<std::uint8_t, 256>, 3> table{};
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t v = 0; v < 256; ++v)
      table[c][v] = factors[c] == 1 ? static_cast<std::uint8_t>(v)
                                    : encoded(linear_of(static_cast<std::uint8_t>(v)) * factors[c]);
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* from =
          source.at(static_cast<int>(std::int64_t{x} * source.width / width),
                    static_cast<int>(std::int64_t{y} * source.height / height));
      for (std::size_t c = 0; c < 3; ++c)
        image.at(x, y)[c] = table[c][from[c]];
    }
  }
  return image;
}

struct Rows {
  int first = 0, count = 0;
};

// The tiles of a model, one below another.
struct Atlas {
  Image image;
  std::map<Tile, Rows> rows;
};

Atlas atlas_of(const OutsideModel& model) {
  std::set<Tile> tiles;
  for (const std::uint16_t surface : model.mesh.surfaces) {
    const ModelMaterial& material = model.materials[surface];
    if (material.picture >= 0) tiles.insert({material.picture, material.color});
  }
  int width = 1;
  for (const Tile& tile : tiles)
    width = std::max(width, model.pictures[static_cast<std::size_t>(tile.picture)].width);
  width = std::min(width, widest_atlas);
  const int highest = highest_atlas / std::max(1, static_cast<int>(tiles.size()));
  Atlas atlas;
  std::vector<Image> images;
  int height = 0;
  for (const Tile& tile : tiles) {
    const Image& picture = model.pictures[static_cast<std::size_t>(tile.picture)];
    const std::int64_t rise = std::int64_t{picture.height} * width / picture.width;
    images.push_back(painted(
        picture, tile.factor, width, static_cast<int>(std::clamp<std::int64_t>(rise, 1, highest))));
    atlas.rows[tile] = {height, images.back().height};
    height += images.back().height;
  }
  if (images.empty()) return atlas;
  atlas.image = Image(width, height);
  auto* out = atlas.image.pixels.data();
  for (const Image& image : images)
    out = std::copy(image.pixels.begin(), image.pixels.end(), out);
  return atlas;
}

// Moves UVs from the tiles to the atlas; vertices that serve two tiles are doubled.
class UvMover {
 public:
  UvMover(OutsideModel& model, const Atlas& atlas) : model_(model), atlas_(atlas) {}

  void move() {
    const Mesh source = std::exchange(model_.mesh, Mesh{});
    for (std::size_t t = 0; t < source.triangles.size(); ++t) {
      const ModelMaterial& material = model_.materials[source.surfaces[t]];
      std::array<std::uint32_t, 3> corners{};
      const Vec2f shift = shift_of(source, source.triangles[t]);
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = moved(source, source.triangles[t][i], material, shift);
      model_.mesh.add_triangle(corners[0], corners[1], corners[2], source.surfaces[t]);
    }
    if (cut_)
      model_.remarks.emplace_back("a picture repeats over a triangle; it is cut at its border");
  }

 private:
  // Whole repeats to take away so that the triangle lies in the first one.
  static Vec2f shift_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    Vec2f low = mesh.uvs[triangle[0]];
    for (const std::uint32_t vertex : triangle) {
      low.x = std::min(low.x, mesh.uvs[vertex].x);
      low.y = std::min(low.y, mesh.uvs[vertex].y);
    }
    return {std::floor(low.x), std::floor(low.y)};
  }

  std::uint32_t moved(const Mesh& source,
                      std::uint32_t vertex,
                      const ModelMaterial& material,
                      Vec2f shift) {
    Vec2f uv = source.uvs[vertex];
    if (material.picture >= 0) {
      const Rows rows = atlas_.rows.at({material.picture, material.color});
      if (atlas_.rows.size() > 1) {
        uv = uv - shift;
        cut_ = cut_ || uv.x > 1 || uv.y > 1;
        uv = {std::min(uv.x, 1.0F), std::min(uv.y, 1.0F)};
        // Half a pixel inside, so that no neighbour shines through.
        const float rise = std::clamp(
            uv.y * static_cast<float>(rows.count), 0.5F, static_cast<float>(rows.count) - 0.5F);
        uv.y = (static_cast<float>(rows.first) + rise) / static_cast<float>(atlas_.image.height);
      }
    }
    const auto [entry, is_new] = copies_.try_emplace(
        {vertex, uv.x, uv.y}, static_cast<std::uint32_t>(model_.mesh.positions.size()));
    if (is_new) model_.mesh.add_vertex(source.positions[vertex], source.normals[vertex], uv);
    return entry->second;
  }

  OutsideModel& model_;
  const Atlas& atlas_;
  std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> copies_;
  bool cut_ = false;
};

}  // namespace

void merge_pictures(OutsideModel& model) {
  Atlas atlas = atlas_of(model);
  UvMover(model, atlas).move();
  for (ModelMaterial& material : model.materials) {
    if (material.picture < 0) continue;
    material.picture = atlas.image.empty() ? -1 : 0;
    if (material.picture == 0) material.color = {1, 1, 1};
  }
  model.pictures.clear();
  if (!atlas.image.empty()) model.pictures.push_back(std::move(atlas.image));
}

}  // namespace marketgen::io
