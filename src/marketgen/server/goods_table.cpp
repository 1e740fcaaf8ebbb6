// Where goods stand, and the light on them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/parallel.h"
#include "render/shading_math.h"
#include "render/stage/item_look.h"
#include "scene/placements.h"
#include "server/view_files.h"
#include "server/view_mesh.h"

namespace marketgen::server {
namespace {

using render::raytrace::LitWorld;

constexpr float tint_scale = 200;  // of a factor of 1: some are a little brighter
constexpr int faces = 6, channels = 3;

const std::array<Vec3f, faces> axes{
    Vec3f{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

std::int32_t shelf_of(const scene::Scene& scene, const scene::SceneProduct& item) {
  return item.facing == scene::no_facing
             ? -1
             : static_cast<std::int32_t>(scene.facings[item.facing].shelf);
}

std::array<std::uint8_t, 3> packed_tint(std::size_t row, std::uint32_t sku) {
  using render::raytrace::ItemKind;
  const Vec3f tint = render::raytrace::look_of_item(row, sku, ItemKind::packed).tint;
  const auto byte = [](float factor) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(factor * tint_scale), 0L, 255L));
  };
  return {byte(tint.x), byte(tint.y), byte(tint.z)};
}

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
  std::vector<float> position;
  std::vector<std::int16_t> rotation;
  std::vector<std::uint16_t> sku, fixture, shelf;
  std::vector<std::uint32_t> facing;
  std::vector<std::uint8_t> tint, flags;
  for (std::size_t row = 0; row < scene.products.size(); ++row) {
    const scene::SceneProduct& item = scene.products[row];
    const Pose pose = scene::world_from_product(item);
    for (const double value : {pose.position.x, pose.position.y, pose.position.z})
      position.push_back(static_cast<float>(value));
    const auto turned = packed_rotation(pose.rotation);
    rotation.insert(rotation.end(), turned.begin(), turned.end());
    sku.push_back(static_cast<std::uint16_t>(item.sku));
    facing.push_back(item.facing);
    flags.push_back(static_cast<std::uint8_t>(item.flags));
    const std::int32_t on = shelf_of(scene, item);
    shelf.push_back(on < 0 ? no_row : static_cast<std::uint16_t>(on));
    fixture.push_back(
        on < 0 ? no_row
               : static_cast<std::uint16_t>(scene.shelves[static_cast<std::size_t>(on)].fixture));
    const auto factor = packed_tint(row, item.sku);
    tint.insert(tint.end(), factor.begin(), factor.end());
  }
  PackedSections sections;
  sections.add("position", 3, std::span<const float>(position));
  sections.add("rotation", 4, std::span<const std::int16_t>(rotation));
  sections.add("sku", 1, std::span<const std::uint16_t>(sku));
  sections.add("fixture", 1, std::span<const std::uint16_t>(fixture));
  sections.add("shelf", 1, std::span<const std::uint16_t>(shelf));
  sections.add("facing", 1, std::span<const std::uint32_t>(facing));
  sections.add("flags", 1, std::span<const std::uint8_t>(flags));
  sections.add("tint", 3, std::span<const std::uint8_t>(tint));
  sections.note("products", scene.products.size());
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
