// One episode as a person drives it, step by step: an Environment in pd_ee_delta_pose, what a page
// is told of it, and the log of its actions.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "environments/environment.h"
#include "environments/teleop_hands.h"
#include "episodes/drive_log.h"
#include "robots/teleop_command.h"
#include "server/drive_documents.h"
#include "server/shown_episode.h"
#include "store/store.h"

namespace marketgen::server {

// Not thread-safe; of one thread, all its life.
class DrivenEpisode {
 public:
  // `store` is where it happens, `catalog` has the rows of its goods and outlives it. Errors: those
  // of Environment::create and reset, and ShownEpisode::of.
  static Result<std::unique_ptr<DrivenEpisode>> open(
      std::shared_ptr<environments::EpisodeGround> ground,
      const episodes::EpisodeSpec& spec,
      std::shared_ptr<const store::Store> store,
      const catalog::Catalog& catalog);

  // From its beginning, with an empty log. Errors: those of Environment::reset.
  Result<void> restart();
  // One control step; `done`: the driver says so, and it is judged. Precondition: running().
  // Errors: those of Environment::step and ReplayThings::add.
  Result<void> step(const robots::TeleopCommand& command, bool done);
  bool running() const { return environment_->running(); }
  const ShownEpisode& shown() const { return *shown_; }
  // Without the number of its place.
  DriveEpisode told() const;
  // Of each tool, as told: 1 open, -1 closed.
  std::span<const double> openings() const { return hands_->openings(); }
  // What was driven so far. Errors: episode.impossible, there was no step.
  Result<episodes::DriveFile> log() const;

 private:
  DrivenEpisode() = default;
  Result<void> reset();

  std::shared_ptr<environments::EpisodeGround> ground_;
  episodes::EpisodeSpec spec_;
  std::unique_ptr<environments::Environment> environment_;
  std::optional<environments::TeleopHands> hands_;
  std::unique_ptr<ShownEpisode> shown_;  // reads the environment
  std::vector<float> seen_;
  std::vector<double> actions_;
};

}  // namespace marketgen::server
