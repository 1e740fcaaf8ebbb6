// scene.bin from anywhere: either a scene that is written and read back unchanged, or an error.
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include "scene/query.h"
#include "scene/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  const std::span<const std::byte> bytes(reinterpret_cast<const std::byte*>(data), size);
  const auto scene = scene::decode_scene(bytes, "fuzz");
  if (!scene.ok()) return 0;
  const std::string again = scene::encode_scene(*scene);
  const auto copy =
      scene::decode_scene({reinterpret_cast<const std::byte*>(again.data()), again.size()}, "fuzz");
  if (!copy.ok() || scene::encode_scene(*copy) != again ||
      scene::scene_hash(*copy) != scene::scene_hash(*scene))
    std::abort();
  for (const char* table : {"products", "fixtures", "zones", "prices", "materials", "planogram"}) {
    const auto rows = scene::query_scene(*scene, table, "");  // what was accepted can be used
    if (!rows.ok()) std::abort();
    scene::to_csv(*rows);
    scene::to_json(*rows);
  }
  return 0;
}
