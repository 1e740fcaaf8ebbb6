#include "episodes/episode_spec.h"

#include <set>

#include <fmt/format.h>

#include "base/hash.h"
#include "episodes/check_episodes.h"
#include "episodes/episode_sets.h"
#include "episodes/frozen_store.h"
#include "io/file.h"
#include "io/gzip.h"
#include "io/json.h"

namespace marketgen::episodes {
namespace fs = std::filesystem;
namespace {

std::string line_of(const std::string& source, std::size_t line) {
  return fmt::format("{}:{}", source, line);
}

}  // namespace

std::set<std::string> skus_of(const EpisodeSpec& spec) {
  std::set<std::string> skus;
  for (const EpisodeItem& item : spec.items)
    skus.insert(item.sku);
  for (const EpisodeGoal& goal : spec.goals)
    skus.insert(goal.sku);
  return skus;
}

std::string plan_hash(const plan::Plan& plan) {
  return io::sha256_hex(io::write_json(plan));
}

std::string episode_hash(const EpisodeHeader& header, const EpisodeSpec& spec) {
  const std::set<std::string> used = skus_of(spec);
  Hasher hasher;
  hasher.add(io::write_json_line(spec));
  for (const catalog::Product& product : header.products)
    if (used.contains(product.sku)) hasher.add(io::write_json_line(product));
  return hasher.hex();
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
      MARKETGEN_TRY(file.header, io::read_json<EpisodeHeader>(row, where));
      continue;
    }
    MARKETGEN_TRY(EpisodeSpec spec, io::read_json<EpisodeSpec>(row, where));
    file.episodes.push_back(std::move(spec));
  }
  if (line == 0 || file.episodes.size() != static_cast<std::size_t>(file.header.episodes))
    return Error{"episode.truncated",
                 source,
                 fmt::format("the header says {} episodes, {} are there; draw them again",
                             file.header.episodes,
                             file.episodes.size())};
  MARKETGEN_CHECK(check_episodes(file, source));
  return file;
}

namespace {

// Each that an episode may open.
Result<void> check_scenes_of_set(const EpisodeHeader& header, const fs::path& folder) {
  for (const EpisodeStore& store : header.stores)
    if (store.scene) {
      MARKETGEN_CHECK(check_set_file(folder, store.scene->file));
    }
  return {};
}

}  // namespace

Result<EpisodeFile> read_episode_file(const fs::path& file) {
  MARKETGEN_TRY(const fs::path data, io::data_folder());
  const bool told = file == "-";
  MARKETGEN_TRY(const fs::path found,
                told ? Result<fs::path>("/dev/stdin") : find_episode_file(file, data));
  const std::string source = told ? "standard input" : found.filename().string();
  const std::string set = told ? "" : set_of_file(found, data);
  if (!set.empty()) {
    MARKETGEN_CHECK(check_set_file(found.parent_path(), source));
  }
  MARKETGEN_TRY(std::string text, io::read_file(found));
  if (io::is_gzip(text)) {
    MARKETGEN_TRY(text, io::gunzip(text, source));
  }
  MARKETGEN_TRY(EpisodeFile episodes, read_episodes(text, source));
  episodes.set = set;
  if (!set.empty()) {
    MARKETGEN_CHECK(check_scenes_of_set(episodes.header, found.parent_path()));
  }
  MARKETGEN_CHECK(check_robots(episodes, source, data));
  MARKETGEN_CHECK(check_frozen(episodes, source, told ? fs::path() : found.parent_path(), data));
  return episodes;
}

std::string write_episodes(const EpisodeFile& file) {
  std::string text = io::write_json_line(file.header) + "\n";
  for (const EpisodeSpec& spec : file.episodes)
    text += io::write_json_line(spec) + "\n";
  return text;
}

}  // namespace marketgen::episodes
