// The planogram: which products stand on which shelf, in how many facings.
//
// A bay is one side of one module: its shelves from the lowest up. Bays of a zone take consecutive
// slices of the zone's assortment, so that brands and subcategories stay together along a run;
// inside a bay heavy goods go low, and every level keeps the assortment's order from left to right.
// Zones whose brands shall have columns or boards of their own: scene/brand_blocks.h.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/fixtures/fixture_model.h"
#include "base/seed.h"
#include "catalog/catalog.h"
#include "plan/plan.h"

namespace marketgen::scene {

// Room that a shelf offers; metres.
struct ShelfRoom {
  double width_m, depth_m, clearance_m;
  assets::ShelfUse use;
  double board_m = 0;  // of its board over the floor
};

// What a person should not lift above the shoulders: HSE INDG143, "Manual handling at work", 7 kg
// for women. Packs are gripped by their upper half, so that boards up to 1.15 m keep it below 1.4
// m.
constexpr double heavy_lift_kg = 7, heavy_board_m = 1.15;
// The stretch level takes light goods: planogram practice has nothing of 2 kg and more above 1.60
// m. HSE INDG143 (3 kg at arm's length above the shoulders, for women) is 1 kg milder.
constexpr double stretch_kg = 2, stretch_m = 1.60;

// No pack of this mass rests as high over the floor, neither on a board nor on another pack;
// metres.
double highest_rest_m(double mass_kg);

// One block of one SKU on a shelf.
struct PlannedBlock {
  std::uint32_t product = 0;  // row of catalog.products
  int facings = 1;
  bool certain = false;  // never out of stock
  // What a planogram says of it; the stocker's own where it says nothing.
  std::optional<double> x_m = std::nullopt;  // left edge from the shelf's left end
  std::optional<int> stack = std::nullopt, rows_deep = std::nullopt;
};

using PlannedShelf = std::vector<PlannedBlock>;  // from left to right

constexpr double pack_gap_m = 0.004;     // between facings; retail practice 2-8 mm
constexpr double depth_gap_m = 0.003;    // between rows
constexpr double finger_room_m = 0.025;  // above goods; retail practice 25-50 mm
constexpr int max_facings = 8;           // of one SKU in one block; leaders have up to 8

// Bottom to top room of one bay; `stock` from the zone; `promotion` bays (endcaps, bins) show few
// SKUs in many facings.
struct Bay {
  std::vector<ShelfRoom> shelves;
  bool promotion = false;
  bool fitted = false;  // goods of one height share a board (plan::ShelfPitch::fitted)
};

// Where the next bay goes on in the assortment.
struct AssortmentCursor {
  std::size_t next = 0;
};

// Plans one bay and moves the cursor on. An empty assortment gives empty shelves. `certain`: rows
// of the assortment that stand here first, whatever comes next; one for which the bay has no room
// is left out.
std::vector<PlannedShelf> plan_bay(const Bay& bay,
                                   const std::vector<std::uint32_t>& assortment,
                                   const plan::StockSpec& stock,
                                   const catalog::Catalog& catalog,
                                   AssortmentCursor& cursor,
                                   Stream draw,
                                   const std::vector<std::uint32_t>& certain = {});

// From one facing of a block to the next: a pack and the gap beside it.
double facing_pitch_m(const catalog::Product& product);

// Whether one pack fits on an empty shelf: its size, and its mass at that height.
bool fits(const catalog::Product& product, const ShelfRoom& room);

// "it is 300 mm tall; the shelf takes no more than 260 mm": `takes` says whose these rooms are.
// Empty when the measures alone are no reason.
std::string too_large_for(const catalog::Product& product,
                          const std::vector<ShelfRoom>& rooms,
                          std::string_view takes);

// Packs on one another on a shelf of this clearance, none higher than its mass allows; 0 when not
// even one fits.
int stack_height(const catalog::Product& product, const ShelfRoom& room);

}  // namespace marketgen::scene
