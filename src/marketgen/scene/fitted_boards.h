// Heights of a bay's boards, fitted to what stands on them: plan::ShelfPitch::fitted.
#pragma once
#include <vector>

#include "assets/fixtures/units.h"
#include "catalog/catalog.h"
#include "plan/plan.h"
#include "scene/zone_range.h"

namespace marketgen::scene {

// What of a bay is there whatever its boards: metres.
struct BayOpening {
  double width_m = 0, depth_m = 0;
  double base_m = 0;    // of the lowest board over the floor, which stays where it is
  double height_m = 0;  // from there to what closes the bay, or to its top edge where it is open
  bool open_top = false;
  double lost_m = 0.041;  // of a board's pitch that goods do not have: board, rail
  double slot_m = 0.05;   // raster of the slots
  IntRange levels{2, 8};  // fewest and most boards
};

// Kept over the packs that a board is fitted to, beside what the raster leaves: a hand, or a
// gripper, comes in there. Planogram practice keeps 30 to 60 mm.
constexpr double hand_room_m = 0.035;
// Over a board with nothing above it.
constexpr double open_top_m = assets::open_top_mm / 1000;
// No board is fitted to less: one must see and reach what stands behind.
constexpr double min_opening_m = 0.12;

// A bay of a run, what it holds.
struct FitBay {
  const BayOpening* opening = nullptr;
  const BayRange* range = nullptr;
};

// For each of `bays`, which stand beside one another and differ in their widths alone: from each
// board to the next and over the last, lowest first, whole slots in millimetres (the last one: what
// is left); none where no boards hold the range. The number of boards and their heights are those
// by which the ranges show the most goods; neighbours have the same where that shows nearly as
// much, so that boards run through.
std::vector<std::vector<int>> fitted_spacings(const std::vector<FitBay>& bays,
                                              const plan::StockSpec& stock,
                                              const catalog::Catalog& catalog);

}  // namespace marketgen::scene
