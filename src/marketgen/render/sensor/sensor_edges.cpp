#include "render/sensor/sensor_edges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <span>

#include "render/shading_math.h"
#include "render/tone.h"

namespace marketgen::render::raytrace {
namespace {

constexpr std::size_t max_samples = 8;
// Rooks in the pixel, the first n of which are spread for n = 2, 4 and 8.
constexpr std::array<Vec2f, max_samples> sample_offsets{Vec2f{0.25F, 0.75F},
                                                        {0.75F, 0.25F},
                                                        {0.125F, 0.125F},
                                                        {0.875F, 0.875F},
                                                        {0.375F, 0.9375F},
                                                        {0.625F, 0.0625F},
                                                        {0.0625F, 0.5F},
                                                        {0.9375F, 0.5625F}};
// Neighbours that differ by less of their brightness need no smoothing; this much of white counts
// as dark.
constexpr float min_contrast = 0.12F, dark_of_white = 0.04F;
constexpr float edge_plane_m = 0.02F, edge_plane_per_m = 0.005F, edge_facing = 0.8F;
// A sample brighter than this many times white counts as this much: lamps' edges would stay jagged
// when the tone curve clips them afterwards.
constexpr float brightest_sample_of_white = 3;
constexpr std::uint32_t behind_pane = 1U << 24, clear_wall = 1U << 25;

Int8 packed_normals(const Vec8& n) {
  const auto part = [](Float8 x) { return Int8(_mm256_cvtps_epi32((x * 127).m)) & 0xFF; };
  return part(n.x) | (part(n.y) << 8) | (part(n.z) << 16);
}

Vec8 unpacked_normals(Int8 packed) {
  const auto part = [&](int shift) {
    return to_float(Int8(_mm256_srai_epi32((packed << shift).m, 24))) * (1.0F / 127);
  };
  return {part(24), part(16), part(8)};
}

Vec3f unpacked_signed_bytes(std::uint32_t packed) {
  const auto part = [&](int shift) {
    return static_cast<float>(static_cast<std::int8_t>(packed >> shift & 255U)) * (1.0F / 127);
  };
  return {part(0), part(8), part(16)};
}

void store_halves(Float8 v, std::uint16_t* to) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm256_cvtps_ph(v.m, _MM_FROUND_TO_NEAREST_INT));
}

float half_at(const SensorPlanes::Halves& plane, std::size_t p) {
  return _cvtsh_ss(plane[p]);
}
Vec3f halves_at(const std::array<SensorPlanes::Halves, 3>& planes, std::size_t p) {
  return {half_at(planes[0], p), half_at(planes[1], p), half_at(planes[2], p)};
}

template <class Planes>
Vec8 eight_at(const Planes& planes, std::size_t p) {
  return {Float8::load(&planes[0][p]), Float8::load(&planes[1][p]), Float8::load(&planes[2][p])};
}

class StripResolver {
 public:
  StripResolver(const Lighting& lighting,
                const View& view,
                const SensorEffort& effort,
                const SensorPlanes& planes,
                int first_row)
      : lighting_(lighting),
        view_(view),
        effort_(effort),
        planes_(planes),
        groups_(planes.stride / lane_count),
        first_row_(first_row),
        rows_(std::min(sensor_strip_rows, view.height() - first_row)),
        samples_(std::min(static_cast<std::size_t>(effort.edge_samples), max_samples)),
        limit_(brightest_sample_of_white / lighting.world.exposure),
        dark_(dark_of_white / lighting.world.exposure),
        edges_(groups_ * sensor_strip_rows + 1) {}

  void run(std::uint8_t* rgb) {
    find_edges();
    for_groups([this](std::size_t group, int row) {
      for_lanes(edges_at(group, row), [&](std::size_t k) {
        add_samples(static_cast<int>(group * lane_count + k), first_row_ + row);
      });
    });
    if (used_ > 0) finish();
    write(rgb);
  }

 private:
  // Blocks of 8 x 4 pixels one after another, so that rays of a packet are near.
  template <class Body>
  void for_groups(const Body& body) const {
    const auto width = static_cast<std::size_t>(view_.width());
    for (std::size_t group = 0; group * lane_count < width; ++group) {
      for (int row = 0; row < rows_; ++row)
        body(group, row);
    }
  }

  std::uint8_t& edges_at(std::size_t group, int row) {
    return edges_[static_cast<std::size_t>(row) * groups_ + group];
  }
  std::size_t place(std::size_t group, int y) const {
    return static_cast<std::size_t>(y) * planes_.stride + group * lane_count;
  }

  // Marks both pixels of each pair of neighbours with an edge between them.
  void find_edges() {
    const auto width = static_cast<std::size_t>(view_.width());
    for (int row = -1; row < rows_; ++row) {
      const int y = first_row_ + row;
      if (y < 0) continue;
      for (std::size_t group = 0; group * lane_count < width; ++group) {
        const std::size_t p = place(group, y), left = width - group * lane_count;
        const unsigned inside = left < lane_count ? (1U << left) - 1 : 255U;
        if (y + 1 < view_.height()) {
          const unsigned down = differ(p, p + planes_.stride) & inside;
          if (row >= 0) edges_at(group, row) |= static_cast<std::uint8_t>(down);
          if (row + 1 < rows_) edges_at(group, row + 1) |= static_cast<std::uint8_t>(down);
        }
        if (row < 0) continue;
        const unsigned right = differ(p, p + 1) & (left <= lane_count ? inside >> 1 : 255U);
        edges_at(group, row) |= static_cast<std::uint8_t>(right | right << 1);
        if (left > lane_count) edges_at(group + 1, row) |= static_cast<std::uint8_t>(right >> 7);
      }
    }
  }

  // Between which of eight neighbours an edge runs that would show when it is jagged.
  unsigned differ(std::size_t p, std::size_t q) const {
    const Mask8 contrast = contrasts(p, q);
    return contrast.any() ? (contrast & differ_in_shape(p, q)).bits() : 0;
  }

  Mask8 contrasts(std::size_t p, std::size_t q) const {
    const Vec8 a = eight_at(planes_.radiance, p), b = eight_at(planes_.radiance, q);
    const auto shows = [this](Float8 x, Float8 y) {
      return absolute(x - y) > (max(x, y) + dark_) * min_contrast;
    };
    return shows(a.x, b.x) | shows(a.y, b.y) | shows(a.z, b.z);
  }

  Mask8 differ_in_shape(std::size_t p, std::size_t q) const {
    const Int8 packed = Int8::load(&planes_.normal[p]), other = Int8::load(&planes_.normal[q]);
    const Vec8 normal = unpacked_normals(packed), at = eight_at(planes_.position, p);
    const Mask8 turned =
        (dot(normal, unpacked_normals(other)) < Float8(edge_facing)) & ~(packed == other);
    const Vec8 way = at - all(view_.ray(0, 0).origin);
    const Float8 distance = square_root(dot(way, way));
    const Float8 off = absolute(dot(normal, eight_at(planes_.position, q) - at));
    const Mask8 same = Int8::load(&planes_.number[p]) == Int8::load(&planes_.number[q]);
    return ~same | turned | (off > edge_plane_m + edge_plane_per_m * distance);
  }

  void add_samples(int x, int y) {
    const std::size_t p =
        static_cast<std::size_t>(y) * planes_.stride + static_cast<std::size_t>(x);
    sums_.push_back(soft({planes_.radiance[0][p], planes_.radiance[1][p], planes_.radiance[2][p]}));
    for (std::size_t s = 0; s < samples_; ++s) {
      asked_[used_] = {static_cast<std::uint32_t>(sums_.size() - 1), x, y};
      x_[used_] = static_cast<float>(x) + sample_offsets[s].x;
      y_[used_] = static_cast<float>(y) + sample_offsets[s].y;
      if (++used_ == packet_size) finish();
    }
  }

  Vec3f soft(Vec3f radiance) const {
    const float top = largest(radiance);
    return top > limit_ ? radiance * (limit_ / top) : radiance;
  }

  void finish() {
    for (std::size_t k = used_; k < packet_size; ++k) {
      x_[k] = x_[0];
      y_[k] = y_[0];
    }
    RTCRayHit16 packet;
    std::array<Rays8, 2> rays;
    for (std::size_t half = 0; half < 2; ++half) {
      rays[half] =
          view_.rays(Float8::load(&x_[half * lane_count]), Float8::load(&y_[half * lane_count]));
      set_rays(packet.ray, half, rays[half], View::near_m);
    }
    trace(lighting_.world, packet, used_, effort_.detail.opaque_mask, RayBundle::coherent);
    fetch_surfaces(lighting_.world, packet);
    for (std::size_t half = 0; half < 2; ++half)
      see(half, rays[half], hits_of(packet, half));
    used_ = 0;
  }

  // Adds what eight samples see.
  void see(std::size_t half, const Rays8& rays, const Hits8& hits) {
    Surface8 s;
    see_surfaces(lighting_.world, rays, hits, view_.footprint(hits.t), TextureDetail::level, s);
    const std::size_t first = half * lane_count;
    const std::size_t count = std::min(lane_count, std::max(used_, first) - first);
    Vec8 irradiance, gloss;
    std::array<std::optional<std::size_t>, lane_count> like;
    for (std::size_t k = 0; k < count; ++k) {
      if (!hits.any[k]) continue;
      like[k] = like_of(s, k, asked_[first + k]);
      if (!like[k]) continue;
      set_lane(irradiance, k, halves_at(planes_.irradiance, *like[k]));
      set_lane(gloss, k, halves_at(planes_.gloss, *like[k]));
    }
    const Vec8 lit = lit_radiance(s, rays.direction, irradiance, gloss);
    for (std::size_t k = 0; k < count; ++k) {
      const Asked& asked = asked_[first + k];
      if (like[k] && s.clear[k]) {  // as the pixel shows it: with what lies behind
        const std::size_t q = *like[k];
        sums_[asked.edge] +=
            soft({planes_.radiance[0][q], planes_.radiance[1][q], planes_.radiance[2][q]});
        continue;
      }
      const Vec3f behind = like[k] ? lane(lit, k) : unlike(s, k, lane(rays.direction, k), hits);
      sums_[asked.edge] += soft(veiled(like[k] ? *like[k] : place_of(asked.x, asked.y), behind));
    }
  }

  // Light of what no pixel around shows.
  Vec3f unlike(const Surface8& s, std::size_t k, Vec3f direction, const Hits8& hits) const {
    if (!hits.any[k]) return lighting_.world.surroundings.radiance(direction);
    return stored_radiance(lighting_, surface_in(s, k), direction, Lamps::seen);
  }

  std::size_t place_of(int x, int y) const {
    return static_cast<std::size_t>(y) * planes_.stride + static_cast<std::size_t>(x);
  }

  Vec3f veiled(std::size_t p, Vec3f behind) const {
    if ((planes_.normal[p] & behind_pane) == 0) return behind;
    return behind * halves_at(planes_.transmittance, p) + halves_at(planes_.overlay, p);
  }

  struct Asked {
    std::uint32_t edge = 0;  // index into sums_
    int x = 0, y = 0;
  };

  // The pixel itself, or else one around it, that shows the surface given.
  std::optional<std::size_t> like_of(const Surface8& s, std::size_t k, const Asked& asked) const {
    constexpr std::array<std::array<int, 2>, 9> places{
        {{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
    const auto number = static_cast<std::uint32_t>(s.id[k]);
    const Vec3f position = lane(s.position, k), normal = lane(s.normal, k);
    const float plane = edge_plane_m + edge_plane_per_m * s.distance[k];
    for (const auto& [dx, dy] : places) {
      const int x = asked.x + dx, y = asked.y + dy;
      if (x < 0 || y < 0 || x >= view_.width() || y >= view_.height()) continue;
      const std::size_t q = place_of(x, y);
      if (planes_.number[q] != number) continue;
      if (((planes_.normal[q] & clear_wall) != 0) != s.clear[k]) continue;
      const Vec3f there{planes_.position[0][q], planes_.position[1][q], planes_.position[2][q]};
      if (std::fabs(dot(normal, there - position)) < plane &&
          dot(normal, unpacked_signed_bytes(planes_.normal[q])) > edge_facing)
        return q;
    }
    return std::nullopt;
  }

  void write(std::uint8_t* rgb) {
    const auto width = static_cast<std::size_t>(view_.width());
    std::size_t edge = 0;
    const float share = 1 / static_cast<float>(samples_ + 1);
    for_groups([&](std::size_t group, int row) {
      const int y = first_row_ + row;
      Vec8 radiance = eight_at(planes_.radiance, place(group, y));
      for_lanes(edges_at(group, row),
                [&](std::size_t k) { set_lane(radiance, k, sums_[edge++] * share); });
      const ToneCurve::Pixels shown =
          tone_curve().shown(exposed(radiance, lighting_.world.exposure, effort_.light));
      const std::size_t x = group * lane_count;
      std::copy_n(shown.begin(),
                  3 * std::min(lane_count, width - x),
                  rgb + 3 * (static_cast<std::size_t>(y) * width + x));
    });
  }

  const Lighting& lighting_;
  const View& view_;
  const SensorEffort& effort_;
  const SensorPlanes& planes_;
  std::size_t groups_;  // of a row
  int first_row_, rows_;
  std::size_t samples_;
  float limit_, dark_;
  std::vector<std::uint8_t> edges_;  // bits of the lanes of each group
  std::vector<Vec3f> sums_;          // of each edge pixel's samples, in the order of for_groups
  std::size_t used_ = 0;
  std::array<Asked, packet_size> asked_;
  alignas(32) std::array<float, packet_size> x_, y_;
};

}  // namespace

void SensorPlanes::resize(const View& view) {
  const auto tiles_down = static_cast<std::size_t>(sensor_tiles_down(view));
  stride = static_cast<std::size_t>(sensor_tiles_across(view)) * sensor_tile_side;
  // Eight neighbours are read from any pixel on.
  const std::size_t count = stride * tiles_down * sensor_tile_side + lane_count;
  if (number.size() == count) return;
  for (auto* planes : {&radiance, &position}) {
    for (Floats& plane : *planes)
      plane.resize(count);
  }
  number.resize(count);
  normal.resize(count);
  for (auto* planes : {&irradiance, &gloss, &transmittance, &overlay}) {
    for (Halves& plane : *planes)
      plane.resize(count);
  }
}

void SensorPlanes::take(const World& world, const SensorTile& tile) {
  const auto store = [](std::array<Floats, 3>& planes, std::size_t p, const Vec8& v) {
    v.x.store(&planes[0][p]);
    v.y.store(&planes[1][p]);
    v.z.store(&planes[2][p]);
  };
  const auto store_half = [](std::array<Halves, 3>& planes, std::size_t p, const Vec8& v) {
    store_halves(v.x, &planes[0][p]);
    store_halves(v.y, &planes[1][p]);
    store_halves(v.z, &planes[2][p]);
  };
  tile.for_groups(static_cast<int>(stride), [&](std::size_t g, std::size_t p, std::size_t) {
    const Surface8& s = tile.surface[g];
    const Mask8 seen = tile.depth[g] > Float8();
    store(radiance, p, radiance_of(world, tile, g));
    store(position, p, select(seen, s.position, Vec8{}));
    select(seen, s.id, Int8(0)).store(&number[p]);
    select(seen, packed_normals(s.normal), Int8(0)).store(&normal[p]);
    store_half(irradiance, p, tile.irradiance[g] * tile.openness[g]);
    store_half(gloss, p, tile.gloss[g]);
  });
  // Edges of clear packs are those of their walls.
  for (const TilePane& wall : std::span(tile.walls).first(tile.wall_count)) {
    if (!tile.inside(wall.pixel)) continue;
    const std::size_t p = place_of(tile, wall.pixel);
    const Surface& s = wall.first;
    number[p] = s.id;
    normal[p] = static_cast<std::uint32_t>(packed_normals(all(s.normal))[0]) | clear_wall;
    position[0][p] = s.position.x;
    position[1][p] = s.position.y;
    position[2][p] = s.position.z;
  }
  for (std::size_t n = 0; n < tile.pane_count; ++n) {
    const TilePane& pane = tile.panes[n];
    if (!tile.inside(pane.pixel)) continue;
    const std::size_t p = place_of(tile, pane.pixel);
    const auto store_one = [p](std::array<Halves, 3>& planes, Vec3f v) {
      planes[0][p] = _cvtss_sh(v.x, _MM_FROUND_TO_NEAREST_INT);
      planes[1][p] = _cvtss_sh(v.y, _MM_FROUND_TO_NEAREST_INT);
      planes[2][p] = _cvtss_sh(v.z, _MM_FROUND_TO_NEAREST_INT);
    };
    normal[p] |= behind_pane;
    store_one(transmittance, pane.transmittance);
    store_one(overlay, pane.light);
  }
}

void resolve_strip(const Lighting& lighting,
                   const View& view,
                   const SensorEffort& effort,
                   const SensorPlanes& planes,
                   int index,
                   std::uint8_t* rgb) {
  StripResolver(lighting, view, effort, planes, index * sensor_strip_rows).run(rgb);
}

}  // namespace marketgen::render::raytrace
