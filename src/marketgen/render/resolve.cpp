#include "render/resolve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "render/shading_math.h"
#include "render/tone.h"

namespace marketgen::raytrace {
namespace {

constexpr std::size_t most_edge_samples = 8;
// Rooks in the pixel, the first n of which are spread for n = 2, 4 and 8.
constexpr std::array<Vec2f, most_edge_samples> offsets{Vec2f{0.125F, 0.625F},
                                                       {0.875F, 0.375F},
                                                       {0.375F, 0.125F},
                                                       {0.625F, 0.875F},
                                                       {0.25F, 0.9375F},
                                                       {0.75F, 0.0625F},
                                                       {0.0625F, 0.25F},
                                                       {0.9375F, 0.75F}};
constexpr float same_plane_m = 0.02F, same_plane_per_m = 0.005F;
constexpr float same_facing = 0.85F;
// A sample brighter than this counts as this much: lamps' edges would stay jagged when tone mapping
// clips them afterwards.
constexpr float brightest_sample = 3;

std::array<std::size_t, 9> neighbours(const Film& film, int x, int y) {
  std::array<std::size_t, 9> list{film.index(x, y)};
  std::size_t used = 1;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) continue;
      list[used++] =
          film.index(std::clamp(x + dx, 0, film.width - 1), std::clamp(y + dy, 0, film.height - 1));
    }
  }
  return list;
}

bool same_surface(const Film& film, std::size_t p, std::size_t q) {
  if (film.instance[p] != film.instance[q] || film.material[p] != film.material[q]) return false;
  if (dot(film.normal.at(p), film.normal.at(q)) < same_facing) return false;
  const float off_plane =
      std::fabs(dot(film.normal.at(p), film.position.at(q) - film.position.at(p)));
  return off_plane < same_plane_m + same_plane_per_m * film.depth[p];
}

bool is_edge(const Film& film, const std::array<std::size_t, 9>& around) {
  return std::any_of(around.begin() + 1, around.end(), [&](std::size_t q) {
    return !same_surface(film, around[0], q);
  });
}

class EdgeResolver {
 public:
  EdgeResolver(
      const Lighting& lighting, const View& view, const Film& film, unsigned mask, int samples)
      : lighting_(lighting),
        view_(view),
        film_(film),
        mask_(mask),
        samples_(std::clamp<std::size_t>(static_cast<std::size_t>(samples), 0, most_edge_samples)) {
  }

  void resolve_row(int y, Planes3& radiance) const {
    std::array<Pending, packet_size> queue;
    std::size_t used = 0;
    for (int x = 0; x < film_.width; ++x) {
      const std::size_t p = film_.index(x, y);
      radiance.set(p, soft(film_.radiance(p)));
      if (samples_ == 0 || !is_edge(film_, neighbours(film_, x, y))) continue;
      radiance.set(p, radiance.at(p) * (1 / static_cast<float>(samples_ + 1)));
      for (std::size_t s = 0; s < samples_; ++s) {
        queue[used++] = {
            x,
            y,
            view_.ray(static_cast<float>(x) + offsets[s].x, static_cast<float>(y) + offsets[s].y)};
        if (used == packet_size) used = finish(queue, used, radiance);
      }
    }
    finish(queue, used, radiance);
  }

 private:
  struct Pending {
    int x = 0, y = 0;
    Ray ray;
  };

  // Radiance that later arithmetic can average without one lamp outweighing all.
  Vec3f soft(Vec3f radiance) const {
    const float limit = brightest_sample / lighting_.world.exposure;
    const float top = largest(radiance);
    return top > limit ? radiance * (limit / top) : radiance;
  }

  std::size_t finish(const std::array<Pending, packet_size>& queue,
                     std::size_t used,
                     Planes3& radiance) const {
    if (used == 0) return 0;
    std::array<Ray, packet_size> rays;
    std::array<Hit, packet_size> hits;
    for (std::size_t k = 0; k < used; ++k)
      rays[k] = queue[k].ray;
    trace(lighting_.world, std::span(rays).first(used), hits, mask_, RayBundle::coherent);
    for (std::size_t k = 0; k < used; ++k) {
      const std::size_t p = film_.index(queue[k].x, queue[k].y);
      const Vec3f sample = soft(seen(queue[k], hits[k]));
      radiance.set(p, radiance.at(p) + sample * (1 / static_cast<float>(samples_ + 1)));
    }
    return 0;
  }

  Vec3f seen(const Pending& pending, const Hit& hit) const {
    const auto around = neighbours(film_, pending.x, pending.y);
    if (!hit.any()) {
      return film_.transmittance.at(around[0]) *
                 lighting_.world.surroundings.radiance(pending.ray.direction) +
             film_.overlay.at(around[0]);
    }
    const Surface surface = surface_at(lighting_.world, pending.ray, hit, view_.footprint(hit.t));
    const auto best = like(surface, around);
    if (!best) {
      const Vec3f stored = stored_radiance(lighting_, surface, pending.ray.direction, Lamps::seen);
      return film_.transmittance.at(around[0]) * stored + film_.overlay.at(around[0]);
    }
    const Vec3f reflectance = rough_fresnel(surface.reflectance(),
                                            -dot(surface.relief_normal, pending.ray.direction),
                                            surface.roughness);
    const Vec3f lit = surface.diffuse() * relief_shade(lighting_, surface);
    const Vec3f behind = lit * film_.irradiance.at(*best) * inverse_pi +
                         reflectance * film_.gloss.at(*best) + surface.emission;
    return film_.transmittance.at(*best) * behind + film_.overlay.at(*best);
  }

  // The pixel around whose surface is most like the one given.
  std::optional<std::size_t> like(const Surface& surface,
                                  const std::array<std::size_t, 9>& around) const {
    std::optional<std::size_t> best;
    float least = 1e9F;
    for (const std::size_t q : around) {
      if (film_.depth[q] <= 0) continue;
      const float off_plane =
          std::fabs(dot(surface.normal, film_.position.at(q) - surface.position));
      const float turned = 1 - dot(surface.normal, film_.normal.at(q));
      if (off_plane > same_plane_m + same_plane_per_m * film_.depth[q] || turned > 1 - same_facing)
        continue;
      const float difference = off_plane + turned * 0.1F +
                               (film_.instance[q] != surface.id ? 0.01F : 0.0F) +
                               (film_.material[q] != surface.material ? 0.005F : 0.0F);
      if (difference < least) {
        least = difference;
        best = q;
      }
    }
    return best;
  }

  const Lighting& lighting_;
  const View& view_;
  const Film& film_;
  unsigned mask_;
  std::size_t samples_;
};

}  // namespace

Planes3 resolve_edges(const Lighting& lighting,
                      const View& view,
                      const Film& film,
                      unsigned opaque_mask,
                      int edge_samples) {
  Planes3 radiance(film.count());
  const EdgeResolver resolver(lighting, view, film, opaque_mask, edge_samples);
  parallel_for(
      static_cast<std::size_t>(film.height),
      [&](std::size_t y) { resolver.resolve_row(static_cast<int>(y), radiance); },
      4);
  return radiance;
}

Image develop(const Planes3& radiance, int width, int height, float exposure) {
  Image image(width, height);
  parallel_for(
      static_cast<std::size_t>(height),
      [&](std::size_t y) {
        for (int x = 0; x < width; ++x) {
          const std::size_t i = y * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
          const Rgb8 color = display_color(radiance.at(i) * exposure);
          std::uint8_t* pixel = image.at(x, static_cast<int>(y));
          pixel[0] = color.r;
          pixel[1] = color.g;
          pixel[2] = color.b;
        }
      },
      8);
  return image;
}

}  // namespace marketgen::raytrace
