#include "evaluation/episode_worker.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/parallel.h"
#include "episodes/episode_spec.h"
#include "io/json.h"

namespace marketgen::evaluation {
namespace {

// Seconds of processor time of this process, all its threads, and of children that it waited for.
double cpu_s() {
  double seconds = 0;
  for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(whose, &usage);
    for (const timeval& part : {usage.ru_utime, usage.ru_stime})
      seconds += static_cast<double>(part.tv_sec) + static_cast<double>(part.tv_usec) * 1e-6;
  }
  return seconds;
}

// The standard output, which from now on nobody else has.
class Report : public environments::EpisodeWatcher {
 public:
  Report() : out_(fdopen(dup(STDOUT_FILENO), "w")) {
    std::fflush(stdout);
    dup2(STDERR_FILENO, STDOUT_FILENO);
  }
  ~Report() override {
    if (out_ != nullptr) std::fclose(out_);
  }
  Report(const Report&) = delete;
  Report& operator=(const Report&) = delete;

  void say(const std::string& line) {
    broken_ = broken_ || out_ == nullptr || std::fputs((line + "\n").c_str(), out_) < 0 ||
              std::fflush(out_) != 0;
  }
  bool broken() const { return broken_; }

  Result<void> begin(const episodes::TrackWorld&) override { return {}; }
  Result<void> step() override { return {}; }
  void asks() override {
    cpu_before_s_ = cpu_s();
    say("asked");
  }
  void answered() override { say(fmt::format("answered {:.6f}", cpu_s() - cpu_before_s_)); }

 private:
  double cpu_before_s_ = 0;
  std::FILE* out_;
  bool broken_ = false;
};

// Nothing at the end of standard input.
std::optional<std::string> next_line() {
  std::string line;
  return std::getline(std::cin, line) ? std::optional(std::move(line)) : std::nullopt;
}

constexpr char told[] = "standard input";

}  // namespace

Result<void> serve_episodes(const std::filesystem::path& data,
                            const catalog::Catalog& catalog,
                            const std::string& policy,
                            const llm::ModelChoice& model) {
  Report report;
  MARKETGEN_TRY(const WorkerTask task, io::read_json<WorkerTask>(next_line().value_or(""), told));
  environments::Arena arena(data, task.header, catalog);
  arena.reach_models(model);
  report.say("ready");
  while (const auto line = next_line()) {
    MARKETGEN_TRY(const episodes::EpisodeSpec spec,
                  io::read_json<episodes::EpisodeSpec>(*line, told));
    std::optional<Result<episodes::EpisodeResult>> result;
    parallel_for(1, [&](std::size_t) {
      result = run_recorded(arena, spec, policy, task.realism, task.kept, &report);
    });
    if (result->ok()) {
      report.say("result " + io::write_json_line(**result));
    } else {
      const Error& error = result->error();
      report.say(fmt::format("error {}\t{}\t{}", error.code, error.where, error.message));
    }
    if (report.broken()) return Error{"io.cannot_write", "standard output", "nobody listens"};
  }
  return {};
}

}  // namespace marketgen::evaluation
