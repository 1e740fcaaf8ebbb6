#include "scene/bays.h"

#include <algorithm>
#include <tuple>

#include "layout/makes.h"
#include "scene/assortment.h"
#include "scene/board_goods.h"
#include "scene/brand_blocks.h"
#include "scene/own_goods.h"

namespace marketgen::scene {
namespace {

// Position of a module along its run as a shopper before this side sees it.
int place_along(const layout::Fixture& fixture, int side) {
  const int turns = (fixture.yaw_deg / 90 + 2 * side) % 4;
  switch (turns) {
    case 0:
      return fixture.x_mm;
    case 1:
      return fixture.y_mm;
    case 2:
      return -fixture.x_mm;
    default:
      return -fixture.y_mm;
  }
}

bool shows_promotions(const layout::Layout& layout, const layout::Fixture& fixture) {
  return !fixture.endcap_of.empty() || fixture.kind == "bin" ||
         layout::counts_as(layout, fixture, "pallet");
}

// In the zone's pattern.
std::vector<PlannedShelf> plan_of_range(const BayRef& bay,
                                        const BayRange& range,
                                        const std::vector<std::uint32_t>& assortment,
                                        const plan::StockSpec& stock,
                                        const catalog::Catalog& catalog,
                                        Stream draw) {
  if (stock.block == plan::BlockPattern::brand_vertical || stock.block == plan::BlockPattern::mixed)
    return plan_range(bay.bay, range, assortment, stock, catalog, bay.certain);
  std::vector<std::uint32_t> rows = bay.certain;
  for (const RangedGoods& goods : range)
    if (std::ranges::find(rows, goods.product) == rows.end()) rows.push_back(goods.product);
  AssortmentCursor from_the_first;
  const auto& plan_goods = has_brand_blocks(bay.bay, stock) ? plan_brand_blocks : plan_bay;
  return plan_goods(bay.bay, rows, stock, catalog, from_the_first, draw, bay.certain);
}

}  // namespace

std::vector<BayRef> bays_of(const Scene& scene) {
  std::vector<BayRef> bays;
  for (std::uint32_t f = 0; f < scene.fixtures.size(); ++f) {
    const layout::Fixture& fixture = scene.layout.fixtures[f];
    const SceneFixture& row = scene.fixtures[f];
    for (int side = 0; side < 2; ++side) {
      BayRef ref{fixture.zone, fixture.run, side, place_along(fixture, side), f, {}, {}, {}, {}};
      ref.bay.promotion = shows_promotions(scene.layout, fixture);
      for (std::uint32_t s = row.first_shelf; s < row.first_shelf + row.shelf_count; ++s) {
        const SceneShelf& shelf = scene.shelves[s];
        if (shelf.side != side) continue;
        ref.shelves.push_back(s);
        ref.bay.shelves.push_back({shelf.width_m,
                                   shelf.depth_m - assets::goods_front_m,
                                   shelf.clearance_m,
                                   shelf.use,
                                   shelf.position_m[2]});
      }
      if (!ref.shelves.empty()) bays.push_back(std::move(ref));
    }
  }
  std::sort(bays.begin(), bays.end(), [](const BayRef& a, const BayRef& b) {
    return std::tie(a.zone, a.run, a.side, a.along, a.fixture) <
           std::tie(b.zone, b.run, b.side, b.along, b.fixture);
  });
  return bays;
}

const plan::Zone& zone_or_usual(const plan::Plan& plan, std::string_view id) {
  static const plan::Zone usual;
  const plan::Zone* found = plan::find_zone(plan, id);
  return found != nullptr ? *found : usual;
}

const plan::Zone& Stocks::zone_of(const BayRef& bay) const {
  return zone_or_usual(plan_, bay.zone);
}

catalog::Storage Stocks::temperature_of(const BayRef& bay) const {
  const catalog::FixtureKind* kind =
      catalog_.fixture_kind(scene_.layout.fixtures[bay.fixture].kind);
  return kind != nullptr ? kind->temperature : catalog::Storage::ambient;
}

Stock& Stocks::of(const BayRef& bay) {
  const catalog::Storage temperature = temperature_of(bay);
  const auto [entry, is_new] = stocks_.try_emplace({bay.zone, temperature});
  Stock& stock = entry->second;
  if (!is_new) return stock;
  stock.assortment = assortment_of(zone_of(bay), temperature, catalog_);
  order_by_demand(stock.assortment, zone_of(bay).stock, catalog_);
  stock.sells.resize(catalog_.products.size(), false);
  for (const std::uint32_t row : stock.assortment)
    stock.sells[row] = true;
  return stock;
}

void plan_bays(std::vector<BayRef>& bays,
               const Scene& scene,
               const plan::Plan& plan,
               const catalog::Catalog& catalog,
               Seed seed,
               const BayRanges& ranges) {
  Stocks stocks(scene, plan, catalog);
  const auto plan_again = [&](BayRef& bay, AssortmentCursor& cursor) {
    const std::string& fixture = scene.layout.fixtures[bay.fixture].id;
    const Seed bay_seed =
        seed.child("bay", fixture).child("side", static_cast<std::uint64_t>(bay.side));
    const plan::StockSpec& stock = stocks.zone_of(bay).stock;
    const std::vector<std::uint32_t>& assortment = stocks.of(bay).assortment;
    const auto range = ranges.find({fixture, bay.side});
    if (range != ranges.end()) {
      bay.plan = plan_of_range(bay, range->second, assortment, stock, catalog, bay_seed.stream());
      return;
    }
    const auto& plan_goods = has_brand_blocks(bay.bay, stock) ? plan_brand_blocks : plan_bay;
    bay.plan =
        plan_goods(bay.bay, assortment, stock, catalog, cursor, bay_seed.stream(), bay.certain);
  };
  std::vector<AssortmentCursor> cursors;  // before each bay
  for (BayRef& bay : bays) {
    cursors.push_back(stocks.of(bay).cursor);
    plan_again(bay, stocks.of(bay).cursor);
  }
  OwnGoods own(plan, catalog, stocks);
  if (own.empty()) return;
  while (own.give_out(bays)) {
    for (std::size_t i = 0; i < bays.size(); ++i) {
      AssortmentCursor before = cursors[i];
      if (own.changed(i)) plan_again(bays[i], before);
    }
  }
}

}  // namespace marketgen::scene
