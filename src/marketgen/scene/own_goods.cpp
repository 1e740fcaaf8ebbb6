#include "scene/own_goods.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "catalog/zone_goods.h"
#include "scene/assortment.h"

namespace marketgen::scene {
namespace {

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

bool holds_product(const BayRef& bay, const catalog::Product& product) {
  return std::ranges::any_of(bay.bay.shelves,
                             [&](const ShelfRoom& room) { return fits(product, room); });
}

PlannedBlock* block_of(BayRef& bay, std::uint32_t row) {
  for (PlannedShelf& shelf : bay.plan) {
    for (PlannedBlock& block : shelf) {
      if (block.product == row) return &block;
    }
  }
  return nullptr;
}

std::vector<std::uint32_t> own_rows(const catalog::Catalog& catalog) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < catalog.products.size(); ++row) {
    if (std::ranges::binary_search(catalog.own, catalog.products[row].sku)) rows.push_back(row);
  }
  return rows;
}

// ---- Why a product stands nowhere. ----

// `bays` sell it.
std::string why_it_does_not_fit(const catalog::Product& product,
                                const std::vector<const BayRef*>& bays) {
  std::vector<ShelfRoom> rooms;
  for (const BayRef* bay : bays)
    rooms.insert(rooms.end(), bay->bay.shelves.begin(), bay->bay.shelves.end());
  std::string why = too_large_for(product, rooms, "no shelf that sells it takes more than");
  if (!why.empty()) return why;
  return fmt::format("no one shelf that sells it takes {:.1f} kg of {} x {} x {} mm",
                     product.mass_kg,
                     product.size_mm[0],
                     product.size_mm[1],
                     product.size_mm[2]);
}

std::string why_nobody_sells_it(const catalog::Product& product,
                                const std::vector<BayRef>& bays,
                                const Stocks& stocks,
                                const catalog::Catalog& catalog) {
  for (const BayRef& bay : bays) {
    const plan::Zone& zone = stocks.zone_of(bay);
    if (!sells(zone, product, catalog)) continue;
    if (named_by(product, zone.stock.exclude))
      return fmt::format("zone \"{}\" leaves out {}", zone.id, fmt::join(zone.stock.exclude, ", "));
    if (!catalog::keeps(stocks.temperature_of(bay), product.storage))
      return fmt::format("it is kept {}, but the fixtures of zone \"{}\" are {}",
                         name_of(product.storage),
                         zone.id,
                         name_of(stocks.temperature_of(bay)));
  }
  std::vector<std::string_view> types;
  std::set<std::string_view> known;
  for (const catalog::ZoneTypeRow& type : catalog.zone_types) {
    if (catalog::belongs_to(type, product, catalog) && !type.categories.empty())
      types.push_back(type.type);
  }
  for (const catalog::Product& other : catalog.products) {
    if (other.category == product.category) known.insert(other.subcategory);
  }
  if (!types.empty())
    return fmt::format("no zone of this store sells {} of {}; zones of type {} do",
                       product.subcategory,
                       product.category,
                       fmt::join(types, ", "));
  return fmt::format("no type of zone sells {} {} of {}; subcategories are: {}",
                     name_of(product.storage),
                     product.subcategory,
                     product.category,
                     fmt::join(known, ", "));
}

std::string why_unstocked(std::uint32_t row,
                          const std::vector<BayRef>& bays,
                          Stocks& stocks,
                          const catalog::Catalog& catalog) {
  const catalog::Product& product = catalog.products[row];
  std::vector<const BayRef*> selling;
  for (const BayRef& bay : bays) {
    if (stocks.of(bay).sells[row]) selling.push_back(&bay);
  }
  if (selling.empty()) return why_nobody_sells_it(product, bays, stocks, catalog);
  const bool fit =
      std::ranges::any_of(selling, [&](const BayRef* bay) { return holds_product(*bay, product); });
  if (!fit) return why_it_does_not_fit(product, selling);
  return fmt::format(
      "{} would hold it, but they are full of other products of your own, or are to "
      "be kept empty",
      selling.size() == 1 ? "one bay" : fmt::format("{} bays", selling.size()));
}

}  // namespace

OwnGoods::OwnGoods(const plan::Plan& plan, const catalog::Catalog& catalog, Stocks& stocks)
    : catalog_(catalog), stocks_(stocks) {
  for (const std::uint32_t row : own_rows(catalog))
    wanted_.push_back({{row}, "", {}});
  for (const plan::Zone& zone : plan.zones) {
    for (const std::string& word : zone.stock.must_stock.value_or(std::vector<std::string>{}))
      wanted_.push_back({best_named(zone, word, catalog), zone.id, {}});
  }
}

double OwnGoods::room_left_m(const BayRef& bay) const {
  double left_m = 0;
  for (const ShelfRoom& room : bay.bay.shelves)
    left_m += room.width_m * stocks_.zone_of(bay).stock.fill;
  for (const std::uint32_t row : bay.certain)
    left_m -= facing_pitch_m(catalog_.products[row]);
  return left_m;
}

std::size_t OwnGoods::best_bay(const std::vector<BayRef>& bays,
                               const Wanted& wanted,
                               std::uint32_t row) const {
  const catalog::Product& product = catalog_.products[row];
  const auto rank = [&](std::size_t i) {
    return std::tuple(bays[i].bay.promotion, bays[i].certain.size(), i);
  };
  std::size_t best = nowhere;
  for (std::size_t i = 0; i < bays.size(); ++i) {
    if (!wanted.zone.empty() && bays[i].zone != wanted.zone) continue;
    if (left_m_[i] < facing_pitch_m(product) || wanted.tried.contains({row, i}) ||
        !stocks_.of(bays[i]).sells[row] || !holds_product(bays[i], product))
      continue;
    if (best == nowhere || rank(i) < rank(best)) best = i;
  }
  return best;
}

// What stands somewhere is promised to go on standing there. Bays that this round has changed are
// not planned yet: there a promise counts, and nothing else.
bool OwnGoods::stands(std::vector<BayRef>& bays, const Wanted& wanted) const {
  for (std::size_t i = 0; i < bays.size(); ++i) {
    if (!wanted.zone.empty() && bays[i].zone != wanted.zone) continue;
    for (const std::uint32_t row : wanted.rows) {
      const bool promised = std::ranges::find(bays[i].certain, row) != bays[i].certain.end();
      if (promised && changed(i)) return true;
      PlannedBlock* block = changed(i) ? nullptr : block_of(bays[i], row);
      if (block == nullptr) continue;
      block->certain = true;
      if (!promised) bays[i].certain.push_back(row);
      return true;
    }
  }
  return false;
}

// The product that is liked best and that some bay holds.
void OwnGoods::put_somewhere(std::vector<BayRef>& bays, Wanted& wanted) {
  for (const std::uint32_t row : wanted.rows) {
    const std::size_t bay = best_bay(bays, wanted, row);
    if (bay == nowhere) continue;
    wanted.tried.insert({row, bay});
    bays[bay].certain.push_back(row);
    left_m_[bay] -= facing_pitch_m(catalog_.products[row]);
    changed_.insert(bay);
    return;
  }
}

bool OwnGoods::give_out(std::vector<BayRef>& bays) {
  changed_.clear();
  left_m_.clear();
  for (const BayRef& bay : bays)
    left_m_.push_back(room_left_m(bay));
  for (Wanted& wanted : wanted_) {
    if (stands(bays, wanted)) continue;
    for (BayRef& bay : bays) {
      if (wanted.zone.empty() || bay.zone == wanted.zone)
        for (const std::uint32_t row : wanted.rows)
          std::erase(bay.certain, row);
    }
    put_somewhere(bays, wanted);
  }
  return !changed_.empty();
}

std::vector<Unstocked> unstocked_products(const Scene& scene,
                                          const plan::Plan& plan,
                                          const catalog::Catalog& catalog) {
  std::vector<Unstocked> unstocked;
  if (catalog.own.empty()) return unstocked;
  std::set<std::string_view> stocked;
  for (const SceneProduct& item : scene.products)
    stocked.insert(scene.catalog[item.sku].sku);
  const std::vector<BayRef> bays = bays_of(scene);
  Stocks stocks(scene, plan, catalog);
  for (const std::uint32_t row : own_rows(catalog)) {
    const std::string& sku = catalog.products[row].sku;
    if (!stocked.contains(sku))
      unstocked.push_back({sku, why_unstocked(row, bays, stocks, catalog)});
  }
  return unstocked;
}

}  // namespace marketgen::scene
