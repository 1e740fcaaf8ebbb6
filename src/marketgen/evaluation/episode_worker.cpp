#include "evaluation/episode_worker.h"

#include <unistd.h>

#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "base/parallel.h"
#include "evaluation/run_episode.h"
#include "io/json.h"

namespace marketgen {
namespace {

// The standard output, which from now on nobody else has.
class Report : public EpisodeWatcher {
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

  Result<void> begin(const TrackWorld&) override { return {}; }
  Result<void> step() override { return {}; }
  void asks() override { say("asked"); }
  void answered() override { say("answered"); }

 private:
  std::FILE* out_;
  bool broken_ = false;
};

std::optional<std::size_t> next_number() {
  unsigned long long number = 0;
  return std::scanf("%llu", &number) == 1 ? std::optional<std::size_t>(number) : std::nullopt;
}

}  // namespace

Result<void> serve_episodes(const std::filesystem::path& data,
                            const EpisodeFile& file,
                            const Catalog& catalog,
                            const std::string& policy) {
  Report report;
  Arena arena(data, file.header, catalog);
  report.say("ready");
  while (const auto number = next_number()) {
    if (*number >= file.episodes.size())
      return Error{"usage.bad_flag", "worker", fmt::format("there is no episode {}", *number)};
    std::optional<Result<EpisodeResult>> result;
    parallel_for(1, [&](std::size_t) {
      result = run_episode(arena, file.episodes[*number], policy, &report);
    });
    if (result->ok()) {
      report.say("result " + write_json_line(**result));
    } else {
      const Error& error = result->error();
      report.say(fmt::format("error {}\t{}\t{}", error.code, error.where, error.message));
    }
    if (report.broken()) return Error{"io.cannot_write", "standard output", "nobody listens"};
  }
  return {};
}

}  // namespace marketgen
