#include "freeze_stores.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "episodes/frozen_store.h"
#include "io/file.h"

namespace marketgen::app {
namespace {

// As it was frozen, byte for byte, where it was: several sets share a folder of scenes.
Result<std::string> scene_bytes(const episodes::EpisodeStore& store,
                                const environments::NamedStores& named,
                                environments::Arena& arena) {
  const auto frozen = named.scenes.find(store.scene_hash);
  if (frozen != named.scenes.end()) return io::read_file(frozen->second.file);
  MARKETGEN_TRY(const auto scene, arena.scene(store.scene_hash));
  return episodes::pack_scene(*scene);
}

// Another set's episodes, which lie there already, are of the file as it is.
Result<void> check_same_scene(const std::filesystem::path& file, const std::string& bytes) {
  std::error_code failed;
  if (!std::filesystem::exists(file, failed)) return {};
  MARKETGEN_TRY(const std::string there, io::read_file(file));
  if (there == bytes) return {};
  return Error{"usage.bad_flag",
               "--frozen",
               fmt::format("{} is there already, the same store as another version froze it: draw "
                           "from the set that it belongs to, or name another folder",
                           file.string())};
}

}  // namespace

Result<void> freeze_stores(const std::filesystem::path& data,
                           const environments::NamedStores& named,
                           environments::Arena& arena,
                           const std::filesystem::path& output,
                           io::Outputs& outputs,
                           episodes::EpisodeFile& file) {
  const std::filesystem::path folder = output.parent_path();
  for (episodes::EpisodeStore& store : file.header.stores) {
    MARKETGEN_TRY(const std::string bytes, scene_bytes(store, named, arena));
    store.scene = {episodes::frozen_scene_file(store), io::sha256_hex(bytes)};
    MARKETGEN_CHECK(check_same_scene(folder / store.scene->file, bytes));
    MARKETGEN_CHECK(outputs.put(folder / store.scene->file, bytes));
  }
  MARKETGEN_TRY(file.header.rows_hash, episodes::rows_hash(data, file));
  return {};
}

}  // namespace marketgen::app
