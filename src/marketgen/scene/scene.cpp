#include "scene/scene.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/hash.h"
#include "catalog/own_faces.h"
#include "scene/placements.h"

namespace marketgen::scene {
namespace {

Pose pose_of(const std::array<float, 3>& position, const std::array<float, 4>& rotation) {
  return {{position[0], position[1], position[2]},
          {rotation[0], rotation[1], rotation[2], rotation[3]}};
}

constexpr double length_step = 1e-5;    // 0.01 mm
constexpr double rotation_step = 1e-4;  // of a quaternion's component

void add_pose(Hasher& hash,
              const std::array<float, 3>& position,
              const std::array<float, 4>& rotation) {
  for (const float p : position)
    hash.add_rounded(p, length_step);
  for (const float r : rotation)
    hash.add_rounded(r, rotation_step);
}

// The first of the placed products, which stand after those of the last block.
std::uint32_t first_placement(const Scene& scene, std::uint32_t product) {
  if (scene.facings.empty()) return 0;
  const Facing& last = scene.facings.back();
  return std::min(last.first_product + last.product_count, product);
}

}  // namespace

Pose world_from_fixture(const Scene& scene, std::uint32_t fixture) {
  const SceneFixture& row = scene.fixtures[fixture];
  return {{row.position_m[0], row.position_m[1], row.position_m[2]},
          yaw_from_quarter_turns(row.quarter_turns)};
}

Pose world_from_shelf(const Scene& scene, std::uint32_t shelf) {
  const SceneShelf& row = scene.shelves[shelf];
  return world_from_fixture(scene, row.fixture) * pose_of(row.position_m, row.rotation_wxyz);
}

Pose world_from_product(const SceneProduct& product) {
  return pose_of(product.position_m, product.rotation_wxyz);
}

void place(SceneProduct& product, const Pose& world_from_product) {
  const Vec3& p = world_from_product.position;
  const Quaternion& q = world_from_product.rotation;
  product.position_m = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  product.rotation_wxyz = {static_cast<float>(q.w),
                           static_cast<float>(q.x),
                           static_cast<float>(q.y),
                           static_cast<float>(q.z)};
}

Pose fixture_from_part(const ScenePart& part) {
  return pose_of(part.position_m, part.rotation_wxyz);
}

std::string product_id(const Scene& scene, std::uint32_t product) {
  const SceneProduct& item = scene.products[product];
  if (item.facing == no_facing) {
    return fmt::format("placement-{}", product - first_placement(scene, product));
  }
  const Facing& facing = scene.facings[item.facing];
  const SceneShelf& shelf = scene.shelves[facing.shelf];
  return fmt::format("{}/{}level-{}/facing-{}/item-{}",
                     scene.layout.fixtures[shelf.fixture].id,
                     shelf.side == 0 ? "" : "back/",
                     shelf.level,
                     facing.position,
                     product - facing.first_product);
}

std::string scene_hash(const Scene& scene) {
  Hasher hash;
  const plan::Shell& shell = scene.layout.shell;
  hash.add(shell.width_mm).add(shell.depth_mm).add(shell.ceiling_mm);
  for (const ScenePart& part : scene.parts) {
    hash.add(part.fixture)
        .add(static_cast<std::int64_t>(part.unit))
        .add(static_cast<std::int64_t>(part.shape));
    add_pose(hash, part.position_m, part.rotation_wxyz);
    for (const float h : part.half_size_m)
      hash.add_rounded(h, length_step);
  }
  for (std::size_t i = 0; i < scene.fixtures.size(); ++i) {
    hash.add(scene.layout.fixtures[i].id)
        .add(scene.layout.fixtures[i].kind)
        .add(scene.fixtures[i].quarter_turns);
    for (const float p : scene.fixtures[i].position_m)
      hash.add_rounded(p, length_step);
  }
  for (const catalog::Product& product : scene.catalog) {
    hash.add(product.sku).add(product.archetype);
    if (!product.mesh.empty()) hash.add(product.mesh);
    for (const int s : product.size_mm)
      hash.add(s);
  }
  for (const SceneProduct& item : scene.products) {
    hash.add(item.sku);
    add_pose(hash, item.position_m, item.rotation_wxyz);
  }
  return hash.hex();
}

std::string look_hash(const Scene& scene) {
  Hasher hash;
  const plan::Look& look = scene.layout.look;
  hash.add(look.floor)
      .add(look.wall)
      .add(look.ceiling)
      .add(look.fixture)
      .add(look.accent)
      .add(look.light_kelvin)
      .add(look.light_lux);
  if (look.lamps) hash.add(static_cast<std::int64_t>(*look.lamps));
  if (look.daylight) hash.add_rounded(*look.daylight, 1e-3);
  if (look.neon) hash.add(static_cast<std::int64_t>(*look.neon));
  for (const catalog::MaterialRow& m : scene.materials) {
    hash.add(m.id)
        .add(static_cast<std::int64_t>(m.pattern))
        .add(m.color)
        .add(m.second_color)
        .add(m.period_mm);
    hash.add_rounded(m.roughness, 1e-3).add_rounded(m.metallic, 1e-3);
  }
  for (const ScenePart& part : scene.parts) {
    hash.add(part.material).add(static_cast<std::int64_t>(part.kind));
    for (const float c : part.color)
      hash.add_rounded(c, 1e-3);
  }
  for (const catalog::Product& p : scene.catalog) {
    hash.add(p.label.primary)
        .add(p.label.secondary)
        .add(p.label.accent)
        .add(p.label.text)
        .add(p.label.motif)
        .add(p.brand)
        .add(p.name);
    for (const catalog::KeptName& face : catalog::face_names(p))
      hash.add(face.where).add(face.name);
    if (!p.contents) continue;
    hash.add(p.contents->color)
        .add(static_cast<std::int64_t>(p.contents->opacity))
        .add(p.contents->particle_mm)
        .add(p.contents->particle_color);
    hash.add_rounded(p.contents->refraction, 1e-3).add_rounded(p.contents->fill, 1e-3);
  }
  return hash.hex();
}

SceneCounts count(const Scene& scene) {
  SceneCounts counts;
  counts.products = scene.products.size();
  counts.skus = scene.catalog.size();
  counts.fixtures = scene.fixtures.size();
  for (const Facing& facing : scene.facings)
    counts.facings += facing.facings;
  return counts;
}

}  // namespace marketgen::scene
