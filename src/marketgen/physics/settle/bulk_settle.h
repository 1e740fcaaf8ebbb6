// Bulk settling: products poured one after another into an open container (a basket, a bin) until
// they rest.
//
// Each hangs any way round over the rim and falls when what fell before it lies. Products are their
// contact pieces, rigid. What rolls over the rim is taken away at once: it is counted, not chased.
//
// Container frame: X along the shorter side of the checkout basket, Z up, the origin in the middle
// of the inner floor. SI units. Deterministic, the same for any number of threads; thread-safe.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "base/seed.h"
#include "geometry/pose.h"
#include "physics/goods/goods_body.h"

namespace marketgen::physics {

// A floor and four walls that may lean outwards. Without a floor's thickness: it lies on a counter
// or a board, which goes on outside.
struct OpenContainer {
  double top_x_m = 0, top_y_m = 0;  // inner, between the walls' upper edges
  double height_m = 0;              // of the rim over the inner floor
  double taper_m = 0;               // by which each wall stands further in at the floor
  double wall_m = 0.010;            // thickness; of a moulded basket that of its rim
  double ledge_width_m = 0, ledge_height_m = 0;  // along the inner bottom; 0 = none
};

// The basket of Checkout Unloading; the ledge keeps packs a finger's width off the walls.
constexpr OpenContainer checkout_basket{.top_x_m = 0.30,
                                        .top_y_m = 0.43,
                                        .height_m = 0.15,
                                        .taper_m = 0.02,
                                        .ledge_width_m = 0.018,
                                        .ledge_height_m = 0.012};

// Walls and ledge as boxes.
struct ContainerBox {
  Pose container_from_box;
  Vec3 half_size;
};
std::vector<ContainerBox> boxes_of(const OpenContainer& container);

// Whether the pack can lie on the floor between the walls, some way round, without standing out.
bool fits_in(const OpenContainer& container, const catalog::Product& product);

struct SettledItem {
  Pose container_from_product;  // of what is inside
  bool inside = false;          // its middle of mass is over the floor
};

struct SettledBulk {
  std::vector<SettledItem> items;  // in the order given, which is that of pouring
  int spilled = 0;                 // how many are not inside
  bool rests = false;              // false: the time limit came first
  double simulated_s = 0;
};

constexpr std::size_t max_bulk_items = 200;
// Of the simulation: so much for each item, and once at the end.
constexpr double max_pour_s = 1.0, max_rest_s = 6.0;

// Errors: physics.bad_command for a container that is not finite, has no room inside, or for more
// items than `max_bulk_items`; catalog.bad_row for a product without mass or size; physics.failed.
// Packs that do not fit spill: no error. No item: an empty result that rests.
Result<SettledBulk> settle_bulk(const OpenContainer& container,
                                const std::vector<SharedGoodsBody>& items,
                                Seed seed);

}  // namespace marketgen::physics
