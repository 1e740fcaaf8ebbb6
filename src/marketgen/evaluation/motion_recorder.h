// Records what moves in an episode as it is run (episodes/motion.h).
#pragma once
#include <filesystem>
#include <map>
#include <utility>

#include "environments/run_episode.h"
#include "episodes/motion.h"
#include "evaluation/event_recorder.h"

namespace marketgen::evaluation {

// Where the motion of an episode lies in a folder of results: motion/ID.bin.gz.
std::filesystem::path motion_file(const std::filesystem::path& results, const std::string& episode);

// Not thread-safe; of one episode at a time.
class MotionRecorder : public environments::EpisodeWatcher {
 public:
  Result<void> begin(const episodes::TrackWorld& world) override;
  Result<void> step() override;
  // So far; of which episode it is, and its events, stand in packed() alone.
  const episodes::Motion& motion() const { return motion_; }
  // The motion so far, as that of `result`, of the episode with that hash. Precondition: it began.
  std::string packed(const episodes::EpisodeResult& result, const std::string& episode_hash);

 private:
  void look();
  void see(const episodes::MovedThing& thing, std::uint32_t step);
  void see_joints(std::uint32_t step);

  const episodes::TrackWorld* world_ = nullptr;
  episodes::Motion motion_;
  std::map<std::pair<episodes::ThingKind, std::uint32_t>, std::size_t>
      places_;                  // in motion_.things
  std::vector<double> joints_;  // as they were written last
  std::map<std::uint32_t, std::size_t> joint_places_;
  EventRecorder events_;
};

}  // namespace marketgen::evaluation
