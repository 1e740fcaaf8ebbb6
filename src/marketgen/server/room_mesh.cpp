// The room as a page draws it: the renderer's own triangles, cut where light changes along them.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "base/parallel.h"
#include "render/picture_objects.h"
#include "render/shading_math.h"
#include "server/room_textures.h"
#include "server/view_files.h"
#include "server/view_mesh.h"

namespace marketgen::server {
namespace {

using render::raytrace::LitWorld;
using render::raytrace::Material;
using render::raytrace::Placement;
using render::raytrace::TriangleRecord;
using render::raytrace::TriangleSet;
using render::raytrace::World;

constexpr float cell_m = 12;  // of a batch: what is behind the viewer need not be drawn

enum class Layer { solid, glass, ceiling };
constexpr std::array<std::string_view, 3> layer_names{"solid", "glass", "ceiling"};

// What is drawn at once: layer, texture file, cell.
using BatchKey = std::tuple<int, int, int, int>;

class RoomMesh {
 public:
  RoomMesh(const LitWorld& lit, const RoomTextures& textures)
      : world_(*lit.world), lit_(lit), textures_(textures) {}

  void add_all(const scene::Scene& scene) {
    const Placement here;
    add(world_.shell, here, Layer::solid, {no_row, no_row}, &scene);
    add(world_.shell_glass, here, Layer::glass, {no_row, no_row}, &scene);
    add(world_.ceiling, here, Layer::ceiling, {no_row, no_row}, &scene);
    for (std::size_t i = 0; i < world_.first_product_instance; ++i) {
      const render::raytrace::Instance& instance = world_.instances[i];
      const std::array<std::uint16_t, 2> owner{row_of(instance.fixture), row_of(instance.joint)};
      const render::raytrace::TracedMesh& mesh = world_.meshes[instance.mesh];
      add(mesh.solid, instance.world_from_mesh, Layer::solid, owner, nullptr);
      add(mesh.glass, instance.world_from_mesh, Layer::glass, owner, nullptr);
    }
  }

  std::string file() {
    ViewMesh mesh;
    nlohmann::ordered_json batches = nlohmann::ordered_json::array();
    for (auto& [key, part] : batches_) {
      batches.push_back(batch_of(key, part, mesh.indices.size()));
      mesh.append(part);
      part = {};
    }
    PackedSections sections;
    mesh.pack(sections);
    const std::vector<std::uint8_t> light = light_of(mesh);
    sections.add("light", 4, std::span<const std::uint8_t>(light));
    std::vector<std::uint8_t> finish;
    std::vector<std::uint16_t> owner;
    for (const ViewVertex& v : mesh.vertices) {
      finish.insert(finish.end(), v.finish.begin(), v.finish.end());
      owner.insert(owner.end(), v.owner.begin(), v.owner.end());
    }
    sections.add("finish", 4, std::span<const std::uint8_t>(finish));
    sections.add("owner", 2, std::span<const std::uint16_t>(owner));
    sections.note("batches", std::move(batches));
    sections.note("textures", textures_.list());
    return sections.file();
  }

 private:
  static std::uint16_t row_of(std::int32_t row) {
    return row < 0 ? no_row : static_cast<std::uint16_t>(row);
  }

  // With a scene: triangles have owners of their own, by the renderer's numbers.
  void add(const TriangleSet& set,
           const Placement& place,
           Layer layer,
           std::array<std::uint16_t, 2> owner,
           const scene::Scene* scene) {
    for (std::size_t i = 0; i < set.triangles.size(); ++i) {
      const TriangleRecord& record = set.records[i];
      if (scene != nullptr)
        owner[0] = record.owner >= render::first_fixture_object &&
                           record.owner < render::first_product_object(*scene)
                       ? static_cast<std::uint16_t>(record.owner - render::first_fixture_object)
                       : no_row;
      Corners corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = look_of(record.material);
        corners[k].position = place(set.positions[set.triangles[i][k]]);
        corners[k].normal = place.turn(render::raytrace::unpacked_normal(record.normals[k]));
        corners[k].uv = textures_.uv_in_file(record.material, record.uvs[k]);
        corners[k].owner = owner;
      }
      const int texture = textures_.file_of(record.material);
      for_short_triangles(corners, [&](const Corners& piece) { keep(piece, layer, texture); });
    }
  }

  ViewVertex look_of(std::uint16_t number) const {
    const Material& material = world_.materials[number];
    ViewVertex look;
    const auto byte = [](float share) {
      return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0F, 1.0F) * 255));
    };
    look.finish = {byte(material.roughness), byte(material.metallic), 0, 0};
    look.glow = material.emission * world_.exposure;
    if (look.glow.x + look.glow.y + look.glow.z <= 0)
      look.color = {srgb_byte(material.color.x),
                    srgb_byte(material.color.y),
                    srgb_byte(material.color.z),
                    255};
    return look;
  }

  void keep(const Corners& corners, Layer layer, int texture) {
    const Vec3f middle =
        (corners[0].position + corners[1].position + corners[2].position) * (1.0F / 3);
    const BatchKey key{static_cast<int>(layer),
                       texture,
                       static_cast<int>(std::floor(middle.x / cell_m)),
                       static_cast<int>(std::floor(middle.y / cell_m))};
    ViewMesh& part = batches_[key];
    for (const ViewVertex& corner : corners)
      part.indices.push_back(part.add(corner));
  }

  static nlohmann::ordered_json batch_of(const BatchKey& key,
                                         const ViewMesh& part,
                                         std::size_t first) {
    Bounds3 bounds;
    for (const ViewVertex& vertex : part.vertices)
      bounds.include(vertex.position);
    return {{"first_index", first},
            {"index_count", part.indices.size()},
            {"layer", layer_names[static_cast<std::size_t>(std::get<0>(key))]},
            {"texture", std::get<1>(key)},
            {"low_m", {bounds.low.x, bounds.low.y, bounds.low.z}},
            {"high_m", {bounds.high.x, bounds.high.y, bounds.high.z}}};
  }

  Vec3f light_on(const ViewVertex& v) const {
    if (v.glow.x + v.glow.y + v.glow.z > 0) return v.glow;
    const std::int32_t fixture = v.owner[0] == no_row ? -1 : v.owner[0];
    const render::raytrace::Place place =
        render::raytrace::place_of(v.position, v.normal, fixture, -1);
    return lit_.field.at(place, v.normal) * (world_.exposure / render::raytrace::pi);
  }

  std::vector<std::uint8_t> light_of(const ViewMesh& mesh) const {
    std::vector<std::uint8_t> light(4 * mesh.vertices.size());
    constexpr std::size_t grain = 4096;
    parallel_for(
        mesh.vertices.size(),
        [&](std::size_t i) {
          const Vec3f on = light_on(mesh.vertices[i]);
          light[4 * i] = packed_light(on.x);
          light[4 * i + 1] = packed_light(on.y);
          light[4 * i + 2] = packed_light(on.z);
        },
        grain);
    return light;
  }

  const World& world_;
  const LitWorld& lit_;
  const RoomTextures& textures_;
  std::map<BatchKey, ViewMesh> batches_;
};

}  // namespace

Result<std::vector<ViewFile>> room_files(const LitWorld& lit, const scene::Scene& scene) {
  const RoomTextures textures(*lit.world);
  MARKETGEN_TRY(std::vector<ViewFile> files, textures.files());
  RoomMesh mesh(lit, textures);
  mesh.add_all(scene);
  files.push_back({"room.bin", "application/octet-stream", mesh.file()});
  return files;
}

}  // namespace marketgen::server
