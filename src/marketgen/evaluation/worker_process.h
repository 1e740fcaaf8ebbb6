// A worker process (evaluation/episode_worker.h) as the one who started it has it.
//
// It ends with all that it started, and when the process does that started it, however that ends
// (io/process_group.h). Not thread-safe.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "episodes/episode_result.h"
#include "io/process_group.h"

namespace marketgen::evaluation {

// For one answer of a policy, or until a worker is ready; 0: none.
struct AnswerLimits {
  // Of processor time, on all threads of the worker: the same on a busy machine as on a quiet one.
  double cpu_s = 0;
  // Of wall time. Only against a policy that waits for what never comes, and so uses no processor
  // time; it is to be far more than the other, whatever else the machine does.
  double hang_s = 0;
};

class WorkerProcess {
 public:
  // Tells it its `task`, a line of JSON, and waits until it is ready, within `limits`. Errors:
  // usage.unavailable when it cannot be started; episode.no_policy when it ends before it is ready
  // (it has said why on standard error) or takes more; internal.interrupted.
  static Result<std::unique_ptr<WorkerProcess>> start(const std::vector<std::string>& command,
                                                      const std::string& task,
                                                      const AnswerLimits& limits);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  // Runs an episode, given as a line of JSON. An answer that came and took too much is too late,
  // too: what counts is how much it took, not when that was looked at. Errors: what the worker
  // reports, which lives on; and, the worker having ended, episode.policy_slow,
  // episode.policy_hung, episode.policy_crashed, program.failed, internal.interrupted.
  Result<episodes::EpisodeResult> run(const std::string& episode, const AnswerLimits& limits);
  bool alive() const { return group_.running(); }
  // Whether an error of run() is that of the policy.
  static bool is_policys(const Error& error);

 private:
  WorkerProcess(io::ProcessGroup group, int to, int from)
      : group_(std::move(group)), to_(to), from_(from) {}
  enum class Heard { line, nothing, end };
  // Until the worker has ended, we are interrupted or one of the limits is over that are not 0.
  struct Wait {
    double limit_s = 0;  // of wall time
    Error too_long = {};
    double cpu_limit_s = 0;  // of the worker's processor time
    Error too_much = {};
  };
  class Waiting;
  Result<void> tell(const std::string& line, const Wait& wait);
  Heard listen();
  Result<std::string> next_line(const Wait& wait);
  Error ended(bool by_itself = false);
  std::optional<Error> late(const std::string& line, const AnswerLimits& limits);

  io::ProcessGroup group_;
  int to_ = -1, from_ = -1;
  std::string heard_;  // and not yet read
};

}  // namespace marketgen::evaluation
