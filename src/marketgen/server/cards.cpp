#include "server/cards.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "catalog/country.h"
#include "io/file.h"
#include "plan/shelf_key.h"
#include "scene/placements.h"

namespace marketgen::server {
namespace {

void add_row(ProductCard& card, const catalog::Product& p) {
  card.sku = p.sku;
  card.ean = p.ean;
  card.plu = p.plu;
  card.name = p.name;
  card.name_zh = p.name_zh;
  card.brand = p.brand;
  card.variant = p.variant;
  card.description = p.description;
  card.category = p.category;
  card.subcategory = p.subcategory;
  card.net = p.net;
  card.price = p.price;
  card.currency = catalog::country_of(p).currency;
  const catalog::UnitPrice unit = catalog::unit_price(p);
  card.unit_price = unit.price;
  card.unit_of_measure = unit.per;
  card.size_mm = p.size_mm;
  card.mass_kg = p.mass_kg;
  card.friction = p.friction;
  card.material = p.material;
  card.rigidity = p.rigidity;
  card.storage = p.storage;
  card.orientation = p.orientation;
  card.archetype = p.archetype;
  card.stack_max = p.stack_max;
  card.shelf_life_days = p.shelf_life_days;
}

void add_place(ProductCard& card, const scene::Scene& scene, const scene::SceneProduct& item) {
  const Pose pose = scene::world_from_product(item);
  card.position_m = {pose.position.x, pose.position.y, pose.position.z};
  card.rotation = {pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w};
  card.misplaced = (item.flags & scene::product_misplaced) != 0;
  if (item.facing == scene::no_facing) return;
  const scene::Facing& facing = scene.facings[item.facing];
  const scene::SceneShelf& shelf = scene.shelves[facing.shelf];
  const layout::Fixture& fixture = scene.layout.fixtures[shelf.fixture];
  card.fixture = {shelf.fixture, fixture.id, fixture.kind};
  card.zone = fixture.zone;
  card.level = shelf.level;
  card.facing = {item.facing, facing.facings, facing.rows_deep, facing.stack, facing.product_count};
}

}  // namespace

std::vector<CardGrasp> grasps_of(const catalog::Product& product,
                                 const GraspFacts& facts,
                                 const std::vector<catalog::FrictionRow>& frictions) {
  std::vector<CardGrasp> grasps;
  for (const robots::GraspTool& tool : facts.tools) {
    const std::optional<grasping::GraspRate> rate = facts.table.find(product, tool, frictions);
    if (!rate) continue;
    grasps.push_back({tool.id,
                      rate->tries.size(),
                      rate->held(),
                      rate->tries.empty() ? "" : std::string(name_of(rate->tries[0].end)),
                      rate->excluded});
  }
  return grasps;
}

Result<GraspFacts> read_grasp_facts() {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  GraspFacts facts;
  MARKETGEN_TRY(facts.table, grasping::GraspTable::read(data));
  MARKETGEN_TRY(const std::vector<std::string> ids, robots::grasp_tool_ids(data));
  for (const std::string& id : ids) {
    MARKETGEN_TRY(robots::GraspTool tool, robots::load_grasp_tool(data, id));
    facts.tools.push_back(std::move(tool));
  }
  return facts;
}

ProductCard product_card(const scene::Scene& scene,
                         std::uint32_t row,
                         const GraspFacts& grasps,
                         const std::vector<catalog::FrictionRow>& frictions) {
  const scene::SceneProduct& item = scene.products[row];
  const catalog::Product& product = scene.catalog[item.sku];
  ProductCard card;
  card.row = row;
  card.id = scene::product_id(scene, row);
  card.sku_row = item.sku;
  add_row(card, product);
  add_place(card, scene, item);
  for (const scene::Facing& facing : scene.facings)
    card.facings_in_store += facing.sku == item.sku ? facing.facings : 0;
  for (const scene::SceneProduct& other : scene.products)
    card.items_in_store += other.sku == item.sku ? 1 : 0;
  card.promotion = std::ranges::any_of(scene.price_labels, [&](const scene::PriceLabel& label) {
    return label.sku == item.sku && label.facing == item.facing && label.promotion != 0;
  });
  card.grasps = grasps_of(product, grasps, frictions);
  return card;
}

FixtureCard fixture_card(const scene::Scene& scene, std::uint32_t row) {
  const scene::SceneFixture& placed = scene.fixtures[row];
  const layout::Fixture& f = scene.layout.fixtures[row];
  const Vec3 at = scene::world_from_fixture(scene, row).position;
  FixtureCard card;
  card.row = row;
  std::tie(card.id, card.run, card.kind, card.zone) = std::tie(f.id, f.run, f.kind, f.zone);
  card.position_m = {at.x, at.y, at.z};
  card.size_m = {f.width_mm * 1e-3, f.depth_mm * 1e-3, f.height_mm * 1e-3};
  std::tie(card.yaw_deg, card.levels, card.base_mm, card.spacing_mm, card.sides) =
      std::tie(f.yaw_deg, f.levels, f.base_mm, f.spacing_mm, f.sides);
  card.material = f.material;
  card.color = f.color;
  card.parts = placed.part_count;
  for (std::uint32_t j = placed.first_joint; j < placed.first_joint + placed.joint_count; ++j)
    card.joints.push_back(j);
  std::set<std::uint32_t> skus;
  for (std::uint32_t s = placed.first_shelf; s < placed.first_shelf + placed.shelf_count; ++s) {
    const scene::SceneShelf& shelf = scene.shelves[s];
    CardShelf line{
        shelf.level, shelf.side, shelf.use, shelf.width_m, shelf.depth_m, shelf.clearance_m};
    line.height_m = scene::world_from_shelf(scene, s).position.z;
    for (const scene::Facing& facing : scene.facings) {
      if (facing.shelf != s) continue;
      ++line.facings;
      line.products += facing.product_count;
      if (facing.product_count > 0) skus.insert(facing.sku);
    }
    card.products += line.products;
    card.shelves.push_back(line);
  }
  card.skus = skus.size();
  return card;
}

RunBlocks blocks_of_run(const scene::Scene& scene, const std::string& run) {
  RunBlocks line;
  for (std::uint32_t f = 0; f < scene.facings.size(); ++f) {
    const scene::Facing& facing = scene.facings[f];
    const scene::SceneShelf& shelf = scene.shelves[facing.shelf];
    const layout::Fixture& fixture = scene.layout.fixtures[shelf.fixture];
    if (fixture.run != run) continue;
    line.blocks.push_back({f,
                           fixture.id,
                           plan::shelf_side(shelf.side),
                           shelf.level + 1,
                           facing.position + 1,
                           scene.catalog[facing.sku].sku,
                           facing.facings,
                           facing.product_count});
  }
  return line;
}

}  // namespace marketgen::server
