// Many episodes, several at a time, kept as they finish: a run that was broken off goes on where it
// was.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "episodes/realism.h"
#include "evaluation/evaluation_summary.h"
#include "evaluation/results_folder.h"
#include "evaluation/worker_process.h"
#include "llm/language_model.h"

namespace marketgen::evaluation {

struct EvaluationOptions {
  std::string policy = "oracle";
  std::filesystem::path folder;  // evaluation/results_folder.h
  bool resume = false;           // keeps what an earlier run has finished there
  int jobs = 0;                  // episodes at a time; 0 = as many as threads may work
  // A command whose process serves episodes (evaluation/episode_worker.h); one runs for each job.
  // Empty: episodes are run in this process, and a policy that hangs hangs all.
  std::vector<std::string> worker = {};
  AnswerLimits answer = {};  // of a policy in a worker
  // Of processor time until a worker is ready; 0 = none. `answer.hang_s` holds here, too.
  double start_limit_s = 120;
  Shard shard = {};    // which of the episodes are run
  int repetition = 1;  // with which draws (episodes::repetition_of)
  episodes::Realism realism = {};
  llm::ModelChoice model = {};  // how that of the policy is reached, if it has one
  bool record_motion = false;   // motion/ID.bin.gz of each episode that is run (motion_recorder.h)
  // decisions/ID.json.gz and .html of each that is run (decision_record.h)
  bool record_decisions = false;
};

// Each finished episode is a line of results.jsonl at once; at the end the lines are in the order
// of the episodes. The same for any number of jobs, in this process or in workers, wall times
// apart. An answer beyond its limits, or a worker that dies, ends its episode with PolicyError:
// nothing of it is judged. An episode that cannot be run is a result too (EpisodeResult::error).
//
// What would befall every episode ends the run: an interrupt, a policy that does not start, a full
// disk. What was finished by then is kept and summed up. Errors, which say how much that is:
// internal.interrupted, episode.no_policy, usage.*, io.*; those of ResultsFolder::open, and before
// all else those of Arena::model.
Result<std::vector<episodes::EpisodeResult>> evaluate(const std::filesystem::path& data,
                                                      const episodes::EpisodeFile& file,
                                                      const catalog::Catalog& catalog,
                                                      const EvaluationOptions& options,
                                                      Progress& progress);

using EpisodeRunner =
    std::function<Result<episodes::EpisodeResult>(const episodes::EpisodeSpec& spec)>;

// The same with runners of one's own: `make_runner` is called once in each of the threads that run
// episodes, and its runner is used and destroyed there. `options.worker` is not read, and of
// `options.realism` the name alone, which results are kept under.
Result<std::vector<episodes::EpisodeResult>> evaluate_with(
    const episodes::EpisodeFile& file,
    const EvaluationOptions& options,
    const std::function<EpisodeRunner()>& make_runner,
    Progress& progress);

}  // namespace marketgen::evaluation
