#include "render/sensor/sensor_packs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "render/path/scattering.h"
#include "render/ray_queue.h"
#include "render/stage/clear_pack.h"

namespace marketgen::render::raytrace {
namespace {

constexpr int max_pack_crossings = 8;  // of walls, all packs together
constexpr float min_share = 0.01F;     // of light: what lies behind less is not looked for

// A look through one pixel's packs.
struct PackWalk {
  Ray ray;
  Vec3f left{1, 1, 1};  // share of light that comes back this way
  float travelled = 0;  // from the eye
  std::uint32_t instance = 0;
  int packs = 0, crossings = 0;
  const Material* inside = nullptr;  // wall of the pack whose contents the ray is in

  void go(float distance) {
    travelled += distance;
    if (inside == nullptr) return;
    const Vec3f depth = inside->absorption_per_m * distance;
    left *= Vec3f{std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)};
  }

  // Through a wall, bent by what fills the pack; mirrored inside where nothing gets out.
  void cross(const Surface& wall, const Material& material) {
    const Vec3f beyond = wall.position - wall.face_normal * (2 * surface_lift_m);
    const bool bends = material.refraction > 1;
    if (!bends) {
      ray = {beyond, ray.direction};
      return;
    }
    const float eta = wall.back_face ? 1 / material.refraction : material.refraction;
    const std::optional<Vec3f> turned = refracted(ray.direction, wall.normal, eta);
    if (!turned) {
      ray = {wall.position, mirrored(ray.direction, wall.normal)};
      return;
    }
    inside = wall.back_face ? nullptr : &material;
    ray = {beyond, *turned};
  }
};

class PackLooker {
 public:
  PackLooker(const World& world, const View& view, const SensorDetail& detail, SensorTile& tile)
      : world_(world), view_(view), detail_(detail), tile_(tile) {}

  void run() {
    for (std::size_t w = 0; w < tile_.wall_count; ++w) {
      const TilePane& wall = tile_.walls[w];
      if (detail_.share_packs && &tile_.model_of(wall) != &wall) continue;
      PackWalk& walk = walks_[w];
      walk = {};
      walk.ray.direction = tile_.direction_of(wall.pixel);
      walk.left = Vec3f{1, 1, 1} * (1 - wall.reflected);
      walk.travelled = wall.first.distance;
      walk.instance = wall.instance;
      enter(w, wall.first);
    }
    while (behind_.used > 0)
      look_behind();
    if (detail_.share_packs) share();
  }

 private:
  const Material& material_of(const Surface& surface) const {
    return world_.materials[surface.material];
  }

  // Hands what the looking pixels have found to their neighbours.
  void share() {
    for (TilePane& wall : std::span(tile_.walls).first(tile_.wall_count)) {
      const TilePane& model = tile_.model_of(wall);
      if (&model == &wall) continue;
      wall.transmittance = model.transmittance;
      const std::size_t from = model.pixel / lane_count, source = model.pixel % lane_count;
      const std::size_t to = wall.pixel / lane_count, k = wall.pixel % lane_count;
      set_surface(tile_.surface[to], k, tile_.surface_of(model.pixel), false);
      tile_.depth[to].set(k, tile_.depth[from][source]);
      set_lane(tile_.direction[to], k, tile_.direction_of(model.pixel));
    }
  }

  // From a wall of a pack to something in it, or to where the ray leaves it.
  void enter(std::size_t w, Surface surface) {
    PackWalk& walk = walks_[w];
    for (; walk.crossings < max_pack_crossings; ++walk.crossings) {
      walk.cross(surface, material_of(surface));
      const bool out = surface.back_face && dot(walk.ray.direction, surface.face_normal) < 0;
      if (out) return leave(w);
      const Hit hit = trace_instance(world_, walk.instance, walk.ray);
      if (!hit.any()) return leave(w);
      walk.go(hit.t);
      surface =
          surface_at(world_, walk.ray, hit, view_.footprint(walk.travelled), TextureDetail::level);
      if (material_of(surface).clear) continue;
      if (walk.inside != nullptr && surface.back_face) surface.albedo = label_back;
      break;
    }
    arrive(w, surface);
  }

  void leave(std::size_t w) {
    PackWalk& walk = walks_[w];
    walk.inside = nullptr;
    if (largest(walk.left) < min_share) return arrive(w, tile_.walls[w].first);
    if (behind_.add(w, walk.ray)) look_behind();
  }

  void look_behind() {
    RayQueue now = behind_;
    behind_.used = 0;
    now.fill();
    trace(world_, now.packet, now.used, detail_.opaque_mask, RayBundle::coherent);
    for (std::size_t k = 0; k < now.used; ++k) {
      const std::size_t w = now.pixels[k];
      const Hit hit = hit_in(now.packet, k);
      if (hit.any())
        see(w, hit);
      else
        see_nothing(w);
    }
  }

  void see(std::size_t w, const Hit& hit) {
    PackWalk& walk = walks_[w];
    walk.go(hit.t);
    const Surface surface =
        surface_at(world_, walk.ray, hit, view_.footprint(walk.travelled), TextureDetail::level);
    if (!material_of(surface).clear) return arrive(w, surface);
    if (hit.instance != walk.instance && ++walk.packs == detail_.packs_deep)
      return arrive(w, surface);
    walk.instance = hit.instance;
    enter(w, surface);
  }

  void see_nothing(std::size_t w) {
    const std::size_t i = tile_.walls[w].pixel;
    tile_.depth[i / lane_count].set(i % lane_count, 0);
    finish(w);
  }

  void arrive(std::size_t w, Surface surface) {
    const std::size_t i = tile_.walls[w].pixel;
    surface.distance = walks_[w].travelled;
    set_surface(tile_.surface[i / lane_count], i % lane_count, surface, false);
    tile_.depth[i / lane_count].set(i % lane_count, surface.distance);
    finish(w);
  }

  void finish(std::size_t w) {
    const std::size_t i = tile_.walls[w].pixel;
    set_lane(tile_.direction[i / lane_count], i % lane_count, walks_[w].ray.direction);
    tile_.walls[w].transmittance = walks_[w].left;
  }

  const World& world_;
  const View& view_;
  const SensorDetail& detail_;
  SensorTile& tile_;
  RayQueue behind_;  // its pixels are walls here
  std::array<PackWalk, sensor_tile_pixels> walks_;
};

}  // namespace

void look_through_packs(const World& world,
                        const View& view,
                        const SensorDetail& detail,
                        SensorTile& tile) {
  if (tile.wall_count > 0) PackLooker(world, view, detail, tile).run();
}

}  // namespace marketgen::render::raytrace
