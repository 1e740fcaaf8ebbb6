#include "render/light/lamp.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float strip_lumens_per_m = 420;    // LED strips of retail coolers: 350-550 lm/m
constexpr float brightest_cd_per_m2 = 6000;  // diffusing covers
constexpr float covered_within_m = 0.03F;
constexpr int probes_each_way = 3;
constexpr int covered_probes = 7;  // of 9: something lies right before the face

struct Face {
  Vec3f corner, u, v;
};

std::array<Face, 6> faces_of(Vec3f h) {
  const Vec3f x{2 * h.x, 0, 0}, y{0, 2 * h.y, 0}, z{0, 0, 2 * h.z};
  return {Face{{-h.x, -h.y, -h.z}, x, z},
          Face{{h.x, h.y, -h.z}, -x, z},
          Face{{-h.x, h.y, -h.z}, -y, z},
          Face{{h.x, -h.y, -h.z}, y, z},
          Face{{-h.x, -h.y, h.z}, x, y},
          Face{{-h.x, h.y, -h.z}, x, -y}};
}

bool is_covered(const TracedMesh& mesh, const AreaLight& light) {
  int blocked = 0;
  for (int i = 0; i < probes_each_way; ++i) {
    for (int j = 0; j < probes_each_way; ++j) {
      const float u = (static_cast<float>(i) + 0.5F) / probes_each_way,
                  v = (static_cast<float>(j) + 0.5F) / probes_each_way;
      const Vec3f from = light.corner + light.edge_u * u + light.edge_v * v + light.normal * 5e-4F;
      RTCRay ray{};
      ray.org_x = from.x;
      ray.org_y = from.y;
      ray.org_z = from.z;
      ray.dir_x = light.normal.x;
      ray.dir_y = light.normal.y;
      ray.dir_z = light.normal.z;
      ray.tfar = covered_within_m;
      ray.mask = mask_opaque;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      rtcOccluded1(mesh.bvh.get(), &context, &ray);
      if (ray.tfar < 0) ++blocked;
    }
  }
  return blocked >= covered_probes;
}

// The material of a mesh's light.
std::uint16_t material_of(const TracedMesh& mesh, std::size_t light) {
  const auto shows = [&](const TriangleRecord& record) {
    return record.light == static_cast<std::int32_t>(light);
  };
  return std::find_if(mesh.solid.records.begin(), mesh.solid.records.end(), shows)->material;
}

// Lights of one box share a material and follow one another.
void switch_on(World& world, TracedMesh& mesh) {
  for (std::size_t first = 0; first < mesh.lights.size(); first += 6) {
    float free_area = 0, longest = 0;
    for (std::size_t i = first; i < first + 6; ++i) {
      AreaLight& light = mesh.lights[i];
      longest = std::max({longest, length(light.edge_u), length(light.edge_v)});
      if (is_covered(mesh, light))
        light.radiance = {};
      else
        free_area += light.area;
    }
    Material& material = world.materials[material_of(mesh, first)];
    const float radiance = lamp_radiance(longest, free_area);
    material.emission = material.emission * radiance;
    for (std::size_t i = first; i < first + 6; ++i)
      mesh.lights[i].radiance = mesh.lights[i].radiance * radiance;
  }
}

}  // namespace

float lamp_radiance(float length_m, float area_m2) {
  return std::min(brightest_cd_per_m2,
                  strip_lumens_per_m * length_m / (pi * std::max(area_m2, 1e-4F)));
}

void add_lamp_box(const World& world,
                  TracedMesh& mesh,
                  const Placement& mesh_from_box,
                  Vec3f half_size,
                  std::uint16_t material) {
  for (const Face& face : faces_of(half_size)) {
    const Vec3f corner = mesh_from_box(face.corner), u = mesh_from_box.turn(face.u),
                v = mesh_from_box.turn(face.v);
    Mesh quad;
    add_quad(quad, corner, corner + u, corner + u + v, corner + v, 0);
    append(mesh.solid,
           mesh.glass,
           quad,
           {material},
           world,
           {0, static_cast<std::int32_t>(mesh.lights.size())});
    mesh.lights.push_back(make_area_light(corner, u, v, world.materials[material].emission));
  }
}

void switch_on_lamps(World& world) {
  for (TracedMesh& mesh : world.meshes)
    switch_on(world, mesh);
  for (Instance& instance : world.instances) {
    instance.first_light = static_cast<std::int32_t>(world.lights.size());
    for (AreaLight light : world.meshes[instance.mesh].lights) {
      light.corner = instance.world_from_mesh(light.corner);
      light.edge_u = instance.world_from_mesh.turn(light.edge_u);
      light.edge_v = instance.world_from_mesh.turn(light.edge_v);
      light.normal = instance.world_from_mesh.turn(light.normal);
      world.lights.push_back(light);
    }
  }
}

}  // namespace marketgen::render::raytrace
