#include "evaluation/evaluate.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "base/call_interrupt.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "environments/policy_name.h"
#include "episodes/episode_origin.h"
#include "evaluation/episode_worker.h"
#include "evaluation/run_recorded.h"
#include "io/json.h"

namespace marketgen::evaluation {
namespace {

episodes::EpisodeResult not_run(const episodes::EpisodeSpec& spec,
                                const std::string& policy,
                                const Error& error) {
  episodes::EpisodeResult result = episodes::unjudged(spec);
  result.policy = policy;
  result.failure = episodes::FailureCode::not_run;
  result.error = error.code;
  result.detail = to_string(error);
  return result;
}

// Whole paths, for workers. Of a folder that has been opened: a path from a working folder that is
// gone has none.
Kept kept_of(const EvaluationOptions& options) {
  const std::string folder = std::filesystem::absolute(options.folder).string();
  return {options.record_motion ? folder : "", options.record_decisions ? folder : ""};
}

// In this process, rounding as every parallel loop does.
EpisodeRunner runner_here(environments::Arena& arena, const EvaluationOptions& options, Kept kept) {
  return [&arena, &options, kept = std::move(kept)](const episodes::EpisodeSpec& spec) {
    std::optional<Result<episodes::EpisodeResult>> result;
    return until_interrupted([&]() -> Result<episodes::EpisodeResult> {
      parallel_for(1, [&](std::size_t) {
        result = run_recorded(arena, spec, options.policy, options.realism, kept);
      });
      return *std::move(result);
    });
  };
}

// In a process that is started anew when it has died or had to be ended.
EpisodeRunner runner_in_worker(const EvaluationOptions& options, std::string work) {
  const auto worker = std::make_shared<std::unique_ptr<WorkerProcess>>();
  return [worker, &options, work = std::move(work)](
             const episodes::EpisodeSpec& spec) -> Result<episodes::EpisodeResult> {
    const auto began = std::chrono::steady_clock::now();
    if (!*worker) {
      const AnswerLimits until_ready{options.start_limit_s, options.answer.hang_s};
      MARKETGEN_TRY(*worker, WorkerProcess::start(options.worker, work, until_ready));
    }
    auto result = (*worker)->run(io::write_json_line(spec), options.answer);
    if (result.ok() || (*worker)->alive()) return result;
    worker->reset();
    if (!WorkerProcess::is_policys(result.error())) return result;
    episodes::EpisodeEnd end{options.policy};
    end.broken = result.error();
    end.by_policy = true;
    end.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return episodes::with_end(episodes::unjudged(spec), end);
  };
}

// The threads of one run.
class EvaluationRun {
 public:
  EvaluationRun(const episodes::EpisodeFile& file,
                const EvaluationOptions& options,
                ResultsFolder& folder,
                Progress& progress)
      : file_(file), options_(options), folder_(folder), progress_(progress) {}

  void go(const std::function<EpisodeRunner()>& make_runner) {
    const std::size_t count = file_.episodes.size();
    progress_.begin("episodes", count);
    const int jobs = options_.jobs > 0 ? options_.jobs : thread_count();
    {
      std::vector<std::jthread> threads;
      for (std::size_t job = 0; job < std::min(count, static_cast<std::size_t>(jobs)); ++job)
        threads.emplace_back([&, interrupt = CallInterrupt::of_this_thread()] {
          const CallInterrupt same_call(interrupt);
          work(make_runner());
        });
    }
    progress_.end();
  }

  const std::optional<Error>& fault() const { return fault_; }  // that ended it

 private:
  void work(const EpisodeRunner& run) {
    for (std::size_t i = next_++; i < file_.episodes.size() && !over_; i = next_++) {
      if (folder_.is_asked_for(i) && !folder_.has(i)) {
        if (const auto kept = run_and_keep(run, i); !kept.ok()) stop(kept.error());
      }
      progress_.advance();
    }
  }

  Result<void> run_and_keep(const EpisodeRunner& run, std::size_t number) {
    const episodes::EpisodeSpec& spec = file_.episodes[number];
    MARKETGEN_CHECK(check_interrupt());
    auto result = run(episodes::repetition_of(spec, options_.repetition));
    if (result.ok()) return folder_.keep(number, *std::move(result));
    if (ends_the_run(result.error())) return result.error();
    return folder_.keep(number, not_run(spec, options_.policy, result.error()));
  }

  void stop(const Error& error) {
    const std::scoped_lock lock(mutex_);
    if (!fault_) fault_ = error;
    over_ = true;
  }

  const episodes::EpisodeFile& file_;
  const EvaluationOptions& options_;
  ResultsFolder& folder_;
  Progress& progress_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> over_ = false;
  std::mutex mutex_;
  std::optional<Error> fault_;
};

// With what became of the rest.
Error with_what_is_kept(Error fault,
                        const ResultsFolder& folder,
                        const EvaluationOptions& options) {
  if (fault.code == "internal.interrupted") fault.message = "interrupted";
  fault.message += folder.count() == 0
                       ? "; no episode had been finished"
                       : fmt::format("; {} finished episodes are kept in {}: go on with --resume",
                                     folder.count(),
                                     options.folder.string());
  return fault;
}

}  // namespace

Result<std::vector<episodes::EpisodeResult>> evaluate_with(
    const episodes::EpisodeFile& file,
    const EvaluationOptions& options,
    const std::function<EpisodeRunner()>& make_runner,
    Progress& progress) {
  MARKETGEN_TRY(
      const auto folder,
      ResultsFolder::open(
          file,
          options.folder,
          record_of(file, options.policy, options.realism.name, options.shard, options.repetition),
          options.resume));
  EvaluationRun run(file, options, *folder, progress);
  run.go(make_runner);
  const NoForcedEnd keeping;
  auto results = folder->close();
  if (run.fault()) return with_what_is_kept(*run.fault(), *folder, options);
  return results;
}

Result<std::vector<episodes::EpisodeResult>> evaluate(const std::filesystem::path& data,
                                                      const episodes::EpisodeFile& file,
                                                      const catalog::Catalog& catalog,
                                                      const EvaluationOptions& options,
                                                      Progress& progress) {
  environments::Arena arena(data, file.header, catalog);
  arena.reach_models(options.model);
  // It has a key. A name that cannot be read may be one that its worker knows; else the first
  // episode says what is wrong with it.
  const auto policy = environments::read_policy_name(options.policy);
  if (policy.ok() && !policy->model.empty()) MARKETGEN_CHECK(arena.model(policy->model));
  if (policy.ok() && policy->has_servers()) MARKETGEN_CHECK(arena.part_client());
  const auto make_runner = [&]() -> EpisodeRunner {
    Kept kept = kept_of(options);
    if (options.worker.empty()) return runner_here(arena, options, std::move(kept));
    const WorkerTask task{file.header, options.realism, std::move(kept)};
    return runner_in_worker(options, io::write_json_line(task));
  };
  return evaluate_with(file, options, make_runner, progress);
}

}  // namespace marketgen::evaluation
