#include "environments/aisle/shared_aisle.h"

#include <fmt/format.h>

namespace marketgen::environments {
namespace {

// Neither has blanks: hashes are hexadecimal, tool sets identifiers.
std::string shared_key(const std::string& scene_hash, const std::string& tools) {
  return scene_hash + " " + tools;
}

}  // namespace

Result<std::shared_ptr<const episodes::AisleStore>> shared_aisle_store(
    Arena& arena, const std::string& scene_hash, const std::string& tools, episodes::Doors doors) {
  const std::string key = fmt::format("{} {}", shared_key(scene_hash, tools), name_of(doors));
  return arena.shared().get<const episodes::AisleStore>(
      key, [&]() -> Result<std::shared_ptr<const episodes::AisleStore>> {
        MARKETGEN_TRY(const auto scene, arena.scene(scene_hash));
        return episodes::open_aisle_store(arena.data(), *scene, tools, doors);
      });
}

Result<std::shared_ptr<SharedAisleView>> shared_aisle_view(Arena& arena,
                                                           const std::string& scene_hash,
                                                           const std::string& tools) {
  return arena.shared().get<SharedAisleView>(shared_key(scene_hash, tools),
                                             []() -> Result<std::shared_ptr<SharedAisleView>> {
                                               return std::make_shared<SharedAisleView>();
                                             });
}

}  // namespace marketgen::environments
