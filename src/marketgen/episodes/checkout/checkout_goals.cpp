#include "episodes/checkout/checkout_goals.h"

#include <algorithm>
#include <cmath>

namespace marketgen::episodes {
namespace {

constexpr double under_the_top_m = 0.02;  // lower than this over the counter is beside it

// Between the leaning walls, or above their opening: goods heaped over the rim are in it, too.
bool is_in_basket(const physics::OpenContainer& c, Vec3 at) {
  const double lean = c.taper_m * (1 - std::clamp(at.z / c.height_m, 0.0, 1.0));
  return at.z >= 0 && std::abs(at.x) <= c.top_x_m / 2 - lean &&
         std::abs(at.y) <= c.top_y_m / 2 - lean;
}

bool is_over(const AreaRow& area, Vec3 at) {
  return area.holds(at.x, at.y) && at.z > -under_the_top_m;
}

}  // namespace

HoldsPoint over_area(const AreaRow& area, const PlacedBasket& basket) {
  return [area,
          container = basket.container,
          container_from_station = inverse(basket.station_from_container)](Vec3 at) {
    return is_over(area, at) && !is_in_basket(container, container_from_station * at);
  };
}

HoldsPoint in_basket(const PlacedBasket& basket) {
  return [container = basket.container,
          container_from_station = inverse(basket.station_from_container)](Vec3 at) {
    return is_in_basket(container, container_from_station * at);
  };
}

HoldsPoint where_goods_belong(const CheckoutStation& station, const Pose& station_from_basket) {
  return [unloading = station.unloading.area(),
          set_aside = station.set_aside,
          container = station.container(),
          container_from_station = inverse(station_from_basket)](Vec3 at) {
    return is_over(unloading, at) || is_over(set_aside, at) ||
           is_in_basket(container, container_from_station * at);
  };
}

EpisodeOutcome judge_checkout(const HoldsPoint& region,
                              const std::vector<EpisodeGoal>& goals,
                              const std::vector<ItemState>& items,
                              double max_basket_tilt_deg) {
  EpisodeOutcome outcome = judge(region, goals, items);
  outcome.is_void = max_basket_tilt_deg > max_tilt_deg;
  if (outcome.is_void) outcome.hits = 0;
  return outcome;
}

}  // namespace marketgen::episodes
