#include "perception/kept_looks.h"

#include <cstring>
#include <filesystem>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "io/cache_entry.h"
#include "io/file.h"
#include "perception/look_fingerprint.h"

namespace marketgen::perception {
namespace {

constexpr std::string_view look_kind = "look/1";
static_assert(std::has_unique_object_representations_v<PackedSurfel>);

std::filesystem::path look_file(const std::string& key) {
  return io::cache_folder() / "looks" / (key + ".look");
}

}  // namespace

std::string look_key(const std::string& row, const std::string& pictures_key) {
  return Hasher().add(look_fingerprint).add(pictures_key).add(row).hex();
}

std::optional<ProductLook> kept_look(const std::string& key, const std::string& sku) {
  const std::filesystem::path file = look_file(key);
  const std::optional<std::string> content = io::kept_entry(file, look_kind);
  if (!content) return std::nullopt;
  std::vector<PackedSurfel> surfels(content->size() / sizeof(PackedSurfel));
  if (surfels.empty() || content->size() % sizeof(PackedSurfel) != 0) {
    io::drop_entry(file, "cannot be understood");
    return std::nullopt;
  }
  std::memcpy(surfels.data(), content->data(), content->size());
  return ProductLook::of(sku, std::move(surfels));
}

void keep_look(const std::string& key, const ProductLook& look) {
  const std::vector<PackedSurfel> surfels = look.packed();
  const std::string_view content(reinterpret_cast<const char*>(surfels.data()),
                                 surfels.size() * sizeof(PackedSurfel));
  (void)io::keep_entry(look_file(key), look_kind, content).ok();
}

}  // namespace marketgen::perception
