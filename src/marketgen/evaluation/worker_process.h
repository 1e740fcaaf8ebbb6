// A worker process (evaluation/episode_worker.h) as the one who started it has it.
//
// It ends with all that it started, and when the process does that started it, however that ends
// (io/process_group.h). Not thread-safe.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "episodes/episode_result.h"
#include "io/process_group.h"

namespace marketgen {

class WorkerProcess {
 public:
  // Tells it the `header` of the episodes' file, and waits until it is ready, at most `limit_s` of
  // wall time. Errors: usage.unavailable when it cannot be started; episode.no_policy when it ends
  // before it is ready (it has said why on standard error) or takes longer; internal.interrupted.
  static Result<std::unique_ptr<WorkerProcess>> start(const std::vector<std::string>& command,
                                                      const std::string& header,
                                                      double limit_s);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  // Runs an episode, given as a line of JSON. The policy may take `act_limit_s` of wall time over
  // each answer; 0 is no limit. Errors: what the worker reports, which lives on; and, the worker
  // having ended, episode.policy_hung, episode.policy_crashed, internal.interrupted.
  Result<EpisodeResult> run(const std::string& episode, double act_limit_s);
  bool alive() const { return group_.running(); }
  // Whether an error of run() is that of the policy.
  static bool is_policys(const Error& error);

 private:
  WorkerProcess(ProcessGroup group, int to, int from)
      : group_(std::move(group)), to_(to), from_(from) {}
  enum class Heard { line, nothing, end };
  // What they do until the worker has ended, we are interrupted or, unless it is 0, the limit.
  struct Wait {
    double limit_s = 0;
    Error too_long = {};
  };
  Result<void> tell(const std::string& line, const Wait& wait);
  Heard listen();
  Result<std::string> next_line(const Wait& wait);
  Error ended(bool by_itself = false);

  ProcessGroup group_;
  int to_ = -1, from_ = -1;
  std::string heard_;  // and not yet read
};

}  // namespace marketgen
