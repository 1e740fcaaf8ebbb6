#include "export/exporter.h"
#include "scene/planogram_rows.h"
#include "scene/query.h"

namespace marketgen::exporters {
namespace {

// How a pack is kept: planogram programs call it the merchandising style.
enum class Merchandising { unit, loose, peg };
constexpr std::array<std::string_view, 3> names_of(Merchandising) {
  return {"unit", "loose", "peg"};
}

enum class BaySide { front, back };
constexpr std::array<std::string_view, 2> names_of(BaySide) {
  return {"front", "back"};
}

// A row of the file, in the words of planogram programs; numbers of shelves, bays and positions
// count from 1.
struct PlanogramPosition {
  std::string store, run, fixture;
  BaySide side = BaySide::front;
  int bay = 1, bay_width_mm = 0, shelf = 1, shelf_height_mm = 0, position = 1;
  int x_mm = 0, y_mm = 0, z_mm = 0;
  std::string gtin, sku, name, brand, category, subcategory;
  int width_mm = 0, height_mm = 0, depth_mm = 0;
  int facings_wide = 0, facings_high = 0, facings_deep = 0, capacity = 0, units = 0;
  scene::PackFace orientation = scene::PackFace::front;
  Merchandising merchandising = Merchandising::unit;
  double price = 0;
  bool promotion = false;

  static constexpr auto fields = field_list(
      field("store", &PlanogramPosition::store, "the store's name"),
      field("run", &PlanogramPosition::run, "line of fixtures"),
      field("fixture", &PlanogramPosition::fixture, "module"),
      field("side", &PlanogramPosition::side, "of the module"),
      field("bay", &PlanogramPosition::bay, "along this side of the run, from the left"),
      field("bay_width_mm", &PlanogramPosition::bay_width_mm, "of its front"),
      field("shelf", &PlanogramPosition::shelf, "from the floor up"),
      field("shelf_height_mm", &PlanogramPosition::shelf_height_mm, "over the floor"),
      field("position", &PlanogramPosition::position, "on the shelf, from the left"),
      field("x_mm", &PlanogramPosition::x_mm, "left edge, from the bay's left"),
      field("y_mm", &PlanogramPosition::y_mm, "front edge, behind the bay's front"),
      field("z_mm", &PlanogramPosition::z_mm, "underside, over the floor"),
      field("gtin", &PlanogramPosition::gtin, "GTIN-13; none for what is sold by weight"),
      field("sku", &PlanogramPosition::sku, "SKU"),
      field("name", &PlanogramPosition::name, "name and variant"),
      field("brand", &PlanogramPosition::brand, "brand"),
      field("category", &PlanogramPosition::category, "category"),
      field("subcategory", &PlanogramPosition::subcategory, "subcategory"),
      field("width_mm", &PlanogramPosition::width_mm, "of one pack"),
      field("height_mm", &PlanogramPosition::height_mm, "of one pack"),
      field("depth_mm", &PlanogramPosition::depth_mm, "of one pack"),
      field("facings_wide", &PlanogramPosition::facings_wide, "packs side by side"),
      field("facings_high", &PlanogramPosition::facings_high, "packs on one another"),
      field("facings_deep", &PlanogramPosition::facings_deep, "packs one behind another"),
      field("capacity", &PlanogramPosition::capacity, "packs when full"),
      field("units", &PlanogramPosition::units, "packs that stand there"),
      field("orientation", &PlanogramPosition::orientation, "side that faces the shopper"),
      field("merchandising", &PlanogramPosition::merchandising, "how packs are kept"),
      field("price", &PlanogramPosition::price, "in the store's money"),
      field("promotion", &PlanogramPosition::promotion, "has a promotion label"));
};

Merchandising merchandising_of(assets::ShelfUse use) {
  switch (use) {
    case assets::ShelfUse::stand:
      return Merchandising::unit;
    case assets::ShelfUse::heap:
      return Merchandising::loose;
    case assets::ShelfUse::hang:
      return Merchandising::peg;
  }
  fatal("no such use of a shelf");
}

PlanogramPosition position_of(const scene::PlanogramRow& row, const std::string& store) {
  return {store,
          row.run,
          row.fixture,
          row.side == 0 ? BaySide::front : BaySide::back,
          row.bay,
          row.bay_width_mm,
          row.level + 1,
          row.shelf_height_mm,
          row.position + 1,
          row.bay_x_mm,
          row.bay_y_mm,
          row.bay_z_mm,
          row.ean,
          row.sku,
          row.name,
          row.brand,
          row.category,
          row.subcategory,
          row.width_mm,
          row.height_mm,
          row.depth_mm,
          row.facings,
          row.stack,
          row.depth_count,
          row.capacity,
          row.units,
          row.orientation,
          merchandising_of(row.use),
          row.price,
          row.promotion};
}

}  // namespace

Result<ExportFiles> write_planogram(const scene::Scene& scene, const ExportOptions&) {
  std::vector<PlanogramPosition> positions;
  for (const scene::PlanogramRow& row : scene::planogram_rows(scene))
    positions.push_back(position_of(row, scene.layout.name));
  return ExportFiles{scene::to_csv(scene::table_of(positions)), {}};
}

}  // namespace marketgen::exporters
