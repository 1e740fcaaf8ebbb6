#include "render/sensor/sensor_panes.h"

#include <algorithm>
#include <span>

#include "render/ray_queue.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float let_in_share = 0.7F;  // of the light before a clear pack, behind it

class PaneLighter {
 public:
  PaneLighter(const Lighting& lighting,
              const View& view,
              const SensorEffort& effort,
              SensorTile& tile)
      : lighting_(lighting),
        view_(view),
        effort_(effort),
        tile_(tile),
        white_(1 / lighting.world.exposure) {}

  void run() {
    if (effort_.mirror_panes)
      mirror_panes();
    else
      light_panes();
    light_walls();
  }

 private:
  // Stored light stands for what panes mirror.
  void light_panes() {
    for (TilePane& pane : std::span(tile_.panes).first(tile_.pane_count))
      add(pane);
    light_few();
  }

  // The same of packs; a quarter of the pixels stand for their neighbours.
  void light_walls() {
    const std::span<TilePane> walls = std::span(tile_.walls).first(tile_.wall_count);
    for (TilePane& wall : walls) {
      if (&tile_.model_of(wall) == &wall) add(wall);
    }
    light_few();
    for (TilePane& wall : walls) {
      const TilePane& model = tile_.model_of(wall);
      if (&model != &wall) wall.light = model.light * (wall.reflected / model.reflected);
    }
  }

  void add(TilePane& pane) {
    few_[few_count_++] = &pane;
    if (few_count_ == lane_count) light_few();
  }

  // Those that wait, at most eight, side by side.
  void light_few() {
    const std::span<TilePane* const> panes = std::span(few_).first(few_count_);
    few_count_ = 0;
    if (panes.empty()) return;
    PanelReflection::Points points;
    for (std::size_t k = 0; k < panes.size(); ++k) {
      set_lane(points.position, k, panes[k]->first.position);
      set_lane(points.normal, k, panes[k]->first.relief_normal);
      set_lane(points.mirror, k, panes[k]->mirror);
      points.roughness.set(k, panes[k]->first.roughness);
    }
    const PanelReflection::Seen seen = lighting_.panels.at(points);
    const unsigned hidden = effort_.panel_shadows ? hidden_panels(panes, seen) : 0;
    for (std::size_t k = 0; k < panes.size(); ++k) {
      TilePane& pane = *panes[k];
      const Float4 around =
          lighting_.field.at(place_of(pane.first), Float4(pane.first.normal), Float4(pane.mirror))
              .mirror;
      const Vec3f panels = (hidden >> k & 1U) != 0 ? Vec3f{} : lane(seen.radiance, k);
      pane.light = ((around * inverse_pi).xyz() + panels) * pane.reflected;
    }
  }

  // Bits of those at whose panels something stands in the way.
  unsigned hidden_panels(std::span<TilePane* const> panes,
                         const PanelReflection::Seen& seen) const {
    std::array<Ray, lane_count> rays;
    std::array<std::size_t, lane_count> whose{};
    std::array<bool, lane_count> blocked{};
    std::size_t used = 0;
    for (std::size_t k = 0; k < panes.size(); ++k) {
      const float shows = largest(lane(seen.radiance, k)) * panes[k]->reflected;
      if (shows <= min_panel_share * white_) continue;
      whose[used] = k;
      rays[used++] = {
          panes[k]->first.position, panes[k]->mirror, 0, seen.distance[k] - shadow_end_m};
    }
    if (used == 0) return 0;
    find_blocked(
        lighting_.world, std::span(rays).first(used), std::span(blocked).first(used), mask_solid);
    unsigned hidden = 0;
    for (std::size_t i = 0; i < used; ++i)
      hidden |= (blocked[i] ? 1U : 0U) << whose[i];
    return hidden;
  }

  void mirror_panes() {
    for (std::size_t p = 0; p < tile_.pane_count; ++p) {
      const TilePane& pane = tile_.panes[p];
      if (queue_.add(p, {pane.first.position, pane.mirror})) finish_panes();
    }
    if (queue_.used > 0) finish_panes();
  }

  // The queue's numbers are panes here.
  void finish_panes() {
    const World& world = lighting_.world;
    queue_.fill();
    trace(world, queue_.packet, queue_.used, mask_opaque, RayBundle::scattered);
    for (std::size_t k = 0; k < queue_.used; ++k) {
      TilePane& pane = tile_.panes[queue_.pixels[k]];
      const Ray ray = ray_in(queue_.packet.ray, k);
      const Hit hit = hit_in(queue_.packet, k);
      Vec3f light = world.surroundings.radiance(ray.direction);
      if (hit.any()) {
        const float footprint = view_.footprint(pane.first.distance + hit.t);
        const Surface seen = surface_at(world, ray, hit, footprint, TextureDetail::level);
        light = stored_radiance(lighting_, seen, ray.direction, Lamps::seen);
      }
      pane.light = light * pane.reflected;
    }
    queue_.used = 0;
  }

  const Lighting& lighting_;
  const View& view_;
  const SensorEffort& effort_;
  SensorTile& tile_;
  float white_;  // radiance shown as white
  RayQueue queue_;
  std::array<TilePane*, lane_count> few_{};
  std::size_t few_count_ = 0;
};

}  // namespace

void light_panes(const Lighting& lighting,
                 const View& view,
                 const SensorEffort& effort,
                 SensorTile& tile) {
  PaneLighter(lighting, view, effort, tile).run();
}

Vec3f light_let_in(const Lighting& lighting,
                   const SensorTile& tile,
                   std::size_t pixel,
                   Vec3f normal,
                   Vec3f behind) {
  if (tile.wall_count == 0 || tile.wall_of[pixel] < 0) return {};
  const TilePane& wall = tile.walls[static_cast<std::size_t>(tile.wall_of[pixel])];
  const Vec3f more = lighting.field.at(place_of(wall.first), normal) - behind;
  return Vec3f{std::max(more.x, 0.0F), std::max(more.y, 0.0F), std::max(more.z, 0.0F)} *
         wall.transmittance * let_in_share;
}

}  // namespace marketgen::render::raytrace
