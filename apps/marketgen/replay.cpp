// marketgen replay: runs one episode again, compares it with what was kept, and films it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/parallel.h"
#include "base/text.h"
#include "command.h"
#include "environments/policies.h"
#include "environments/run_episode.h"
#include "episodes/episode_origin.h"
#include "episodes/named_dials.h"
#include "evaluation/evaluate.h"
#include "evaluation/film.h"
#include "evaluation/finished_run.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "io/picture_file.h"
#include "named_flag.h"
#include "number_flags.h"
#include "say.h"

namespace marketgen::app {
namespace {

struct ReplayFlags {
  CommonFlags common;
  std::string episodes, episode, policy = "oracle", realism, results, film, strip;
  int width = 640, height = 480;
  double speed = 4;
};

// By its id, or its number from 0 on.
Result<episodes::EpisodeSpec> episode_named(const episodes::EpisodeFile& file,
                                            const std::string& name) {
  std::vector<std::string_view> ids;
  for (std::size_t i = 0; i < file.episodes.size(); ++i) {
    ids.push_back(file.episodes[i].id);
    if (file.episodes[i].id == name || std::to_string(i) == name) return file.episodes[i];
  }
  return Error{"usage.bad_flag",
               "--episode",
               fmt::format("the file has no episode \"{}\"{}; it has {}, from 0 on",
                           name,
                           did_you_mean(name, ids),
                           ids.size())};
}

// The kept result with which the run will be compared; nothing when none was named. Errors: those
// of finished_results; episode.not_repeated when it cannot be compared with.
Result<std::optional<episodes::EpisodeResult>> kept_result(const ReplayFlags& flags,
                                                           const episodes::EpisodeHeader& header,
                                                           const episodes::EpisodeSpec& spec) {
  if (flags.results.empty()) return std::optional<episodes::EpisodeResult>();
  MARKETGEN_TRY(const auto kept, evaluation::finished_results(flags.results));
  const auto before = kept.find(spec.id);
  const auto fault = [&](std::string why) {
    return Error{"episode.not_repeated", flags.results, std::move(why)};
  };
  if (before == kept.end()) return fault("has no result of " + spec.id);
  const episodes::EpisodeResult& result = before->second;
  if (result.policy != flags.policy)
    return fault(
        fmt::format("{} was run by \"{}\": name it with --policy", spec.id, result.policy));
  if (!result.episode_hash.empty() && result.episode_hash != episodes::episode_hash(header, spec))
    return fault(spec.id + " has changed since it was run: take the file that it is of");
  if (result.state_hash.empty())
    return fault(fmt::format("{} was not run to its end: {}", spec.id, result.detail));
  return std::optional(result);
}

// What was asked for, or else what the kept result was run with. Errors: those of load_realism;
// episode.not_repeated when these two differ.
Result<episodes::Realism> realism_of(const ReplayFlags& flags,
                                     const std::filesystem::path& data,
                                     const std::optional<episodes::EpisodeResult>& before) {
  const auto differs = [&](const std::string& asked) {
    return Error{"episode.not_repeated",
                 flags.results,
                 fmt::format("{} was run with the realism \"{}\"{}: name that, or its file, with "
                             "--realism",
                             before->episode,
                             before->realism,
                             asked)};
  };
  const bool is_own = before && before->realism.starts_with(episodes::own_dials);
  if (flags.realism.empty() && is_own) return differs("");
  const std::string kept = before ? before->realism : episodes::Realism{}.name;
  MARKETGEN_TRY(episodes::Realism realism,
                episodes::load_realism(data, flags.realism.empty() ? kept : flags.realism));
  if (before && before->realism != realism.name)
    return differs(fmt::format(", not \"{}\"", realism.name));
  return realism;
}

Result<void> replay_episode(const ReplayFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_CHECK(io::check_ending(flags.film, {".mp4"}, "--film"));
  MARKETGEN_CHECK(io::check_picture_ending(flags.strip, "--strip"));
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--film", flags.film}, {"--strip", flags.strip}}));
  MARKETGEN_TRY(const episodes::EpisodeFile file, episodes::read_episode_file(flags.episodes));
  MARKETGEN_TRY(const episodes::EpisodeSpec spec, episode_named(file, flags.episode));
  MARKETGEN_TRY(const auto before, kept_result(flags, file.header, spec));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const episodes::Realism realism, realism_of(flags, data, before));
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  environments::Arena arena(data, file.header, catalog);
  constexpr double frame_rate = 20;
  evaluation::FilmWatcher filming({.film = flags.film,
                                   .strip = flags.strip,
                                   .width = flags.width,
                                   .height = flags.height,
                                   .every_s = flags.speed / frame_rate,
                                   .frame_rate = frame_rate});
  const bool filmed = !flags.film.empty() || !flags.strip.empty();
  MARKETGEN_TRY(const episodes::EpisodeResult result,
                environments::run_episode(
                    arena,
                    episodes::repetition_of(spec, before ? before->repetition.value_or(1) : 1),
                    flags.policy,
                    filmed ? &filming : nullptr,
                    {},
                    realism));
  if (filmed) MARKETGEN_CHECK(filming.finish(outputs));
  MARKETGEN_CHECK(outputs.commit());
  if (flags.common.json)
    fmt::print("{}\n", io::write_json_line(result));
  else if (!flags.common.quiet)
    say("reached {} of {} goals, {:.1f} s; {}\n",
        std::ranges::count_if(result.goals,
                              [](const auto& goal) { return goal.reached >= goal.count; }),
        result.goals.size(),
        result.simulated_s,
        name_of(result.failure));
  if (!before) return {};
  MARKETGEN_CHECK(evaluation::check_repeated(*before, result));
  if (!flags.common.quiet) say("the same    {}\n", result.state_hash);
  return {};
}

}  // namespace

Run add_replay(CLI::App& app) {
  auto flags = std::make_shared<ReplayFlags>();
  CLI::App* command = app.add_subcommand("replay", "Run one episode again, and film it");
  command
      ->add_option(
          "--episodes", flags->episodes, "file of `marketgen episodes`; - = standard input")
      ->type_name("EPISODES")
      ->required();
  command->add_option("--episode", flags->episode, "its id, or its number from 0 on")
      ->type_name("EPISODE")
      ->required();
  command->add_option("--policy", flags->policy, "who acts")
      ->type_name(choice_of(environments::policies))
      ->capture_default_str();
  command
      ->add_option("--realism",
                   flags->realism,
                   "as of eval; that of --results where they are given, else ideal")
      ->type_name("REALISM");
  command->add_option("--results", flags->results, "results.jsonl with which it is compared")
      ->type_name("FILE");
  add_output(*command, "--film", flags->film, "MP4 file");
  add_output(*command, "--strip", flags->strip, "PNG or JPEG file with six pictures of it");
  command->add_option("--speed", flags->speed, "of the film, times real time")
      ->check(real_number(0.1, 100))
      ->capture_default_str();
  command->add_option("--width", flags->width, "pixels of the film")
      ->check(whole_number(64, 4096))
      ->capture_default_str();
  command->add_option("--height", flags->height, "pixels of the film")
      ->check(whole_number(64, 4096))
      ->capture_default_str();
  add_common_flags(*command, flags->common, Takes::json);
  command->footer(
      "Example:  marketgen replay --episodes tasks.jsonl --episode 0 --film film.mp4 --strip "
      "film.png");
  return [flags] {
    const auto done = replay_episode(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
