#include "io/process_group.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace marketgen::io {
namespace {

constexpr int look_pause_us = 1000;

// Waits for the end of our lifeline, then ends its own group. A shell, because what runs between
// fork and exec in a process with threads may do next to nothing.
constexpr std::array sentinel_command{"/bin/sh", "-c", "read -r _; kill -KILL 0"};

// What a new process is told before it begins.
class SpawnPlan {
 public:
  // `group`: which it joins; 0: one of its own.
  explicit SpawnPlan(pid_t group) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    sigset_t defaults, none;
    sigemptyset(&none);
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);  // we may ignore it; a program expects it
    posix_spawnattr_setsigdefault(&attributes_, &defaults);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setpgroup(&attributes_, group);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  void connect(int end, int standard) {
    if (end >= 0) posix_spawn_file_actions_adddup2(&actions_, end, standard);
  }
  void silence(int standard) {
    posix_spawn_file_actions_addopen(&actions_, standard, "/dev/null", O_WRONLY, 0);
  }

  Result<pid_t> start(char* const* words, char* const* environment = environ) const {
    pid_t pid = -1;
    const int fault = posix_spawnp(&pid, words[0], &actions_, &attributes_, words, environment);
    if (fault == 0) return pid;
    return Error{
        "usage.unavailable", words[0], fmt::format("cannot be started: {}", std::strerror(fault))};
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

Result<pid_t> start_sentinel(const Pipe& lifeline) {
  std::vector<char*> words;
  for (const char* word : sentinel_command)
    words.push_back(const_cast<char*>(word));
  words.push_back(nullptr);
  SpawnPlan plan(0);
  plan.connect(lifeline.read_end(), STDIN_FILENO);
  plan.silence(STDOUT_FILENO);
  plan.silence(STDERR_FILENO);
  return plan.start(words.data());
}

// A variable that no other group has; a name of its own, so that groups within groups carry all.
std::string mark_of(pid_t sentinel) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  return fmt::format("MARKETGEN_GROUP_{}_{}_{}=1", getpid(), sentinel, now);
}

// Ours, and the mark. Points into both.
std::vector<char*> marked_environment(const std::string& mark) {
  std::vector<char*> variables;
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable)
    variables.push_back(*variable);
  variables.push_back(const_cast<char*>(mark.c_str()));
  variables.push_back(nullptr);
  return variables;
}

// The processes that inherited the mark, whichever group and parent they have now. One that has
// ended has no environment.
std::vector<pid_t> bearers_of(const std::string& mark) {
  std::vector<pid_t> bearers;
  std::error_code failed;
  for (std::filesystem::directory_iterator entry("/proc", failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    pid_t pid = 0;
    std::from_chars(name.data(), name.data() + name.size(), pid);
    if (pid <= 0) continue;
    std::ifstream file(entry->path() / "environ", std::ios::binary);
    const std::string variables(std::istreambuf_iterator<char>(file), {});
    if (variables.find(mark) != std::string::npos) bearers.push_back(pid);
  }
  return bearers;
}

// Again and again: one may have started another while we looked.
void end_bearers_of(const std::string& mark) {
  constexpr int max_looks = 200;
  for (int look = 0; look < max_looks; ++look) {
    const std::vector<pid_t> bearers = bearers_of(mark);
    if (bearers.empty()) return;
    for (const pid_t bearer : bearers)
      kill(bearer, SIGKILL);
    usleep(look_pause_us);
  }
}

int state_of(pid_t pid) {
  int state = 0;
  while (waitpid(pid, &state, 0) < 0 && errno == EINTR) {
  }
  return state;
}

}  // namespace

Pipe::Pipe() : open_(pipe2(ends_.data(), O_CLOEXEC) == 0) {}

Pipe::~Pipe() {
  close_end(0);
  close_end(1);
}

void Pipe::close_end(std::size_t end) {
  if (ends_[end] >= 0) close(take_end(end));
}

int Pipe::take_end(std::size_t end) {
  return std::exchange(ends_[end], -1);
}

Result<ProcessGroup> ProcessGroup::start(const std::vector<std::string>& command,
                                         const std::array<int, 3>& ends) {
  Pipe lifeline;
  if (!lifeline.open()) return Error{"usage.unavailable", command[0], std::strerror(errno)};
  MARKETGEN_TRY(const pid_t sentinel, start_sentinel(lifeline));
  ProcessGroup group(sentinel, lifeline.take_end(1));
  std::vector<char*> words;
  for (const std::string& word : command)
    words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  SpawnPlan plan(sentinel);
  for (std::size_t standard = 0; standard < ends.size(); ++standard)
    plan.connect(ends[standard], static_cast<int>(standard));
  group.mark_ = mark_of(sentinel);
  MARKETGEN_TRY(group.program_, plan.start(words.data(), marked_environment(group.mark_).data()));
  return group;
}

ProcessGroup::ProcessGroup(ProcessGroup&& other) noexcept
    : sentinel_(std::exchange(other.sentinel_, -1)),
      program_(std::exchange(other.program_, -1)),
      lifeline_(std::exchange(other.lifeline_, -1)),
      state_(other.state_),
      mark_(std::move(other.mark_)) {}

ProcessGroup::~ProcessGroup() {
  end();
}

bool ProcessGroup::is_over() const {
  siginfo_t found{};
  return program_ < 0 ||
         (waitid(P_PID, static_cast<id_t>(program_), &found, WEXITED | WNOHANG | WNOWAIT) == 0 &&
          found.si_pid != 0);
}

// proc(5): after the name, which may hold anything but ends with the last ")", the 12th to 15th
// words are utime, stime, cutime and cstime.
double ProcessGroup::cpu_s() const {
  if (program_ < 0) return 0;
  std::ifstream file(fmt::format("/proc/{}/stat", program_), std::ios::binary);
  const std::string stat(std::istreambuf_iterator<char>(file), {});
  std::istringstream words(stat.substr(stat.rfind(')') + 1));
  std::string word;
  for (int i = 0; i < 11; ++i)
    words >> word;
  double ticks = 0, part = 0;
  for (int i = 0; i < 4 && words >> part; ++i)
    ticks += part;
  return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

int ProcessGroup::end() {
  // While the sentinel is not waited for, its number is that of no other group.
  if (sentinel_ > 0) kill(-sentinel_, SIGKILL);
  if (program_ > 0) {
    kill(program_, SIGKILL);  // it may have left the group
    end_bearers_of(mark_);
  }
  if (program_ > 0) state_ = state_of(std::exchange(program_, -1));
  if (sentinel_ > 0) state_of(std::exchange(sentinel_, -1));
  if (lifeline_ >= 0) close(std::exchange(lifeline_, -1));
  return state_;
}

int ProcessGroup::wait(double limit_s) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_s);
  while (!is_over() && std::chrono::steady_clock::now() < until)
    usleep(look_pause_us);
  return end();
}

std::string end_of_program(int state) {
  const bool exited = WIFEXITED(state);
  return fmt::format(
      "{} {}", exited ? "status" : "signal", exited ? WEXITSTATUS(state) : WTERMSIG(state));
}

}  // namespace marketgen::io
