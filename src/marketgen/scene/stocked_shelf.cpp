#include "scene/stocked_shelf.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "catalog/zone_goods.h"
#include "scene/planogram_rows.h"
#include "scene/shelf_fill.h"

namespace marketgen::scene {
namespace {

constexpr double rounding_m = 0.001;  // of places in whole millimetres, at both ends of a block
constexpr double touching_shelf_m = 1e-6;

// One shelf while it is made out.
class ShelfReading {
 public:
  ShelfReading(const std::vector<plan::ShelfBlock>& blocks,
               const ShelfPlace& place,
               const catalog::Catalog& catalog)
      : blocks_(blocks), place_(place), catalog_(catalog) {}

  StockedShelf read() {
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      take(i);
    const bool placed =
        std::ranges::any_of(blocks_, [](const plan::ShelfBlock& b) { return b.x_mm.has_value(); });
    if (placed) settle();
    check_room();
    return std::move(made_);
  }

 private:
  void fault(std::size_t block, std::string_view field, std::string message) {
    made_.faults.push_back({block, std::string(field), std::move(message)});
  }

  void take(std::size_t i) {
    const plan::ShelfBlock& block = blocks_[i];
    const catalog::Product& product = *catalog_.product(block.sku);
    PlannedBlock planned;
    planned.product = static_cast<std::uint32_t>(&product - catalog_.products.data());
    planned.facings = block.facings;
    planned.stack = block.facings_high;
    planned.rows_deep = block.facings_deep;
    if (block.x_mm) planned.x_m = *block.x_mm * 1e-3 - place_.left_m;
    made_.shelf.push_back(planned);
    check_product(i, product);
    check_counts(i, product);
  }

  void check_product(std::size_t i, const catalog::Product& product) {
    if (!catalog::keeps(place_.temperature, product.storage)) {
      fault(i,
            "sku",
            fmt::format("\"{}\" is kept {}, but the fixture is {}; put it elsewhere",
                        product.sku,
                        name_of(product.storage),
                        name_of(place_.temperature)));
    } else if (!fits(product, place_.room)) {
      std::string why = too_large_for(product, {place_.room}, "the shelf takes no more than");
      if (why.empty())
        why = fmt::format("{} kg are too heavy for a shelf {:.0f} mm over the floor",
                          product.mass_kg,
                          place_.room.board_m * 1e3);
      fault(i, "sku", fmt::format("\"{}\": {}; put it elsewhere", product.sku, why));
    }
  }

  void check_counts(std::size_t i, const catalog::Product& product) {
    const plan::ShelfBlock& block = blocks_[i];
    const bool loose = lies_in_a_heap(product);
    const auto check = [&](std::string_view field, std::optional<int> said, int most) {
      if (said && loose)
        fault(i, field, fmt::format("loose goods lie as they fall; leave {} out", field));
      else if (said && *said > most && most > 0)
        fault(i, field, fmt::format("is {}, but {} at most have room there", *said, most));
    };
    check("facings_high", block.facings_high, stack_height(product, place_.room));
    check("facings_deep", block.facings_deep, rows_that_fit(product, place_.room, 1));
  }

  double width_m(std::size_t i) const { return block_width_m(made_.shelf[i], catalog_); }

  // A place for every block: its own, or beside the one before it.
  void settle() {
    double end = 0;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const double at = made_.shelf[i].x_m.value_or(end);
      made_.shelf[i].x_m = at < end && end - at <= rounding_m ? end : at;
      end = *made_.shelf[i].x_m + width_m(i);
    }
    double limit = place_.room.width_m;
    for (std::size_t i = blocks_.size(); i-- > 0;) {
      double& at = *made_.shelf[i].x_m;
      const double over = at + width_m(i) - limit;
      if (over > 0 && over <= rounding_m) at -= over;
      limit = at;
    }
  }

  void check_room() {
    const std::vector<double> starts = block_starts(made_.shelf, place_.room, catalog_);
    double end = 0;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      if (starts[i] < end - touching_shelf_m) {
        fault(i,
              "x_mm",
              i == 0 ? fmt::format("begins {:.0f} mm before the shelf does", -starts[i] * 1e3)
                     : fmt::format("overlaps the block before it by {:.0f} mm; leave x_mm of this "
                                   "shelf's blocks empty, and they are spread",
                                   (end - starts[i]) * 1e3));
        return;
      }
      end = starts[i] + width_m(i);
      if (end <= place_.room.width_m + touching_shelf_m) continue;
      fault(i,
            "facings",
            fmt::format("reaches {:.0f} mm beyond the shelf, which is {:.0f} mm wide; take away "
                        "facings, or move blocks",
                        (end - place_.room.width_m) * 1e3,
                        place_.room.width_m * 1e3));
      return;
    }
  }

  const std::vector<plan::ShelfBlock>& blocks_;
  const ShelfPlace& place_;
  const catalog::Catalog& catalog_;
  StockedShelf made_;
};

// What is promised never to be out of stock stays so: block by block of the same product.
void keep_promises(PlannedShelf& now, const PlannedShelf& before) {
  std::vector<bool> taken(before.size(), false);
  for (PlannedBlock& block : now) {
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (taken[i] || before[i].product != block.product) continue;
      taken[i] = true;
      block.certain = before[i].certain;
      break;
    }
  }
}

}  // namespace

StockedShelf stocked_shelf(const std::vector<plan::ShelfBlock>& blocks,
                           const ShelfPlace& place,
                           const catalog::Catalog& catalog) {
  return ShelfReading(blocks, place, catalog).read();
}

ShelfFinder::ShelfFinder(const Scene& scene,
                         const plan::Plan& plan,
                         const catalog::Catalog& catalog)
    : scene_(scene), bays_(bays_of(scene)), stocks_(scene, plan, catalog) {
  for (std::size_t i = 0; i < bays_.size(); ++i)
    bay_of_[{scene.layout.fixtures[bays_[i].fixture].id, bays_[i].side}] = i;
}

Result<ShelfFinder::Found> ShelfFinder::find(const std::string& fixture,
                                             plan::ShelfSide side,
                                             int shelf,
                                             const std::string& where) const {
  const auto bay = bay_of_.find({fixture, side == plan::ShelfSide::front ? 0 : 1});
  if (bay == bay_of_.end()) {
    std::vector<std::string_view> known;
    for (const auto& [place, index] : bay_of_)
      known.push_back(place.first);
    if (std::ranges::find(known, fixture) != known.end())
      return Error{"plan.unknown_reference",
                   where + "side",
                   "\"" + fixture + "\" has no shelves on its " + std::string(name_of(side))};
    return Error{
        "plan.unknown_reference",
        where + "fixture",
        "the store has no fixture with shelves \"" + fixture + "\"" + did_you_mean(fixture, known)};
  }
  std::vector<int> numbers;
  const BayRef& ref = bays_[bay->second];
  for (std::size_t i = 0; i < ref.shelves.size(); ++i) {
    numbers.push_back(scene_.shelves[ref.shelves[i]].level + 1);
    if (numbers.back() == shelf) return Found{bay->second, i};
  }
  return Error{"plan.unknown_reference",
               where + "shelf",
               fmt::format("\"{}\", {}, has no shelf {}; it has {}",
                           fixture,
                           name_of(side),
                           shelf,
                           fmt::join(numbers, ", "))};
}

ShelfPlace ShelfFinder::place(const Found& found) const {
  const BayRef& bay = bays_[found.bay];
  return {bay.bay.shelves[found.shelf],
          shelf_left_m(scene_, bay.shelves[found.shelf]),
          stocks_.temperature_of(bay)};
}

Result<void> stock_by_planogram(std::vector<BayRef>& bays,
                                const Scene& scene,
                                const plan::Plan& plan,
                                const catalog::Catalog& catalog) {
  if (!plan.planogram) return {};
  const ShelfFinder finder(scene, plan, catalog);
  for (std::size_t i = 0; i < plan.planogram->size(); ++i) {
    const plan::StockedShelf& said = (*plan.planogram)[i];
    const std::string where = fmt::format("/planogram/{}/", i);
    MARKETGEN_TRY(const ShelfFinder::Found found,
                  finder.find(said.fixture, said.side, said.shelf, where));
    StockedShelf made = stocked_shelf(said.blocks, finder.place(found), catalog);
    if (!made.faults.empty()) {
      const ShelfFault& fault = made.faults.front();
      return Error{"planogram.does_not_fit",
                   fmt::format("{}blocks/{}/{}", where, fault.block, fault.field),
                   fault.message};
    }
    keep_promises(made.shelf, bays[found.bay].plan[found.shelf]);
    bays[found.bay].plan[found.shelf] = std::move(made.shelf);
  }
  return {};
}

}  // namespace marketgen::scene
