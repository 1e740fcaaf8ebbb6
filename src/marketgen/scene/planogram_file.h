// Planograms that people bring: CSV with the columns that `export --format planogram` writes, of
// which few are needed (docs/planogram.md). What is not possible is refused row by row; nothing is
// passed over.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "plan/patch.h"
#include "scene/stocked_shelf.h"

namespace marketgen::scene {

// A row: a block of one product.
struct PlanogramBlock {
  int line = 0;  // of the file
  int position = 0;
  std::uint32_t product = 0;  // row of catalog.products
  int facings = 1;            // packs, or loose pieces, side by side
  std::optional<int> x_mm, facings_high, facings_deep;
};

// A shelf that the file names, with all that it puts there.
struct PlanogramShelf {
  std::uint32_t shelf = 0;  // row of scene.shelves
  std::string fixture;
  plan::ShelfSide side = plan::ShelfSide::front;
  int number = 1;  // from the floor up
  int line = 0;    // of the file, where it is named first
  ShelfPlace place;
  std::vector<PlanogramBlock> blocks;  // from left to right
  PlannedShelf planned;                // the same, as the stocker has it
};

struct PlanogramFile {
  std::vector<PlanogramShelf> shelves;  // in the scene's order
  std::vector<Error> refused;           // by line; each says what helps
};

// `plan` is the store's. Errors: csv.syntax, input.*; planogram.bad_row when a column is missing.
// `refused`: planogram.*, plan.unknown_reference, catalog.unknown_sku.
Result<PlanogramFile> read_planogram(std::string_view text,
                                     const std::string& source,
                                     const Scene& scene,
                                     const plan::Plan& plan,
                                     const catalog::Catalog& catalog);

// The first refused row as the error of them all.
Error refusal_of(const std::vector<Error>& refused);

// What a planogram changes.
struct PlanogramChanges {
  plan::PatchSet patches;        // one stock_shelves, or none when all stands so
  std::size_t as_they_were = 0;  // shelves that hold what the file says already
};

// Shelves that hold what the file says are left alone, and of the others no more is pinned than the
// stocker would do otherwise. `plan` is the store's.
PlanogramChanges changes_by(const PlanogramFile& file,
                            const Scene& scene,
                            const plan::Plan& plan,
                            const catalog::Catalog& catalog);

}  // namespace marketgen::scene
