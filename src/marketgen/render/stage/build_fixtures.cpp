#include "render/stage/build_fixtures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "assets/fixtures/fixture_model.h"
#include "render/light/lamp.h"
#include "render/picture_objects.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

// The joint that carries a part about, counted from its fixture's first; -1: none does. Belts stand
// still.
std::int32_t moving_joint(const scene::Scene& scene,
                          const scene::SceneFixture& fixture,
                          const scene::ScenePart& part) {
  if (part.joint < 0 ||
      scene.joints[static_cast<std::size_t>(part.joint)].kind == assets::JointKind::belt)
    return -1;
  return part.joint - static_cast<std::int32_t>(fixture.first_joint);
}

// The parts as bytes, without the rows of their fixture and joint: equal modules have equal bytes.
std::string content_of(const scene::Scene& scene, const scene::SceneFixture& fixture) {
  std::string bytes;
  for (std::uint32_t i = 0; i < fixture.part_count; ++i) {
    scene::ScenePart part = scene.parts[fixture.first_part + i];
    part.fixture = 0;
    part.joint = moving_joint(scene, fixture, part);
    bytes.append(reinterpret_cast<const char*>(&part), sizeof(part));
  }
  return bytes;
}

assets::FixturePart as_fixture_part(const scene::ScenePart& part) {
  assets::FixturePart result;
  result.unit = part.unit;
  result.shape = part.shape;
  result.fixture_from_part = scene::fixture_from_part(part);
  result.half_size = {part.half_size_m[0], part.half_size_m[1], part.half_size_m[2]};
  return result;
}

Vec3f color_of(const scene::ScenePart& part) {
  return {part.color[0], part.color[1], part.color[2]};
}

// Area lights are rectangles: a lamp of another shape shines where rays meet it by themselves.
Material glow_of(const scene::ScenePart& part) {
  const float radius = part.half_size_m[0], length = 2 * part.half_size_m[2];
  return {.color = {0, 0, 0},
          .emission = color_of(part) *
                      lamp_radiance(std::max(2 * radius, length), two_pi * radius * length)};
}

std::uint16_t material_of(Draft& draft, const scene::ScenePart& part) {
  if (part.kind == assets::SurfaceKind::emissive) return draft.material(glow_of(part));
  if (part.material >= 0)
    return draft.tiled_material(
        draft.scene().materials[static_cast<std::size_t>(part.material)].id);
  Material material{
      .color = color_of(part), .roughness = part.roughness, .metallic = part.metallic};
  if (part.kind == assets::SurfaceKind::glass) {
    material.glass = true;
    // A pane is a box with two faces: each takes half of the tint.
    material.color = {
        std::sqrt(material.color.x), std::sqrt(material.color.y), std::sqrt(material.color.z)};
  }
  return draft.material(material);
}

float uv_extent(const Draft& draft, const scene::ScenePart& part) {
  return part.material < 0
             ? 1
             : draft.extent_m(draft.scene().materials[static_cast<std::size_t>(part.material)].id);
}

}  // namespace

FixtureBuilder::FixtureBuilder(Draft& draft) {
  std::map<std::string, std::uint32_t> known;
  for (const scene::SceneFixture& fixture : draft.scene().fixtures) {
    const auto [entry, is_new] = known.try_emplace(content_of(draft.scene(), fixture),
                                                   static_cast<std::uint32_t>(shapes_.size()));
    if (is_new) shapes_.push_back(make_shape(draft, fixture));
    shape_of_fixture_.push_back(entry->second);
  }
}

FixtureBuilder::Body& FixtureBuilder::body_of(Shape& shape, std::int32_t joint) {
  const auto same = [&](const Body& body) { return body.joint == joint; };
  const auto found = std::find_if(shape.bodies.begin(), shape.bodies.end(), same);
  if (found != shape.bodies.end()) return *found;
  shape.bodies.push_back({joint, {}, {}});
  return shape.bodies.back();
}

FixtureBuilder::Shape FixtureBuilder::make_shape(Draft& draft, const scene::SceneFixture& fixture) {
  Shape shape;
  shape.bodies.emplace_back();
  for (std::uint32_t i = fixture.first_part; i < fixture.first_part + fixture.part_count; ++i) {
    const scene::ScenePart& part = draft.scene().parts[i];
    if (part.kind == assets::SurfaceKind::emissive && part.shape == assets::PartShape::box) {
      shape.lamps.push_back({draft.material({.color = {0, 0, 0}, .emission = color_of(part)}), i});
      continue;
    }
    Body& body = body_of(shape, moving_joint(draft.scene(), fixture, part));
    const std::size_t first_vertex = body.mesh.uvs.size();
    assets::add_part_mesh(
        body.mesh, as_fixture_part(part), static_cast<std::uint16_t>(body.materials.size()));
    body.materials.push_back(material_of(draft, part));
    const float extent = uv_extent(draft, part);
    for (std::size_t v = first_vertex; v < body.mesh.uvs.size(); ++v)
      body.mesh.uvs[v] = body.mesh.uvs[v] * (1 / extent);
  }
  return shape;
}

void FixtureBuilder::add_lamps(Draft& draft, const Shape& shape, TracedMesh& mesh) {
  for (const Lamp& lamp : shape.lamps) {
    const scene::ScenePart& part = draft.scene().parts[lamp.part];
    const Vec3f half{part.half_size_m[0], part.half_size_m[1], part.half_size_m[2]};
    add_lamp_box(
        draft.world(), mesh, placement_of(scene::fixture_from_part(part)), half, lamp.material);
  }
}

void FixtureBuilder::add_instances(World& world,
                                   const scene::Scene& scene,
                                   std::size_t row,
                                   const Shape& shape) {
  for (std::size_t k = 0; k < shape.bodies.size(); ++k) {
    Instance instance;
    instance.mesh = shape.first_mesh + static_cast<std::uint32_t>(k);
    instance.id = first_fixture_object + static_cast<std::uint32_t>(row);
    instance.fixture = static_cast<std::int32_t>(row);
    if (shape.bodies[k].joint >= 0)
      instance.joint =
          static_cast<std::int32_t>(scene.fixtures[row].first_joint) + shape.bodies[k].joint;
    instance.world_from_mesh =
        placement_of(scene::world_from_fixture(scene, static_cast<std::uint32_t>(row)));
    world.instances.push_back(instance);
  }
}

void FixtureBuilder::build(Draft& draft) {
  World& world = draft.world();
  const scene::Scene& scene = draft.scene();
  for (Shape& shape : shapes_) {
    shape.first_mesh = static_cast<std::uint32_t>(world.meshes.size());
    for (std::size_t k = 0; k < shape.bodies.size(); ++k) {
      TracedMesh mesh;
      append(mesh.solid, mesh.glass, shape.bodies[k].mesh, shape.bodies[k].materials, world, {});
      if (k == 0) add_lamps(draft, shape, mesh);
      world.meshes.push_back(std::move(mesh));
    }
  }
  for (std::size_t i = 0; i < scene.fixtures.size(); ++i)
    add_instances(world, scene, i, shapes_[shape_of_fixture_[i]]);
}

}  // namespace marketgen::render::raytrace
