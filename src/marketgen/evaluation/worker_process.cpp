#include "evaluation/worker_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "io/json.h"

namespace marketgen {
namespace {

constexpr int look_up_ms = 200;  // how often an interrupt is looked for
// How long one that has closed its output may take to end.
constexpr int grace_looks = 100, grace_look_us = 10'000;

struct WorkerPipe {
  std::array<int, 2> ends{-1, -1};
  bool open() { return pipe2(ends.data(), O_CLOEXEC) == 0; }
  void close_both() const {
    for (const int end : ends)
      if (end >= 0) close(end);
  }
};

// In the new process: only what is safe after a fork among threads.
[[noreturn]] void become(char* const* words, int in, int out, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it has ended already
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  execv(words[0], words);
  _exit(127);
}

// Writing to a worker that has ended must be an error, not a signal.
bool tell(int to, const std::string& line) {
  sigset_t pipe_signal, before;
  sigemptyset(&pipe_signal);
  sigaddset(&pipe_signal, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe_signal, &before);
  const bool told = write(to, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const timespec now{0, 0};
  if (!told) sigtimedwait(&pipe_signal, nullptr, &now);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return told;
}

Error error_told(const std::string& text) {
  const std::size_t first = text.find('\t'), second = text.find('\t', first + 1);
  if (first == std::string::npos || second == std::string::npos)
    return {"program.failed", "worker", text};
  return {
      text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1)};
}

}  // namespace

Result<std::unique_ptr<WorkerProcess>> WorkerProcess::start(
    const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command)
    words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  WorkerPipe in, out;
  if (!in.open() || !out.open()) {
    in.close_both();
    return Error{"usage.unavailable", command[0], std::strerror(errno)};
  }
  const pid_t parent = getpid(), pid = fork();
  if (pid == 0) become(words.data(), in.ends[0], out.ends[1], parent);
  close(in.ends[0]);
  close(out.ends[1]);
  std::unique_ptr<WorkerProcess> worker(new WorkerProcess(pid, in.ends[1], out.ends[0]));
  if (pid < 0) return Error{"usage.unavailable", command[0], std::strerror(errno)};
  auto ready = worker->next_line(false, 0);
  if (ready.ok() && *ready == "ready") return worker;
  if (!ready.ok() && ready.error().code == "internal.interrupted") return ready.error();
  return Error{"program.failed", command[0], "ended before it was ready to run episodes"};
}

WorkerProcess::~WorkerProcess() {
  if (to_ >= 0) close(to_);
  if (from_ >= 0) close(from_);
  if (pid_ > 0) ended();
}

// Ends it, unless it is about to end by itself, and says how it was found.
Error WorkerProcess::ended(bool by_itself) {
  int state = 0;
  for (int i = 0; by_itself && i < grace_looks; ++i) {
    siginfo_t none{};
    const bool over =
        waitid(P_PID, static_cast<id_t>(pid_), &none, WEXITED | WNOHANG | WNOWAIT) == 0;
    if (over && none.si_pid != 0) break;
    usleep(grace_look_us);
  }
  kill(pid_, SIGKILL);
  while (waitpid(pid_, &state, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  const bool exited = WIFEXITED(state);
  return {"episode.policy_crashed",
          "worker",
          fmt::format("ended with {} {}; its last words, if any, are on standard error",
                      exited ? "status" : "signal",
                      exited ? WEXITSTATUS(state) : WTERMSIG(state))};
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

Result<std::string> WorkerProcess::next_line(bool asked, double limit_s) {
  const auto since = std::chrono::steady_clock::now();
  while (true) {
    const Heard heard = listen();
    if (heard == Heard::line) break;
    if (heard == Heard::end) return ended(true);
    if (const auto go_on = check_interrupt(); !go_on.ok()) {
      ended();
      return go_on.error();
    }
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - since;
    if (!asked || limit_s <= 0 || waited.count() < limit_s) continue;
    ended();
    return Error{"episode.policy_hung",
                 "policy",
                 fmt::format("took longer than {} s over one answer (--act-limit-s)", limit_s)};
  }
  const std::size_t end = heard_.find('\n');
  std::string line = heard_.substr(0, end);
  heard_.erase(0, end + 1);
  return line;
}

Result<EpisodeResult> WorkerProcess::run(std::size_t episode, double act_limit_s) {
  constexpr std::string_view result = "result ", error = "error ";
  if (!tell(to_, fmt::format("{}\n", episode))) return ended(true);
  bool asked = false;
  while (true) {
    MARKETGEN_TRY(const std::string line, next_line(asked, act_limit_s));
    asked = line == "asked";
    if (line.starts_with(result))
      return read_json<EpisodeResult>(line.substr(result.size()), "worker");
    if (line.starts_with(error)) return error_told(line.substr(error.size()));
  }
}

bool WorkerProcess::is_policys(const Error& error) {
  return error.code == "episode.policy_hung" || error.code == "episode.policy_crashed";
}

}  // namespace marketgen
