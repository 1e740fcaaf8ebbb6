// marketgen eval: runs episodes with a policy and reports what it reached.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/parallel.h"
#include "command.h"
#include "evaluation/run_episode.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::app {
namespace {

struct EvalFlags {
  CommonFlags common;
  std::string episodes, policy = "oracle", output;
  int jobs = 0;
};

Result<std::vector<EpisodeResult>> run_all(const EvalFlags& flags, const EpisodeFile& file) {
  MARKETGEN_TRY(const std::filesystem::path data, data_folder());
  MARKETGEN_TRY(const Catalog catalog, load_rows());
  Progress& progress = progress_for(flags.common);
  progress.begin("episodes", file.episodes.size());
  const auto made = parallel_map(file.episodes.size(), [&](std::size_t i) {
    auto result =
        run_episode(data, file.episodes[i], file.header.products, catalog.frictions, flags.policy);
    progress.advance();
    return std::make_shared<Result<EpisodeResult>>(std::move(result));
  });
  progress.end();
  std::vector<EpisodeResult> results;
  for (const auto& result : made) {
    if (!result->ok()) return result->error();
    results.push_back(result->value());
  }
  return results;
}

Result<void> write_results(const EvalFlags& flags,
                           const std::vector<EpisodeResult>& results,
                           const EvaluationSummary& summary) {
  MARKETGEN_TRY(FolderDraft draft, FolderDraft::begin(flags.output));
  std::string lines;
  for (const EpisodeResult& result : results)
    lines += write_json_line(result) + "\n";
  MARKETGEN_CHECK(write_file(draft.folder() / "results.jsonl", lines));
  MARKETGEN_CHECK(write_file(draft.folder() / "summary.json", write_json(summary)));
  return draft.commit();
}

void print_share(const char* name, const Share& share) {
  fmt::print("{:<12}{:5.1f} %  ({:.1f} to {:.1f}), {} of {}\n",
             name,
             share.share * 100,
             share.low * 100,
             share.high * 100,
             share.number,
             share.of);
}

void print_summary(const EvaluationSummary& summary) {
  print_share("SR strict", summary.strict);
  print_share("SR clean", summary.clean);
  print_share("goals", summary.goals);
  fmt::print("SR partial  {:5.1f} %\n", summary.success_partial * 100);
  fmt::print("{:.1f} simulated seconds and {:.1f} s of computing an episode\n",
             summary.mean_simulated_s,
             summary.mean_wall_s);
  for (const FailureCount& failure : summary.failures)
    fmt::print("{:<12}{}\n", name_of(failure.failure), failure.episodes);
}

Result<void> evaluate(const EvalFlags& flags) {
  const ThreadLimit limit(flags.jobs > 0 ? flags.jobs : flags.common.threads);
  MARKETGEN_TRY(const EpisodeFile file, read_episode_file(flags.episodes));
  MARKETGEN_TRY(const std::vector<EpisodeResult> results, run_all(flags, file));
  const EvaluationSummary summary = summarize(results);
  MARKETGEN_CHECK(write_results(flags, results, summary));
  if (flags.common.json)
    fmt::print("{}", write_json(summary));
  else if (!flags.common.quiet)
    print_summary(summary);
  return {};
}

}  // namespace

Run add_eval(CLI::App& app) {
  auto flags = std::make_shared<EvalFlags>();
  CLI::App* command = app.add_subcommand("eval", "Run episodes with a policy, in physics");
  command->add_option("--episodes", flags->episodes, "file of `marketgen episodes`")->required();
  command->add_option("--policy", flags->policy, "who acts: oracle")->capture_default_str();
  command->add_option("--jobs", flags->jobs, "episodes at a time; 0 = as --threads")
      ->check(CLI::Range(0, 1024));
  command->add_option("-o,--output", flags->output, "folder for the results")->required();
  add_common_flags(*command, flags->common, Takes::json);
  command->footer("Example:  marketgen eval --episodes tasks.jsonl --policy oracle -o results");
  return [flags] {
    const auto done = evaluate(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
