// The shapes of fixtures that an edit has moved or made, without waiting for the renderer.
#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "assets/print/color.h"
#include "server/edit_delta.h"
#include "server/picture_pages.h"
#include "server/view_mesh.h"

namespace marketgen::server {
namespace {

constexpr float lamp_light = 2;  // times white: what a lamp is drawn with

assets::FixturePart shape_of_part(const scene::ScenePart& part) {
  assets::FixturePart shape;
  shape.unit = part.unit;
  shape.shape = part.shape;
  shape.fixture_from_part = scene::fixture_from_part(part);
  shape.half_size = {part.half_size_m[0], part.half_size_m[1], part.half_size_m[2]};
  return shape;
}

// A part in a catalogue material has that material's ground colour.
Vec3f plain_color(const scene::Scene& scene, const scene::ScenePart& part) {
  const Vec3f own{part.color[0], part.color[1], part.color[2]};
  if (part.material < 0) return own;
  const auto row = static_cast<std::size_t>(part.material);
  const Result<Vec3f> color = assets::linear_from_hex(scene.materials[row].color);
  return color.ok() ? *color : own;
}

std::uint8_t byte_of(float share) {
  return static_cast<std::uint8_t>(std::clamp(share, 0.0F, 1.0F) * 255 + 0.5F);
}

ViewVertex look_of_part(const scene::Scene& scene, const scene::ScenePart& part) {
  const Vec3f color = plain_color(scene, part);
  ViewVertex look;
  look.finish = {byte_of(part.roughness), byte_of(part.metallic), 0, 0};
  look.owner = {static_cast<std::uint16_t>(part.fixture), no_row};
  if (part.kind == assets::SurfaceKind::emissive)
    look.glow = color * lamp_light;
  else
    look.color = {srgb_byte(color.x), srgb_byte(color.y), srgb_byte(color.z), 255};
  return look;
}

// What is drawn at once: all solid parts, all panes.
class FixtureShapes {
 public:
  explicit FixtureShapes(const scene::Scene& scene) : scene_(scene) {}

  void add(std::uint32_t fixture) {
    const scene::SceneFixture& row = scene_.fixtures[fixture];
    const Pose place = scene::world_from_fixture(scene_, fixture);
    for (std::uint32_t i = 0; i < row.part_count; ++i)
      add(scene_.parts[row.first_part + i], place);
  }

  void pack(PackedSections& sections) {
    ViewMesh mesh;
    nlohmann::ordered_json batches = nlohmann::ordered_json::array();
    for (auto& [part, layer] : {std::pair{&solid_, "solid"}, std::pair{&glass_, "glass"}}) {
      if (part->indices.empty()) continue;
      batches.push_back({{"first_index", mesh.indices.size()},
                         {"index_count", part->indices.size()},
                         {"layer", layer},
                         {"texture", -1}});
      mesh.append(*part);
    }
    mesh.pack(sections);
    std::vector<std::uint8_t> light, finish;
    std::vector<std::uint16_t> owner;
    for (const ViewVertex& v : mesh.vertices) {
      for (const float channel : {v.glow.x, v.glow.y, v.glow.z, 0.0F})
        light.push_back(packed_light(channel));
      finish.insert(finish.end(), v.finish.begin(), v.finish.end());
      owner.insert(owner.end(), v.owner.begin(), v.owner.end());
    }
    sections.add("light", 4, std::span<const std::uint8_t>(light));
    sections.add("finish", 4, std::span<const std::uint8_t>(finish));
    sections.add("owner", 2, std::span<const std::uint16_t>(owner));
    sections.note("batches", std::move(batches));
    sections.note("textures", nlohmann::ordered_json::array());
  }

 private:
  void add(const scene::ScenePart& part, const Pose& world_from_fixture) {
    Mesh mesh;
    assets::add_part_mesh(mesh, shape_of_part(part), 0);
    const ViewVertex look = look_of_part(scene_, part);
    ViewMesh& to = part.kind == assets::SurfaceKind::glass ? glass_ : solid_;
    for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
      Corners corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = look;
        corners[k].position = to_float(world_from_fixture * to_double(mesh.positions[triangle[k]]));
        corners[k].normal =
            to_float(rotate(world_from_fixture.rotation, to_double(mesh.normals[triangle[k]])));
      }
      for_short_triangles(corners, [&](const Corners& piece) {
        for (const ViewVertex& corner : piece)
          to.indices.push_back(to.add(corner));
      });
    }
  }

  const scene::Scene& scene_;
  ViewMesh solid_, glass_;
};

}  // namespace

void pack_fixture_shapes(const scene::Scene& scene,
                         const std::vector<std::uint32_t>& rows,
                         PackedSections& sections) {
  FixtureShapes shapes(scene);
  for (const std::uint32_t row : rows)
    shapes.add(row);
  shapes.pack(sections);
}

}  // namespace marketgen::server
