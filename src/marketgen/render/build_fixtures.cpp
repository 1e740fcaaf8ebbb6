#include "render/build_fixtures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "assets/fixture_model.h"
#include "render/lamp.h"
#include "render/picture_objects.h"
#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

// The parts as bytes, without the rows of their fixture and joint: equal modules have equal bytes.
std::string content_of(const Scene& scene, const SceneFixture& fixture) {
  std::string bytes;
  for (std::uint32_t i = 0; i < fixture.part_count; ++i) {
    ScenePart part = scene.parts[fixture.first_part + i];
    part.fixture = 0;
    part.joint = -1;
    bytes.append(reinterpret_cast<const char*>(&part), sizeof(part));
  }
  return bytes;
}

FixturePart as_fixture_part(const ScenePart& part) {
  FixturePart result;
  result.unit = part.unit;
  result.shape = part.shape;
  result.fixture_from_part = fixture_from_part(part);
  result.half_size = {part.half_size_m[0], part.half_size_m[1], part.half_size_m[2]};
  return result;
}

Vec3f color_of(const ScenePart& part) {
  return {part.color[0], part.color[1], part.color[2]};
}

// Area lights are rectangles: a lamp of another shape shines where rays meet it by themselves.
Material glow_of(const ScenePart& part) {
  const float radius = part.half_size_m[0], length = 2 * part.half_size_m[2];
  return {.color = {0, 0, 0},
          .emission = color_of(part) *
                      lamp_radiance(std::max(2 * radius, length), two_pi * radius * length)};
}

std::uint16_t material_of(Draft& draft, const ScenePart& part) {
  if (part.kind == SurfaceKind::emissive) return draft.material(glow_of(part));
  if (part.material >= 0)
    return draft.tiled_material(
        draft.scene().materials[static_cast<std::size_t>(part.material)].id);
  Material material{
      .color = color_of(part), .roughness = part.roughness, .metallic = part.metallic};
  if (part.kind == SurfaceKind::glass) {
    material.glass = true;
    // A pane is a box with two faces: each takes half of the tint.
    material.color = {
        std::sqrt(material.color.x), std::sqrt(material.color.y), std::sqrt(material.color.z)};
  }
  return draft.material(material);
}

float uv_extent(const Draft& draft, const ScenePart& part) {
  return part.material < 0
             ? 1
             : draft.extent_m(draft.scene().materials[static_cast<std::size_t>(part.material)].id);
}

}  // namespace

FixtureBuilder::FixtureBuilder(Draft& draft) {
  std::map<std::string, std::uint32_t> known;
  for (const SceneFixture& fixture : draft.scene().fixtures) {
    const auto [entry, is_new] = known.try_emplace(content_of(draft.scene(), fixture),
                                                   static_cast<std::uint32_t>(shapes_.size()));
    if (is_new) shapes_.push_back(make_shape(draft, fixture));
    shape_of_fixture_.push_back(entry->second);
  }
}

FixtureBuilder::Shape FixtureBuilder::make_shape(Draft& draft, const SceneFixture& fixture) {
  Shape shape;
  for (std::uint32_t i = fixture.first_part; i < fixture.first_part + fixture.part_count; ++i) {
    const ScenePart& part = draft.scene().parts[i];
    if (part.kind == SurfaceKind::emissive && part.shape == PartShape::box) {
      shape.lamps.push_back({draft.material({.color = {0, 0, 0}, .emission = color_of(part)}), i});
      continue;
    }
    const std::size_t first_vertex = shape.mesh.uvs.size();
    add_part_mesh(
        shape.mesh, as_fixture_part(part), static_cast<std::uint16_t>(shape.materials.size()));
    shape.materials.push_back(material_of(draft, part));
    const float extent = uv_extent(draft, part);
    for (std::size_t v = first_vertex; v < shape.mesh.uvs.size(); ++v)
      shape.mesh.uvs[v] = shape.mesh.uvs[v] * (1 / extent);
  }
  return shape;
}

void FixtureBuilder::add_lamps(Draft& draft, const Shape& shape, TracedMesh& mesh) {
  for (const Lamp& lamp : shape.lamps) {
    const ScenePart& part = draft.scene().parts[lamp.part];
    const Vec3f half{part.half_size_m[0], part.half_size_m[1], part.half_size_m[2]};
    add_lamp_box(draft.world(), mesh, placement_of(fixture_from_part(part)), half, lamp.material);
  }
}

void FixtureBuilder::build(Draft& draft) const {
  World& world = draft.world();
  const Scene& scene = draft.scene();
  const auto first_mesh = static_cast<std::uint32_t>(world.meshes.size());
  for (const Shape& shape : shapes_) {
    TracedMesh mesh;
    append(mesh.solid, mesh.glass, shape.mesh, shape.materials, world, {});
    add_lamps(draft, shape, mesh);
    world.meshes.push_back(std::move(mesh));
  }
  for (std::size_t i = 0; i < scene.fixtures.size(); ++i) {
    Instance instance;
    instance.mesh = first_mesh + shape_of_fixture_[i];
    instance.id = first_fixture_object + static_cast<std::uint32_t>(i);
    instance.fixture = static_cast<std::int32_t>(i);
    instance.world_from_mesh =
        placement_of(world_from_fixture(scene, static_cast<std::uint32_t>(i)));
    world.instances.push_back(instance);
  }
}

}  // namespace marketgen::raytrace
