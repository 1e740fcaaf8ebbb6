// What a track is to those who do not care which: its rows, and what its episodes say.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "episodes/episode_spec.h"
#include "episodes/motion.h"
#include "episodes/recorded_place.h"
#include "episodes/recorded_view.h"

namespace marketgen::episodes {

// The robot of a track, and the tool sets between which its episodes may choose.
struct TrackRobot {
  std::string robot;
  std::vector<std::string> tools = {};
};

// Immutable; any number of threads may ask.
class TrackEntry {
 public:
  virtual ~TrackEntry() = default;
  // Cameras that an agent can have, as EpisodeSpec::cameras names them.
  virtual std::vector<std::string_view> cameras() const = 0;
  // Of EpisodeSpec, those of its fields that not every track has: "items", "categories",
  // "station", "lane", "start".
  virtual std::vector<std::string_view> own_fields() const = 0;
  // Whether the goals can be met, as far as the episode tells, at "WHERE/goals". Errors:
  // episode.impossible.
  virtual Result<void> check_goals(const EpisodeSpec& spec, const std::string& where) const = 0;
  // What EpisodeCertificate::proved may say of its episodes, besides "physics".
  virtual std::vector<std::string_view> proofs() const = 0;
  // Whether each pick of the witness is of this episode. Error episode.bad_value at
  // "witness/PICK/FIELD" (episodes/check_witness.h).
  virtual Result<void> check_picks(const EpisodeSpec& spec) const = 0;
  // Errors: those of the station's file.
  virtual Result<TrackRobot> robot(const std::filesystem::path& data) const = 0;
  // How many things an episode is about, and how many at most one that is drawn.
  virtual int items_of(const EpisodeSpec& spec) const = 0;
  virtual int max_items() const = 0;
  // Where the motion of one of its episodes happened, in that store. Errors: those of the station's
  // file; robot.unknown; episode.other_store, the store lacks its lane.
  virtual Result<RecordedPlace> place_of(const std::filesystem::path& data,
                                         const Motion& motion,
                                         std::shared_ptr<const scene::Scene> store,
                                         const catalog::Catalog& catalog) const = 0;
  // Cameras of which a recorded episode has pictures; the first shows most.
  virtual std::vector<std::string> recorded_cameras() const = 0;
  // `place` is the motion's and outlives the view, as the motion does. `products`: rows of its
  // items. Errors: those of the station's file and of Renderer::create; catalog.unknown_sku.
  virtual Result<std::unique_ptr<RecordedView>> open_recorded(
      const std::filesystem::path& data,
      const Motion& motion,
      const RecordedPlace& place,
      const std::vector<catalog::Product>& products) const = 0;
};

#define MARKETGEN_TRACK(name, Type) const TrackEntry& name##_entry();
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK

const TrackEntry& entry_of(Track track);

}  // namespace marketgen::episodes
