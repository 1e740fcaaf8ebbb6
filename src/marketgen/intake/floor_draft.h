// A design of the floor in words: which zone stands in which band of the store, in what order.
// Search changes drafts; `build_floor` gives them sizes.
//
// The draft is drawn as if the entrance were in the south wall (canonical frame); orientation.h
// turns it.
//
//   +------------------ north -------------------+      the back wall: cold cabinets
//   | w |                                    | e |
//   | e |   core: columns of gondola runs    | a |      side walls; a deep side is a hall with
//   tables | s |                                    | s | | t | | t |
//   +---+-- front zones --[entrance]-- tills ----+
#pragma once
#include <array>
#include <vector>

#include "geometry/rectangle.h"
#include "intake/slices.h"
#include "intake/store_program.h"

namespace marketgen::intake {

enum class Band { front, west, east, north, core };
constexpr std::size_t band_count = 5;
constexpr std::size_t index_of(Band band) {
  return static_cast<std::size_t>(band);
}

struct FloorDraft {
  // Zone indices: front, north and core from west to east, west and east from south to north. Tills
  // are in `tills`.
  std::array<std::vector<int>, band_count> bands;
  std::vector<int> tills;     // checkout, self-checkout, service, from the entrance's side outwards
  bool tills_east = true;     // the exit's end of the front
  bool corner_tills = false;  // small shops: tills in a corner instead of along the whole front
  std::size_t entrance_gap =
      0;  // the entrance faces the gap after that many front zones, counted from the far end
  bool deep_west = false, deep_east = false;
  bool stacked_core = false;  // two zones in one core column, with a cross aisle between them

  std::vector<int>& band(Band b) { return bands[index_of(b)]; }
  const std::vector<int>& band(Band b) const { return bands[index_of(b)]; }
};

// A draft with sizes, in the canonical frame.
struct DraftedFloor {
  Slice root;
  int width_mm = 0, depth_mm = 0;
  std::vector<RectMm> rects;         // by zone index
  int entrance_mm = 0, exit_mm = 0;  // centres along the south wall
  int entrance_width_mm = 0, exit_width_mm = 0;
  int run_aisle_mm = 0;  // between gondola runs
  int runs = 0;          // gondola runs side by side
  double crowding = 0;   // metres that zones lack; 0 = everything fits
  double waste_m2 = 0;   // floor in bands that are deeper than their zones need
};

DraftedFloor build_floor(const FloorDraft& draft,
                         const StoreProgram& program,
                         const catalog::Catalog& catalog,
                         int width_mm,
                         int depth_mm);

}  // namespace marketgen::intake
