#include "evaluation/evaluate.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <thread>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "evaluation/worker_process.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen {
namespace {

constexpr char results_file[] = "results.jsonl";

std::string lines_of(const std::vector<EpisodeResult>& results) {
  std::string lines;
  for (const EpisodeResult& result : results)
    lines += write_json_line(result) + "\n";
  return lines;
}

Result<std::map<std::string, EpisodeResult>> begin_folder(const EpisodeFile& episodes,
                                                          const EvaluationOptions& options) {
  const std::filesystem::path file = options.folder / results_file;
  if (std::filesystem::exists(file) && !options.resume)
    return Error{"store.exists",
                 file.string(),
                 "there are results already: name another folder, or go on with --resume"};
  std::error_code failed;
  std::filesystem::create_directories(options.folder, failed);
  if (failed) return Error{"io.cannot_write", options.folder.string(), failed.message()};
  MARKETGEN_TRY(auto finished, finished_results(file));
  std::vector<EpisodeResult> kept;
  for (const auto& [id, result] : finished) {
    if (result.policy != options.policy)
      return Error{"usage.bad_flag",
                   "--policy",
                   fmt::format("{} has results of \"{}\": go on with that, or name another folder",
                               file.string(),
                               result.policy)};
    if (std::ranges::find(episodes.episodes, id, &EpisodeSpec::id) == episodes.episodes.end())
      return Error{"usage.bad_flag",
                   "--resume",
                   fmt::format("{} has a result of {}, which is not among these episodes: go on "
                               "with the file it is of, or name another folder",
                               file.string(),
                               id)};
    kept.push_back(result);
  }
  MARKETGEN_CHECK(write_file(file, lines_of(kept)));
  return finished;
}

}  // namespace

Result<std::map<std::string, EpisodeResult>> finished_results(const std::filesystem::path& file) {
  std::map<std::string, EpisodeResult> finished;
  if (!std::filesystem::exists(file)) return finished;
  MARKETGEN_TRY(const std::string text, read_file(file));
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  for (std::string line; std::getline(lines, line);) {
    MARKETGEN_TRY(EpisodeResult result, read_json<EpisodeResult>(line, file.string()));
    finished[result.episode] = std::move(result);
  }
  return finished;
}

namespace {

// Results as they come in, from any thread.
class ResultKeeper {
 public:
  ResultKeeper(const std::filesystem::path& file, std::size_t count)
      : file_(file), lines_(file, std::ios::app), results_(count) {}

  // `is_new`: not in the file yet.
  void keep(std::size_t number, Result<EpisodeResult> result, bool is_new) {
    const std::scoped_lock lock(mutex_);
    if (result.ok() && is_new) {
      lines_ << write_json_line(*result) << "\n" << std::flush;
      if (!lines_) result = Error{"io.cannot_write", file_.string(), "is the disk full?"};
    }
    results_[number] = std::move(result);
  }

  // In the order of the episodes; the first error instead.
  Result<std::vector<EpisodeResult>> all() {
    lines_.close();
    std::vector<EpisodeResult> ordered;
    for (auto& result : results_) {
      if (!result->ok()) return result->error();
      ordered.push_back(std::move(*result).value());
    }
    return ordered;
  }

 private:
  std::filesystem::path file_;
  std::mutex mutex_;
  std::ofstream lines_;
  std::vector<std::optional<Result<EpisodeResult>>> results_;
};

// In this process, rounding as every parallel loop does.
EpisodeRunner runner_here(Arena& arena, const std::string& policy) {
  return [&arena, &policy](std::size_t, const EpisodeSpec& spec) {
    std::optional<Result<EpisodeResult>> result;
    parallel_for(1, [&](std::size_t) { result = run_episode(arena, spec, policy); });
    return *std::move(result);
  };
}

// In a process that is started anew when it has died or had to be ended.
EpisodeRunner runner_in_worker(const EvaluationOptions& options) {
  const auto worker = std::make_shared<std::unique_ptr<WorkerProcess>>();
  return [worker, &options](std::size_t number, const EpisodeSpec& spec) -> Result<EpisodeResult> {
    const auto began = std::chrono::steady_clock::now();
    if (!*worker) {
      MARKETGEN_TRY(*worker, WorkerProcess::start(options.worker));
    }
    auto result = (*worker)->run(number, options.act_limit_s);
    if (result.ok() || (*worker)->alive()) return result;
    worker->reset();
    if (!WorkerProcess::is_policys(result.error())) return result;
    EpisodeEnd end{options.policy};
    end.broken = result.error();
    end.by_policy = true;
    end.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return with_end(unjudged(spec), end);
  };
}

}  // namespace

Result<std::vector<EpisodeResult>> evaluate_with(const EpisodeFile& file,
                                                 const EvaluationOptions& options,
                                                 const std::function<EpisodeRunner()>& make_runner,
                                                 Progress& progress) {
  MARKETGEN_TRY(const auto finished, begin_folder(file, options));
  const std::size_t count = file.episodes.size();
  ResultKeeper keeper(options.folder / results_file, count);
  progress.begin("episodes", count);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    const EpisodeRunner run = make_runner();
    for (std::size_t i = next++; i < count; i = next++) {
      const EpisodeSpec& spec = file.episodes[i];
      const auto before = finished.find(spec.id);
      const auto go_on = check_interrupt();
      if (before != finished.end())
        keeper.keep(i, before->second, false);
      else if (go_on.ok())
        keeper.keep(i, run(i, spec), true);
      else
        keeper.keep(i, go_on.error(), false);
      progress.advance();
    }
  };
  const int jobs = options.jobs > 0 ? options.jobs : thread_count();
  {
    std::vector<std::jthread> threads;
    for (std::size_t job = 0; job < std::min(count, static_cast<std::size_t>(jobs)); ++job)
      threads.emplace_back(work);
  }
  progress.end();
  MARKETGEN_TRY(std::vector<EpisodeResult> results, keeper.all());
  MARKETGEN_CHECK(write_file(options.folder / results_file, lines_of(results)));
  MARKETGEN_CHECK(write_file(options.folder / "summary.json", write_json(summarize(results))));
  return results;
}

Result<std::vector<EpisodeResult>> evaluate(const std::filesystem::path& data,
                                            const EpisodeFile& file,
                                            const Catalog& catalog,
                                            const EvaluationOptions& options,
                                            Progress& progress) {
  Arena arena(data, file.header, catalog);
  const auto make_runner = [&] {
    return options.worker.empty() ? runner_here(arena, options.policy) : runner_in_worker(options);
  };
  return evaluate_with(file, options, make_runner, progress);
}

}  // namespace marketgen
