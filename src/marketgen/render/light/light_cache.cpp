#include "render/light/light_cache.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <utility>

#include "base/build_info.h"
#include "base/hash.h"
#include "io/cache_entry.h"
#include "io/file.h"
#include "render/art_fingerprint.h"
#include "render/render_fingerprint.h"

namespace marketgen::render::raytrace {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_files = 256;
constexpr std::string_view light_kind = "light/2";

struct LightHeader {
  std::uint64_t probes = 0;
  Vec3f mean;
  float floor_mean = 0;
};

template <class T>
void add_rows(Hasher& hasher, const std::vector<T>& rows) {
  hasher.add(static_cast<std::int64_t>(rows.size())).add_bytes(std::as_bytes(std::span(rows)));
}

void add_triangles(Hasher& hasher, const TriangleSet& set) {
  add_rows(hasher, set.positions);
  add_rows(hasher, set.triangles);
  add_rows(hasher, set.records);
}

template <class... T>
void add_numbers(Hasher& hasher, const T&... numbers) {
  (hasher.add_bytes(std::as_bytes(std::span(&numbers, 1))), ...);
}

// What is added to these belongs into the key, unless no baked light depends on it.
static_assert(sizeof(Material) == 80 && sizeof(Surroundings) == 36 && sizeof(AreaLight) == 64);

void add_material(Hasher& hasher, const Material& m) {
  add_numbers(hasher, m.color, m.emission, m.roughness, m.metallic, m.texture, m.relief);
  add_numbers(hasher, m.roughness_scale, m.glass, m.clear);
}

void add_instance(Hasher& hasher, const Instance& i) {
  add_numbers(hasher, i.mesh, i.fixture, i.shelf, i.look, i.world_from_mesh);
}

fs::path light_folder() {
  return io::cache_folder() / "light";
}

fs::path file_of(const std::string& key) {
  return light_folder() / (key + ".light");
}

void leave_newest(const fs::path& folder, std::size_t count) {
  std::error_code ignored;
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    files.emplace_back(entry.last_write_time(ignored), entry.path());
  if (files.size() <= count) return;
  std::sort(files.begin(), files.end(), std::greater<>());
  for (std::size_t i = count; i < files.size(); ++i)
    fs::remove(files[i].second, ignored);
}

std::string_view payload_of(const std::vector<PackedCube>& probes) {
  return {reinterpret_cast<const char*>(probes.data()), probes.size() * sizeof(PackedCube)};
}

}  // namespace

std::string light_key(const World& world, std::span<const Vec3f> probe_positions) {
  Hasher hasher;
  hasher.add(program_version).add(art_fingerprint).add(render_fingerprint);
  hasher.add(world.art_key);
  for (const TriangleSet* set : {&world.shell, &world.shell_glass, &world.ceiling})
    add_triangles(hasher, *set);
  for (const TracedMesh& mesh : world.meshes) {
    add_triangles(hasher, mesh.solid);
    add_triangles(hasher, mesh.glass);
  }
  for (const Material& material : world.materials)
    add_material(hasher, material);
  for (const Instance& instance : world.instances)
    add_instance(hasher, instance);
  add_rows(hasher, world.lights);
  add_numbers(hasher, world.panel_count, world.room, world.exposure);
  const Surroundings& s = world.surroundings;
  add_numbers(hasher, s.white, s.daylight, s.day_tint, s.even, s.sampled_as_lights);
  hasher.add_bytes(std::as_bytes(probe_positions));
  return hasher.hex();
}

std::optional<BakedLight> kept_light(const std::string& key, std::size_t probes) {
  if (key.empty()) return std::nullopt;
  const fs::path file = file_of(key);
  const std::optional<std::string> content = io::kept_entry(file, light_kind);
  if (!content) return std::nullopt;
  LightHeader header;
  const std::size_t part = probes * sizeof(PackedCube);
  const bool fits = content->size() == sizeof(header) + 2 * part;
  if (fits) std::memcpy(&header, content->data(), sizeof(header));
  if (!fits || header.probes != probes) {
    io::drop_entry(file, "is of another store");
    return std::nullopt;
  }
  const std::string_view payload = std::string_view(*content).substr(sizeof(header));
  BakedLight light{std::vector<PackedCube>(probes),
                   std::vector<PackedCube>(probes),
                   header.mean,
                   header.floor_mean};
  std::memcpy(light.probes.data(), payload.data(), part);
  std::memcpy(light.without_panels.data(), payload.data() + part, part);
  return light;
}

void keep_light(const std::string& key, const BakedLight& light) {
  const LightHeader header{light.probes.size(), light.mean, light.floor_mean};
  std::string content(reinterpret_cast<const char*>(&header), sizeof(header));
  content.append(payload_of(light.probes)).append(payload_of(light.without_panels));
  (void)io::keep_entry(file_of(key), light_kind, content).ok();
  leave_newest(light_folder(), max_files);
}

}  // namespace marketgen::render::raytrace
