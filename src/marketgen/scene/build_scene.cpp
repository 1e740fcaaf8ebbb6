#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "base/parallel.h"
#include "base/text.h"
#include "layout/module_spec.h"
#include "scene/bays.h"
#include "scene/catalog_slice.h"
#include "scene/fitted_shelves.h"
#include "scene/handled_goods.h"
#include "scene/placements.h"
#include "scene/price_tags.h"
#include "scene/row_arrays.h"
#include "scene/sales.h"
#include "scene/scene.h"
#include "scene/shelf_fill.h"
#include "scene/sold_goods.h"
#include "scene/stocked_shelf.h"
#include "scene/store_catalog.h"

namespace marketgen::scene {
namespace {

auto key_of(const assets::FixtureShape& s) {
  return std::tuple(s.generator,
                    s.width_mm,
                    s.depth_mm,
                    s.height_mm,
                    s.levels,
                    s.base_mm,
                    s.spacing_mm,
                    s.sides,
                    s.start,
                    s.end,
                    s.material,
                    s.color,
                    s.accent,
                    s.spacings_mm,
                    s.back_spacings_mm,
                    s.board_mm,
                    s.shelf_tilt_deg,
                    s.fence_mm,
                    s.header_mm);
}

// Models of every module; equal shapes are built once.
class FixtureModels {
 public:
  static Result<FixtureModels> build(const layout::Layout& layout,
                                     const catalog::Catalog& catalog) {
    FixtureModels models;
    std::map<decltype(key_of(assets::FixtureShape{})), std::size_t> known;
    std::vector<assets::FixtureShape> shapes;
    for (const layout::Fixture& fixture : layout.fixtures) {
      const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
      if (kind == nullptr)
        return Error{"catalog.unknown_kind",
                     "layout:" + fixture.id,
                     "no fixture kind \"" + fixture.kind + "\""};
      const assets::FixtureShape shape = layout::fixture_shape(fixture, *kind, layout.look);
      const auto [entry, is_new] = known.try_emplace(key_of(shape), shapes.size());
      if (is_new) shapes.push_back(shape);
      models.model_of_fixture_.push_back(entry->second);
    }
    for (const assets::FixtureShape& shape : shapes) {
      MARKETGEN_TRY(assets::FixtureModel model, assets::make_fixture_model(shape, catalog));
      models.models_.push_back(std::move(model));
    }
    return models;
  }

  const assets::FixtureModel& of(std::size_t fixture) const {
    return models_[model_of_fixture_[fixture]];
  }

 private:
  std::vector<assets::FixtureModel> models_;
  std::vector<std::size_t> model_of_fixture_;
};

// Index of a material in scene.materials, adding it when it is new. -1 for none.
std::int32_t material_row(Scene& scene, const std::string& id, const catalog::Catalog& catalog) {
  const catalog::MaterialRow* row = id.empty() ? nullptr : catalog.material(id);
  if (row == nullptr) return -1;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (scene.materials[i].id == id) return static_cast<std::int32_t>(i);
  }
  scene.materials.push_back(*row);
  return static_cast<std::int32_t>(scene.materials.size() - 1);
}

// The scene's row of a fixture's own; -1 stays -1.
std::int32_t joint_row(std::uint32_t first_joint, int joint) {
  return joint < 0 ? -1 : static_cast<std::int32_t>(first_joint) + joint;
}

void add_part(Scene& scene,
              std::uint32_t fixture,
              std::uint32_t first_joint,
              const assets::FixturePart& part,
              const catalog::Catalog& catalog) {
  ScenePart row;
  row.fixture = fixture;
  row.unit = part.unit;
  row.shape = part.shape;
  row.kind = part.surface.kind;
  row.position_m = as_array(part.fixture_from_part.position);
  row.rotation_wxyz = as_array(part.fixture_from_part.rotation);
  row.half_size_m = as_array(part.half_size);
  row.color = as_array(part.surface.color);
  row.roughness = part.surface.roughness;
  row.metallic = part.surface.metallic;
  row.material = material_row(scene, part.surface.texture, catalog);
  row.joint = joint_row(first_joint, part.joint);
  scene.parts.push_back(row);
}

void add_joint(Scene& scene,
               std::uint32_t fixture,
               std::uint32_t first_joint,
               const assets::FixtureJoint& joint) {
  SceneJoint row;
  row.fixture = fixture;
  row.name = joint.name;
  row.kind = joint.kind;
  row.parent = joint_row(first_joint, joint.parent);
  row.position_m = as_array(joint.fixture_from_joint.position);
  row.rotation_wxyz = as_array(joint.fixture_from_joint.rotation);
  row.lower = static_cast<float>(joint.lower);
  row.upper = static_cast<float>(joint.upper);
  row.friction = static_cast<float>(joint.friction);
  row.damping = static_cast<float>(joint.damping);
  row.stiffness = static_cast<float>(joint.stiffness);
  row.spring_rest = static_cast<float>(joint.spring_rest);
  row.hold_open = static_cast<float>(joint.hold_open);
  row.mass_kg = static_cast<float>(joint.mass_kg);
  row.states = joint.states;
  row.gasket = static_cast<float>(joint.gasket);
  row.gasket_reach = static_cast<float>(joint.gasket_reach);
  scene.joints.push_back(std::move(row));
}

void add_shelf(Scene& scene, std::uint32_t fixture, const assets::ShelfSurface& shelf) {
  SceneShelf row;
  row.fixture = fixture;
  row.level = shelf.level;
  row.side = shelf.side;
  row.use = shelf.use;
  row.position_m = as_array(shelf.fixture_from_shelf.position);
  row.rotation_wxyz = as_array(shelf.fixture_from_shelf.rotation);
  row.width_m = static_cast<float>(shelf.width_m);
  row.depth_m = static_cast<float>(shelf.depth_m);
  row.clearance_m = static_cast<float>(shelf.clearance_m);
  row.price_rail = shelf.price_rail ? 1 : 0;
  scene.shelves.push_back(row);
}

void add_fixture(Scene& scene,
                 const layout::Fixture& fixture,
                 const assets::FixtureModel& model,
                 const catalog::Catalog& catalog) {
  const auto index = static_cast<std::uint32_t>(scene.fixtures.size());
  SceneFixture row;
  row.first_part = static_cast<std::uint32_t>(scene.parts.size());
  row.part_count = static_cast<std::uint32_t>(model.parts.size());
  row.first_shelf = static_cast<std::uint32_t>(scene.shelves.size());
  row.shelf_count = static_cast<std::uint32_t>(model.shelves.size());
  row.position_m = as_array(Vec3{fixture.x_mm * 1e-3, fixture.y_mm * 1e-3, 0});
  row.quarter_turns = fixture.yaw_deg / 90;
  row.first_joint = static_cast<std::uint32_t>(scene.joints.size());
  row.joint_count = static_cast<std::uint32_t>(model.joints.size());
  for (const assets::FixturePart& part : model.parts)
    add_part(scene, index, row.first_joint, part, catalog);
  for (const assets::FixtureJoint& joint : model.joints)
    add_joint(scene, index, row.first_joint, joint);
  for (const assets::ShelfSurface& shelf : model.shelves)
    add_shelf(scene, index, shelf);
  scene.fixtures.push_back(row);
}

// Refuses a scene that would take gigabytes before the first item of it is laid.
Result<void> check_number(const std::vector<BayRef>& bays,
                          const Scene& scene,
                          const plan::Plan& plan,
                          const catalog::Catalog& catalog) {
  std::uint64_t number = plan.placements.size();
  for (const BayRef& ref : bays) {
    const plan::StockSpec& stock = zone_or_usual(plan, ref.zone).stock;
    for (std::size_t s = 0; s < ref.plan.size(); ++s) {
      for (const PlannedBlock& block : ref.plan[s])
        number += max_items(block, ref.bay.shelves[s], stock, catalog);
    }
  }
  if (number <= max_scene_products) return {};
  return Error{"scene.too_large",
               "plan:/zones",
               fmt::format("its {} shelves have room for {} products, more than the {} that a "
                           "scene may hold; make the shop smaller, or stock larger goods",
                           with_thousands(static_cast<std::int64_t>(scene.shelves.size())),
                           with_thousands(static_cast<std::int64_t>(number)),
                           with_thousands(static_cast<std::int64_t>(max_scene_products)))};
}

using FilledBay = std::vector<std::vector<FilledBlock>>;  // per shelf

// What was sold until the plan's time; nothing where it has none.
Result<std::optional<StoreSales>> sales_of(const plan::Plan& plan,
                                           const catalog::Catalog& catalog) {
  if (!plan.time) return std::optional<StoreSales>();
  MARKETGEN_TRY(const plan::StoreTime time,
                plan::parse_store_time(*plan.time, "plan.bad_value", "plan:/time"));
  return std::optional<StoreSales>(StoreSales(plan, time, catalog));
}

// One shelf that shoppers come to.
struct ShoppedShelf {
  const PlannedShelf& planned;
  const ShelfRoom& room;
  const plan::StockSpec& stock;
  Seed fill, disorder;  // its own
};

// Takes off a shelf what was sold of it, and leaves the rest as shoppers do. Where nothing stands
// out of line, staff have just faced it up: what is gone is missing at the back.
void sell(std::vector<FilledBlock>& blocks,
          const ShoppedShelf& shelf,
          const StoreSales& sales,
          const catalog::Catalog& catalog) {
  SoldOfShelf sold;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const catalog::Product& product = catalog.products[blocks[i].product];
    const bool heaped = lies_in_a_heap(product);
    const Seed own = shelf.fill.child("sold", i);
    UnitsWanted wanted =
        sales.wanted(product, capacity_of(blocks[i], heaped), own.child("when").stream());
    if (shelf.stock.jitter == 0) wanted = {wanted.all(), 0};
    sold.push_back(take_sold(
        blocks[i], wanted, heaped, shelf.planned[i].certain, own.child("where").stream()));
  }
  handle_goods(blocks,
               sold,
               shelf.planned,
               shelf.room,
               shelf.stock.jitter,
               catalog,
               shelf.fill.child("handled"),
               shelf.disorder);
}

std::vector<FilledBay> fill_bays(const std::vector<BayRef>& bays,
                                 const Scene& scene,
                                 const plan::Plan& plan,
                                 const std::optional<StoreSales>& sales,
                                 const catalog::Catalog& catalog,
                                 Seed seed,
                                 Seed disorder) {
  return parallel_map(bays.size(), [&](std::size_t i) {
    const BayRef& ref = bays[i];
    const plan::StockSpec& stock = zone_or_usual(plan, ref.zone).stock;
    const std::string& fixture = scene.layout.fixtures[ref.fixture].id;
    FilledBay filled;
    for (std::size_t s = 0; s < ref.shelves.size(); ++s) {
      const std::uint64_t shelf = ref.shelves[s] - scene.fixtures[ref.fixture].first_shelf;
      const Seed shelf_seed = seed.child("shelf_fill", fixture).child("shelf", shelf);
      filled.push_back(
          fill_shelf(ref.plan[s], ref.bay.shelves[s], stock, catalog, shelf_seed.stream()));
      const Seed strange = disorder.child("put_down", fixture).child("shelf", shelf);
      if (sales)
        sell(filled.back(),
             {ref.plan[s], ref.bay.shelves[s], stock, shelf_seed, strange},
             *sales,
             catalog);
    }
    return filled;
  });
}

constexpr double promotion_share = 0.08;  // of price labels are yellow

void add_price_label(Scene& scene,
                     std::uint32_t shelf,
                     const FilledBlock& block,
                     const catalog::Product& product,
                     Stream draw) {
  PriceLabel label = tag_before_block(shelf, block.x_m, block.width_m);
  label.sku = block.product;
  label.facing = static_cast<std::uint32_t>(scene.facings.size());
  label.promotion = draw.chance(promotion_share) ? 1 : 0;
  label.price_cents = price_cents(product);
  scene.price_labels.push_back(label);
}

// Appends a block; SKU columns hold rows of the whole catalogue until take_catalog_slice.
void add_block(Scene& scene,
               std::uint32_t shelf,
               std::uint16_t position,
               const FilledBlock& block,
               const Pose& world_from_shelf,
               const catalog::Catalog& catalog,
               Seed seed) {
  const catalog::Product& product = catalog.products[block.product];
  if (scene.shelves[shelf].price_rail != 0) {
    add_price_label(scene, shelf, block, product, seed.child("price_label", position).stream());
  }
  Facing row;
  row.shelf = shelf;
  row.sku = block.product;
  row.x_m = static_cast<float>(block.x_m);
  row.width_m = static_cast<float>(block.width_m);
  row.facings = static_cast<std::uint16_t>(block.facings);
  row.rows_deep = static_cast<std::uint16_t>(block.rows_deep);
  row.stack = static_cast<std::uint16_t>(block.stack);
  row.position = position;
  row.first_product = static_cast<std::uint32_t>(scene.products.size());
  row.product_count = static_cast<std::uint32_t>(block.items.size());
  for (const ShelfItem& item : block.items) {
    const Pose world_from_item =
        world_from_shelf * Pose{item.position + Vec3{0, assets::goods_front_m, 0}, item.rotation};
    scene.products.push_back({item.product,
                              static_cast<std::uint32_t>(scene.facings.size()),
                              as_array(world_from_item.position),
                              as_array(world_from_item.rotation),
                              item.flags});
  }
  scene.facings.push_back(row);
}

void add_stock(Scene& scene,
               const std::vector<BayRef>& bays,
               const std::vector<FilledBay>& filled,
               const catalog::Catalog& catalog,
               Seed seed) {
  // Rows follow the shelves' order, not the zones': an edit in one zone then moves no other zone's
  // rows relative to its shelf.
  std::vector<const std::vector<FilledBlock>*> by_shelf(scene.shelves.size(), nullptr);
  for (std::size_t b = 0; b < bays.size(); ++b) {
    for (std::size_t s = 0; s < bays[b].shelves.size(); ++s)
      by_shelf[bays[b].shelves[s]] = &filled[b][s];
  }
  for (std::uint32_t shelf = 0; shelf < by_shelf.size(); ++shelf) {
    if (by_shelf[shelf] == nullptr) continue;
    const Pose pose = world_from_shelf(scene, shelf);
    const Seed shelf_seed =
        seed.child("prices", scene.layout.fixtures[scene.shelves[shelf].fixture].id)
            .child("shelf", shelf - scene.fixtures[scene.shelves[shelf].fixture].first_shelf);
    std::uint16_t position = 0;
    for (const FilledBlock& block : *by_shelf[shelf])
      add_block(scene, shelf, position++, block, pose, catalog, shelf_seed);
  }
}

// The store without goods.
Result<Scene> bare_scene(layout::Layout layout, const catalog::Catalog& catalog, Seed seed) {
  Scene scene;
  scene.seed = seed.value();
  scene.layout = std::move(layout);
  const plan::Look& look = scene.layout.look;
  for (const std::string* id : {&look.floor, &look.wall, &look.ceiling, &look.fixture})
    material_row(scene, *id, catalog);
  const std::vector<layout::Fixture>& fixtures = scene.layout.fixtures;
  MARKETGEN_TRY(const FixtureModels models, FixtureModels::build(scene.layout, catalog));
  for (std::size_t f = 0; f < fixtures.size(); ++f)
    add_fixture(scene, fixtures[f], models.of(f), catalog);
  return scene;
}

}  // namespace

Result<Scene> build_scene(const layout::Layout& layout,
                          const plan::Plan& plan,
                          const catalog::Catalog& catalog,
                          Seed seed) {
  const StoreCatalog local(catalog, plan);
  const catalog::Catalog& rows = local.get();
  const bool fits_boards = plan.shelves == plan::ShelfPitch::fitted;
  MARKETGEN_TRY(Scene scene,
                bare_scene(fits_boards ? before_fitting(layout, plan, rows) : layout, rows, seed));

  const auto of = [&](std::optional<std::uint64_t> plan::Vary::*axis) {
    return plan::axis_seed(plan.vary, axis, seed, scene_stream);
  };
  const Seed prices = of(&plan::Vary::prices), planogram = of(&plan::Vary::planogram);
  BayRanges ranges;
  if (fits_boards) {
    FittedShelves fitted = fit_shelves(scene, plan, rows, planogram);
    MARKETGEN_TRY(scene, bare_scene(std::move(fitted.layout), rows, seed));
    ranges = std::move(fitted.ranges);
  }
  std::vector<BayRef> bays = bays_of(scene);
  plan_bays(bays, scene, plan, rows, planogram, ranges);
  MARKETGEN_CHECK(stock_by_planogram(bays, scene, plan, rows));
  MARKETGEN_CHECK(check_number(bays, scene, plan, rows));
  MARKETGEN_TRY(const std::optional<StoreSales> sales, sales_of(plan, rows));
  const Seed disorder = of(&plan::Vary::disorder);
  const std::vector<FilledBay> filled =
      fill_bays(bays, scene, plan, sales, rows, of(&plan::Vary::fill), disorder);
  add_stock(scene, bays, filled, rows, prices);
  misplace_items(scene, plan, rows, disorder);
  fault_price_tags(scene, plan, prices);
  MARKETGEN_CHECK(add_placements(scene, plan, rows));
  take_catalog_slice(scene, rows);
  return scene;
}

}  // namespace marketgen::scene
