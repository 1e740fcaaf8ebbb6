#include "render/stage/world.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float int16_unit = 32767;

std::array<std::int16_t, 3> packed(Vec3f n) {
  const auto pack = [](float x) {
    return static_cast<std::int16_t>(std::lround(std::clamp(x, -1.0F, 1.0F) * int16_unit));
  };
  return {pack(n.x), pack(n.y), pack(n.z)};
}

// log2 of texels per metre across the triangle; 0 without a texture.
float texel_density(const std::array<Vec3f, 3>& p,
                    const std::array<Vec2f, 3>& uv,
                    const Material& material,
                    const World& world) {
  if (material.texture < 0) return 0;
  const Texture& texture = world.textures[static_cast<std::size_t>(material.texture)];
  const float world_area = length(cross(p[1] - p[0], p[2] - p[0]));
  const Vec2f a = uv[1] - uv[0], b = uv[2] - uv[0];
  const float texel_area =
      std::fabs(a.x * b.y - b.x * a.y) * static_cast<float>(texture.width() * texture.height());
  return 0.5F * std::log2(std::max(texel_area, 1e-9F) / std::max(world_area, 1e-12F));
}

RTCGeometry make_geometry(RTCDevice device, const TriangleSet& set, unsigned mask) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
  rtcSetSharedGeometryBuffer(geometry,
                             RTC_BUFFER_TYPE_VERTEX,
                             0,
                             RTC_FORMAT_FLOAT3,
                             set.positions.data(),
                             0,
                             sizeof(Vec3f),
                             set.positions.size());
  rtcSetSharedGeometryBuffer(geometry,
                             RTC_BUFFER_TYPE_INDEX,
                             0,
                             RTC_FORMAT_UINT3,
                             set.triangles.data(),
                             0,
                             sizeof(set.triangles[0]),
                             set.triangles.size());
  rtcSetGeometryMask(geometry, mask);
  rtcCommitGeometry(geometry);
  return geometry;
}

void attach(RTCScene scene, RTCGeometry geometry, unsigned id) {
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

void commit_mesh(RTCDevice device, TracedMesh& mesh) {
  mesh.bvh.reset(rtcNewScene(device));
  rtcSetSceneFlags(mesh.bvh.get(), RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);  // light_through.h
  rtcSetSceneBuildQuality(mesh.bvh.get(), RTC_BUILD_QUALITY_MEDIUM);
  if (!mesh.solid.empty())
    attach(mesh.bvh.get(), make_geometry(device, mesh.solid, mask_solid), mesh_solid_geometry);
  if (!mesh.glass.empty())
    attach(mesh.bvh.get(), make_geometry(device, mesh.glass, mask_glass), mesh_glass_geometry);
  rtcCommitScene(mesh.bvh.get());
}

void find_records(World& world, Instance& instance) {
  const TracedMesh& mesh = world.meshes[instance.mesh];
  instance.records[mesh_solid_geometry] = mesh.solid.records.data();
  instance.records[mesh_glass_geometry] = mesh.glass.records.data();
}

void set_transform(RTCGeometry geometry, const Placement& p) {
  const std::array<float, 12> columns{p.x.x,
                                      p.x.y,
                                      p.x.z,
                                      p.y.x,
                                      p.y.y,
                                      p.y.z,
                                      p.z.x,
                                      p.z.y,
                                      p.z.z,
                                      p.position.x,
                                      p.position.y,
                                      p.position.z};
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
}

RTCGeometry make_instance(RTCDevice device, const Instance& instance, RTCScene mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, mesh);
  set_transform(geometry, instance.world_from_mesh);
  rtcSetGeometryMask(geometry, mask_solid | mask_glass);
  rtcCommitGeometry(geometry);
  return geometry;
}

// Embree reads 16 bytes at a time: a vertex buffer must be readable a little past its end.
void pad_for_embree(TriangleSet& set) {
  set.positions.reserve(set.positions.size() + 1);
}

constexpr float tangent_steps = 32768;  // of a full turn

}  // namespace

std::uint16_t packed_tangent(const std::array<Vec3f, 3>& p,
                             const std::array<Vec2f, 3>& uv,
                             Vec3f face_normal) {
  const Vec3f e1 = p[1] - p[0], e2 = p[2] - p[0];
  const Vec2f a = uv[1] - uv[0], b = uv[2] - uv[0];
  const float area = a.x * b.y - b.x * a.y;
  const float sign = area < 0 ? -1.0F : 1.0F;
  const Vec3f along = (e1 * b.y - e2 * a.y) * sign, down = (e2 * a.x - e1 * b.x) * sign;
  const TangentFrame frame(face_normal);
  const float turn = std::atan2(dot(along, frame.bitangent), dot(along, frame.tangent)) / two_pi;
  const auto step = static_cast<std::uint32_t>(std::lround((turn + 1) * tangent_steps)) % 32768U;
  // v grows downwards in the texture.
  const bool mirrored = dot(cross(face_normal, along), down) > 0;
  return static_cast<std::uint16_t>(step << 1 | (mirrored ? 1U : 0U));
}

TextureAxes texture_axes(std::uint16_t packed, Vec3f face_normal) {
  const TangentFrame frame(face_normal);
  const float turn = static_cast<float>(packed >> 1) * (two_pi / tangent_steps);
  const Vec3f along = frame.tangent * std::cos(turn) + frame.bitangent * std::sin(turn);
  const Vec3f up = cross(face_normal, along);
  return {along, (packed & 1U) != 0 ? -up : up};
}

AreaLight make_area_light(Vec3f corner, Vec3f edge_u, Vec3f edge_v, Vec3f radiance) {
  const Vec3f across = cross(edge_u, edge_v);
  return {corner, edge_u, edge_v, normalized(across), radiance, length(across)};
}

Placement placement_of(const Pose& pose) {
  return {to_float(rotate(pose.rotation, {1, 0, 0})),
          to_float(rotate(pose.rotation, {0, 1, 0})),
          to_float(rotate(pose.rotation, {0, 0, 1})),
          to_float(pose.position)};
}

void append(TriangleSet& solid,
            TriangleSet& glass,
            const Mesh& mesh,
            const std::vector<std::uint16_t>& materials_of_surfaces,
            const World& world,
            TriangleOwner owner) {
  const std::array<TriangleSet*, 2> sets{&solid, &glass};
  const std::array<std::uint32_t, 2> base{static_cast<std::uint32_t>(solid.positions.size()),
                                          static_cast<std::uint32_t>(glass.positions.size())};
  std::array<bool, 2> used{};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint16_t material_id = materials_of_surfaces[mesh.surfaces[i]];
    const Material& material = world.materials[material_id];
    const std::size_t side = material.glass ? 1 : 0;
    used[side] = true;
    const auto& corners = mesh.triangles[i];
    TriangleRecord record;
    std::array<Vec3f, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = mesh.positions[corners[k]];
      record.normals[k] = packed(mesh.normals[corners[k]]);
      record.uvs[k] = mesh.uvs[corners[k]];
    }
    record.face_normal = packed(normalized(cross(p[1] - p[0], p[2] - p[0])));
    record.texel_density = texel_density(p, record.uvs, material, world);
    record.material = material_id;
    if (material.relief >= 0)
      record.tangent = packed_tangent(p, record.uvs, unpacked_normal(record.face_normal));
    record.light = owner.light;
    record.owner = owner.id;
    sets[side]->triangles.push_back(
        {corners[0] + base[side], corners[1] + base[side], corners[2] + base[side]});
    sets[side]->records.push_back(record);
  }
  for (std::size_t side = 0; side < sets.size(); ++side) {
    if (!used[side]) continue;
    sets[side]->positions.insert(
        sets[side]->positions.end(), mesh.positions.begin(), mesh.positions.end());
  }
}

void commit(World& world) {
  RTCDevice device = world.device.get();
  for (TracedMesh& mesh : world.meshes) {
    pad_for_embree(mesh.solid);
    pad_for_embree(mesh.glass);
    world.has_glass = world.has_glass || !mesh.glass.empty();
  }
  parallel_for(world.meshes.size(), [&](std::size_t i) {
    if (!world.meshes[i].bvh) commit_mesh(device, world.meshes[i]);
  });
  for (TriangleSet* set : {&world.shell, &world.shell_glass, &world.ceiling})
    pad_for_embree(*set);
  world.has_glass = world.has_glass || !world.shell_glass.empty();

  world.bvh.reset(rtcNewScene(device));
  RTCScene top = world.bvh.get();
  rtcSetSceneFlags(top, RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  rtcSetSceneBuildQuality(top, RTC_BUILD_QUALITY_MEDIUM);
  if (!world.shell.empty())
    attach(top, make_geometry(device, world.shell, mask_solid), shell_geometry);
  if (!world.shell_glass.empty())
    attach(top, make_geometry(device, world.shell_glass, mask_glass), shell_glass_geometry);
  if (!world.ceiling.empty())
    attach(top, make_geometry(device, world.ceiling, mask_ceiling), ceiling_geometry);
  for (std::size_t i = 0; i < world.instances.size(); ++i) {
    Instance& instance = world.instances[i];
    find_records(world, instance);
    attach(top,
           make_instance(device, instance, world.meshes[instance.mesh].bvh.get()),
           first_instance_geometry + static_cast<unsigned>(i));
  }
  rtcCommitScene(top);
  world.actors.first_mesh = world.meshes.size();
  world.actors.first_instance = world.instances.size();
  world.actors.first_material = world.materials.size();
}

void drop_bvhs(World& world) {
  world.actors.bvh.reset();
  world.bvh.reset();
  for (TracedMesh& mesh : world.meshes)
    mesh.bvh.reset();
}

void commit_actors(World& world) {
  ActorRows& actors = world.actors;
  actors.bvh.reset();
  if (world.instances.size() == actors.first_instance) return;
  RTCDevice device = world.device.get();
  parallel_for(world.meshes.size() - actors.first_mesh, [&](std::size_t k) {
    TracedMesh& mesh = world.meshes[actors.first_mesh + k];
    if (mesh.bvh) return;
    pad_for_embree(mesh.solid);
    commit_mesh(device, mesh);
  });
  actors.bvh.reset(rtcNewScene(device));
  rtcSetSceneFlags(actors.bvh.get(),
                   RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  for (std::size_t i = actors.first_instance; i < world.instances.size(); ++i) {
    Instance& instance = world.instances[i];
    find_records(world, instance);
    attach(actors.bvh.get(),
           make_instance(device, instance, world.meshes[instance.mesh].bvh.get()),
           static_cast<unsigned>(i - actors.first_instance));
  }
  rtcCommitScene(actors.bvh.get());
}

void update_actors(World& world, std::span<const std::size_t> instances) {
  const ActorRows& actors = world.actors;
  for (const std::size_t i : instances) {
    RTCGeometry geometry =
        rtcGetGeometry(actors.bvh.get(), static_cast<unsigned>(i - actors.first_instance));
    set_transform(geometry, world.instances[i].world_from_mesh);
    rtcCommitGeometry(geometry);
  }
  if (actors.bvh) rtcCommitScene(actors.bvh.get());
}

void leave_out_hidden(World& world, const std::vector<std::uint8_t>& before) {
  bool changed = false;
  for (std::size_t i = 0; i < world.actors.first_instance; ++i) {
    const bool was = i < before.size() && before[i] != 0, is = world.hidden.has(i);
    if (was == is) continue;
    changed = true;
    RTCGeometry geometry =
        rtcGetGeometry(world.bvh.get(), first_instance_geometry + static_cast<unsigned>(i));
    if (is)
      rtcDisableGeometry(geometry);
    else
      rtcEnableGeometry(geometry);
  }
  if (changed) rtcCommitScene(world.bvh.get());
}

}  // namespace marketgen::render::raytrace
