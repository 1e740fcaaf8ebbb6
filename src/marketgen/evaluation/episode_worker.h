// The inside of a worker process: runs the episodes of a file that it is told, one at a time.
//
// Why processes: a policy that never answers cannot be stopped from inside its own process. A
// thread cannot be killed, only left behind, with the locks that it holds and the core that it
// keeps busy; a process can be, with all that it has. It is also the only way to survive a policy
// that crashes. So `evaluate` looks on from outside (evaluation/worker_process.h) and ends a worker
// whose policy computes too long over one answer, or never gives one.
//
// A line each way, all of JSON: first, on standard input, a WorkerTask; then one episode after the
// other. So files are read once, by whoever has them, be they pipes. On
// standard output "ready" once, then around every call of the policy "asked" and "answered " with
// the seconds of processor time that it took, and at the end of the episode "result " and a
// market-result/1, or "error ", the error's code, where and message between tabs. What policies
// print goes to standard error.
#pragma once
#include <filesystem>
#include <string>

#include "base/result.h"
#include "catalog/catalog.h"
#include "episodes/episode_spec.h"
#include "episodes/realism.h"
#include "evaluation/run_recorded.h"
#include "llm/language_model.h"

namespace marketgen::evaluation {

// What all of a worker's episodes have in common.
struct WorkerTask {
  episodes::EpisodeHeader header;  // of their file
  episodes::Realism realism;
  Kept kept;  // beside results
  static constexpr auto fields =
      field_list(field("header", &WorkerTask::header, "of the episodes' file", required()),
                 field("realism", &WorkerTask::realism, "that they are run with", required()),
                 field("kept", &WorkerTask::kept, "what is kept of them beside results"));
};

// Returns when standard input ends. `model`: how that of the policy is reached, if it has one.
// Errors: those of read_json; io.cannot_write when nobody listens any more.
Result<void> serve_episodes(const std::filesystem::path& data,
                            const catalog::Catalog& catalog,
                            const std::string& policy,
                            const llm::ModelChoice& model = {});

}  // namespace marketgen::evaluation
