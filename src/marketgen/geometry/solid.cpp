#include "geometry/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/weld.h"

namespace marketgen {
inline namespace geometry {
namespace {

// Where a column's middle line enters (up: +1) or leaves a body.
struct Crossing {
  float z;
  int turn;
};

// Twice the area of a, b, p, with the same magnitude whichever way the edge is walked, so that two
// triangles at one edge never both claim a line, nor both miss it.
double edge_side(Vec3 a, Vec3 b, double px, double py) {
  const bool swapped = b.x < a.x || (b.x == a.x && b.y < a.y);
  if (swapped) std::swap(a, b);
  double side = (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x);
  if (side == 0) side = 1e-300;
  return swapped ? -side : side;
}

// The columns whose middles lie between two places, counted from `low`.
Solid::Range columns_between(double from, double to, double low, double pitch, int columns) {
  const int first = static_cast<int>(std::ceil((from - low) / pitch - 0.5));
  const int last = static_cast<int>(std::floor((to - low) / pitch - 0.5)) + 1;
  return {std::clamp(first, 0, columns), std::clamp(last, 0, columns)};
}

class Sampler {
 public:
  Sampler(Vec3f low, Vec3f pitch, int columns)
      : low_(to_double(low)),
        pitch_(to_double(pitch)),
        columns_(columns),
        crossings_(static_cast<std::size_t>(columns * columns)) {}

  void add(Vec3 a, Vec3 b, Vec3 c) {
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0) return;
    const int turn = area > 0 ? -1 : 1;  // the upper side of a body is left on the way up
    const Solid::Range xs = columns_between(
        std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), low_.x, pitch_.x, columns_);
    const Solid::Range ys = columns_between(
        std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), low_.y, pitch_.y, columns_);
    for (int y = ys.first; y < ys.last; ++y) {
      for (int x = xs.first; x < xs.last; ++x) {
        const double px = low_.x + (x + 0.5) * pitch_.x, py = low_.y + (y + 0.5) * pitch_.y;
        const double wa = edge_side(b, c, px, py), wb = edge_side(c, a, px, py),
                     wc = edge_side(a, b, px, py);
        const bool inside = turn < 0 ? wa > 0 && wb > 0 && wc > 0 : wa < 0 && wb < 0 && wc < 0;
        if (!inside) continue;
        const double z = (wa * a.z + wb * b.z + wc * c.z) / (wa + wb + wc);
        crossings_[static_cast<std::size_t>(y * columns_ + x)].push_back(
            {static_cast<float>(z), turn});
      }
    }
  }

  std::vector<std::vector<Solid::Span>> spans() {
    std::vector<std::vector<Solid::Span>> all;
    for (std::vector<Crossing>& column : crossings_) {
      std::stable_sort(column.begin(), column.end(), [](const Crossing& a, const Crossing& b) {
        return a.z < b.z;
      });
      std::vector<Solid::Span>& spans = all.emplace_back();
      int depth = 0;
      float low = 0;
      for (const Crossing& crossing : column) {
        if (depth == 0) low = crossing.z;
        depth += crossing.turn;
        if (depth == 0 && crossing.z > low) spans.push_back({low, crossing.z});
      }
    }
    return all;
  }

 private:
  Vec3 low_, pitch_;
  int columns_;
  std::vector<std::vector<Crossing>> crossings_;
};

}  // namespace

Solid::Solid(const Mesh& mesh, int columns)
    : columns_(columns), bounds_(bounds_of(mesh)), low_(bounds_.low) {
  pitch_ = bounds_.size() / static_cast<float>(columns);
  Sampler sampler(low_, pitch_, columns);
  const std::vector<std::uint32_t> welded = weld_positions(mesh.positions, weld_distance_m);
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return to_double(mesh.positions[welded[t[i]]]); };
    sampler.add(corner(0), corner(1), corner(2));
  }
  spans_ = sampler.spans();
}

double Solid::volume() const {
  double length = 0;
  for (const std::vector<Span>& column : spans_) {
    for (const Span& span : column)
      length += static_cast<double>(span.high) - span.low;
  }
  return length * column_area();
}

MassProperties Solid::mass_properties(float below_z) const {
  const double dx = pitch_.x, dy = pitch_.y;
  double volume = 0;
  Vec3 first{};                    // moments about the origin
  std::array<double, 6> second{};  // integrals of xx yy zz xy xz yz
  for (int y = 0; y < columns_; ++y) {
    for (int x = 0; x < columns_; ++x) {
      const Vec3 at{low_.x + (x + 0.5) * dx, low_.y + (y + 0.5) * dy, 0};
      for (const Span& span : spans(x, y)) {
        const double low = span.low, high = std::min(span.high, below_z);
        if (high <= low) continue;
        const double v = (high - low) * dx * dy, z = (low + high) / 2, dz = high - low;
        volume += v;
        first += Vec3{at.x, at.y, z} * v;
        second[0] += v * (at.x * at.x + dx * dx / 12);
        second[1] += v * (at.y * at.y + dy * dy / 12);
        second[2] += v * (z * z + dz * dz / 12);
        second[3] += v * at.x * at.y;
        second[4] += v * at.x * z;
        second[5] += v * at.y * z;
      }
    }
  }
  if (volume <= 0) return {};
  const Vec3 c = first / volume;
  const double xx = second[0] - volume * c.x * c.x, yy = second[1] - volume * c.y * c.y,
               zz = second[2] - volume * c.z * c.z;
  return {volume,
          c,
          {yy + zz,
           xx + zz,
           xx + yy,
           -(second[3] - volume * c.x * c.y),
           -(second[4] - volume * c.x * c.z),
           -(second[5] - volume * c.y * c.z)}};
}

float Solid::fill_height(double share) const {
  float low = bounds_.low.z, high = bounds_.high.z;
  const double wanted = share * volume();
  constexpr int halvings = 20;  // a millionth of the height
  for (int i = 0; i < halvings; ++i) {
    const float middle = 0.5F * (low + high);
    (mass_properties(middle).volume < wanted ? low : high) = middle;
  }
  return high;
}

}  // namespace geometry
}  // namespace marketgen
