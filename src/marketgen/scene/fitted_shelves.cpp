#include "scene/fitted_shelves.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "io/json.h"
#include "layout/makes.h"
#include "scene/assortment.h"
#include "scene/brand_blocks.h"
#include "scene/fitted_boards.h"
#include "scene/shelf_shares.h"

namespace marketgen::scene {
namespace {

constexpr double usual_pitch_m = 0.27;  // of fitted boards, until they are known
constexpr double tallest_goods_m = 0.45;
constexpr int rounds = 2;  // ranges follow from how many boards there are, and those from ranges

// Bays of one zone and temperature while their boards are fitted.
struct ZoneBays {
  std::string zone;
  std::vector<const BayRef*> bays;
  std::vector<std::optional<BayOpening>> openings;  // of those whose boards can be moved
  std::vector<Bay> rooms;                           // what they hold with boards at any height
  std::vector<std::vector<int>> spacings;
};

// What the plan says of the fixture's boards.
struct BoardWish {
  bool spacing = false, levels = false;
};

BoardWish wish_of(const plan::Plan& plan,
                  const layout::Layout& layout,
                  const layout::Fixture& fixture) {
  BoardWish wish;
  const auto hear = [&](const plan::FixtureSpec& spec) {
    wish.spacing |= spec.spacing_mm.has_value();
    wish.levels |= spec.levels.has_value();
  };
  const plan::Zone& zone = zone_or_usual(plan, fixture.zone);
  hear(zone.fixture);
  if (zone.also)
    for (const plan::FixtureSpec& also : *zone.also)
      if (layout::counts_as(layout, fixture, also.kind)) hear(also);
  wish.levels |= std::ranges::any_of(plan.overrides, [&](const plan::Override& change) {
    return change.fixture == fixture.id && change.field_name == "levels";
  });
  return wish;
}

// Nothing where the boards stay as they are.
std::optional<BayOpening> opening_of(const BayRef& bay,
                                     const Scene& bare,
                                     const plan::Plan& plan,
                                     const catalog::Catalog& catalog) {
  const layout::Fixture& fixture = bare.layout.fixtures[bay.fixture];
  const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
  const std::vector<ShelfRoom>& shelves = bay.bay.shelves;
  if (kind == nullptr || kind->slot_mm == 0 || shelves.size() < 2) return std::nullopt;
  const BoardWish wish = wish_of(plan, bare.layout, fixture);
  if (wish.spacing) return std::nullopt;
  const ShelfRoom &lowest = shelves.front(), &highest = shelves.back();
  BayOpening opening;
  opening.width_m = std::ranges::min_element(shelves, {}, &ShelfRoom::width_m)->width_m;
  opening.depth_m = std::ranges::min_element(shelves, {}, &ShelfRoom::depth_m)->depth_m;
  opening.base_m = lowest.board_m;
  opening.open_top = std::abs(highest.clearance_m - open_top_m) < 1e-6;
  const double top_m =
      opening.open_top ? fixture.height_mm * 1e-3 : highest.board_m + highest.clearance_m;
  opening.height_m = top_m - lowest.board_m;
  opening.lost_m = std::clamp(shelves[1].board_m - lowest.board_m - lowest.clearance_m, 0.0, 0.06);
  opening.slot_m = kind->slot_mm * 1e-3;
  opening.levels = wish.levels ? IntRange{fixture.levels, fixture.levels} : kind->level_range;
  return opening;
}

// A bay whose boards can be moved holds what is no taller than any goods are.
Bay room_of(const BayRef& bay, const std::optional<BayOpening>& opening) {
  if (!opening) return bay.bay;
  const double clearance_m = std::min(opening->height_m, tallest_goods_m);
  return {{{opening->width_m,
            opening->depth_m,
            clearance_m,
            assets::ShelfUse::stand,
            opening->base_m}}};
}

double front_of(const BayRef& bay, const std::vector<int>& spacings, double fill) {
  double front_m = 0;
  for (const ShelfRoom& room : bay.bay.shelves)
    front_m += room.width_m * fill;
  if (spacings.empty()) return front_m;
  return front_m / static_cast<double>(bay.bay.shelves.size()) *
         static_cast<double>(spacings.size());
}

// The user's own products and one of each of the words that the zone must stock.
std::set<std::uint32_t> certain_goods(const plan::Zone& zone,
                                      const std::vector<std::uint32_t>& assortment,
                                      const catalog::Catalog& catalog) {
  std::set<std::uint32_t> rows;
  for (const std::uint32_t row : assortment)
    if (std::ranges::binary_search(catalog.own, catalog.products[row].sku)) rows.insert(row);
  for (const std::string& word : zone.stock.must_stock.value_or(std::vector<std::string>{})) {
    const std::vector<std::uint32_t> best = best_named(zone, word, catalog);
    const auto sold = std::ranges::find_if(best, [&](std::uint32_t row) {
      return std::ranges::find(assortment, row) != assortment.end();
    });
    if (sold != best.end()) rows.insert(*sold);
  }
  return rows;
}

std::vector<ZoneBays> zones_of(const std::vector<BayRef>& bays,
                               const Scene& bare,
                               const plan::Plan& plan,
                               const catalog::Catalog& catalog,
                               const Stocks& stocks) {
  std::map<std::pair<std::string, catalog::Storage>, std::size_t> known;
  std::vector<ZoneBays> zones;
  for (const BayRef& bay : bays) {
    const bool hangs = bay.bay.shelves.front().use == assets::ShelfUse::hang;
    if (bay.bay.promotion || hangs) continue;
    const auto [entry, is_new] =
        known.try_emplace({bay.zone, stocks.temperature_of(bay)}, zones.size());
    if (is_new) zones.push_back({bay.zone, {}, {}, {}, {}});
    ZoneBays& zone = zones[entry->second];
    zone.bays.push_back(&bay);
    zone.openings.push_back(opening_of(bay, bare, plan, catalog));
    zone.rooms.push_back(room_of(bay, zone.openings.back()));
    const auto& opening = zone.openings.back();
    const int levels = opening ? std::clamp(static_cast<int>(opening->height_m / usual_pitch_m),
                                            opening->levels[0],
                                            opening->levels[1])
                               : 0;
    zone.spacings.emplace_back(static_cast<std::size_t>(levels), 0);
  }
  return zones;
}

// The leader, the shop's own brand, the others, from left to right: so, too, where the plan says
// nothing of brands.
plan::StockSpec brands_by_demand(plan::StockSpec stock) {
  if (stock.block == plan::BlockPattern::brand_vertical)
    stock.block = plan::BlockPattern::brand_columns;
  return stock;
}

bool stand_alike(const ZoneBays& zone, std::size_t a, std::size_t b) {
  const auto &one = zone.openings[a], &other = zone.openings[b];
  return one && other && zone.bays[a]->run == zone.bays[b]->run &&
         zone.bays[a]->side == zone.bays[b]->side && one->height_m == other->height_m &&
         one->base_m == other->base_m && one->open_top == other->open_top &&
         one->lost_m == other->lost_m && one->slot_m == other->slot_m &&
         one->levels == other->levels;
}

std::vector<BayRange> fit_zone(ZoneBays& zone,
                               const RangeWish& wish,
                               const catalog::Catalog& catalog,
                               Seed seed) {
  std::vector<const Bay*> rooms;
  for (const Bay& room : zone.rooms)
    rooms.push_back(&room);
  std::vector<BayRange> ranges;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> fronts_m;
    for (std::size_t i = 0; i < zone.bays.size(); ++i)
      fronts_m.push_back(front_of(*zone.bays[i], zone.spacings[i], wish.stock.fill));
    ranges = ranges_of(rooms, fronts_m, wish, catalog, seed);
    for (std::size_t i = 0; i < zone.bays.size();) {
      std::vector<FitBay> alike;
      for (std::size_t k = i; zone.openings[i] && k < zone.bays.size(); ++k) {
        if (k > i && !stand_alike(zone, k - 1, k)) break;
        alike.push_back({&*zone.openings[k], &ranges[k]});
      }
      std::vector<std::vector<int>> spacings = fitted_spacings(alike, wish.stock, catalog);
      std::ranges::move(spacings, zone.spacings.begin() + static_cast<std::ptrdiff_t>(i));
      i += std::max<std::size_t>(1, alike.size());
    }
  }
  return ranges;
}

void move_boards(layout::Fixture& fixture, int side, std::vector<int> spacings) {
  if (spacings.empty()) return;
  if (side == 0) {
    fixture.levels = static_cast<int>(spacings.size());
    fixture.spacings_mm = std::move(spacings);
  } else {
    fixture.back_spacings_mm = std::move(spacings);
  }
}

}  // namespace

layout::Layout with_even_boards(layout::Layout layout) {
  for (layout::Fixture& fixture : layout.fixtures) {
    fixture.spacings_mm.reset();
    fixture.back_spacings_mm.reset();
  }
  return layout;
}

layout::Layout before_fitting(layout::Layout layout,
                              const plan::Plan& plan,
                              const catalog::Catalog& catalog) {
  for (layout::Fixture& fixture : layout.fixtures) {
    const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
    if (fixture.spacings_mm && kind != nullptr && !wish_of(plan, layout, fixture).levels)
      fixture.levels = kind->levels;
  }
  return with_even_boards(std::move(layout));
}

bool same_but_for_boards(const layout::Layout& a, const layout::Layout& b) {
  const auto line_of = [](const layout::Layout& layout) {
    layout::Layout bare = with_even_boards(layout);
    for (layout::Fixture& fixture : bare.fixtures)
      fixture.levels = 0;
    return io::write_json_line(bare);
  };
  return line_of(a) == line_of(b);
}

FittedShelves fit_shelves(const Scene& bare,
                          const plan::Plan& plan,
                          const catalog::Catalog& catalog,
                          Seed seed) {
  FittedShelves fitted{bare.layout, {}};
  const std::vector<BayRef> bays = bays_of(bare);
  Stocks stocks(bare, plan, catalog);
  const double floor_m2 = area_m2(plan::floor_of(plan.shell));
  for (ZoneBays& zone : zones_of(bays, bare, plan, catalog, stocks)) {
    const BayRef& first = *zone.bays.front();
    const plan::Zone& row = stocks.zone_of(first);
    std::vector<std::uint32_t> assortment = stocks.of(first).assortment;
    order_by_demand(assortment, brands_by_demand(row.stock), catalog);
    const RangeWish wish{assortment,
                         row.stock,
                         is_small_shop(plan.profile, floor_m2),
                         certain_goods(row, assortment, catalog)};
    const Seed own = seed.child("range", zone.zone).child(name_of(stocks.temperature_of(first)));
    std::vector<BayRange> ranges = fit_zone(zone, wish, catalog, own);
    for (std::size_t i = 0; i < zone.bays.size(); ++i) {
      layout::Fixture& fixture = fitted.layout.fixtures[zone.bays[i]->fixture];
      if (zone.openings[i]) move_boards(fixture, zone.bays[i]->side, zone.spacings[i]);
      fitted.ranges[{fixture.id, zone.bays[i]->side}] = std::move(ranges[i]);
    }
  }
  return fitted;
}

}  // namespace marketgen::scene
