// Checkout Unloading as an entry of episodes/tracks.inc.
#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "episodes/checkout/checkout_scene.h"
#include "episodes/checkout/checkout_view.h"
#include "episodes/checkout/sample_checkout.h"
#include "episodes/track_entry.h"

namespace marketgen::episodes {
namespace {

class CheckoutEntry : public TrackEntry {
 public:
  std::vector<std::string_view> cameras() const override { return {"scene", "wrist"}; }
  std::vector<std::string_view> own_fields() const override { return {"items", "station", "lane"}; }

  Result<void> check_goals(const EpisodeSpec& spec, const std::string& where) const override {
    for (const EpisodeGoal& goal : spec.goals) {
      const auto lying = std::ranges::count(spec.items, goal.sku, &EpisodeItem::sku);
      if (lying < goal.count)
        return Error{
            "episode.impossible",
            where + "/goals",
            fmt::format(
                "asks for {} of \"{}\"; {} lie in the basket", goal.count, goal.sku, lying)};
    }
    return {};
  }

  Result<TrackRobot> robot(const std::filesystem::path& data) const override {
    MARKETGEN_TRY(const CheckoutStation station, load_checkout_station(data));
    return TrackRobot{station.robot, ids_of(station.tool_sets)};
  }

  // All that lies there.
  int items_of(const EpisodeSpec& spec) const override {
    return static_cast<int>(spec.items.size());
  }
  int max_items() const override { return max_targets + max_others; }

  Result<RecordedPlace> place_of(const std::filesystem::path& data,
                                 const Motion& motion,
                                 std::shared_ptr<const scene::Scene> store,
                                 const catalog::Catalog& catalog) const override {
    const std::string named = motion.station.empty() ? checkout_station : motion.station;
    MARKETGEN_TRY(const CheckoutStation station, load_checkout_station(data, named, motion.tools));
    MARKETGEN_TRY(robots::Robot robot, load_station_robot(data, station));
    CheckoutPlace place = checkout_room(station);
    if (!motion.lane.empty()) {
      MARKETGEN_TRY(
          place, checkout_at_lane(station, *store, catalog, motion.lane, motion.episode + "/lane"));
    }
    return RecordedPlace{std::make_shared<scene::Scene>(std::move(place.surroundings)),
                         named + "/" + motion.lane,
                         std::move(robot),
                         basket_actor(station)};
  }
};

}  // namespace

const TrackEntry& checkout_entry() {
  static const CheckoutEntry entry;
  return entry;
}

}  // namespace marketgen::episodes
