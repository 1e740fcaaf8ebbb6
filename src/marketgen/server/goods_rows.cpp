#include "server/goods_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "render/stage/item_look.h"
#include "scene/placements.h"
#include "server/view_mesh.h"

namespace marketgen::server {
namespace {

constexpr float tint_scale = 200;  // of a factor of 1: some are a little brighter

std::array<std::uint8_t, 3> packed_tint(std::size_t row, std::uint32_t sku) {
  using render::raytrace::ItemKind;
  const Vec3f tint = render::raytrace::look_of_item(row, sku, ItemKind::packed).tint;
  const auto byte = [](float factor) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(factor * tint_scale), 0L, 255L));
  };
  return {byte(tint.x), byte(tint.y), byte(tint.z)};
}

}  // namespace

std::int32_t shelf_of(const scene::Scene& scene, const scene::SceneProduct& item) {
  return item.facing == scene::no_facing
             ? -1
             : static_cast<std::int32_t>(scene.facings[item.facing].shelf);
}

void GoodsRows::add(const scene::Scene& scene, std::size_t row, std::uint32_t sku) {
  const scene::SceneProduct& item = scene.products[row];
  const Pose pose = scene::world_from_product(item);
  for (const double value : {pose.position.x, pose.position.y, pose.position.z})
    position_.push_back(static_cast<float>(value));
  const auto turned = packed_rotation(pose.rotation);
  rotation_.insert(rotation_.end(), turned.begin(), turned.end());
  sku_.push_back(static_cast<std::uint16_t>(sku));
  facing_.push_back(item.facing);
  flags_.push_back(static_cast<std::uint8_t>(item.flags));
  const std::int32_t on = shelf_of(scene, item);
  shelf_.push_back(on < 0 ? no_row : static_cast<std::uint16_t>(on));
  fixture_.push_back(
      on < 0 ? no_row
             : static_cast<std::uint16_t>(scene.shelves[static_cast<std::size_t>(on)].fixture));
  const auto factor = packed_tint(row, item.sku);
  tint_.insert(tint_.end(), factor.begin(), factor.end());
}

void GoodsRows::pack(PackedSections& sections, const std::string& prefix) const {
  const auto add = [&](const char* name, std::size_t components, const auto& values) {
    sections.add(prefix + name, components, std::span(values));
  };
  add("position", 3, position_);
  add("rotation", 4, rotation_);
  add("sku", 1, sku_);
  add("fixture", 1, fixture_);
  add("shelf", 1, shelf_);
  add("facing", 1, facing_);
  add("flags", 1, flags_);
  add("tint", 3, tint_);
}

}  // namespace marketgen::server
