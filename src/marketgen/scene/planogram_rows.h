// The planogram as rows: what stands in each facing block, and where in its bay.
//
// A bay is one side of one module. Its frame: the left corner of its front on the floor, for who
// looks at it; X to the right along the front, Y into the bay, Z up.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "scene/scene.h"

namespace marketgen::scene {

// Which side of the first pack in a block one sees from the front; `loose` for goods in a heap.
enum class PackFace { front, back, side, top, bottom, loose };
constexpr std::array<std::string_view, 6> names_of(PackFace) {
  return {"front", "back", "side", "top", "bottom", "loose"};
}

struct PlanogramRow {
  std::string fixture;
  int level = 0, side = 0, position = 0;
  std::string sku, ean;
  int x_mm = 0, facings = 0, depth_count = 0, stack = 0;
  double price = 0;
  std::string run;
  int bay = 0, bay_width_mm = 0, shelf_height_mm = 0;
  int bay_x_mm = 0, bay_y_mm = 0, bay_z_mm = 0;
  std::string name, brand, category, subcategory;
  int width_mm = 0, depth_mm = 0, height_mm = 0, block_width_mm = 0;
  int capacity = 0, units = 0, misplaced = 0;
  PackFace orientation = PackFace::front;
  assets::ShelfUse use = assets::ShelfUse::stand;
  bool promotion = false;

  static constexpr auto fields = field_list(
      field("fixture", &PlanogramRow::fixture, "fixture id"),
      field("level", &PlanogramRow::level, "0 = lowest"),
      field("side", &PlanogramRow::side, "1 = back"),
      field("position", &PlanogramRow::position, "order from the left"),
      field("sku", &PlanogramRow::sku, "SKU"),
      field("ean", &PlanogramRow::ean, "EAN-13"),
      field("x_mm", &PlanogramRow::x_mm, "left edge"),
      field("facings", &PlanogramRow::facings, "packs side by side"),
      field("depth_count", &PlanogramRow::depth_count, "packs one behind another"),
      field("stack", &PlanogramRow::stack, "packs on one another"),
      field("price", &PlanogramRow::price, "in the store's money"),
      field("run", &PlanogramRow::run, "line of fixtures"),
      field("bay", &PlanogramRow::bay, "number of its bay on this side of the run, from the left"),
      field("bay_width_mm", &PlanogramRow::bay_width_mm, "of the bay's front"),
      field(
          "shelf_height_mm", &PlanogramRow::shelf_height_mm, "what packs stand on, over the floor"),
      field("bay_x_mm", &PlanogramRow::bay_x_mm, "left edge of the block, from the bay's left"),
      field("bay_y_mm", &PlanogramRow::bay_y_mm, "front edge of the shelf, from the bay's front"),
      field("bay_z_mm", &PlanogramRow::bay_z_mm, "underside of the block, over the floor"),
      field("name", &PlanogramRow::name, "name and variant"),
      field("brand", &PlanogramRow::brand, "brand"),
      field("category", &PlanogramRow::category, "category"),
      field("subcategory", &PlanogramRow::subcategory, "subcategory"),
      field("width_mm", &PlanogramRow::width_mm, "of one pack"),
      field("depth_mm", &PlanogramRow::depth_mm, "of one pack"),
      field("height_mm", &PlanogramRow::height_mm, "of one pack"),
      field("block_width_mm", &PlanogramRow::block_width_mm, "gaps between its packs included"),
      field("capacity", &PlanogramRow::capacity, "packs that the block holds when full"),
      field("units", &PlanogramRow::units, "packs that stand in it"),
      field("misplaced", &PlanogramRow::misplaced, "those of them that are of another SKU"),
      field("orientation", &PlanogramRow::orientation, "side of the pack that faces the shopper"),
      field("use", &PlanogramRow::use, "how goods are kept"),
      field("promotion", &PlanogramRow::promotion, "has a promotion label"));
};

// How far a shelf's left end lies from the left corner of its bay's front; metres.
double shelf_left_m(const Scene& scene, std::uint32_t shelf);

// One row a facing block, in the scene's order. Items that the plan pins to a place of their own
// stand in no block.
std::vector<PlanogramRow> planogram_rows(const Scene& scene);

}  // namespace marketgen::scene
