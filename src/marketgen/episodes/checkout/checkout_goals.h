// The goal region of Checkout Unloading: the unloading area on the counter, but for the basket.
#pragma once
#include <vector>

#include "episodes/checkout/checkout_station.h"
#include "episodes/goal_judge.h"

namespace marketgen::episodes {

constexpr double max_tilt_deg = 15;

// The basket where it stands now.
struct PlacedBasket {
  physics::OpenContainer container;
  Pose station_from_container;
};

// Points over the area, not under it, and neither in the basket nor above its opening: what a
// basket holds is not unloaded, wherever that was pushed. Station frame.
HoldsPoint over_area(const AreaRow& area, const PlacedBasket& basket);

// Points in the basket or above its opening.
HoldsPoint in_basket(const PlacedBasket& basket);

// Those, and points over an area that takes goods: nothing there is astray.
HoldsPoint where_goods_belong(const CheckoutStation& station, const Pose& station_from_basket);

// `is_void` when the basket was tilted too far.
EpisodeOutcome judge_checkout(const HoldsPoint& region,
                              const std::vector<EpisodeGoal>& goals,
                              const std::vector<ItemState>& items,
                              double max_basket_tilt_deg);

}  // namespace marketgen::episodes
