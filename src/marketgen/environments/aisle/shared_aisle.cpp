#include "environments/aisle/shared_aisle.h"

namespace marketgen::environments {
namespace {

// Neither has blanks: hashes are hexadecimal, tool sets identifiers.
std::string shared_key(const std::string& scene_hash, const std::string& tools) {
  return scene_hash + " " + tools;
}

}  // namespace

Result<std::shared_ptr<const episodes::AisleStore>> shared_aisle_store(
    Arena& arena, const std::string& scene_hash, const std::string& tools) {
  return arena.shared().get<const episodes::AisleStore>(
      shared_key(scene_hash, tools), [&]() -> Result<std::shared_ptr<const episodes::AisleStore>> {
        MARKETGEN_TRY(const auto scene, arena.scene(scene_hash));
        return episodes::open_aisle_store(arena.data(), *scene, tools);
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
