// Checkout Unloading as an entry of episodes/tracks.inc.
#include <algorithm>

#include <fmt/format.h>

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
};

}  // namespace

const TrackEntry& checkout_entry() {
  static const CheckoutEntry entry;
  return entry;
}

}  // namespace marketgen::episodes
