#include "io/program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

#include "base/fields.h"
#include "base/interrupt.h"
#include "io/installation.h"
#include "io/json.h"
#include "io/process_group.h"

namespace marketgen::io {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

std::string running_python;  // of use_python()

constexpr int look_up_ms = 200;                 // how often an interrupt is looked for
constexpr std::size_t kept_error_bytes = 4096;  // of standard error: its end says what went wrong

// Writing to a program that has ended must be an error, not a signal.
class NoPipeSignal {
 public:
  NoPipeSignal() : before_(signal(SIGPIPE, SIG_IGN)) {}
  ~NoPipeSignal() { signal(SIGPIPE, before_); }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  void (*before_)(int);
};

// Moves bytes to and from the program until it closes its output. Errors: program.failed with the
// limit that it broke; internal.interrupted.
class Conversation {
 public:
  Conversation(const std::string& program,
               Pipe& in,
               Pipe& out,
               Pipe& err,
               std::string_view input,
               const ProgramLimits& limits)
      : program_(program), in_(in), out_(out), err_(err), input_(input), limits_(limits) {
    fcntl(in_.write_end(), F_SETFL, O_NONBLOCK);
  }

  Result<void> run() {
    const auto until = Clock::now() + std::chrono::duration<double>(limits_.seconds);
    bool out_open = true, err_open = true;
    while (out_open || err_open) {
      if (input_.empty()) in_.close_end(1);
      std::array<pollfd, 3> ends{pollfd{in_.write_end(), POLLOUT, 0},
                                 pollfd{out_open ? out_.read_end() : -1, POLLIN, 0},
                                 pollfd{err_open ? err_.read_end() : -1, POLLIN, 0}};
      const double left = std::chrono::duration<double>(until - Clock::now()).count();
      if (left <= 0) return broken(fmt::format("took longer than {:.0f} s", limits_.seconds));
      MARKETGEN_CHECK(check_interrupt());  // its group does not hear Ctrl-C
      const int pause_ms = std::min(look_up_ms, static_cast<int>(1000 * left) + 1);
      if (poll(ends.data(), ends.size(), pause_ms) < 0 && errno != EINTR)
        return broken(std::string("cannot be listened to: ") + std::strerror(errno));
      if (ends[0].revents != 0) feed();
      if (ends[1].revents != 0) out_open = take(out_.read_end(), output);
      if (ends[2].revents != 0) err_open = take(err_.read_end(), complaints);
      if (output.size() > limits_.output_bytes) return broken("wrote more than was expected");
      if (complaints.size() > 2 * kept_error_bytes)
        complaints.erase(0, complaints.size() - kept_error_bytes);
    }
    return {};
  }

  std::string output, complaints;

 private:
  Error broken(std::string limit) const { return {"program.failed", program_, std::move(limit)}; }

  void feed() {
    const ssize_t written = write(in_.write_end(), input_.data(), input_.size());
    if (written > 0)
      input_.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EAGAIN && errno != EINTR)
      input_ = {};  // it no longer listens; its status will say why
  }

  static bool take(int end, std::string& text) {
    char block[1 << 16];
    const ssize_t got = read(end, block, sizeof block);
    if (got > 0) text.append(block, static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && errno == EINTR);
  }

  const std::string& program_;
  Pipe &in_, &out_, &err_;
  std::string_view input_;
  const ProgramLimits& limits_;
};

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\n\r ");
  if (end == std::string::npos) return "it says nothing";
  const std::size_t start = text.find_last_of('\n', end);
  return text.substr(start == std::string::npos ? 0 : start + 1, end - start);
}

struct WorkerParts {
  std::string coacd, av, usd_core;
  static constexpr auto fields =
      field_list(field("coacd", &WorkerParts::coacd, "version"),
                 field("av", &WorkerParts::av, "version of PyAV, for films"),
                 field("usd-core", &WorkerParts::usd_core, "version of OpenUSD, reads exports"));

  const std::string& of(std::string_view package) const {
    if (package == "av") return av;
    return package == "usd-core" ? usd_core : coacd;
  }
};

}  // namespace

Result<std::string> run_program(const std::vector<std::string>& command,
                                std::string_view input,
                                const ProgramLimits& limits) {
  Pipe in, out, err;
  if (!in.open() || !out.open() || !err.open())
    return Error{"usage.unavailable", command[0], std::strerror(errno)};
  const NoPipeSignal quiet;
  MARKETGEN_TRY(ProcessGroup group,
                ProcessGroup::start(command, {in.read_end(), out.write_end(), err.write_end()}));
  in.close_end(0);
  out.close_end(1);
  err.close_end(1);
  Conversation talk(command[0], in, out, err, input, limits);
  MARKETGEN_CHECK(talk.run());
  const int state = group.wait(limits.seconds);
  if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return std::move(talk.output);
  return Error{"program.failed",
               command[0],
               fmt::format("ended with {}: {}", end_of_program(state), last_line(talk.complaints))};
}

std::string worker_python() {
  if (const char* named = std::getenv("MARKETGEN_PYTHON"); named != nullptr && *named != '\0')
    return named;
  if (!running_python.empty()) return running_python;
  for (const fs::path& packages : site_packages()) {
    if (const fs::path python = python_of(packages); !python.empty()) return python.string();
  }
  return "python3";
}

void use_python(const std::string& interpreter) {
  running_python = interpreter;
}

Result<fs::path> worker_script() {
  std::error_code failed;
  const char* script = "python/marketgen/worker.py";
  for (const fs::path& place : share_folders()) {
    if (fs::exists(place / script, failed)) return place / script;
  }
  return Error{
      "usage.unavailable", script, "is not there; restore it or install the program again"};
}

Result<std::string> run_worker(const std::string& job, std::string_view request, double seconds) {
  MARKETGEN_TRY(const fs::path script, worker_script());
  // Threads of libraries that wait must not keep others from working.
  return run_program({"env",
                      "OMP_WAIT_POLICY=passive",
                      "PYTHONSAFEPATH=1",  // what lies beside the script is not for it
                      "PYTHONDONTWRITEBYTECODE=1",
                      worker_python(),
                      script.string(),
                      job},
                     request,
                     {.seconds = seconds});
}

Result<std::string> worker_part(const std::string& package) {
  MARKETGEN_TRY(const std::string answer, run_worker("parts", "", 20));
  MARKETGEN_TRY(const WorkerParts parts, read_json<WorkerParts>(answer, "worker"));
  const std::string& version = parts.of(package);
  if (!version.empty()) return version;
  return Error{"usage.unavailable",
               package,
               "is not installed; run: " + worker_python() + " -m pip install " + package};
}

}  // namespace marketgen::io
