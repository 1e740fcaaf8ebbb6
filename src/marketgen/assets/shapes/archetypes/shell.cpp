#include "assets/shapes/archetypes/shell.h"

#include <algorithm>
#include <cmath>

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

using ShellRing = std::vector<Vec3f>;

class Shell {
 public:
  Shell(PackBuilder& pack, const ShellSkin& skin, const ShellGrid& grid, const ShellPoint& point)
      : pack_(pack),
        skin_(skin),
        grid_(grid),
        panel_(pack.is_print(skin.surface) ? pack.panel(PanelKind::skin) : nullptr) {
    for (std::size_t i = 0; i < grid.stations.size(); ++i)
      rings_.push_back(ring_at(point, i));
  }

  void add_bands() {
    for (std::size_t i = 0; i + 1 < rings_.size(); ++i)
      add_band(i);
  }

 private:
  bool is_pole(std::size_t ring) const {
    return !grid_.closed && (ring == 0 || ring + 1 == rings_.size());
  }

  ShellRing ring_at(const ShellPoint& point, std::size_t i) const {
    const bool end = i == 0 || i + 1 == grid_.stations.size();
    if (end && !grid_.closed)
      return ShellRing(static_cast<std::size_t>(grid_.segments) + 1, point(0, grid_.stations[i]));
    const double along = grid_.closed && i + 1 == grid_.stations.size() ? 0 : grid_.stations[i];
    ShellRing ring;
    for (int k = 0; k < grid_.segments; ++k)
      ring.push_back(point(static_cast<double>(k) / grid_.segments, along));
    ring.push_back(ring.front());
    return ring;
  }

  Vec2f uv_at(float segments_around, std::size_t ring) const {
    const auto along = static_cast<float>(grid_.stations[ring]);
    const float v = skin_.v_low + (skin_.v_high - skin_.v_low) * along;
    return uv_in(panel_, segments_around / static_cast<float>(grid_.segments), v);
  }

  void add_band(std::size_t i) {
    for (int k = 0; k < grid_.segments; ++k) {
      const auto at = static_cast<std::size_t>((k + skin_.first_segment) % grid_.segments);
      // The skin shrinks to a point at an end: its corner takes the middle of the segment.
      const auto corner = [&](std::size_t ring, int side) {
        const float u = static_cast<float>(k) + (is_pole(ring) ? 0.5F : static_cast<float>(side));
        return Corner{rings_[ring][at + static_cast<std::size_t>(side)], uv_at(u, ring)};
      };
      pack_.add_quad(corner(i, 0), corner(i, 1), corner(i + 1, 1), corner(i + 1, 0), skin_.surface);
    }
  }

  PackBuilder& pack_;
  const ShellSkin& skin_;
  const ShellGrid& grid_;
  const Panel* panel_;
  std::vector<ShellRing> rings_;  // segments + 1 points each, the last is the first
};

// Catmull-Rom through four values, at t 0..1 between the middle two.
template <class T>
T spline(const T& a, const T& b, const T& c, const T& d, float t) {
  const T tangent_b = (c - a) * 0.5F, tangent_c = (d - b) * 0.5F;
  const float t2 = t * t, t3 = t2 * t;
  return b * (2 * t3 - 3 * t2 + 1) + tangent_b * (t3 - 2 * t2 + t) + c * (3 * t2 - 2 * t3) +
         tangent_c * (t3 - t2);
}

struct LinePoint {
  Vec3f at;
  Vec2f half;       // across and thick
  Vec3f direction;  // unit
};

// The curve through a tube's knots, to be asked by its length.
class TubeLine {
 public:
  explicit TubeLine(const TubeForm& form) : form_(form) {
    const std::size_t spans = form.closed ? form.knots.size() : form.knots.size() - 1;
    length_.push_back(0);
    Vec3f last = position(0);
    for (std::size_t i = 1; i <= spans * samples; ++i) {
      const Vec3f next = position(static_cast<float>(i) / samples);
      length_.push_back(length_.back() + length(next - last));
      last = next;
    }
  }

  float total() const { return length_.back(); }

  LinePoint at(float share) const {
    const float place = knot_place(share * total());
    constexpr float step = 0.02F;  // of a span
    const float last = static_cast<float>(length_.size() - 1) / samples;
    const float before = form_.closed ? place - step : std::max(0.0F, place - step);
    const float after = form_.closed ? place + step : std::min(last, place + step);
    return {position(place), half_at(place), normalized(position(after) - position(before))};
  }

 private:
  static constexpr int samples = 12;  // of a span between knots

  const TubeKnot& knot(int i) const {
    const int n = static_cast<int>(form_.knots.size());
    const int at = form_.closed ? (i % n + n) % n : std::clamp(i, 0, n - 1);
    return form_.knots[static_cast<std::size_t>(at)];
  }

  Vec3f position(float place) const {
    const auto [i, t] = split(place);
    return spline(knot(i - 1).at, knot(i).at, knot(i + 1).at, knot(i + 2).at, t);
  }

  Vec2f half_at(float place) const {
    const auto [i, t] = split(place);
    const auto half = [&](int k) { return Vec2f{knot(k).across, knot(k).thick}; };
    const Vec2f h = spline(half(i - 1), half(i), half(i + 1), half(i + 2), t);
    return {std::max(h.x, 0.0F), std::max(h.y, 0.0F)};
  }

  // The span in which a place lies and how far into it.
  std::pair<int, float> split(float place) const {
    const int last = static_cast<int>(form_.knots.size()) - (form_.closed ? 1 : 2);
    const int i = form_.closed ? static_cast<int>(std::floor(place))
                               : std::clamp(static_cast<int>(place), 0, last);
    return {i, place - static_cast<float>(i)};
  }

  float knot_place(float along) const {
    const auto above = std::upper_bound(length_.begin() + 1, length_.end() - 1, along);
    const auto i = static_cast<std::size_t>(above - length_.begin());
    const float span = length_[i] - length_[i - 1];
    const float t = span > 0 ? (along - length_[i - 1]) / span : 0.0F;
    return (static_cast<float>(i - 1) + std::clamp(t, 0.0F, 1.0F)) / samples;
  }

  const TubeForm& form_;
  std::vector<float> length_;  // from the start, `samples` to a span
};

// Height of a quarter ellipse at share t of its width.
float rounded_end(float t) {
  const float s = std::clamp(t, 0.0F, 1.0F);
  return std::sqrt(std::max(0.0F, s * (2 - s)));
}

// Closer together where the ends round off.
std::vector<double> tube_stations(double low_round, double high_round, int bands) {
  const auto ends = {0.0, 0.05, 0.2, 0.45};
  std::vector<double> stations;
  if (low_round > 0) {
    for (const double s : ends)
      stations.push_back(s * low_round);
  } else {
    stations.push_back(0);
  }
  const double from = low_round > 0 ? 0.8 * low_round : 0.002;
  const double to = high_round > 0 ? 1 - 0.8 * high_round : 0.998;
  for (int i = 0; i <= bands; ++i)
    stations.push_back(from + (to - from) * i / bands);
  if (high_round > 0) {
    for (const double s : {0.45, 0.2, 0.05})
      stations.push_back(1 - s * high_round);
  }
  stations.push_back(1);
  return stations;
}

}  // namespace

std::vector<double> even_stations(int count) {
  std::vector<double> stations;
  for (int i = 0; i <= count; ++i)
    stations.push_back(static_cast<double>(i) / count);
  return stations;
}

void add_shell(PackBuilder& pack,
               const ShellSkin& skin,
               const ShellGrid& grid,
               const ShellPoint& point) {
  Shell(pack, skin, grid, point).add_bands();
}

void add_tube(PackBuilder& pack,
              const ShellSkin& skin,
              int segments,
              int bands,
              const TubeForm& form,
              const Placement& place) {
  const TubeLine line(form);
  // An end rounds off over at most 45 % of the line.
  const float low = std::min(form.low_round_m / line.total(), 0.45F);
  const float high = std::min(form.high_round_m / line.total(), 0.45F);
  const ShellPoint point = [&](double turn, double along) {
    const auto share = static_cast<float>(along);
    const LinePoint here = line.at(share);
    const Vec3f across = normalized(cross(form.up, here.direction));
    const Vec3f normal = cross(here.direction, across);
    const float round = (low > 0 ? rounded_end(share / low) : 1.0F) *
                        (high > 0 ? rounded_end((1 - share) / high) : 1.0F);
    const bool end = !form.closed && (along <= 0 || along >= 1);
    const Vec2 circle = unit_circle(turn + 0.75);
    const auto cx = static_cast<float>(circle.x), cy = static_cast<float>(circle.y);
    const float side = end ? 0 : here.half.x * round * cx;
    const Vec2 wave = unit_circle(form.ruffles * along + (cx > 0 ? 0.3 : 0.0));
    const float edge = cx * cx * here.half.x * round;
    const float rise = edge * (form.fold + form.ruffle * static_cast<float>(wave.x));
    const float up = end ? 0 : here.half.y * round * cy + rise;
    return place(here.at + across * side + normal * up);
  };
  const std::vector<double> stations =
      form.closed ? even_stations(bands) : tube_stations(low, high, bands);
  add_shell(pack, skin, {segments, stations, form.closed}, point);
}

}  // namespace marketgen::assets
