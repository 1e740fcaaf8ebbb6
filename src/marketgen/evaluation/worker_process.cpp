#include "evaluation/worker_process.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "io/json.h"

namespace marketgen::evaluation {
namespace {

constexpr int look_up_ms = 200;  // how often an interrupt is looked for
constexpr double grace_s = 1;    // that one which has closed its output may take to end

// Writing to a worker that has ended must be an error, not a signal. -1 as write() does.
ssize_t write_quietly(int to, std::string_view text) {
  sigset_t pipe_signal, before;
  sigemptyset(&pipe_signal);
  sigaddset(&pipe_signal, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe_signal, &before);
  const ssize_t written = write(to, text.data(), text.size());
  const int fault = errno;
  const timespec now{0, 0};
  if (written < 0 && fault == EPIPE) sigtimedwait(&pipe_signal, nullptr, &now);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = fault;
  return written;
}

Error error_told(const std::string& text) {
  const std::size_t first = text.find('\t'), second = text.find('\t', first + 1);
  if (first == std::string::npos || second == std::string::npos)
    return {"program.failed", "worker", text};
  return {
      text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1)};
}

Error too_slow(double limit_s) {
  return {"episode.policy_slow",
          "policy",
          fmt::format("computed for more than {} s over one answer (--act-limit-s)", limit_s)};
}

Error too_long(double limit_s) {
  return {"episode.policy_hung",
          "policy",
          fmt::format("gave no answer within {} s of wall time (--hang-limit-s)", limit_s)};
}

Error not_ready(const std::string& program, double limit_s, std::string_view of_what) {
  return {"episode.no_policy",
          program,
          fmt::format("was not ready to run episodes after {} s of {}", limit_s, of_what)};
}

constexpr std::string_view answered = "answered ";

// How much processor time an answer took, as the worker tells.
std::optional<double> told_cpu_s(std::string_view line) {
  line.remove_prefix(answered.size());
  double cpu_s = 0;
  const auto read = std::from_chars(line.data(), line.data() + line.size(), cpu_s);
  if (read.ec != std::errc{} || read.ptr != line.data() + line.size()) return std::nullopt;
  return cpu_s;
}

}  // namespace

// Looks again and again whether it has to end.
class WorkerProcess::Waiting {
 public:
  Waiting(const Wait& wait, const io::ProcessGroup& group)
      : wait_(wait), group_(group), cpu_before_s_(wait.cpu_limit_s > 0 ? group.cpu_s() : 0) {}

  std::optional<Error> over() const {
    if (const auto go_on = check_interrupt(); !go_on.ok()) return go_on.error();
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - since_;
    if (wait_.limit_s > 0 && waited.count() >= wait_.limit_s) return wait_.too_long;
    if (wait_.cpu_limit_s > 0 && group_.cpu_s() - cpu_before_s_ >= wait_.cpu_limit_s)
      return wait_.too_much;
    return std::nullopt;
  }

 private:
  const Wait& wait_;
  const io::ProcessGroup& group_;
  double cpu_before_s_;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

Result<std::unique_ptr<WorkerProcess>> WorkerProcess::start(const std::vector<std::string>& command,
                                                            const std::string& task,
                                                            const AnswerLimits& limits) {
  io::Pipe in, out;
  if (!in.open() || !out.open())
    return Error{"usage.unavailable", command[0], std::strerror(errno)};
  MARKETGEN_TRY(io::ProcessGroup group,
                io::ProcessGroup::start(command, {in.read_end(), out.write_end(), -1}));
  std::unique_ptr<WorkerProcess> worker(
      new WorkerProcess(std::move(group), in.take_end(1), out.take_end(0)));
  fcntl(worker->to_, F_SETFL, O_NONBLOCK);
  in.close_end(0);
  out.close_end(1);
  const Wait until_ready{limits.hang_s,
                         not_ready(command[0], limits.hang_s, "wall time (hang_limit_s)"),
                         limits.cpu_s,
                         not_ready(command[0], limits.cpu_s, "processor time (start_limit_s)")};
  const auto unready = [&](const Error& error) {
    if (error.code != "episode.policy_crashed") return error;
    return Error{"episode.no_policy", command[0], "ended before it was ready to run episodes"};
  };
  if (const auto told = worker->tell(task, until_ready); !told.ok()) return unready(told.error());
  const auto ready = worker->next_line(until_ready);
  if (!ready.ok()) return unready(ready.error());
  if (*ready == "ready") return worker;
  return Error{"episode.no_policy", command[0], "is no worker: it says \"" + *ready + "\""};
}

WorkerProcess::~WorkerProcess() {
  if (to_ >= 0) close(to_);
  if (from_ >= 0) close(from_);
}

// Ends it, unless it is about to end by itself, and says how it was found.
Error WorkerProcess::ended(bool by_itself) {
  const int state = by_itself ? group_.wait(grace_s) : group_.end();
  return {"episode.policy_crashed",
          "worker",
          fmt::format("ended with {}; its last words, if any, are on standard error",
                      io::end_of_program(state))};
}

Result<void> WorkerProcess::tell(const std::string& line, const Wait& wait) {
  const std::string text = line + "\n";
  std::string_view left = text;
  const Waiting waiting(wait, group_);
  while (!left.empty()) {
    const ssize_t written = write_quietly(to_, left);
    if (written > 0) {
      left.remove_prefix(static_cast<std::size_t>(written));
      continue;
    }
    if (errno != EAGAIN && errno != EINTR) return ended(true);
    pollfd end{to_, POLLOUT, 0};
    poll(&end, 1, look_up_ms);
    if (auto over = waiting.over()) {
      ended();
      return *std::move(over);
    }
  }
  return {};
}

WorkerProcess::Heard WorkerProcess::listen() {
  if (heard_.find('\n') != std::string::npos) return Heard::line;
  pollfd end{from_, POLLIN, 0};
  if (poll(&end, 1, look_up_ms) <= 0) return Heard::nothing;
  char block[4096];
  const ssize_t got = read(from_, block, sizeof block);
  if (got == 0 || (got < 0 && errno != EINTR)) return Heard::end;
  if (got > 0) heard_.append(block, static_cast<std::size_t>(got));
  return heard_.find('\n') != std::string::npos ? Heard::line : Heard::nothing;
}

Result<std::string> WorkerProcess::next_line(const Wait& wait) {
  const Waiting waiting(wait, group_);
  while (true) {
    const Heard heard = listen();
    if (heard == Heard::line) break;
    if (heard == Heard::end) return ended(true);
    if (auto over = waiting.over()) {
      ended();
      return *std::move(over);
    }
  }
  const std::size_t end = heard_.find('\n');
  std::string line = heard_.substr(0, end);
  heard_.erase(0, end + 1);
  return line;
}

// The error of an answer that has come, if it took too much.
std::optional<Error> WorkerProcess::late(const std::string& line, const AnswerLimits& limits) {
  const auto cpu_s = told_cpu_s(line);
  if (cpu_s && (limits.cpu_s <= 0 || *cpu_s < limits.cpu_s)) return std::nullopt;
  ended();
  if (cpu_s) return too_slow(limits.cpu_s);
  return Error{"program.failed", "worker", fmt::format("it says \"{}\"", line)};
}

Result<episodes::EpisodeResult> WorkerProcess::run(const std::string& episode,
                                                   const AnswerLimits& limits) {
  constexpr std::string_view result = "result ", error = "error ";
  const Wait for_ever,
      for_an_answer{limits.hang_s, too_long(limits.hang_s), limits.cpu_s, too_slow(limits.cpu_s)};
  MARKETGEN_CHECK(tell(episode, for_ever));
  bool asked = false;
  while (true) {
    MARKETGEN_TRY(const std::string line, next_line(asked ? for_an_answer : for_ever));
    // Here too: next_line() looks only where it has to wait, and some are never silent.
    if (const auto go_on = check_interrupt(); !go_on.ok()) {
      ended();
      return go_on.error();
    }
    asked = line == "asked";
    if (line.starts_with(answered)) {
      if (auto fault = late(line, limits)) return *std::move(fault);
    }
    if (line.starts_with(result))
      return io::read_json<episodes::EpisodeResult>(line.substr(result.size()), "worker");
    if (line.starts_with(error)) return error_told(line.substr(error.size()));
  }
}

bool WorkerProcess::is_policys(const Error& error) {
  return error.code == "episode.policy_slow" || error.code == "episode.policy_hung" ||
         error.code == "episode.policy_crashed";
}

}  // namespace marketgen::evaluation
