// Worlds of a few quads whose light is known by arithmetic.
#pragma once
#include <memory>

#include "render/path/path_picture.h"
#include "render/stage/world.h"

namespace marketgen::render::raytrace {

inline std::unique_ptr<World> empty_world(const Material& material) {
  auto world = std::make_unique<World>();
  world->device.reset(rtcNewDevice(nullptr));
  world->materials = {material};
  world->exposure = 1e-6F;  // the firefly cap is in units of white: out of the way
  return world;
}

// Everything built so far becomes the room.
inline void finish_world(World& world, const Mesh& mesh, TriangleOwner owner = {1, -1}) {
  append(world.shell, world.shell_glass, mesh, {0, 1}, world, owner);
  for (const Vec3f& p : world.shell.positions)
    world.room.include(p);
  commit(world);
}

// A closed cube of 2 m around the origin, inside out.
inline Mesh cube_room() {
  Mesh mesh;
  add_quad(mesh, {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, 0);  // floor
  add_quad(mesh, {-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}, 0);      // ceiling
  add_quad(mesh, {1, -1, -1}, {-1, -1, -1}, {-1, -1, 1}, {1, -1, 1}, 0);
  add_quad(mesh, {-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}, 0);
  add_quad(mesh, {-1, -1, -1}, {-1, 1, -1}, {-1, 1, 1}, {-1, -1, 1}, 0);
  add_quad(mesh, {1, 1, -1}, {1, -1, -1}, {1, -1, 1}, {1, 1, 1}, 0);
  return mesh;
}

// Mean of the paths through the pixels of `view`: nothing ends in stored light.
inline Vec3f mean_path_light(const World& world, const View& view, int paths) {
  const LightGrid lights(world);
  const scene::Scene none;
  const IrradianceField field(world, lights, none);
  const PathScene scene{world, lights, field};
  const PathSettings settings{mask_opaque, false};
  const int pixels = view.width() * view.height();
  Vec3f sum;
  for (int i = 0; i < paths; ++i) {
    const PathStart start{i % pixels % view.width(),
                          i % pixels / view.width(),
                          static_cast<std::uint32_t>(i / pixels)};
    const Ray ray = eye_ray(view, start);
    const Hit hit = trace_one(world, ray, mask_opaque | mask_glass);
    const PathLight light = trace_path(scene, view, settings, start, ray, hit);
    sum += light.diffuse + light.gloss + light.glow;
  }
  return sum / static_cast<float>(paths);
}

inline View square_view(Vec3 from, Vec3 at, int side_px = 16, double fov_deg = 60) {
  render::Camera camera;
  camera.from = from;
  camera.at = at;
  camera.fov_deg = fov_deg;
  camera.width = camera.height = side_px;
  return View(camera);
}

}  // namespace marketgen::render::raytrace
