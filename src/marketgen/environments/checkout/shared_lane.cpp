#include "environments/checkout/shared_lane.h"

#include <fmt/format.h>

namespace marketgen::environments {

Result<std::shared_ptr<const episodes::CheckoutPlace>> shared_lane(
    Arena& arena, const episodes::CheckoutStation& station, const episodes::EpisodeSpec& spec) {
  using Place = const episodes::CheckoutPlace;
  if (!spec.lane) return std::shared_ptr<Place>();
  return arena.shared().get<Place>(
      fmt::format("{} {} {}", spec.scene_hash, station.id, *spec.lane),
      [&]() -> Result<std::shared_ptr<Place>> {
        MARKETGEN_TRY(const auto store, arena.scene(spec.scene_hash));
        MARKETGEN_TRY(episodes::CheckoutPlace place,
                      episodes::checkout_at_lane(
                          station, *store, arena.catalog(), *spec.lane, spec.id + "/lane"));
        return std::make_shared<Place>(std::move(place));
      });
}

}  // namespace marketgen::environments
