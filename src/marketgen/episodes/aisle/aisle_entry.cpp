// In-Aisle Item Collection as an entry of episodes/tracks.inc.
#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "episodes/aisle/aisle_view.h"
#include "episodes/aisle/sample_aisle.h"
#include "episodes/proved_names.h"
#include "episodes/track_entry.h"

namespace marketgen::episodes {
namespace {

class RecordedAisle : public RecordedView {
 public:
  RecordedAisle(const Motion& motion, const RecordedPlace& place, std::unique_ptr<AisleView> view)
      : motion_(motion), place_(place), view_(std::move(view)) {}
  Result<Image> picture(std::string_view name, std::size_t step, int width, int height) override {
    MARKETGEN_CHECK(
        view_->follow(place_.robot, scenery_at(motion_, step, 0), joints_at(motion_, step)));
    MARKETGEN_TRY(const render::Camera camera, view_->camera(name, width, height));
    MARKETGEN_TRY(render::Frame frame, view_->renderer().render(camera, {}));
    return std::move(frame.color);
  }

 private:
  const Motion& motion_;
  const RecordedPlace& place_;
  std::unique_ptr<AisleView> view_;
};

class AisleEntry : public TrackEntry {
 public:
  std::vector<std::string_view> cameras() const override {
    return {aisle_cameras.begin(), aisle_cameras.end()};
  }
  std::vector<std::string_view> own_fields() const override {
    return {"categories", "doors", "start"};
  }

  // What the store offers is not in the episode: AisleWorld::reset looks.
  Result<void> check_goals(const EpisodeSpec&, const std::string&) const override { return {}; }

  std::vector<std::string_view> proofs() const override {
    std::set<std::string_view> shown{shown_by_wider_search};
    shown.insert(shown_by_fetching.begin(), shown_by_fetching.end());
    shown.insert(shown_behind_doors.begin(), shown_behind_doors.end());
    shown.insert(shown_on_paper.begin(), shown_on_paper.end());
    return {shown.begin(), shown.end()};
  }

  // Goals are drawn one after the other, each from where the witness left off, and nothing else is
  // fetched.
  Result<void> check_picks(const EpisodeSpec& spec) const override {
    auto goal = spec.goals.begin();
    const std::vector<WitnessPick>& witness = spec.certificate.witness;
    for (std::size_t i = 0; i < witness.size(); ++i) {
      const auto next = std::find_if(goal, spec.goals.end(), [&](const EpisodeGoal& each) {
        return each.sku == witness[i].sku;
      });
      if (next == spec.goals.end())
        return Error{"episode.bad_value",
                     fmt::format("witness/{}/sku", i),
                     std::ranges::count(spec.goals, witness[i].sku, &EpisodeGoal::sku) == 0
                         ? fmt::format("\"{}\" is no goal", witness[i].sku)
                         : fmt::format("\"{}\" is taken after a goal that comes later: goals are "
                                       "fetched in their order",
                                       witness[i].sku)};
      goal = next;
    }
    return {};
  }

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
  int max_items() const override { return episodes::max_items; }

  // The basket is part of the robot.
  Result<RecordedPlace> place_of(const std::filesystem::path& data,
                                 const Motion& motion,
                                 std::shared_ptr<const scene::Scene> store,
                                 const catalog::Catalog&) const override {
    MARKETGEN_TRY(const AisleStation station, load_aisle_station(data, motion.tools));
    MARKETGEN_TRY(robots::Robot robot, load_station_robot(data, station));
    return RecordedPlace{std::move(store), "", std::move(robot), {}};
  }

  std::vector<std::string> recorded_cameras() const override {
    std::vector<std::string> names{film_camera_name};
    names.insert(names.end(), aisle_cameras.begin(), aisle_cameras.end());
    return names;
  }

  Result<std::unique_ptr<RecordedView>> open_recorded(
      const std::filesystem::path& data,
      const Motion& motion,
      const RecordedPlace& place,
      const std::vector<catalog::Product>&) const override {
    MARKETGEN_TRY(const AisleStation station, load_aisle_station(data, motion.tools));
    MARKETGEN_TRY(auto view,
                  AisleView::create(station, place.robot, *place.scene, {.keep_light = true}));
    return std::unique_ptr<RecordedView>(
        std::make_unique<RecordedAisle>(motion, place, std::move(view)));
  }
};

}  // namespace

const TrackEntry& aisle_entry() {
  static const AisleEntry entry;
  return entry;
}

}  // namespace marketgen::episodes
