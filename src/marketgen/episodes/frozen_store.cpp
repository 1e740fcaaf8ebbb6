#include "episodes/frozen_store.h"

#include <map>
#include <set>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "base/hash.h"
#include "catalog/complete_contents.h"
#include "episodes/track_entry.h"
#include "io/file.h"
#include "io/gzip.h"
#include "io/model_file.h"
#include "scene/scene_file.h"

namespace marketgen::episodes {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t max_row_bytes = 1U << 20;

// The files of a folder of rows by the ids that other rows name them by.
class RowFiles {
 public:
  explicit RowFiles(fs::path folder) : folder_(std::move(folder)) {}

  // Reads what is named in a text, and what is named there, by name.
  Result<void> read_named_in(const std::string& text) {
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder_, failed)) {
      const std::string id = entry.path().stem().string();
      if (texts_.contains(id) || text.find('"' + id + '"') == std::string::npos) continue;
      MARKETGEN_TRY(texts_[id], io::read_file(entry.path(), max_row_bytes));
      MARKETGEN_CHECK(read_named_in(std::string(texts_[id])));
    }
    if (failed)
      return Error{"io.cannot_read", folder_.string(), "cannot be listed: " + failed.message()};
    return {};
  }
  const std::map<std::string, std::string>& texts() const { return texts_; }

 private:
  fs::path folder_;
  std::map<std::string, std::string> texts_;
};

std::string station_file(const EpisodeSpec& spec) {
  return fmt::format("{}.json", spec.station.value_or(std::string(name_of(spec.track))));
}

}  // namespace

std::string frozen_scene_file(const EpisodeStore& store) {
  return fmt::format("{}/{}.bin.gz", scenes_folder, store.scene_hash);
}

std::string pack_scene(const scene::Scene& scene) {
  return io::gzip(scene::encode_scene(scene));
}

Result<std::shared_ptr<const scene::Scene>> open_frozen_scene(const EpisodeStore& store,
                                                              const catalog::Catalog& catalog) {
  const std::string& file = store.scene->file;
  MARKETGEN_TRY(const std::string packed, io::read_file(file));
  if (io::sha256_hex(packed) != store.scene->sha256)
    return Error{"episode.other_store",
                 file,
                 "is not the file of which the episodes have the SHA-256: fetch it again, or the "
                 "episodes that belong to it"};
  MARKETGEN_TRY(const std::string bytes, io::gunzip(packed, file));
  MARKETGEN_TRY(scene::Scene scene, scene::decode_scene(std::as_bytes(std::span(bytes)), file));
  if (const std::string there = scene::scene_hash(scene); there != store.scene_hash)
    return Error{"episode.other_store",
                 file,
                 fmt::format("has scene {}, the episodes are of {}", there, store.scene_hash)};
  catalog::complete_contents(scene.catalog, catalog);
  return std::make_shared<const scene::Scene>(std::move(scene));
}

Result<std::string> rows_hash(const fs::path& data, const EpisodeFile& file) {
  std::set<std::string> stations;
  for (const EpisodeSpec& spec : file.episodes)
    stations.insert(station_file(spec));
  Hasher hasher;
  MARKETGEN_TRY(const std::string friction, io::read_file(data / "friction.json", max_row_bytes));
  hasher.add(friction);
  RowFiles robots(data / "robots");
  for (const std::string& station : stations) {
    MARKETGEN_TRY(const std::string text,
                  io::read_file(data / "benchmark" / station, max_row_bytes));
    hasher.add(station).add(text);
    MARKETGEN_CHECK(robots.read_named_in(text));
  }
  for (const auto& [id, text] : robots.texts())
    hasher.add(id).add(text);
  return hasher.hex();
}

Result<void> find_scenes(EpisodeHeader& header, const std::string& source, const fs::path& folder) {
  for (EpisodeStore& store : header.stores) {
    if (!store.scene) continue;
    MARKETGEN_TRY(const fs::path path, io::path_within(folder, store.scene->file, source));
    store.scene->file = path.string();
  }
  return {};
}

Result<void> check_frozen(EpisodeFile& file,
                          const std::string& source,
                          const fs::path& folder,
                          const fs::path& data) {
  MARKETGEN_CHECK(find_scenes(file.header, source, folder));
  if (!file.header.rows_hash) return {};
  MARKETGEN_TRY(const std::string there, rows_hash(data, file));
  if (there == *file.header.rows_hash) return {};
  return Error{"episode.other_rows",
               source,
               "the rows of robots, stations or friction are no longer those with which these "
               "episodes were frozen, so that results would not compare: use the version of "
               "marketgen that froze them, or set MARKETGEN_DATA to its data"};
}

}  // namespace marketgen::episodes
