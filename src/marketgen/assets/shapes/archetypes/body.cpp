#include "assets/shapes/archetypes/body.h"

#include <algorithm>
#include <cmath>

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr int lump_count = 7;
constexpr float groove_half_turn = 0.055F;  // width of a peach's seam
constexpr double groove_toward = 0.62;      // in front, at the right hand
constexpr int line_points = 96;

std::vector<Vec2f> points_of(const Outline& outline) {
  std::vector<Vec2f> points;
  for (const Vec2& p : outline) {
    points.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
    if (points.size() > 1 && p.x <= 0) break;
  }
  return points;
}

float distance(Vec2f a, Vec2f b) {
  const Vec2f d = b - a;
  return std::sqrt(d.x * d.x + d.y * d.y);
}

// Between b and c: a centripetal Catmull-Rom curve, which neither loops nor overshoots where points
// lie close (Barry and Goldman, SIGGRAPH 1988).
Vec2f curve_between(Vec2f a, Vec2f b, Vec2f c, Vec2f d, float t) {
  const auto knot = [](Vec2f p, Vec2f q) { return std::sqrt(std::max(distance(p, q), 1e-4F)); };
  const float t1 = knot(a, b), t2 = t1 + knot(b, c), t3 = t2 + knot(c, d);
  const float at = t1 + (t2 - t1) * t;
  const auto mix = [at](Vec2f p, Vec2f q, float from, float to) {
    return p * ((to - at) / (to - from)) + q * ((at - from) / (to - from));
  };
  const Vec2f ab = mix(a, b, 0, t1), bc = mix(b, c, t1, t2), cd = mix(c, d, t2, t3);
  return mix(mix(ab, bc, 0, t2), mix(bc, cd, t1, t3), t1, t2);
}

// The smooth outline; beyond a pole it goes on as its mirror image, so that it crosses the axis
// level.
std::vector<Vec2f> smooth_line(const Outline& outline) {
  std::vector<Vec2f> points = points_of(outline);
  const Vec2f first = points[1], last = points[points.size() - 2];
  points.insert(points.begin(), {-first.x, first.y});
  points.push_back({-last.x, last.y});
  std::vector<Vec2f> line;
  constexpr int samples = 16;
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    for (int s = 0; s < samples; ++s) {
      line.push_back(curve_between(
          points[i - 1], points[i], points[i + 1], points[i + 2], static_cast<float>(s) / samples));
    }
  }
  line.push_back(points[points.size() - 2]);
  for (Vec2f& p : line)
    p.x = std::max(p.x, 0.0F);
  return line;
}

// The line's points at equal lengths on a body of that half width and length.
std::vector<Vec2f> evened(const std::vector<Vec2f>& line, Vec2f scale) {
  std::vector<float> at{0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2f a{line[i - 1].x * scale.x, line[i - 1].y * scale.y};
    const Vec2f b{line[i].x * scale.x, line[i].y * scale.y};
    at.push_back(at.back() + distance(a, b));
  }
  std::vector<Vec2f> even{line.front()};
  std::size_t i = 1;
  for (int k = 1; k < line_points; ++k) {
    const float want = at.back() * static_cast<float>(k) / line_points;
    while (at[i] < want)
      ++i;
    const float t = (want - at[i - 1]) / std::max(at[i] - at[i - 1], 1e-9F);
    even.push_back(line[i - 1] + (line[i] - line[i - 1]) * t);
  }
  even.push_back(line.back());
  return even;
}

}  // namespace

GrownBody::GrownBody(const BodyForm& form, Vec3f half, Stream draw)
    : form_(form),
      half_(half),
      line_(evened(smooth_line(form.outline), {std::min(half.x, half.y), 2 * half.z})) {
  for (int i = 0; i < lump_count; ++i) {
    const Vec3 direction{draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)};
    lumps_.push_back({to_float(normalized(direction)), static_cast<float>(draw.uniform(-1, 1))});
  }
  for (int i = 0; i < form.lobes; ++i)
    lobe_sizes_.push_back(static_cast<float>(draw.uniform(0.75, 1.25)));
  lobe_turn_ = draw.uniform();
  groove_turn_ = groove_toward + draw.uniform(-0.08, 0.08);
  lean_ = {static_cast<float>(form.lean * draw.uniform(-1, 1)),
           static_cast<float>(form.lean * draw.uniform(-1, 1))};
  bend_ = static_cast<float>(form.bend);
}

Vec2f GrownBody::outline_at(double along) const {
  const double place = along * line_points;
  const auto i = std::min(static_cast<std::size_t>(place), line_.size() - 2);
  const auto t = static_cast<float>(place - static_cast<double>(i));
  return line_[i] + (line_[i + 1] - line_[i]) * t;
}

// 0 on the ribs, down to -1 in the valleys, each rib of its own size.
float GrownBody::lobe_wave(double turn) const {
  if (form_.lobes == 0) return 0;
  double place = (turn + lobe_turn_) * form_.lobes;
  const auto whole = static_cast<int>(place);
  place -= whole;
  const auto rib = static_cast<std::size_t>(whole % form_.lobes);
  const std::size_t next = (rib + 1) % lobe_sizes_.size();
  const auto t = static_cast<float>(place);
  const float size = lobe_sizes_[rib] + (lobe_sizes_[next] - lobe_sizes_[rib]) * t;
  const float arch = 4 * t * (1 - t);
  return size * (arch * (2 - arch) - 1);
}

float GrownBody::lump_at(Vec3f direction) const {
  float sum = 0;
  for (const Lump& lump : lumps_) {
    const float toward = dot(direction, lump.direction);
    if (toward > 0) sum += lump.size * toward * toward * toward;
  }
  return sum;
}

// Where the axis lies at that height (0..1): upright bodies lean, long ones bend.
Vec3f GrownBody::off_axis(float height) const {
  const float radius = std::min(half_.x, half_.y);
  const float s = 2 * height - 1;
  const float rise = height * height;
  return {lean_.x * rise * radius - bend_ * 2 * half_.z * (1 - s * s), lean_.y * rise * radius, 0};
}

Vec3f GrownBody::point(double turn, double along) const {
  const Vec2f outline = outline_at(along);
  const Vec2 circle = unit_circle(0.25 + turn);
  const auto cx = static_cast<float>(circle.x), cy = static_cast<float>(circle.y);
  const float up = 2 * outline.y - 1;
  const Vec3f direction = normalized(Vec3f{outline.x * cx, outline.x * cy, up});
  const float spread = std::min(1.0F, 1.6F * outline.x);  // all that goes around ends at the poles
  const auto depth =
      static_cast<float>(form_.lobe_low + (form_.lobe_high - form_.lobe_low) * double{outline.y});
  float swell = 1 + spread * depth * lobe_wave(turn);
  const auto from_groove = static_cast<float>(turn - groove_turn_) / groove_half_turn;
  if (form_.groove > 0 && std::abs(from_groove) < 1) {
    const float wall = 1 - from_groove * from_groove;
    swell -= static_cast<float>(form_.groove) * wall * wall * spread;
  }
  swell += static_cast<float>(form_.lumps) * lump_at(direction);
  const Vec3f own{outline.x * cx * half_.x * swell,
                  outline.x * cy * half_.y * swell,
                  half_.z * (1 + up * (1 + (swell - 1) * 0.8F))};
  return own + off_axis(outline.y);
}

}  // namespace marketgen::assets
