#include "scene/block_swap.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "plan/shelf_key.h"
#include "scene/standing_shelf.h"
#include "scene/stocked_shelf.h"
#include "scene/store_catalog.h"

namespace marketgen::scene {
namespace {

// A block that comes to stand in a place of the other's.
struct Arrival {
  const plan::BlockPlace* to = nullptr;
  std::string where_to, where;  // in the patches: of that place, and of the block
};

std::vector<Arrival> arrivals_of(const plan::PatchSet& patches, const std::string& source) {
  std::vector<Arrival> arrivals;
  for (std::size_t i = 0; i < patches.patches.size(); ++i) {
    const auto& swap = patches.patches[i].swap_blocks;
    if (!swap) continue;
    const std::string where = fmt::format("{}:/patches/{}/swap_blocks/", source, i);
    const std::string a = where + "a/", b = where + "b/";
    arrivals.push_back({&swap->a, a, b});
    arrivals.push_back({&swap->b, b, a});
  }
  return arrivals;
}

const plan::StockedShelf* shelf_of(const plan::Plan& plan, const plan::BlockPlace& place) {
  if (!plan.planogram) return nullptr;
  const auto shelf = std::ranges::find_if(*plan.planogram, [&](const plan::StockedShelf& said) {
    return plan::key_of(said) == plan::key_of(place);
  });
  return shelf == plan.planogram->end() ? nullptr : &*shelf;
}

// The most facings of the block with which all of the shelf has room, as a hint.
std::string what_fits(std::vector<plan::ShelfBlock> blocks,
                      std::size_t block,
                      const ShelfPlace& place,
                      const catalog::Catalog& catalog) {
  while (--blocks[block].facings > 0) {
    if (!stocked_shelf(blocks, place, catalog).faults.empty()) continue;
    return fmt::format("; with \"facings\": {} it has room", blocks[block].facings);
  }
  return "";
}

struct Refusal {
  Error error;
  bool by_the_block = true;  // another one on the shelf may be what is too wide
};

std::optional<Refusal> refused_arrival(const Arrival& arrival,
                                       const plan::StockedShelf& shelf,
                                       const ShelfPlace& place,
                                       const catalog::Catalog& catalog) {
  const StockedShelf made = stocked_shelf(shelf.blocks, place, catalog);
  if (made.faults.empty()) return std::nullopt;
  const ShelfFault& fault = made.faults.front();
  const auto block =
      std::min(static_cast<std::size_t>(arrival.to->position) - 1, shelf.blocks.size() - 1);
  const bool too_wide = fault.field == "facings" || fault.field == "x_mm";
  const std::string helps = too_wide ? what_fits(shelf.blocks, block, place, catalog) : "";
  return Refusal{{"planogram.does_not_fit",
                  arrival.where + (too_wide ? "facings" : "sku"),
                  fmt::format("with \"{}\" on shelf {} of \"{}\", {}: {}{}",
                              shelf.blocks[block].sku,
                              shelf.shelf,
                              shelf.fixture,
                              name_of(shelf.side),
                              fault.message,
                              helps)},
                 !too_wide || !helps.empty()};
}

}  // namespace

Result<plan::Plan> with_swapped_shelves(plan::Plan plan,
                                        const plan::PatchSet& patches,
                                        const std::string& source,
                                        const Scene& scene,
                                        const catalog::Catalog& catalog) {
  const std::vector<Arrival> arrivals = arrivals_of(patches, source);
  if (arrivals.empty()) return plan;
  const plan::Plan before = plan;
  const StoreCatalog rows(catalog, plan);
  const ShelfFinder finder(scene, before, rows.get());
  for (const Arrival& arrival : arrivals) {
    const plan::BlockPlace& to = *arrival.to;
    if (shelf_of(plan, to) != nullptr) continue;
    MARKETGEN_TRY(const ShelfFinder::Found found,
                  finder.find(to.fixture, to.side, to.shelf, arrival.where_to));
    const std::uint32_t shelf = finder.bays()[found.bay].shelves[found.shelf];
    if (!plan.planogram) plan.planogram.emplace();
    plan.planogram->push_back(
        standing_shelf(scene, shelf, finder.place(found), before, rows.get()));
  }
  return plan;
}

Result<void> check_swapped(const plan::Plan& swapped,
                           const plan::PatchSet& patches,
                           const std::string& source,
                           const Scene& scene,
                           const catalog::Catalog& catalog) {
  const std::vector<Arrival> arrivals = arrivals_of(patches, source);
  if (arrivals.empty()) return {};
  const StoreCatalog rows(catalog, swapped);
  const ShelfFinder finder(scene, swapped, rows.get());
  std::optional<Error> refused;
  for (const Arrival& arrival : arrivals) {
    const plan::BlockPlace& to = *arrival.to;
    const plan::StockedShelf* shelf = shelf_of(swapped, to);
    if (shelf == nullptr || shelf->blocks.empty()) continue;  // a later patch has taken it back
    MARKETGEN_TRY(const ShelfFinder::Found found,
                  finder.find(to.fixture, to.side, to.shelf, arrival.where_to));
    const auto refusal = refused_arrival(arrival, *shelf, finder.place(found), rows.get());
    if (refusal && refusal->by_the_block) return refusal->error;
    if (refusal && !refused) refused = refusal->error;
  }
  if (refused) return *refused;
  return {};
}

}  // namespace marketgen::scene
