#include "render/sensor_edges.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "render/shading_math.h"
#include "render/tone.h"

namespace marketgen::raytrace {
namespace {

constexpr std::size_t most_samples = 8;
// Rooks in the pixel, the first n of which are spread for n = 2, 4 and 8.
constexpr std::array<Vec2f, most_samples> sample_offsets{Vec2f{0.25F, 0.75F},
                                                         {0.75F, 0.25F},
                                                         {0.125F, 0.125F},
                                                         {0.875F, 0.875F},
                                                         {0.375F, 0.9375F},
                                                         {0.625F, 0.0625F},
                                                         {0.0625F, 0.5F},
                                                         {0.9375F, 0.5625F}};
// Neighbours that differ by less of their brightness need no smoothing; this much of white counts
// as dark.
constexpr float least_contrast = 0.08F, dark_of_white = 0.04F;
constexpr float edge_plane_m = 0.02F, edge_plane_per_m = 0.005F, edge_facing = 0.8F;
// A sample brighter than this many times white counts as this much: lamps' edges would stay jagged
// when the tone curve clips them afterwards.
constexpr float brightest_sample_of_white = 3;

std::uint32_t packed_normal(Vec3f n) {
  const auto part = [](float x) {
    return static_cast<std::uint32_t>(
        static_cast<std::uint8_t>(static_cast<std::int8_t>(std::lrint(x * 127))));
  };
  return part(n.x) | part(n.y) << 8 | part(n.z) << 16;
}

Float4 unpacked_normal4(std::uint32_t packed) {
  const __m128i bytes = _mm_cvtsi32_si128(static_cast<int>(packed));
  return Float4(_mm_mul_ps(_mm_cvtepi32_ps(_mm_cvtepi8_epi32(bytes)), _mm_set1_ps(1.0F / 127)));
}

std::uint64_t halves(Float4 v) {
  return static_cast<std::uint64_t>(
      _mm_cvtsi128_si64(_mm_cvtps_ph(v.m, _MM_FROUND_TO_NEAREST_INT)));
}

Float4 from_halves(std::uint64_t bits) {
  return Float4(_mm_cvtph_ps(_mm_cvtsi64_si128(static_cast<long long>(bits))));
}

class TileResolver {
 public:
  TileResolver(const Lighting& lighting,
               const View& view,
               const SensorEffort& effort,
               const SensorPlanes& planes,
               std::uint8_t* rgb)
      : lighting_(lighting),
        view_(view),
        effort_(effort),
        planes_(planes),
        rgb_(rgb),
        samples_(std::min(static_cast<std::size_t>(effort.edge_samples), most_samples)),
        limit_(brightest_sample_of_white / lighting.world.exposure),
        dark_(dark_of_white / lighting.world.exposure) {}

  void run(int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        if (is_edge(x, y)) add_samples(x, y);
      }
    }
    finish();
    std::array<Float4, sensor_tile_side> row;
    std::size_t e = 0;  // edges lie row by row
    for (int y = y0; y < y1; ++y) {
      const std::size_t first = index(x0, y);
      const auto count = static_cast<std::size_t>(x1 - x0);
      std::copy_n(
          planes_.radiance.begin() + static_cast<std::ptrdiff_t>(first), count, row.begin());
      for (; e < edges_ && edge_pixel_[e] < first + count; ++e)
        row[edge_pixel_[e] - first] = edge_sum_[e] * (1 / static_cast<float>(samples_ + 1));
      tone_curve().write(std::span(row).first(count), lighting_.world.exposure, rgb_ + 3 * first);
    }
  }

 private:
  struct Pending {
    std::uint16_t edge = 0;
    Ray ray;
  };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(planes_.width) +
           static_cast<std::size_t>(x);
  }
  std::uint32_t number_at(std::size_t p) const {
    return std::bit_cast<std::uint32_t>(planes_.position[p].w());
  }

  // Whether an edge runs between two pixels that would show when it is jagged.
  bool differ(std::size_t p, std::size_t q) const {
    return contrast(p, q) && differ_in_shape(p, q);
  }

  bool contrast(std::size_t p, std::size_t q) const {
    const __m128 a = planes_.radiance[p].m, b = planes_.radiance[q].m;
    const __m128 off = _mm_andnot_ps(_mm_set1_ps(-0.0F), _mm_sub_ps(a, b));
    const __m128 bright = _mm_add_ps(_mm_max_ps(a, b), _mm_set1_ps(dark_));
    const __m128 shows = _mm_cmpgt_ps(off, _mm_mul_ps(bright, _mm_set1_ps(least_contrast)));
    return (_mm_movemask_ps(shows) & 7) != 0;
  }

  bool differ_in_shape(std::size_t p, std::size_t q) const {
    if (number_at(p) != number_at(q)) return true;
    if (planes_.normal[p] == planes_.normal[q] && number_at(p) == 0) return false;
    const Float4 normal = unpacked_normal4(planes_.normal[p]);
    if (planes_.normal[p] != planes_.normal[q] &&
        dot(normal, unpacked_normal4(planes_.normal[q])) < edge_facing)
      return true;
    const float off = std::fabs(dot(normal, planes_.position[q] - planes_.position[p]));
    return off > edge_plane_m && off > edge_plane_m + edge_plane_per_m * distance_to(p);
  }

  float distance_to(std::size_t p) const {
    const Float4 way = planes_.position[p] - Float4(view_.ray(0, 0).origin);
    return std::sqrt(dot(way, way));
  }

  bool is_edge(int x, int y) const {
    const std::size_t p = index(x, y);
    return (x > 0 && differ(p, p - 1)) || (x + 1 < planes_.width && differ(p, p + 1)) ||
           (y > 0 && differ(p, index(x, y - 1))) ||
           (y + 1 < planes_.height && differ(p, index(x, y + 1)));
  }

  void add_samples(int x, int y) {
    const std::size_t p = index(x, y);
    const auto edge = static_cast<std::uint16_t>(edges_++);
    edge_pixel_[edge] = p;
    edge_x_[edge] = x;
    edge_y_[edge] = y;
    edge_sum_[edge] = soft(planes_.radiance[p]);
    for (std::size_t s = 0; s < samples_; ++s) {
      pending_[used_++] = {edge,
                           view_.ray(static_cast<float>(x) + sample_offsets[s].x,
                                     static_cast<float>(y) + sample_offsets[s].y)};
      if (used_ == packet_size) finish();
    }
  }

  Float4 soft(Float4 radiance) const {
    const float top = std::max(radiance.x(), std::max(radiance.y(), radiance.z()));
    return top > limit_ ? radiance * (limit_ / top) : radiance;
  }

  void finish() {
    if (used_ == 0) return;
    std::array<Ray, packet_size> rays;
    std::array<Hit, packet_size> hits;
    for (std::size_t k = 0; k < used_; ++k)
      rays[k] = pending_[k].ray;
    trace(lighting_.world,
          std::span(rays).first(used_),
          std::span(hits).first(used_),
          effort_.detail.opaque_mask,
          RayBundle::coherent);
    fetch_surfaces(lighting_.world, std::span(hits).first(used_));
    for (std::size_t k = 0; k < used_; ++k)
      edge_sum_[pending_[k].edge] += soft(seen(pending_[k], hits[k]));
    used_ = 0;
  }

  Float4 seen(const Pending& pending, const Hit& hit) const {
    const std::size_t p = edge_pixel_[pending.edge];
    if (!hit.any())
      return veiled(p, Float4(lighting_.world.surroundings.radiance(pending.ray.direction)));
    const Surface surface =
        surface_at(lighting_.world, pending.ray, hit, view_.footprint(hit.t), TextureDetail::level);
    const auto like = like_of(surface, edge_x_[pending.edge], edge_y_[pending.edge]);
    if (!like)
      return veiled(
          p, Float4(stored_radiance(lighting_, surface, pending.ray.direction, Lamps::seen)));
    return veiled(*like,
                  lit_radiance(surface,
                               Float4(pending.ray.direction),
                               from_halves(planes_.irradiance[*like]),
                               from_halves(planes_.gloss[*like])));
  }

  Float4 veiled(std::size_t p, Float4 behind) const {
    return behind * from_halves(planes_.transmittance[p]) + from_halves(planes_.overlay[p]);
  }

  // The pixel itself, or else one around it, that shows the surface given.
  std::optional<std::size_t> like_of(const Surface& surface, int x, int y) const {
    constexpr std::array<std::array<int, 2>, 9> places{
        {{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
    const Float4 position(surface.position), normal(surface.normal);
    const float plane = edge_plane_m + edge_plane_per_m * surface.distance;
    for (const auto& [dx, dy] : places) {
      const int qx = x + dx, qy = y + dy;
      if (qx < 0 || qy < 0 || qx >= planes_.width || qy >= planes_.height) continue;
      const std::size_t q = index(qx, qy);
      if (number_at(q) == surface.id &&
          std::fabs(dot(normal, planes_.position[q] - position)) < plane &&
          dot(normal, unpacked_normal4(planes_.normal[q])) > edge_facing)
        return q;
    }
    return std::nullopt;
  }

  const Lighting& lighting_;
  const View& view_;
  const SensorEffort& effort_;
  const SensorPlanes& planes_;
  std::uint8_t* rgb_;
  std::size_t samples_;
  float limit_, dark_;
  std::size_t edges_ = 0, used_ = 0;
  std::array<Pending, packet_size> pending_;
  std::array<std::size_t, sensor_tile_pixels> edge_pixel_;
  std::array<int, sensor_tile_pixels> edge_x_, edge_y_;
  std::array<Float4, sensor_tile_pixels> edge_sum_;
};

}  // namespace

void SensorPlanes::resize(int w, int h) {
  width = w;
  height = h;
  const auto count = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
  if (radiance.size() == count) return;
  radiance.resize(count);
  position.resize(count);
  normal.resize(count);
  for (std::vector<std::uint64_t>* plane : {&irradiance, &gloss, &transmittance, &overlay})
    plane->resize(count);
}

void SensorPlanes::take(const World& world, const SensorTile& tile) {
  const std::uint64_t clear = halves(Float4(1.0F));
  for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
    if (!tile.inside(i)) continue;
    const auto p = static_cast<std::size_t>(tile.y0 + SensorTile::row_of(i)) *
                       static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(tile.x0 + SensorTile::column_of(i));
    radiance[p] = radiance_of(world, tile, i);
    transmittance[p] = clear;
    overlay[p] = 0;
    if (tile.pane_of[i] >= 0) {
      transmittance[p] =
          halves(Float4(tile.panes[static_cast<std::size_t>(tile.pane_of[i])].transmittance));
      overlay[p] = halves(Float4(tile.overlay[i]));
    }
    if (tile.depth[i] <= 0) {
      position[p] = Float4(0.0F);
      normal[p] = 0;
      continue;
    }
    const Surface& s = tile.surface[i];
    position[p] = Float4(s.position.x, s.position.y, s.position.z, std::bit_cast<float>(s.id));
    normal[p] = packed_normal(s.normal);
    irradiance[p] = halves(Float4(tile.irradiance[i]) * tile.openness[i]);
    gloss[p] = halves(Float4(tile.gloss[i]));
  }
}

void resolve_tile(const Lighting& lighting,
                  const View& view,
                  const SensorEffort& effort,
                  const SensorPlanes& planes,
                  int index,
                  std::uint8_t* rgb) {
  const int x0 = index % sensor_tiles_across(view) * sensor_tile_side;
  const int y0 = index / sensor_tiles_across(view) * sensor_tile_side;
  TileResolver(lighting, view, effort, planes, rgb)
      .run(x0,
           y0,
           std::min(x0 + sensor_tile_side, view.width()),
           std::min(y0 + sensor_tile_side, view.height()));
}

}  // namespace marketgen::raytrace
