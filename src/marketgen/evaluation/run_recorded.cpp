#include "evaluation/run_recorded.h"

#include <utility>
#include <vector>

#include "evaluation/decision_recorder.h"
#include "evaluation/motion_recorder.h"
#include "io/file.h"

namespace marketgen::evaluation {

Result<episodes::EpisodeResult> run_recorded(environments::Arena& arena,
                                             const episodes::EpisodeSpec& spec,
                                             const std::string& policy,
                                             const episodes::Realism& realism,
                                             const Kept& kept,
                                             environments::EpisodeWatcher* watcher) {
  MotionRecorder motion;
  DecisionRecorder decisions;
  // The caller's first: it measures how long answers take, and that is not to be counted.
  std::vector<environments::EpisodeWatcher*> all;
  if (watcher != nullptr) all.push_back(watcher);
  if (!kept.motion.empty()) all.push_back(&motion);
  if (!kept.decisions.empty()) all.push_back(&decisions);
  environments::EpisodeWatchers watchers(std::move(all));
  MARKETGEN_TRY(const episodes::EpisodeResult result,
                environments::run_episode(arena, spec, policy, &watchers, {}, realism));
  const std::string hash = episodes::episode_hash(arena.header(), spec);
  if (!kept.motion.empty())
    MARKETGEN_CHECK(io::write_file(motion_file(kept.motion, spec.id), motion.packed(result, hash)));
  if (!kept.decisions.empty()) {
    MARKETGEN_TRY(const EpisodeDecisions decided, decisions.decided(result, hash));
    MARKETGEN_CHECK(write_decisions(kept.decisions, decided));
  }
  return result;
}

}  // namespace marketgen::evaluation
