// Shelves that the plan's planogram stocks: what it says of a shelf as the stocker has it, and what
// of that is not possible.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "plan/plan.h"
#include "scene/bays.h"

namespace marketgen::scene {

// What of a planogram cannot be done on its shelf.
struct ShelfFault {
  std::size_t block = 0;
  std::string field;    // of plan::ShelfBlock
  std::string message;  // what is wrong, and what helps
};

// The shelf as the stocker has it; with faults it is not to be used.
struct StockedShelf {
  PlannedShelf shelf;
  std::vector<ShelfFault> faults;
};

// A shelf and where it stands.
struct ShelfPlace {
  ShelfRoom room;
  double left_m = 0;  // of the shelf's left end, from the left of its bay's front
  catalog::Storage temperature = catalog::Storage::ambient;
};

// The shelf as its bay has it. Blocks whose places overlap by no more than rounding to millimetres
// stand beside one another. Every SKU must be in the catalogue.
StockedShelf stocked_shelf(const std::vector<plan::ShelfBlock>& blocks,
                           const ShelfPlace& place,
                           const catalog::Catalog& catalog);

// Finds shelves by fixture, side and number.
class ShelfFinder {
 public:
  ShelfFinder(const Scene& scene, const plan::Plan& plan, const catalog::Catalog& catalog);

  // Places in `bays()` and in the bay's shelves.
  struct Found {
    std::size_t bay = 0, shelf = 0;
  };
  // Error: plan.unknown_reference with the nearest name, or with the shelves that there are.
  // `where` is the place of what names the shelf; ".../fixture" and so on are put behind it.
  Result<Found> find(const std::string& fixture,
                     plan::ShelfSide side,
                     int shelf,
                     const std::string& where) const;

  const std::vector<BayRef>& bays() const { return bays_; }
  ShelfPlace place(const Found& found) const;

 private:
  const Scene& scene_;
  std::vector<BayRef> bays_;
  std::map<std::pair<std::string, int>, std::size_t> bay_of_;  // by fixture and side
  Stocks stocks_;
};

// Puts what the plan's planogram says in the place of what was planned for these shelves; all other
// shelves stay as they are. `bays` are those of bays_of. Errors: plan.unknown_reference,
// planogram.does_not_fit, at "/planogram/3/blocks/0".
Result<void> stock_by_planogram(std::vector<BayRef>& bays,
                                const Scene& scene,
                                const plan::Plan& plan,
                                const catalog::Catalog& catalog);

}  // namespace marketgen::scene
