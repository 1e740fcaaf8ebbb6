// A worker process (evaluation/episode_worker.h) as the one who started it has it.
//
// It ends with the thread that started it, however that ends. Not thread-safe.
#pragma once
#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "episodes/episode_result.h"

namespace marketgen {

class WorkerProcess {
 public:
  // `command[0]` is a path. Errors: usage.unavailable when it cannot be started, program.failed
  // when it ends before it is ready; it has said why on standard error.
  static Result<std::unique_ptr<WorkerProcess>> start(const std::vector<std::string>& command);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  // Runs an episode of the file. The policy may take `act_limit_s` of wall time over each answer; 0
  // is no limit. Errors: what the worker reports, which lives on; and, the worker having ended,
  // episode.policy_hung, episode.policy_crashed, internal.interrupted.
  Result<EpisodeResult> run(std::size_t episode, double act_limit_s);
  bool alive() const { return pid_ > 0; }
  // Whether an error of run() is that of the policy.
  static bool is_policys(const Error& error);

 private:
  WorkerProcess(pid_t pid, int to, int from) : pid_(pid), to_(to), from_(from) {}
  enum class Heard { line, nothing, end };
  Heard listen();
  Result<std::string> next_line(bool asked, double limit_s);
  Error ended(bool by_itself = false);

  pid_t pid_ = -1;
  int to_ = -1, from_ = -1;
  std::string heard_;  // and not yet read
};

}  // namespace marketgen
