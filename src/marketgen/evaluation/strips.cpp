#include "evaluation/strips.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "environments/run_episode.h"
#include "episodes/episode_origin.h"
#include "episodes/named_dials.h"
#include "episodes/realism.h"
#include "episodes/track_world.h"
#include "evaluation/film.h"
#include "evaluation/same_runs.h"
#include "io/file.h"
#include "io/output.h"

namespace marketgen::evaluation {
namespace {

constexpr int strip_px = 240;  // square: a strip cuts nothing off at the sides
constexpr int strip_pictures = 6;

constexpr std::array<std::pair<std::string_view, std::string_view>, 2> picture_types{
    {{".png", "image/png"}, {".jpg", "image/jpeg"}}};

std::filesystem::path strip_path(const FinishedRun& run,
                                 const std::string& episode,
                                 std::string_view ending) {
  return run.folder / "strips" / (episode + std::string(ending));
}

// Its file and media type.
std::optional<std::pair<std::filesystem::path, std::string_view>> strip_of(
    const FinishedRun& run, const std::string& episode) {
  std::error_code none;
  for (const auto& [ending, type] : picture_types)
    if (const auto file = strip_path(run, episode, ending);
        std::filesystem::is_regular_file(file, none))
      return std::pair{file, type};
  return std::nullopt;
}

Result<void> check_can_be_repeated(const FinishedRun& run, const episodes::EpisodeFile& file) {
  const auto fault = [&](const char* why) {
    return Error{"usage.bad_flag", "--strips", run.folder.string() + why};
  };
  for (const episodes::EpisodeResult& result : run.results)
    if (result.isolation != episodes::PolicyIsolation::own)
      return fault(" is of a policy written in Python: film it where it is run");
  if (run.record.realism.starts_with(episodes::own_dials))
    return fault(
        " has a realism of one's own: `marketgen replay --realism FILE --strip` makes strips");
  const FinishedRun asked{"--episodes",
                          record_of(file,
                                    run.record.policy,
                                    run.record.realism,
                                    run.record.shard,
                                    run.record.repetition.value_or(1)),
                          {}};
  return check_same_episodes({run, asked});
}

// Those of which strips are to be made.
std::vector<const episodes::EpisodeResult*> without_strip(const FinishedRun& run,
                                                          std::size_t at_most) {
  std::vector<const episodes::EpisodeResult*> chosen;
  for (auto [code, results] : results_by_code(run)) {
    std::erase_if(results, [](const auto* result) { return result->state_hash.empty(); });
    results.resize(std::min(results.size(), at_most));
    std::erase_if(results,
                  [&](const auto* result) { return strip_of(run, result->episode).has_value(); });
    chosen.insert(chosen.end(), results.begin(), results.end());
  }
  return chosen;
}

Result<void> make_strip(environments::Arena& arena,
                        const episodes::EpisodeSpec& spec,
                        const episodes::EpisodeResult& before,
                        const episodes::Realism& realism,
                        const std::filesystem::path& file) {
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--strips", file}}));
  const double ran_s = before.steps * episodes::control_step_s;
  FilmWatcher film({.film = {},
                    .strip = file,
                    .width = strip_px,
                    .height = strip_px,
                    .every_s = std::max(episodes::control_step_s, ran_s / (strip_pictures - 1)),
                    .strip_pictures = strip_pictures});
  MARKETGEN_TRY(
      const episodes::EpisodeResult again,
      environments::run_episode(arena,
                                episodes::repetition_of(spec, before.repetition.value_or(1)),
                                before.policy,
                                &film,
                                {},
                                realism));
  MARKETGEN_CHECK(check_repeated(before, again));
  MARKETGEN_CHECK(film.finish(outputs));
  return outputs.commit();
}

}  // namespace

ResultsByCode results_by_code(const FinishedRun& run) {
  ResultsByCode codes;
  for (const episodes::EpisodeResult& result : run.results)
    codes[std::string(name_of(result.failure))].push_back(&result);
  return codes;
}

Result<std::vector<StripPicture>> strips_of(const FinishedRun& run, std::size_t at_most) {
  std::vector<StripPicture> strips;
  for (const auto& [code, results] : results_by_code(run)) {
    std::size_t taken = 0;
    for (const episodes::EpisodeResult* result : results) {
      const auto strip = strip_of(run, result->episode);
      if (taken == at_most || !strip) continue;
      MARKETGEN_TRY(std::string bytes, io::read_file(strip->first));
      strips.push_back({result->episode, std::string(strip->second), std::move(bytes)});
      ++taken;
    }
  }
  return strips;
}

Result<void> make_strips(const std::filesystem::path& data,
                         const FinishedRun& run,
                         const episodes::EpisodeFile& file,
                         const catalog::Catalog& catalog,
                         std::size_t at_most,
                         Progress& progress) {
  MARKETGEN_CHECK(check_can_be_repeated(run, file));
  MARKETGEN_TRY(const episodes::Realism realism, episodes::load_realism(data, run.record.realism));
  environments::Arena arena(data, file.header, catalog);
  const auto chosen = without_strip(run, at_most);
  progress.begin("film strips", chosen.size());
  for (const episodes::EpisodeResult* result : chosen) {
    const auto spec = std::ranges::find(file.episodes, result->episode, &episodes::EpisodeSpec::id);
    MARKETGEN_CHECK(
        make_strip(arena, *spec, *result, realism, strip_path(run, result->episode, ".png")));
    progress.advance();
  }
  progress.end();
  return {};
}

}  // namespace marketgen::evaluation
