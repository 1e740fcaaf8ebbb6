// The shapes of fixtures that an edit has moved or made, without waiting for the renderer.
#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>

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

// A box without the bevel that it has from near: a third of the corners.
Mesh plain_mesh(const scene::ScenePart& part) {
  const assets::FixturePart shape = shape_of_part(part);
  Mesh mesh;
  if (shape.shape != assets::PartShape::box) {
    assets::add_part_mesh(mesh, shape, 0);
    return mesh;
  }
  const Vec3f half = shape.half_size;
  add_box(mesh, half * -1.0F, half, 0, 0);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] = to_float(shape.fixture_from_part * to_double(mesh.positions[i]));
    mesh.normals[i] =
        to_float(rotate(shape.fixture_from_part.rotation, to_double(mesh.normals[i])));
    mesh.uvs[i] = {};
  }
  return mesh;
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
  if (part.kind == assets::SurfaceKind::emissive)
    look.glow = color * lamp_light;
  else
    look.color = {srgb_byte(color.x), srgb_byte(color.y), srgb_byte(color.z), 255};
  return look;
}

// The parts as bytes, without the rows of their fixture and joint: equal modules have equal bytes.
std::string content_of(const scene::Scene& scene, const scene::SceneFixture& fixture) {
  std::string bytes;
  for (std::uint32_t i = 0; i < fixture.part_count; ++i) {
    scene::ScenePart part = scene.parts[fixture.first_part + i];
    part.fixture = 0;
    part.joint = -1;
    bytes.append(reinterpret_cast<const char*>(&part), sizeof part);
  }
  return bytes;
}

// Each shape once, in its fixture's frame, and where it stands.
class FixtureShapes {
 public:
  explicit FixtureShapes(const scene::Scene& scene) : scene_(scene) {}

  void place(std::uint32_t fixture) {
    const scene::SceneFixture& row = scene_.fixtures[fixture];
    const auto [known, is_new] =
        shapes_.try_emplace(content_of(scene_, row), static_cast<std::uint32_t>(shapes_.size()));
    if (is_new) add_shape(row);
    for (const std::uint32_t value : {known->second, fixture})
      places_.push_back(value);
    at_.insert(at_.end(), row.position_m.begin(), row.position_m.end());
    turns_.push_back(static_cast<std::uint8_t>(row.quarter_turns));
  }

  void pack(PackedSections& sections) const {
    mesh_.pack(sections);
    std::vector<std::uint8_t> light, finish;
    for (const ViewVertex& v : mesh_.vertices) {
      for (const float channel : {v.glow.x, v.glow.y, v.glow.z, 0.0F})
        light.push_back(packed_light(channel));
      finish.insert(finish.end(), v.finish.begin(), v.finish.end());
    }
    sections.add("light", 4, std::span<const std::uint8_t>(light));
    sections.add("finish", 4, std::span<const std::uint8_t>(finish));
    sections.add("shapes", 5, std::span<const std::uint32_t>(ranges_));
    sections.add("places", 2, std::span<const std::uint32_t>(places_));
    sections.add("place_at", 3, std::span<const float>(at_));
    sections.add("place_turns", 1, std::span<const std::uint8_t>(turns_));
  }

 private:
  void add_shape(const scene::SceneFixture& row) {
    const std::array<std::size_t, 2> first{mesh_.vertices.size(), mesh_.indices.size()};
    mesh_.begin_part();
    add_parts(row, false);
    const std::size_t solid = mesh_.indices.size() - first[1];
    add_parts(row, true);
    for (const std::size_t value : {first[0],
                                    mesh_.vertices.size() - first[0],
                                    first[1],
                                    solid,
                                    mesh_.indices.size() - first[1] - solid})
      ranges_.push_back(static_cast<std::uint32_t>(value));
  }

  void add_parts(const scene::SceneFixture& row, bool glass) {
    for (std::uint32_t i = row.first_part; i < row.first_part + row.part_count; ++i) {
      const scene::ScenePart& part = scene_.parts[i];
      if ((part.kind == assets::SurfaceKind::glass) == glass) add(part);
    }
  }

  void add(const scene::ScenePart& part) {
    const Mesh mesh = plain_mesh(part);
    const ViewVertex look = look_of_part(scene_, part);
    for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
      Corners corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = look;
        corners[k].position = mesh.positions[triangle[k]];
        corners[k].normal = mesh.normals[triangle[k]];
      }
      for_short_triangles(corners, [&](const Corners& piece) {
        for (const ViewVertex& corner : piece)
          mesh_.indices.push_back(mesh_.add(corner));
      });
    }
  }

  const scene::Scene& scene_;
  std::map<std::string, std::uint32_t> shapes_;
  ViewMesh mesh_;
  std::vector<std::uint32_t> ranges_, places_;
  std::vector<float> at_;
  std::vector<std::uint8_t> turns_;
};

}  // namespace

void pack_fixture_shapes(const scene::Scene& scene,
                         const std::vector<std::uint32_t>& rows,
                         PackedSections& sections) {
  FixtureShapes shapes(scene);
  for (const std::uint32_t row : rows)
    shapes.place(row);
  shapes.pack(sections);
}

}  // namespace marketgen::server
