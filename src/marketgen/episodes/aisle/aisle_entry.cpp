// In-Aisle Item Collection as an entry of episodes/tracks.inc.
#include <utility>

#include "episodes/aisle/sample_aisle.h"
#include "episodes/track_entry.h"

namespace marketgen::episodes {
namespace {

class AisleEntry : public TrackEntry {
 public:
  std::vector<std::string_view> cameras() const override { return {"head_camera"}; }
  std::vector<std::string_view> own_fields() const override { return {"categories", "start"}; }

  // What the store offers is not in the episode: AisleWorld::reset looks.
  Result<void> check_goals(const EpisodeSpec&, const std::string&) const override { return {}; }

  Result<TrackRobot> robot(const std::filesystem::path& data) const override {
    MARKETGEN_TRY(const AisleStation station, load_aisle_station(data));
    return TrackRobot{station.robot, ids_of(station.tool_sets)};
  }

  // What is asked for.
  int items_of(const EpisodeSpec& spec) const override {
    int asked = 0;
    for (const EpisodeGoal& goal : spec.goals)
      asked += goal.count;
    return asked;
  }
  int max_items() const override { return max_goals; }

  // The basket is part of the robot.
  Result<RecordedPlace> place_of(const std::filesystem::path& data,
                                 const Motion& motion,
                                 std::shared_ptr<const scene::Scene> store,
                                 const catalog::Catalog&) const override {
    MARKETGEN_TRY(const AisleStation station, load_aisle_station(data, motion.tools));
    MARKETGEN_TRY(robots::Robot robot, load_station_robot(data, station));
    return RecordedPlace{std::move(store), "", std::move(robot), {}};
  }
};

}  // namespace

const TrackEntry& aisle_entry() {
  static const AisleEntry entry;
  return entry;
}

}  // namespace marketgen::episodes
