#include "render/stage/actor_stage.h"

#include <algorithm>
#include <string>
#include <utility>

namespace marketgen::render::raytrace {
namespace {

constexpr std::size_t max_materials = 65'535;
// Of a store whose search tree is built anew when other things stand elsewhere: some milliseconds.
// A ray that has to pass a hidden place is traced again, alone, from there on.
constexpr std::size_t max_rebuilt = 8'000;

Material material_of(const ActorSurface& surface) {
  return {.color = surface.color,
          .roughness = surface.roughness,
          .metallic = surface.metallic,
          .scatter_m = surface.scatter_m};
}

std::size_t surface_count(const std::vector<Actor>& actors) {
  std::size_t count = 0;
  for (const Actor& actor : actors) {
    for (const ActorBody& body : actor.bodies)
      count += body.surfaces.size();
  }
  return count;
}

}  // namespace

Result<void> ActorStage::set(const std::vector<Actor>& actors) {
  for (const Actor& actor : actors)
    MARKETGEN_CHECK(check_actor(actor));
  if (world_.actors.first_material + surface_count(actors) > max_materials)
    return Error{"render.bad_actor", "actors", "the bodies have more than 65,000 surfaces in all"};
  clear();
  for (std::size_t k = 0; k < actors.size(); ++k) {
    Member member{actors[k].name, {}};
    for (const ActorBody& body : actors[k].bodies)
      member.instances.push_back(add_body(body, first_id_ + static_cast<std::uint32_t>(k)));
    members_.push_back(std::move(member));
  }
  add_displaced();
  return commit();
}

Result<void> ActorStage::commit() {
  put_.clear();
  commit_actors(world_);
  if (rtcGetDeviceError(world_.device.get()) != RTC_ERROR_NONE)
    return Error{"io.out_of_memory", "actors", "Embree could not build the actors' search tree"};
  return {};
}

Result<void> ActorStage::displace(std::vector<Displaced> rows) {
  const auto same_row = [](const Displaced& a, const Displaced& b) {
    return a.instance == b.instance;
  };
  const bool same =
      std::equal(rows.begin(), rows.end(), displaced_.begin(), displaced_.end(), same_row);
  displaced_ = std::move(rows);
  if (same) {
    for (std::size_t i = 0; i < displaced_.size(); ++i) {
      world_.instances[first_displaced_ + i].shelf = displaced_[i].shelf;
      put(first_displaced_ + i, displaced_[i].world_from_mesh);
    }
    return {};
  }
  world_.instances.resize(first_displaced_ == 0 ? world_.instances.size() : first_displaced_);
  hide_displaced();
  add_displaced();
  return commit();
}

void ActorStage::put(std::size_t instance, const Placement& place) {
  if (world_.instances[instance].world_from_mesh == place) return;
  world_.instances[instance].world_from_mesh = place;
  put_.push_back(instance);
}

void ActorStage::settle() {
  if (put_.empty()) return;
  update_actors(world_, put_);
  put_.clear();
}

void ActorStage::hide_displaced() {
  const HiddenRows before = std::exchange(world_.hidden, {});
  if (!displaced_.empty()) world_.hidden.is_hidden.resize(world_.actors.first_instance);
  for (const Displaced& row : displaced_) {
    world_.hidden.is_hidden[row.instance] = 1;
    const Instance& instance = world_.instances[row.instance];
    for (const Vec3f& p : world_.meshes[instance.mesh].solid.positions)
      world_.hidden.bounds.include(instance.world_from_mesh(p));
    for (const Vec3f& p : world_.meshes[instance.mesh].glass.positions)
      world_.hidden.bounds.include(instance.world_from_mesh(p));
  }
  if (world_.actors.first_instance <= max_rebuilt)
    leave_out_hidden(world_, before.is_hidden);
  else
    world_.hidden.in_bvh = !displaced_.empty();
}

void ActorStage::add_displaced() {
  first_displaced_ = world_.instances.size();
  for (const Displaced& row : displaced_) {
    Instance copy = world_.instances[row.instance];
    copy.world_from_mesh = row.world_from_mesh;
    copy.shelf = row.shelf;
    world_.instances.push_back(copy);
  }
}

Result<void> ActorStage::move(std::size_t actor, std::span<const Pose> world_from_body) {
  if (actor >= members_.size())
    return Error{"render.bad_actor",
                 "actor " + std::to_string(actor),
                 "there are " + std::to_string(members_.size()) + " actors"};
  const Member& member = members_[actor];
  if (world_from_body.size() != member.instances.size())
    return Error{"render.bad_actor",
                 member.name,
                 "expected " + std::to_string(member.instances.size()) +
                     " poses, one a body; got " + std::to_string(world_from_body.size())};
  for (const Pose& pose : world_from_body)
    MARKETGEN_CHECK(check_body_pose(pose, member.name));
  for (std::size_t i = 0; i < world_from_body.size(); ++i) {
    if (member.instances[i] < 0) continue;
    put(static_cast<std::size_t>(member.instances[i]), placement_of(world_from_body[i]));
  }
  return {};
}

void ActorStage::clear() {
  members_.clear();
  world_.actors.bvh.reset();
  world_.instances.resize(world_.actors.first_instance);
  world_.meshes.resize(world_.actors.first_mesh);
  world_.materials.resize(world_.actors.first_material);
}

std::int32_t ActorStage::add_body(const ActorBody& body, std::uint32_t id) {
  if (body.mesh.triangles.empty()) return -1;
  std::vector<std::uint16_t> materials;
  for (const ActorSurface& surface : body.surfaces) {
    materials.push_back(static_cast<std::uint16_t>(world_.materials.size()));
    world_.materials.push_back(material_of(surface));
  }
  TracedMesh mesh;
  append(mesh.solid, mesh.glass, body.mesh, materials, world_, {id, -1});
  Instance instance;
  instance.mesh = static_cast<std::uint32_t>(world_.meshes.size());
  instance.id = id;
  instance.world_from_mesh = placement_of(body.world_from_body);
  world_.meshes.push_back(std::move(mesh));
  world_.instances.push_back(instance);
  return static_cast<std::int32_t>(world_.instances.size()) - 1;
}

}  // namespace marketgen::render::raytrace
