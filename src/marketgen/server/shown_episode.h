// What pages are told of an episode that runs, whoever steps it.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "environments/environment.h"
#include "environments/episode_ground.h"
#include "episodes/recorded_place.h"
#include "evaluation/event_recorder.h"
#include "evaluation/motion_recorder.h"
#include "server/drive_documents.h"
#include "server/replay_bodies.h"
#include "server/replay_things.h"
#include "store/store.h"

namespace marketgen::server {

// Not thread-safe.
class ShownEpisode {
 public:
  // `environment` has begun an episode and outlives this, as does `catalog`, which has the rows of
  // its goods; `store` is where it happens. Errors: those of look(), TrackEntry::place_of and
  // ReplayBodies::of.
  static Result<std::unique_ptr<ShownEpisode>> of(environments::Environment& environment,
                                                  environments::EpisodeGround& ground,
                                                  std::shared_ptr<const store::Store> store,
                                                  const catalog::Catalog& catalog);

  // The same episode has begun anew. Errors: those of look().
  Result<void> begin();
  // A control step was made. Errors: those of Environment::items and ReplayThings::add.
  Result<void> look();
  bool running() const { return environment_.running(); }

  // As things are now: a motion of one step, with all joints of the place that have moved so far.
  const episodes::Motion& now() const { return now_; }
  const episodes::RecordedPlace& place() const { return place_; }
  const ReplayBodies& bodies() const { return bodies_; }
  const ReplayThings& things() const { return things_; }
  // Without the number of its place, and what a driver may move.
  DriveEpisode told() const;
  // What a page is sent after each step: MGV1 with `head` and what is known here beside it.
  std::string message(DriveMoment head) const;

 private:
  explicit ShownEpisode(environments::Environment& environment) : environment_(environment) {}
  const episodes::EpisodeSpec& spec() const { return environment_.world().spec(); }
  std::uint32_t steps() const { return static_cast<std::uint32_t>(environment_.world().steps()); }
  bool is_goal(const std::string& sku) const;
  void put_back();
  Result<void> see();
  void see_joints();
  Result<void> count_goals();

  environments::Environment& environment_;
  evaluation::EventRecorder events_;
  episodes::Motion now_;
  episodes::RecordedPlace place_;
  ReplayBodies bodies_;
  ReplayThings things_;
  std::map<std::pair<episodes::ThingKind, std::uint32_t>, std::size_t> rows_;  // of things_
  std::vector<Pose> thing_poses_;                                              // store from thing
  std::vector<double> rest_joints_;  // of the place, at the beginning
  std::set<std::uint32_t> moved_joints_;
  std::vector<int> reached_;
};

}  // namespace marketgen::server
