// One recorded episode as a page plays it: what it was, where everything is at each control step,
// and the shapes that move. docs/viewer.md says what each file holds.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "episodes/episode_result.h"
#include "episodes/motion.h"
#include "episodes/recorded_place.h"
#include "episodes/recorded_view.h"
#include "server/replay_bodies.h"
#include "server/replay_runs.h"
#include "server/replay_things.h"
#include "server/view_build.h"
#include "server/view_files.h"
#include "store/store.h"

namespace marketgen::server {

struct ReplayGoal {
  std::string sku, name, name_zh;
  int count = 0, reached = 0;
  double since_s = -1;
  static constexpr auto fields = field_list(
      field("sku", &ReplayGoal::sku, "product"),
      field("name", &ReplayGoal::name, "of the product"),
      field("name_zh", &ReplayGoal::name_zh, "in Chinese"),
      field("count", &ReplayGoal::count, "how many were asked for"),
      field("reached", &ReplayGoal::reached, "how many were in place when it was judged"),
      field("since_s", &ReplayGoal::since_s, "since when they lay there still; -1: none does"));
};

struct ReplaySummary {
  EpisodeLine result;
  RunLine run;
  std::string instruction, robot;
  int place = -1;
  double step_s = 0;
  std::uint32_t steps = 0;
  std::vector<std::string> bodies;
  std::vector<ReplayGoal> goals;
  std::vector<ReplayThing> things;
  std::vector<episodes::MotionEvent> events;
  episodes::SideEffects side_effects;
  std::vector<std::string> cameras;
  static constexpr auto fields = field_list(
      field("result", &ReplaySummary::result, "how it ended"),
      field("run", &ReplaySummary::run, "whose it is"),
      field("instruction", &ReplaySummary::instruction, "what the agent was told"),
      field("robot", &ReplaySummary::robot, "row in data/robots"),
      field("place", &ReplaySummary::place, "below places; -1: the store itself"),
      field("step_s", &ReplaySummary::step_s, "seconds a control step"),
      field("steps", &ReplaySummary::steps, "with the beginning"),
      field("bodies", &ReplaySummary::bodies, "of robot.bin; the basket, if there is one, last"),
      field("goals", &ReplaySummary::goals, "one by one"),
      field("things", &ReplaySummary::things, "in the order of things.bin"),
      field("events", &ReplaySummary::events, "by their first step"),
      field("side_effects", &ReplaySummary::side_effects, "the ledger"),
      field("cameras", &ReplaySummary::cameras, "of which there are pictures"));
};

class ReplayEpisode {
 public:
  // Reads the motion and finds its place. `store` must be that of the result. Errors:
  // results.no_motion, results.changed; those of read_motion and TrackEntry::place_of.
  static Result<std::shared_ptr<ReplayEpisode>> open(const ReplayRuns& runs,
                                                     std::size_t run,
                                                     std::size_t episode,
                                                     std::shared_ptr<const store::Store> store,
                                                     const catalog::Catalog& catalog);

  const episodes::RecordedPlace& place() const { return place_; }
  const episodes::Motion& motion() const { return motion_; }
  // Without the number of its place.
  const ReplaySummary& summary() const { return summary_; }

  // Thread-safe, all of them.
  ViewFile robot() const { return bodies_.file(); }
  // Steps from `first` on, as many as there are up to `count`. Precondition: first < steps.
  ViewFile poses(std::uint32_t first, std::uint32_t count) const;
  ViewFile things() const;
  // meshes.bin and goods-P.jpg of the things; made when one is first asked for. Errors: those of
  // goods_meshes; server.not_found.
  Result<ViewBuild::Body> shape(const std::string& name);
  // What takes its pictures, for as long as the episode lives. Errors: those of
  // TrackEntry::open_recorded.
  Result<std::unique_ptr<episodes::RecordedView>> open_view() const;

 private:
  ReplayEpisode() = default;
  Result<void> find_things(const episodes::EpisodeResult& result, const catalog::Catalog& catalog);
  void summarise(const ReplayRuns& runs, std::size_t run, std::size_t episode);
  void add_goals(const episodes::EpisodeResult& result);
  std::vector<double> state(std::size_t step) const;

  std::shared_ptr<const store::Store> store_;
  episodes::Motion motion_;
  episodes::RecordedPlace place_;
  ReplayBodies bodies_;
  ReplayThings things_;
  ReplaySummary summary_;
  std::mutex mutex_;
  std::map<std::string, ViewBuild::Body> shapes_;
};

}  // namespace marketgen::server
