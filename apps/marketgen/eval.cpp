// marketgen eval: runs episodes with a policy and reports what it reached.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "command.h"
#include "environments/policies.h"
#include "environments/policy_name.h"
#include "episodes/episode_origin.h"
#include "evaluation/episode_worker.h"
#include "evaluation/evaluate.h"
#include "evaluation/measure_perception.h"
#include "evaluation/same_runs.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "leaderboard_table.h"
#include "named_flag.h"
#include "number_flags.h"
#include "say.h"

namespace marketgen::app {
namespace {

struct EvalFlags {
  CommonFlags common;
  std::string episodes, policy = "oracle", output;
  std::vector<std::string> truth, against;
  std::string shard, realism = "ideal";
  std::string model, model_url, model_record, model_replay, masks_url, grasps_url;
  int jobs = 0, repetition = 1;
  double model_limit_s = 60;
  evaluation::AnswerLimits answer{120, 1200};
  bool resume = false, perception = false, worker = false, record_motion = false,
       record_decisions = false;
};

template <class Share>
void print_share(const char* name, const Share& share) {
  say("{:<12}{:5.1f} %  ({:.1f} to {:.1f}), {} of {}\n",
      name,
      share.share * 100,
      share.low * 100,
      share.high * 100,
      share.number,
      share.of);
}

// What was asked of a policy's model, and what came of it.
void print_model(const agent::ModelUse& use, int episodes) {
  say("model       {} questions in {} requests ({:.1f} an episode), {} tokens read, {} written\n",
      use.questions,
      use.requests,
      static_cast<double>(use.requests) / std::max(1, episodes),
      use.tokens_in,
      use.tokens_out);
  say("answers     {} marks, {} \"not there\"; failed: {} refused, {} timed out, {} unreachable, "
      "{} "
      "bad answers, {} off the picture, {} without a pose, {} not asked; {} times the choice "
      "without "
      "a model stood in\n",
      use.chosen,
      use.absent,
      use.refused,
      use.timed_out,
      use.unreachable,
      use.bad_answer,
      use.off_picture,
      use.no_pose,
      use.skipped,
      use.offline);
}

// The same of a part in a server.
void print_part(const char* name, const std::optional<agent::PartUse>& use) {
  if (!use) return;
  say("{:<12}{} questions, {} answered; failed: {} refused, {} timed out, {} unreachable, {} bad "
      "answers, {} not asked; {} times the program's own part stood in\n",
      name,
      use->questions,
      use->answered,
      use->refused,
      use->timed_out,
      use->unreachable,
      use->bad_answer,
      use->skipped,
      use->offline);
}

void print_summary(const evaluation::EvaluationSummary& summary,
                   episodes::Split split,
                   const std::string& realism) {
  print_share("SR strict", summary.strict);
  print_share("SR clean", summary.clean);
  print_share("goals", summary.goals);
  if (summary.mean_path_m > 0)
    say("SPL         {:5.1f} %  ({:.1f} % of the goals reached); {:.1f} m an episode, {:.1f} m "
        "a success\n",
        summary.spl * 100,
        summary.spl_subset * 100,
        summary.mean_path_m,
        summary.mean_path_success_m);
  say("SR partial  {:5.1f} %  ({:.1f} to {:.1f}), {} episodes ({}, {}) of {} stores\n",
      summary.partial.value * 100,
      summary.partial.low * 100,
      summary.partial.high * 100,
      summary.episodes,
      name_of(split),
      realism,
      summary.stores);
  print_share("violations", summary.violations);
  say("{:.1f} simulated seconds and {:.1f} s of computing an episode\n",
      summary.mean_simulated_s,
      summary.mean_wall_s);
  if (summary.model) print_model(*summary.model, summary.episodes);
  if (summary.parts) {
    print_part("masks", summary.parts->masks);
    print_part("grasps", summary.parts->grasps);
  }
  for (const evaluation::FailureCount& failure : summary.failures)
    say("{:<12}{}\n", name_of(failure.failure), failure.episodes);
  for (const evaluation::ErrorCount& count : summary.errors)
    say("not run     {} ({}): they are in none of these shares\n", count.episodes, count.error);
}

// Episodes that could not be run: the summary stands, and the caller is told. The first of them.
template <class Row>
Result<void> check_all_run(const std::vector<Row>& rows, const std::filesystem::path& file) {
  const auto failed = [](const Row& row) { return !row.error.empty(); };
  const auto first = std::ranges::find_if(rows, failed);
  if (first == rows.end()) return {};
  return Error{first->error,
               first->episode,
               fmt::format("{} of {} episodes could not be run; {} says why, of this one: {}",
                           std::ranges::count_if(rows, failed),
                           rows.size(),
                           file.string(),
                           first->detail)};
}

// The eyes of `classical` by themselves, against the truth.
Result<void> eval_perception(const EvalFlags& flags) {
  if (!(flags.model + flags.masks_url + flags.grasps_url).empty() || !flags.truth.empty())
    return Error{
        "usage.bad_flag",
        "--perception",
        "measures the eyes of classical as they are: without --truth, --model, --masks-url "
        "and --grasps-url"};
  const ThreadLimit limit(flags.jobs > 0 ? flags.jobs : flags.common.threads);
  if (flags.output.empty())
    return Error{"usage.bad_flag", "--output", "name a folder for the results"};
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add_folder(flags.output));
  MARKETGEN_TRY(const episodes::EpisodeFile file, episodes::read_episode_file(flags.episodes));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  MARKETGEN_TRY(const episodes::Realism realism, episodes::load_realism(data, flags.realism));
  environments::Arena arena(data, file.header, catalog);
  MARKETGEN_TRY(const std::vector<evaluation::PerceptionMeasure> measures,
                evaluation::measure_perception(arena, file.episodes, realism));
  std::string lines;
  for (const evaluation::PerceptionMeasure& measure : measures)
    lines += io::write_json_line(measure) + "\n";
  const std::filesystem::path results = std::filesystem::path(flags.output) / "perception.jsonl";
  MARKETGEN_CHECK(outputs.put(results, lines));
  MARKETGEN_CHECK(outputs.commit());
  fmt::print("{}", io::write_json(evaluation::summarize(measures)));
  return check_all_run(measures, results);
}

// This program once more, as a worker of ours with its share of the threads. It is told its
// episodes; their file's name is for whoever looks at a list of processes.
std::vector<std::string> worker_command(const EvalFlags& flags, int jobs) {
  std::error_code failed;
  std::vector<std::string> command{std::filesystem::read_symlink("/proc/self/exe", failed).string(),
                                   "eval",
                                   "--worker",
                                   "--episodes",
                                   flags.episodes,
                                   "--policy",
                                   flags.policy,
                                   "--threads",
                                   std::to_string(std::max(1, thread_count() / jobs)),
                                   "--model-limit-s",
                                   fmt::format("{}", flags.model_limit_s)};
  const std::pair<const char*, const std::string*> of_model[] = {
      {"--model-url", &flags.model_url},
      {"--model-record", &flags.model_record},
      {"--model-replay", &flags.model_replay}};
  for (const auto& [flag, value] : of_model)
    if (!value->empty()) command.insert(command.end(), {flag, *value});
  return command;
}

// How the model of `vlm` is reached. A robot waits for it: shorter than a planner does.
llm::ModelChoice model_access(const EvalFlags& flags) {
  llm::ModelChoice access;
  access.url = flags.model_url;
  access.record = flags.model_record;
  access.replay = flags.model_replay;
  access.limits.total_s = flags.model_limit_s;
  return access;
}

Result<evaluation::EvaluationOptions> options_of(const EvalFlags& flags,
                                                 const std::filesystem::path& data) {
  evaluation::EvaluationOptions options{flags.policy, flags.output, flags.resume};
  MARKETGEN_TRY(options.realism, episodes::load_realism(data, flags.realism));
  options.jobs = flags.jobs > 0 ? flags.jobs : thread_count();
  options.answer = flags.answer;
  options.repetition = flags.repetition;
  options.model = model_access(flags);
  options.record_motion = flags.record_motion;
  options.record_decisions = flags.record_decisions;
  if (!flags.shard.empty()) {
    MARKETGEN_TRY(options.shard, evaluation::read_shard(flags.shard));
  }
  if (flags.answer.cpu_s > 0) options.worker = worker_command(flags, options.jobs);
  return options;
}

// The other runs with which this one will be compared, before it begins. Errors: those of
// read_run, check_complete and check_same_episodes.
Result<std::vector<evaluation::FinishedRun>> others_of(
    const EvalFlags& flags,
    const episodes::EpisodeFile& file,
    const evaluation::EvaluationOptions& options) {
  MARKETGEN_TRY(std::vector<evaluation::FinishedRun> others, evaluation::read_runs(flags.against));
  if (!others.empty() && options.shard.of > 1)
    return Error{"usage.bad_flag", "--against", "a shard is no whole run: merge, then leaderboard"};
  std::vector<evaluation::FinishedRun> all = others;
  all.insert(all.begin(),
             {options.folder,
              evaluation::record_of(
                  file, options.policy, options.realism.name, options.shard, options.repetition),
              {}});
  MARKETGEN_CHECK(evaluation::check_same_episodes(all));
  for (const evaluation::FinishedRun& run : others)
    MARKETGEN_CHECK(evaluation::check_complete(run));
  return others;
}

Result<void> print_beside(const EvalFlags& flags, std::vector<evaluation::FinishedRun> others) {
  if (others.empty() || flags.common.json || flags.common.quiet) return {};
  MARKETGEN_TRY(evaluation::FinishedRun own, evaluation::read_run(flags.output));
  others.push_back(std::move(own));
  MARKETGEN_TRY(const evaluation::Leaderboard board, evaluation::leaderboard_of(others));
  say("\n");
  print_leaderboard(board);
  return {};
}

// Flags that name parts of a policy, put into its name, which has none yet.
Result<std::string> with_parts(const EvalFlags& flags) {
  const std::string& policy = flags.policy;
  const bool given = policy.find('(') != std::string::npos;
  const std::string servers = flags.masks_url + flags.grasps_url;
  if (!flags.model.empty() && (given || (policy != "vlm" && policy != "hybrid")))
    return Error{"usage.bad_flag",
                 "--model",
                 given ? "the policy names its model already" : "goes with --policy vlm or hybrid"};
  const char* const flag = flags.masks_url.empty() ? "--grasps-url" : "--masks-url";
  if (!servers.empty() && (given || policy != "hybrid"))
    return Error{"usage.bad_flag",
                 flag,
                 given ? "the policy names its parts already" : "goes with --policy hybrid"};
  if (servers.find(',') != std::string::npos)
    return Error{"usage.bad_flag", flag, "an address with a comma cannot stand in a policy's name"};
  environments::PolicyName whole{policy, flags.model, flags.masks_url, flags.grasps_url};
  return whole.written();
}

// The policy's whole name: with its parts, and the modules in whose place the truth stands.
Result<EvalFlags> with_whole_policy(EvalFlags flags) {
  MARKETGEN_TRY(flags.policy, with_parts(flags));
  for (const std::string& module : flags.truth)
    flags.policy += "+" + module;
  MARKETGEN_TRY(const environments::PolicyName policy,
                environments::read_policy_name(flags.policy));
  const bool asks_others = !policy.model.empty() || policy.has_servers();
  if (!asks_others && !(flags.model_url + flags.model_record + flags.model_replay).empty())
    return Error{"usage.bad_flag",
                 "--model",
                 "--model-url, --model-record and --model-replay go with --policy vlm or hybrid"};
  if (policy.model.empty() && !flags.model_url.empty())
    return Error{"usage.bad_flag", "--model-url", "there is no --model whose server it would be"};
  flags.policy = policy.written();
  return flags;
}

Result<void> eval(const EvalFlags& given) {
  if (given.perception) return eval_perception(given);
  MARKETGEN_TRY(const EvalFlags flags, with_whole_policy(given));
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  if (flags.worker)
    return evaluation::serve_episodes(data, catalog, flags.policy, model_access(flags));
  if (flags.output.empty())
    return Error{"usage.bad_flag", "--output", "name a folder for the results"};
  io::Outputs record;  // whether it has a place
  if (!flags.model_record.empty()) MARKETGEN_CHECK(record.add_folder(flags.model_record));
  MARKETGEN_TRY(const evaluation::EvaluationOptions options, options_of(flags, data));
  MARKETGEN_TRY(const episodes::EpisodeFile file, episodes::read_episode_file(flags.episodes));
  MARKETGEN_TRY(std::vector<evaluation::FinishedRun> others, others_of(flags, file, options));
  MARKETGEN_TRY(
      const std::vector<episodes::EpisodeResult> results,
      marketgen::evaluation::evaluate(data, file, catalog, options, progress_for(flags.common)));
  const evaluation::EvaluationSummary summary = evaluation::summarize(results);
  if (flags.common.json)
    fmt::print("{}", io::write_json(summary));
  else if (!flags.common.quiet)
    print_summary(summary, file.header.split, options.realism.name);
  MARKETGEN_CHECK(check_all_run(results, std::filesystem::path(flags.output) / "results.jsonl"));
  return print_beside(flags, std::move(others));
}

// Who acts, and what it is given.
void add_policy(CLI::App& command, EvalFlags& flags) {
  command
      .add_option("--policy",
                  flags.policy,
                  "who acts: oracle (knows everything), classical (sees pictures), vlm (classical "
                  "whose targets --model chooses), hybrid (classical with parts from elsewhere: "
                  "--masks-url, --grasps-url, --model), highest, random or stop (know nothing)")
      ->type_name(choice_of(environments::policies))
      ->capture_default_str();
  command
      .add_option(
          "--truth",
          flags.truth,
          "modules of classical, vlm or hybrid in whose place the truth stands: masks, target, "
          "grasp, language")
      ->type_name(choice_of(environments::names_of(environments::TrueModule{})))
      ->delimiter(',');
  command
      .add_option("--realism",
                  flags.realism,
                  "what stands between the world and the robot: ideal (nothing), standard or "
                  "hard, or a file of your own that ends with .json; rankings are meant to use "
                  "standard")
      ->type_name("REALISM")
      ->capture_default_str();
}

// That of `vlm`, as `assets import` has its own.
void add_model(CLI::App& command, EvalFlags& flags) {
  command
      .add_option(
          "--model",
          flags.model,
          "model that sees pictures and chooses for --policy vlm or hybrid: openai:MODEL, "
          "anthropic:MODEL, "
          "gemini:MODEL, qwen:MODEL; it is sent pictures of the robot's cameras and product names")
      ->type_name("MODEL");
  command.add_option("--model-url", flags.model_url, "base URL of another server of that kind")
      ->type_name("URL");
  add_output(
      command, "--model-record", flags.model_record, "folder to keep the exchange with it in");
  command
      .add_option(
          "--model-replay", flags.model_replay, "such a folder to answer from: nothing is sent")
      ->type_name("FOLDER");
  command
      .add_option("--model-limit-s",
                  flags.model_limit_s,
                  "wall time for one answer of the model, or of a server of --policy hybrid")
      ->check(real_number(0.1, 86400))
      ->capture_default_str();
}

// Those of `hybrid` that run in servers.
void add_servers(CLI::App& command, EvalFlags& flags) {
  command
      .add_option("--masks-url",
                  flags.masks_url,
                  "segmentation server for --policy hybrid at the counter (SAM, SAM 2: "
                  "docs/models.md); it is sent pictures of the robot's cameras")
      ->type_name("URL");
  command
      .add_option(
          "--grasps-url",
          flags.grasps_url,
          "grasp server for --policy hybrid (AnyGrasp: docs/hybrid.md); it is sent pictures "
          "with depth")
      ->type_name("URL");
}

// Of a policy that acts in a process of its own.
void add_limits(CLI::App& command, EvalFlags& flags) {
  command
      .add_option("--act-limit-s",
                  flags.answer.cpu_s,
                  "processor time for one answer of the policy, which acts in a process of its "
                  "own; 0 = none, and all in one process")
      ->check(real_number(0, 86400))
      ->capture_default_str();
  command
      .add_option("--hang-limit-s",
                  flags.answer.hang_s,
                  "wall time after which a policy in its own process that has not answered is "
                  "taken to hang; 0 = never")
      ->check(real_number(0, 86400))
      ->capture_default_str();
}

}  // namespace

Run add_eval(CLI::App& app) {
  auto flags = std::make_shared<EvalFlags>();
  CLI::App* command = app.add_subcommand("eval", "Run episodes with a policy, in physics");
  command
      ->add_option(
          "--episodes", flags->episodes, "file of `marketgen episodes`; - = standard input")
      ->type_name("EPISODES")
      ->required();
  add_policy(*command, *flags);
  add_model(*command, *flags);
  add_servers(*command, *flags);
  command->add_option("--jobs", flags->jobs, "episodes at a time; 0 = as --threads")
      ->check(whole_number(0, 1024));
  command
      ->add_option("--shard",
                   flags->shard,
                   "run a part of the file, 2/4: the second of four; `marketgen merge` joins "
                   "them")
      ->type_name("PART");
  command
      ->add_option("--repetition",
                   flags->repetition,
                   "which run of the episodes this is: from 2 on what the policy and a realism "
                   "draw is drawn anew; `marketgen leaderboard` sums repetitions up")
      ->check(whole_number(1, episodes::max_repetitions))
      ->capture_default_str();
  command
      ->add_option("--against",
                   flags->against,
                   "results of other policies on the same episodes, to be compared with")
      ->type_name("RESULTS");
  add_output(*command, "-o,--output", flags->output, "folder for the results");
  add_limits(*command, *flags);
  command->add_flag("--worker", flags->worker, "run what standard input says")->group("");
  command->add_flag("--perception",
                    flags->perception,
                    "measure masks, recognition and poses of `classical` alone, on the baskets");
  command->add_flag("--record-motion",
                    flags->record_motion,
                    "also keep what moved in each episode, in motion/ID.bin.gz of the results");
  command->add_flag(
      "--record-decisions",
      flags->record_decisions,
      "also keep what classical, vlm or hybrid decided in each episode and which module was "
      "first wrong, in decisions/ID.json.gz and ID.html of the results");
  command->add_flag("--resume", flags->resume, "go on with a run that was broken off");
  add_common_flags(*command, flags->common, Takes::json);
  command->footer("Example:  marketgen eval --episodes tasks.jsonl --policy oracle -o results");
  return [flags] {
    const auto done = eval(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
