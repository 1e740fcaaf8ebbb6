// An episode as it is run for a folder of results, and what is kept of it there beside its result.
#pragma once
#include <filesystem>
#include <string>

#include "base/fields.h"
#include "environments/run_episode.h"

namespace marketgen::evaluation {

// What else is kept. Empty: nothing is.
struct Kept {
  std::string motion;     // folder of results that keeps what moved (motion_recorder.h)
  std::string decisions;  // that keeps what the policy decided (decision_recorder.h)
  static constexpr auto fields =
      field_list(field("motion", &Kept::motion, "folder of results that keeps what moved"),
                 field("decisions", &Kept::decisions, "folder that keeps what was decided"));
};

// run_episode(), with `watcher` if there is one. Errors: those, too; io.cannot_write.
Result<episodes::EpisodeResult> run_recorded(environments::Arena& arena,
                                             const episodes::EpisodeSpec& spec,
                                             const std::string& policy,
                                             const episodes::Realism& realism,
                                             const Kept& kept,
                                             environments::EpisodeWatcher* watcher = nullptr);

}  // namespace marketgen::evaluation
