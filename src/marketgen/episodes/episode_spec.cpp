#include "episodes/episode_spec.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen {
namespace {

std::string line_of(const std::string& source, std::size_t line) {
  return fmt::format("{}:{}", source, line);
}

Result<void> check_sku(const EpisodeHeader& header,
                       const std::string& sku,
                       const std::string& where) {
  std::vector<std::string_view> known;
  for (const Product& product : header.products)
    known.push_back(product.sku);
  if (std::ranges::find(known, sku) != known.end()) return {};
  return Error{"catalog.unknown_sku",
               where,
               fmt::format("the header has no product \"{}\"{}", sku, did_you_mean(sku, known))};
}

Result<void> check_episode(const EpisodeFile& file,
                           const EpisodeSpec& spec,
                           const std::string& where) {
  for (const EpisodeItem& item : spec.items)
    MARKETGEN_CHECK(check_sku(file.header, item.sku, where + "/items"));
  for (const EpisodeGoal& goal : spec.goals) {
    MARKETGEN_CHECK(check_sku(file.header, goal.sku, where + "/goals"));
    if (spec.track != Track::checkout) continue;
    const auto lying = std::ranges::count(spec.items, goal.sku, &EpisodeItem::sku);
    if (lying < goal.count)
      return Error{
          "episode.impossible",
          where + "/goals",
          fmt::format("asks for {} of \"{}\"; {} lie in the basket", goal.count, goal.sku, lying)};
  }
  const bool known = std::ranges::any_of(file.header.stores, [&](const EpisodeStore& store) {
    return check_store(spec, store.scene_hash, store.plan_hash).ok();
  });
  if (!known)
    return Error{"episode.other_store", where, "its hashes are those of no store in the header"};
  return {};
}

}  // namespace

Result<Track> track_named(std::string_view name) {
  if (const auto track = value_named<Track>(name)) return *track;
  return Error{"episode.unknown_track",
               std::string(name),
               fmt::format("there is no such track{}; there are: {}",
                           did_you_mean(name, names_of(Track{})),
                           fmt::join(names_of(Track{}), ", "))};
}

std::string plan_hash(const Plan& plan) {
  return sha256_hex(write_json(plan));
}

Result<void> check_store(const EpisodeSpec& spec,
                         const std::string& scene_hash,
                         const std::string& plan_hash) {
  if (spec.scene_hash == scene_hash && spec.plan_hash == plan_hash) return {};
  return Error{"episode.other_store",
               spec.id,
               fmt::format("drawn from scene {} and plan {}, not from scene {} and plan {}",
                           spec.scene_hash,
                           spec.plan_hash,
                           scene_hash,
                           plan_hash)};
}

Result<EpisodeFile> read_episodes(std::string_view text, const std::string& source) {
  EpisodeFile file;
  std::size_t line = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos)
      return Error{"episode.truncated",
                   line_of(source, line + 1),
                   "the last line has no end: the file was cut off; draw the episodes again"};
    const std::string_view row = text.substr(0, end);
    text.remove_prefix(end + 1);
    const std::string where = line_of(source, ++line);
    if (line == 1) {
      MARKETGEN_TRY(file.header, read_json<EpisodeHeader>(row, where));
      continue;
    }
    MARKETGEN_TRY(EpisodeSpec spec, read_json<EpisodeSpec>(row, where));
    MARKETGEN_CHECK(check_episode(file, spec, where));
    file.episodes.push_back(std::move(spec));
  }
  if (line == 0 || file.episodes.size() != static_cast<std::size_t>(file.header.episodes))
    return Error{"episode.truncated",
                 source,
                 fmt::format("the header says {} episodes, {} are there; draw them again",
                             file.header.episodes,
                             file.episodes.size())};
  return file;
}

Result<EpisodeFile> read_episode_file(const std::filesystem::path& file) {
  MARKETGEN_TRY(const std::string text, read_file(file));
  return read_episodes(text, file.filename().string());
}

std::string write_episodes(const EpisodeFile& file) {
  std::string text = write_json_line(file.header) + "\n";
  for (const EpisodeSpec& spec : file.episodes)
    text += write_json_line(spec) + "\n";
  return text;
}

}  // namespace marketgen
