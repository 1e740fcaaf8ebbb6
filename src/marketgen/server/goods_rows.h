// Single products as rows that a page draws: goods.bin, and what of it an edit changes.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "server/packed_sections.h"

namespace marketgen::server {

// Row of the shelf a product stands on, -1: none.
std::int32_t shelf_of(const scene::Scene& scene, const scene::SceneProduct& item);

class GoodsRows {
 public:
  // A row of the scene's products, whose SKU the page has under the number `sku`.
  void add(const scene::Scene& scene, std::size_t row, std::uint32_t sku);
  // Sections position, rotation, sku, fixture, shelf, facing, flags and tint, each after `prefix`.
  void pack(PackedSections& sections, const std::string& prefix) const;

 private:
  std::vector<float> position_;
  std::vector<std::int16_t> rotation_;
  std::vector<std::uint16_t> sku_, fixture_, shelf_;
  std::vector<std::uint32_t> facing_;
  std::vector<std::uint8_t> tint_, flags_;
};

}  // namespace marketgen::server
