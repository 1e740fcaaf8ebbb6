// Keeps what a policy decides in an episode, beside what is true at that time.
#pragma once
#include <cstddef>
#include <string>

#include "environments/run_episode.h"
#include "evaluation/decision_record.h"

namespace marketgen::evaluation {

// Not thread-safe; of one episode at a time.
class DecisionRecorder : public environments::EpisodeWatcher {
 public:
  Result<void> begin(const episodes::TrackWorld& world) override;
  void meets(agent::Policy& policy) override;
  void answered() override;
  Result<void> step() override { return state_; }
  // All of it, once the episode has ended with that result. Precondition: it began. Errors: of
  // encode_jpeg.
  Result<EpisodeDecisions> decided(const episodes::EpisodeResult& result,
                                   const std::string& episode_hash);

 private:
  Result<void> take_new();
  Result<DecisionRecord> record_of(const agent::Decision& decision) const;

  const episodes::TrackWorld* world_ = nullptr;
  agent::DecisionLog* log_ = nullptr;  // null: the policy tells nothing
  std::size_t taken_ = 0;
  Result<void> state_;  // of what was taken so far
  EpisodeDecisions made_;
};

// Writes decisions/ID.json.gz of a folder of results, and decisions/ID.html, which shows it.
// Errors: io.cannot_write.
Result<void> write_decisions(const std::filesystem::path& results,
                             const EpisodeDecisions& decisions);

}  // namespace marketgen::evaluation
