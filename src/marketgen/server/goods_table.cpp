// Where goods stand, and the light on them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/parallel.h"
#include "render/shading_math.h"
#include "render/tone.h"
#include "scene/placements.h"
#include "server/goods_rows.h"
#include "server/view_files.h"
#include "server/view_mesh.h"

namespace marketgen::server {
namespace {

using render::raytrace::LitWorld;

constexpr int faces = 6, channels = 3;

const std::array<Vec3f, faces> axes{
    Vec3f{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

// Half the extent of a pack along a direction of the store, whichever way it lies.
float reach_of(const catalog::Product& product, const Quaternion& rotation, Vec3f axis) {
  const Vec3 along = rotate(inverse(rotation), {axis.x, axis.y, axis.z});
  return static_cast<float>((std::abs(along.x) * product.width_m() +
                             std::abs(along.y) * product.depth_m() +
                             std::abs(along.z) * product.height_m()) /
                            2);
}

}  // namespace

ViewFile goods_table(const scene::Scene& scene) {
  GoodsRows rows;
  for (std::size_t row = 0; row < scene.products.size(); ++row)
    rows.add(scene, row, scene.products[row].sku);
  PackedSections sections;
  rows.pack(sections, "");
  sections.note("products", scene.products.size());
  const render::raytrace::FilmTable film = render::raytrace::film_table();
  sections.add("film", 1, std::span<const float>(film.values));
  return {"goods.bin", "application/octet-stream", sections.file()};
}

ViewFile goods_light(const LitWorld& lit, const scene::Scene& scene) {
  constexpr std::size_t row_bytes = faces * channels, grain = 512;
  std::vector<std::uint8_t> light(scene.products.size() * row_bytes);
  const float white = lit.world->exposure / render::raytrace::pi;
  parallel_for(
      scene.products.size(),
      [&](std::size_t row) {
        const scene::SceneProduct& item = scene.products[row];
        const catalog::Product& product = scene.catalog[item.sku];
        const Pose pose = scene::world_from_product(item);
        const Vec3f middle = to_float(pose * Vec3{0, 0, product.height_m() / 2});
        std::uint8_t* to = &light[row * row_bytes];
        for (const Vec3f& axis : axes) {
          const Vec3f face = middle + axis * reach_of(product, pose.rotation, axis);
          const render::raytrace::Place place =
              render::raytrace::place_of(face, axis, -1, shelf_of(scene, item));
          const Vec3f on = lit.field.at(place, axis) * white;
          for (const float channel : {on.x, on.y, on.z})
            *to++ = packed_light(channel);
        }
      },
      grain);
  PackedSections sections;
  sections.add("light", row_bytes, std::span<const std::uint8_t>(light));
  return {"goods-light.bin", "application/octet-stream", sections.file()};
}

}  // namespace marketgen::server
