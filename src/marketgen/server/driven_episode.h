// One episode as a person drives it, step by step: an Environment in pd_ee_delta_pose, what a page
// is told of it, and the log of its actions.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "environments/environment.h"
#include "environments/teleop_command.h"
#include "episodes/drive_log.h"
#include "episodes/recorded_place.h"
#include "evaluation/event_recorder.h"
#include "evaluation/motion_recorder.h"
#include "server/drive_documents.h"
#include "server/replay_bodies.h"
#include "server/replay_things.h"
#include "store/store.h"

namespace marketgen::server {

// Not thread-safe; of one thread, all its life.
class DrivenEpisode {
 public:
  // `store` is where it happens, `catalog` has the rows of its goods and outlives it. Errors: those
  // of Environment::create and reset, TrackEntry::place_of, ReplayBodies::of and ReplayThings::add.
  static Result<std::unique_ptr<DrivenEpisode>> open(
      std::shared_ptr<environments::EpisodeGround> ground,
      const episodes::EpisodeSpec& spec,
      std::shared_ptr<const store::Store> store,
      const catalog::Catalog& catalog);

  // From its beginning, with an empty log. Errors: those of Environment::reset.
  Result<void> restart();
  // One control step; `done`: the driver says so, and it is judged. Precondition: running().
  // Errors: those of Environment::step and ReplayThings::add.
  Result<void> step(const environments::TeleopCommand& command, bool done);
  bool running() const { return environment_->running(); }
  std::uint32_t steps() const { return static_cast<std::uint32_t>(environment_->world().steps()); }

  // As things are now: a motion of one step, with all joints of the place that have moved so far.
  const episodes::Motion& now() const { return now_; }
  const episodes::RecordedPlace& place() const { return place_; }
  const ReplayBodies& bodies() const { return bodies_; }
  const ReplayThings& things() const { return things_; }
  // Without the number of its place.
  DriveEpisode told() const;
  // What a page is sent after each step: MGV1 with `head` and what is known here beside it.
  std::string message(DriveMoment head) const;
  // What was driven so far. Errors: episode.impossible, there was no step.
  Result<episodes::DriveFile> log() const;

 private:
  DrivenEpisode() = default;
  bool is_goal(const std::string& sku) const;
  void put_back();
  Result<void> look();
  void see_joints();
  Result<void> count_goals();

  std::shared_ptr<environments::EpisodeGround> ground_;
  episodes::EpisodeSpec spec_;
  std::unique_ptr<environments::Environment> environment_;
  std::optional<environments::TeleopHands> hands_;
  evaluation::EventRecorder events_;
  std::vector<float> seen_;
  std::vector<double> actions_;
  episodes::Motion now_;
  episodes::RecordedPlace place_;
  ReplayBodies bodies_;
  ReplayThings things_;
  std::map<std::pair<episodes::ThingKind, std::uint32_t>, std::size_t> rows_;  // of things_
  std::vector<Pose> thing_poses_;                                              // store from thing
  std::shared_ptr<const store::Store> store_;
  std::vector<double> rest_joints_;  // of the place, at the beginning
  std::set<std::uint32_t> moved_joints_;
  std::vector<int> reached_;
};

}  // namespace marketgen::server
