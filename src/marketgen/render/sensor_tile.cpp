#include "render/sensor_tile.h"

#include <algorithm>

#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr int most_panes_deep = 4;  // seen through one another
constexpr float behind_pane_m = 2e-3F;

// Rays of any pixels of a tile waiting for a full packet.
struct PixelRays {
  std::array<Ray, packet_size> rays;
  std::array<std::uint16_t, packet_size> pixels;
  std::size_t used = 0;
};

class TileTracer {
 public:
  TileTracer(const World& world, const View& view, const SensorDetail& detail, SensorTile& tile)
      : world_(world),
        view_(view),
        detail_(detail),
        tile_(tile),
        mask_(detail.opaque_mask | (world.has_glass ? mask_glass : 0U)) {}

  void run() {
    for (std::size_t block = 0; block < sensor_tile_pixels / packet_size; ++block) {
      const std::size_t first = block * packet_size;
      if (SensorTile::column_of(first) < tile_.columns && SensorTile::row_of(first) < tile_.rows)
        trace_block(first);
      else
        std::fill_n(tile_.depth.begin() + static_cast<std::ptrdiff_t>(first), packet_size, 0.0F);
    }
    finish_behind();
  }

 private:
  void trace_block(std::size_t first) {
    std::array<Ray, packet_size> rays;
    std::array<Hit, packet_size> hits;
    for (std::size_t k = 0; k < packet_size; ++k) {
      // Pixels past the picture's edge repeat the last one: a full packet is as cheap as a part.
      const int x = std::min(tile_.x0 + SensorTile::column_of(first + k), view_.width() - 1);
      const int y = std::min(tile_.y0 + SensorTile::row_of(first + k), view_.height() - 1);
      rays[k] = view_.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      tile_.direction[first + k] = rays[k].direction;
    }
    trace(world_, rays, hits, mask_, RayBundle::coherent);
    fetch_surfaces(world_, hits);
    for (std::size_t k = 0; k < packet_size; ++k)
      take(first + k, rays[k], hits[k]);
  }

  void take(std::size_t i, const Ray& ray, const Hit& hit) {
    tile_.pane_of[i] = -1;
    tile_.depth[i] = 0;
    if (!hit.any()) return;
    see_surface(world_, ray, hit, view_.footprint(hit.t), detail_.textures, tile_.surface[i]);
    if (tile_.surface[i].glass) {
      tile_.pane_of[i] = static_cast<std::int16_t>(tile_.pane_count);
      TilePane& pane = tile_.panes[tile_.pane_count++];
      pane.pixel = static_cast<std::uint16_t>(i);
      pane.first = tile_.surface[i];
      pane.reflected = reflected_by(pane.first, ray.direction);
      pane.transmittance = pane.first.albedo * (1 - pane.reflected);
      look_behind(i, ray, hit.t);
      return;
    }
    tile_.depth[i] = view_.depth_of(ray, hit.t);
  }

  static float reflected_by(const Surface& pane, Vec3f direction) {
    return fresnel({pane_reflectance, pane_reflectance, pane_reflectance},
                   -dot(pane.normal, direction))
        .x;
  }

  // Goes on behind the pane that was met at `distance`.
  void look_behind(std::size_t i, Ray ray, float distance) {
    ray.near = distance + behind_pane_m;
    behind_.rays[behind_.used] = ray;
    behind_.pixels[behind_.used++] = static_cast<std::uint16_t>(i);
    if (behind_.used == packet_size) trace_behind();
  }

  // Every pass goes through one more pane; the last looks through all that are left.
  void trace_behind() {
    PixelRays now = behind_;
    behind_.used = 0;
    for (int pane = 1; now.used > 0; ++pane) {
      const unsigned mask = pane < most_panes_deep ? mask_ : detail_.opaque_mask;
      std::array<Hit, packet_size> hits;
      trace(world_,
            std::span(now.rays).first(now.used),
            std::span(hits).first(now.used),
            mask,
            RayBundle::scattered);
      PixelRays next;
      for (std::size_t k = 0; k < now.used; ++k) {
        if (!hits[k].any()) continue;
        if (see_behind(now.pixels[k], now.rays[k], hits[k])) continue;
        next.rays[next.used] = now.rays[k];
        next.rays[next.used].near = hits[k].t + behind_pane_m;
        next.pixels[next.used++] = now.pixels[k];
      }
      now = next;
    }
  }

  // Whether the pixel has arrived at something that is no pane.
  bool see_behind(std::size_t i, const Ray& ray, const Hit& hit) {
    const Surface seen = surface_at(world_, ray, hit, view_.footprint(hit.t), detail_.textures);
    if (seen.glass) {
      TilePane& pane = tile_.panes[static_cast<std::size_t>(tile_.pane_of[i])];
      pane.transmittance *= seen.albedo * (1 - reflected_by(seen, ray.direction));
      return false;
    }
    tile_.surface[i] = seen;
    tile_.depth[i] = view_.depth_of(ray, hit.t);
    return true;
  }

  void finish_behind() {
    if (behind_.used > 0) trace_behind();
  }

  const World& world_;
  const View& view_;
  const SensorDetail& detail_;
  SensorTile& tile_;
  unsigned mask_;
  PixelRays behind_;
};

}  // namespace

void trace_tile(
    const World& world, const View& view, int index, const SensorDetail& detail, SensorTile& tile) {
  tile.x0 = index % sensor_tiles_across(view) * sensor_tile_side;
  tile.y0 = index / sensor_tiles_across(view) * sensor_tile_side;
  tile.columns = std::min(sensor_tile_side, view.width() - tile.x0);
  tile.rows = std::min(sensor_tile_side, view.height() - tile.y0);
  tile.pane_count = 0;
  TileTracer(world, view, detail, tile).run();
}

}  // namespace marketgen::raytrace
