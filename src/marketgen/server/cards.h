// The cards of what a person clicks on: one product, one fixture.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "grasping/grasp_table.h"
#include "plan/planogram.h"
#include "robots/grasp_tool.h"
#include "scene/scene.h"

namespace marketgen::server {

// What one tool made of the product in the grasp study that the program is shipped with.
struct CardGrasp {
  std::string tool;
  std::uint64_t tries = 0;
  int held = 0;
  std::string first;  // what became of the best candidate; empty without tries
  grasping::GraspExclusion excluded = grasping::GraspExclusion::none;
  static constexpr auto fields =
      field_list(field("tool", &CardGrasp::tool, "row of the tool"),
                 field("tries", &CardGrasp::tries, "candidates that were tried"),
                 field("held", &CardGrasp::held, "of them"),
                 field("first", &CardGrasp::first, "what became of the best"),
                 field("excluded", &CardGrasp::excluded, "why none was tried; none = some were"));
};

struct CardFacing {
  std::int64_t row = -1;  // -1: it stands in no block
  int facings = 0, rows_deep = 0, stack = 0;
  std::uint32_t products = 0;
  static constexpr auto fields =
      field_list(field("row", &CardFacing::row, "row in facings, -1 for none"),
                 field("facings", &CardFacing::facings, "packs side by side"),
                 field("rows_deep", &CardFacing::rows_deep, "packs one behind another"),
                 field("stack", &CardFacing::stack, "packs on one another"),
                 field("products", &CardFacing::products, "items in the block"));
};

struct CardFixture {
  std::int64_t row = -1;
  std::string id, kind;
  static constexpr auto fields = field_list(field("row", &CardFixture::row, "row, -1 for none"),
                                            field("id", &CardFixture::id, "id"),
                                            field("kind", &CardFixture::kind, "fixture kind"));
};

struct ProductCard {
  std::uint32_t row = 0;
  std::string id;
  std::uint32_t sku_row = 0;
  std::string sku, ean, plu, name, name_zh, brand, variant, description, category, subcategory, net;
  double price = 0;
  std::string currency;
  bool promotion = false;
  double unit_price = 0;
  std::string unit_of_measure;
  std::array<int, 3> size_mm{};
  double mass_kg = 0, friction = 0;
  std::string material;
  catalog::Rigidity rigidity = catalog::Rigidity::rigid;
  catalog::Storage storage = catalog::Storage::ambient;
  catalog::Orientation orientation = catalog::Orientation::upright;
  std::string archetype;
  int stack_max = 1, shelf_life_days = 0;
  std::array<double, 3> position_m{};
  std::array<double, 4> rotation{};
  bool misplaced = false;
  CardFixture fixture;
  std::string zone;
  int level = 0;
  CardFacing facing;
  std::uint64_t facings_in_store = 0, items_in_store = 0;
  std::vector<CardGrasp> grasps;

  static constexpr auto fields = field_list(
      field("row", &ProductCard::row, "row in products"),
      field("id", &ProductCard::id, "item id"),
      field("sku_row", &ProductCard::sku_row, "row of its SKU"),
      field("sku", &ProductCard::sku, "SKU"),
      field("ean", &ProductCard::ean, "EAN-13; empty for loose produce"),
      field("plu", &ProductCard::plu, "price look-up code of loose produce"),
      field("name", &ProductCard::name, "name"),
      field("name_zh", &ProductCard::name_zh, "name in Chinese"),
      field("brand", &ProductCard::brand, "brand"),
      field("variant", &ProductCard::variant, "variant"),
      field("description", &ProductCard::description, "one sentence"),
      field("category", &ProductCard::category, "category"),
      field("subcategory", &ProductCard::subcategory, "shelf group"),
      field("net", &ProductCard::net, "net quantity as printed"),
      field("price", &ProductCard::price, "in `currency`"),
      field("currency", &ProductCard::currency, "ISO 4217"),
      field("promotion", &ProductCard::promotion, "it is on offer"),
      field("unit_price", &ProductCard::unit_price, "in `currency`, a unit"),
      field("unit_of_measure", &ProductCard::unit_of_measure, "l, kg, piece, oz, lb or fl oz"),
      field("size_mm", &ProductCard::size_mm, "width, depth, height"),
      field("mass_kg", &ProductCard::mass_kg, "gross mass"),
      field("friction", &ProductCard::friction, "on a painted steel shelf"),
      field("material", &ProductCard::material, "contact material"),
      field("rigidity", &ProductCard::rigidity, "how it takes a grip"),
      field("storage", &ProductCard::storage, "temperature it is kept at"),
      field("orientation", &ProductCard::orientation, "ways it may be put down"),
      field("archetype", &ProductCard::archetype, "container shape"),
      field("stack_max", &ProductCard::stack_max, "items on one another"),
      field("shelf_life_days", &ProductCard::shelf_life_days, "from delivery to its date"),
      field("position_m", &ProductCard::position_m, "bottom centre, store frame"),
      field("rotation", &ProductCard::rotation, "x, y, z, w"),
      field("misplaced", &ProductCard::misplaced, "it stands in the wrong place"),
      field("fixture", &ProductCard::fixture, "what it stands on"),
      field("zone", &ProductCard::zone, "zone id"),
      field("level", &ProductCard::level, "0 = lowest"),
      field("facing", &ProductCard::facing, "its block"),
      field("facings_in_store", &ProductCard::facings_in_store, "packs in front rows, of its SKU"),
      field("items_in_store", &ProductCard::items_in_store, "of its SKU"),
      field("grasps", &ProductCard::grasps, "by tool"));
};

// A block of a line of shelves, by what swap_blocks of market-patch/1 names it.
struct RunBlock {
  std::uint32_t facing = 0;
  std::string fixture;
  plan::ShelfSide side = plan::ShelfSide::front;
  int shelf = 1, position = 1;
  std::string sku;
  int facings = 1;
  std::uint32_t products = 0;
  static constexpr auto fields =
      field_list(field("facing", &RunBlock::facing, "row in facings"),
                 field("fixture", &RunBlock::fixture, "id"),
                 field("side", &RunBlock::side, "of the fixture"),
                 field("shelf", &RunBlock::shelf, "from the floor up"),
                 field("position", &RunBlock::position, "from the left"),
                 field("sku", &RunBlock::sku, "product"),
                 field("facings", &RunBlock::facings, "packs side by side"),
                 field("products", &RunBlock::products, "items in it; 0 when it is sold out"));
};

struct RunBlocks {
  std::vector<RunBlock> blocks;
  static constexpr auto fields =
      field_list(field("blocks", &RunBlocks::blocks, "in the scene's order"));
};

struct CardShelf {
  int level = 0, side = 0;
  assets::ShelfUse use = assets::ShelfUse::stand;
  double width_m = 0, depth_m = 0, clearance_m = 0, height_m = 0;
  std::uint64_t facings = 0, products = 0;
  static constexpr auto fields =
      field_list(field("level", &CardShelf::level, "0 = lowest"),
                 field("side", &CardShelf::side, "1 = back of a double-sided fixture"),
                 field("use", &CardShelf::use, "how goods are kept"),
                 field("width_m", &CardShelf::width_m, "usable width"),
                 field("depth_m", &CardShelf::depth_m, "usable depth"),
                 field("clearance_m", &CardShelf::clearance_m, "free height"),
                 field("height_m", &CardShelf::height_m, "of the board above the floor"),
                 field("facings", &CardShelf::facings, "blocks"),
                 field("products", &CardShelf::products, "items"));
};

struct FixtureCard {
  std::uint32_t row = 0;
  std::string id, run, kind, zone;
  std::array<double, 3> position_m{}, size_m{};
  int yaw_deg = 0, levels = 0, base_mm = 0, spacing_mm = 0, sides = 1;
  std::string material, color;
  std::uint32_t parts = 0;
  std::vector<CardShelf> shelves;
  std::vector<std::uint32_t> joints;
  std::uint64_t products = 0, skus = 0;

  static constexpr auto fields =
      field_list(field("row", &FixtureCard::row, "row in fixtures"),
                 field("id", &FixtureCard::id, "id"),
                 field("run", &FixtureCard::run, "the line it stands in"),
                 field("kind", &FixtureCard::kind, "fixture kind"),
                 field("zone", &FixtureCard::zone, "zone id"),
                 field("position_m", &FixtureCard::position_m, "middle of its footprint"),
                 field("yaw_deg", &FixtureCard::yaw_deg, "0 = front faces south"),
                 field("size_m", &FixtureCard::size_m, "width, depth, height"),
                 field("levels", &FixtureCard::levels, "stocked levels"),
                 field("base_mm", &FixtureCard::base_mm, "top of the lowest level"),
                 field("spacing_mm", &FixtureCard::spacing_mm, "between levels"),
                 field("sides", &FixtureCard::sides, "2 when stocked from both"),
                 field("material", &FixtureCard::material, "of its body"),
                 field("color", &FixtureCard::color, "of its body"),
                 field("parts", &FixtureCard::parts, "minimal units"),
                 field("shelves", &FixtureCard::shelves, "stocked surfaces"),
                 field("joints", &FixtureCard::joints, "rows of what moves"),
                 field("products", &FixtureCard::products, "items on it"),
                 field("skus", &FixtureCard::skus, "different ones"));
};

// What cards read beside the scene. Read once; the table lies in the data folder.
struct GraspFacts {
  grasping::GraspTable table;
  std::vector<robots::GraspTool> tools;
};
// Errors: those of GraspTable::read and load_grasp_tool.
Result<GraspFacts> read_grasp_facts();

// One a tool that the study had on the product.
std::vector<CardGrasp> grasps_of(const catalog::Product& product,
                                 const GraspFacts& facts,
                                 const std::vector<catalog::FrictionRow>& frictions);

// Precondition: `row` is a row of the scene's products, of its fixtures.
ProductCard product_card(const scene::Scene& scene,
                         std::uint32_t row,
                         const GraspFacts& grasps,
                         const std::vector<catalog::FrictionRow>& frictions);
FixtureCard fixture_card(const scene::Scene& scene, std::uint32_t row);
// What stands on the line, both sides; nothing where there is no such line.
RunBlocks blocks_of_run(const scene::Scene& scene, const std::string& run);

}  // namespace marketgen::server
