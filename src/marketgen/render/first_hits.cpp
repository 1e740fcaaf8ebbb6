#include "render/first_hits.h"

#include <algorithm>

#include "render/render.h"
#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr int block = 4;            // one packet: 4 x 4 pixels
constexpr int most_seen_panes = 4;  // seen through one another
constexpr float past_pane_m = 2e-3F;
constexpr float least_bare_metal = 0.5F;  // metallic; lacquered tin has 0.3

std::size_t lane_pixel(int bx, int by, std::size_t lane) {
  const int x = bx * block + static_cast<int>(lane) % block;
  const int y = by * block + static_cast<int>(lane) / block;
  return static_cast<std::size_t>(y * tile_size + x);
}

void trace_block(
    const World& world, const View& view, Tile& tile, int bx, int by, unsigned opaque_mask) {
  std::array<Ray, packet_size> rays;
  std::array<Hit, packet_size> solid, glass;
  for (std::size_t k = 0; k < packet_size; ++k) {
    const std::size_t i = lane_pixel(bx, by, k);
    // Pixels past the picture's edge repeat the last one: a full packet is as cheap as a part of
    // it.
    const int x = std::min(tile.x_of(i), view.width() - 1),
              y = std::min(tile.y_of(i), view.height() - 1);
    rays[k] = view.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
  }
  trace(world, rays, solid, opaque_mask, RayBundle::coherent);
  std::array<Ray, packet_size> before = rays;
  for (std::size_t k = 0; k < packet_size; ++k)
    before[k].far = solid[k].t;
  if (world.has_glass) trace(world, before, glass, mask_glass, RayBundle::coherent);
  for (std::size_t k = 0; k < packet_size; ++k) {
    FirstHit& hit = tile.hits[lane_pixel(bx, by, k)];
    hit.ray = rays[k];
    hit.any = solid[k].any();
    if (hit.any) hit.surface = surface_at(world, rays[k], solid[k], view.footprint(solid[k].t));
    hit.glass.reset();
    if (world.has_glass && glass[k].any()) hit.glass = glass_before(world, rays[k], solid[k].t);
  }
}

float pane_fresnel(const Surface& pane, Vec3f direction) {
  return fresnel({pane_reflectance, pane_reflectance, pane_reflectance},
                 -dot(pane.relief_normal, direction))
      .x;
}

Matter matter_of(const World& world, const FirstHit& hit) {
  if (hit.glass) return Matter::glass;
  if (!hit.any) return Matter::none;
  return matter_of(world, hit.surface);
}

}  // namespace

Matter matter_of(const World& world, const Surface& surface) {
  if (world.materials[surface.material].clear) return Matter::clear;
  return surface.metallic > least_bare_metal ? Matter::metal : Matter::solid;
}

int tiles_across(const View& view) {
  return (view.width() + tile_size - 1) / tile_size;
}
int tiles_down(const View& view) {
  return (view.height() + tile_size - 1) / tile_size;
}

std::optional<GlassLayer> glass_before(const World& world, const Ray& ray, float far) {
  std::optional<GlassLayer> layer;
  Ray rest = ray;
  rest.far = far;
  for (int pane = 0; pane < most_seen_panes && rest.near < far; ++pane) {
    const Hit hit = trace_one(world, rest, mask_glass);
    if (!hit.any()) break;
    const Surface surface = surface_at(world, ray, hit, 0);
    const float reflected = pane_fresnel(surface, ray.direction);
    if (!layer) layer = GlassLayer{surface, {1, 1, 1}, reflected};
    layer->transmittance *= surface.albedo * (1 - reflected);
    rest.near = hit.t + past_pane_m;
  }
  return layer;
}

void find_first_hits(
    const World& world, const View& view, int index, unsigned opaque_mask, Tile& tile) {
  tile.x0 = index % tiles_across(view) * tile_size;
  tile.y0 = index / tiles_across(view) * tile_size;
  tile.columns = std::min(tile_size, view.width() - tile.x0);
  tile.rows = std::min(tile_size, view.height() - tile.y0);
  for (int by = 0; by * block < tile.rows; ++by) {
    for (int bx = 0; bx * block < tile.columns; ++bx)
      trace_block(world, view, tile, bx, by, opaque_mask);
  }
}

void store_first_hits(const World& world, const View& view, const Tile& tile, Film& film) {
  for (std::size_t k = 0; k < tile_pixels; ++k) {
    if (!tile.inside(k)) continue;
    const FirstHit& hit = tile.hits[k];
    const std::size_t i = film.index(tile.x_of(k), tile.y_of(k));
    film.matter[i] = static_cast<std::uint8_t>(matter_of(world, hit));
    film.transmittance.set(i, hit.glass ? hit.glass->transmittance : Vec3f{1, 1, 1});
    if (!hit.any) {
      film.emission.set(i, world.surroundings.radiance(hit.ray.direction));
      film.position.set(i, hit.ray.origin + hit.ray.direction * 1e4F);
      film.normal.set(i, -hit.ray.direction);
      continue;
    }
    const Surface& s = hit.surface;
    film.position.set(i, s.position);
    film.normal.set(i, s.normal);
    film.depth[i] = view.depth_of(hit.ray, s.distance);
    film.instance[i] = s.id;
    film.material[i] = s.material;
    film.albedo.set(i, s.diffuse());
    film.reflectance.set(
        i, rough_fresnel(s.reflectance(), -dot(s.relief_normal, hit.ray.direction), s.roughness));
    film.emission.set(i, s.emission);
  }
}

}  // namespace marketgen::raytrace
