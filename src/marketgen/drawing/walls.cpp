#include "drawing/walls.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "drawing/polygons.h"

namespace marketgen::drawing {
namespace {

constexpr double wall_degree = std::numbers::pi / 180;
constexpr double thick_line_mm = 40;     // thinner lines have no width on the floor
constexpr double shortest_end_mm = 100;  // shorter pieces say nothing of a wall's direction
const double straight_on = std::cos(3 * wall_degree);
constexpr double largest_small_shape_mm = 2000, slimmest_small_shape = 4;

// Walls where some are named, else outlines, else what has no name.
Role role_of_walls(const Sketch& sketch) {
  for (const Role role : {Role::wall, Role::outline}) {
    if (std::ranges::any_of(sketch.strokes, [&](const Stroke& s) { return s.role == role; }))
      return role;
  }
  return Role::unknown;
}

// What is drawn as walls: strokes of that role, or whatever has none.
bool is_wall(const Stroke& stroke, Role role) {
  if (role != Role::unknown) return stroke.role == role;
  return stroke.role == Role::unknown && !is_door_swing(stroke) && !is_small_shape(stroke);
}

void add_line(std::vector<Segment>& segments, const std::vector<Vec2>& points, bool closed) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    segments.push_back({points[i], points[i + 1]});
  if (closed && points.size() > 2) segments.push_back({points.back(), points.front()});
}

// Ends of segments, joined where they meet.
class Joints {
 public:
  Joints(const std::vector<Segment>& segments, double join_mm) : join_mm_(join_mm) {
    for (const Segment& segment : segments) {
      ends_.push_back(joint_at(segment.from));
      ends_.push_back(joint_at(segment.to));
    }
    at_.resize(joints_.size());
    for (std::size_t e = 0; e < ends_.size(); ++e)
      at_[ends_[e]].push_back(e);
  }

  // Ends are numbered 2 i and 2 i + 1 for segment i.
  const std::vector<std::size_t>& ends_with(std::size_t end) const { return at_[ends_[end]]; }

  // Ends that nearly meet meet.
  void snap(std::vector<Segment>& segments) const {
    for (std::size_t i = 0; i < segments.size(); ++i)
      segments[i] = {joints_[ends_[2 * i]], joints_[ends_[2 * i + 1]]};
  }

 private:
  std::size_t joint_at(Vec2 p) {
    const auto cell = [&](double v) { return static_cast<long long>(std::floor(v / join_mm_)); };
    for (long long dx = -1; dx <= 1; ++dx) {
      for (long long dy = -1; dy <= 1; ++dy) {
        const auto found = cells_.find({cell(p.x) + dx, cell(p.y) + dy});
        if (found == cells_.end()) continue;
        for (const std::size_t joint : found->second)
          if (distance(joints_[joint], p) <= join_mm_) return joint;
      }
    }
    cells_[{cell(p.x), cell(p.y)}].push_back(joints_.size());
    joints_.push_back(p);
    return joints_.size() - 1;
  }

  double join_mm_;
  std::vector<Vec2> joints_;
  std::vector<std::size_t> ends_;
  std::vector<std::vector<std::size_t>> at_;
  std::map<std::pair<long long, long long>, std::vector<std::size_t>> cells_;
};

struct End {
  std::size_t index;
  Vec2 at, outward;  // a unit vector, on over the end
};

class GapFinder {
 public:
  GapFinder(const std::vector<Segment>& segments, const Tolerance& tolerance)
      : segments_(segments), tolerance_(tolerance), joints_(segments, tolerance.join_mm) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Segment& s = segments[i];
      const double l = length(s);
      if (l < shortest_end_mm) continue;
      const Vec2 on = (s.to - s.from) * (1 / l);
      if (is_loose(2 * i, on)) ends_.push_back({2 * i, s.from, on * -1});
      if (is_loose(2 * i + 1, on)) ends_.push_back({2 * i + 1, s.to, on});
    }
  }

  std::vector<Bridge> run() const {
    std::vector<std::size_t> nearest(ends_.size());
    for (std::size_t i = 0; i < ends_.size(); ++i)
      nearest[i] = opposite(i);
    std::vector<Bridge> bridges;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const std::size_t k = nearest[i];
      if (k < ends_.size() && k > i && nearest[k] == i)
        bridges.push_back({ends_[i].at, ends_[k].at});
    }
    return bridges;
  }

 private:
  // Nothing goes on from here but the end of a wall as thick as one, or the leaf of a door.
  bool is_loose(std::size_t end, Vec2 on) const {
    for (const std::size_t other : joints_.ends_with(end)) {
      if (other / 2 == end / 2) continue;
      const Segment& s = segments_[other / 2];
      const double l = length(s);
      if (l <= tolerance_.join_mm) continue;
      const Vec2 way = (s.to - s.from) * (1 / l);
      const bool across = std::abs(way.x * on.x + way.y * on.y) < 0.7;
      const bool dangles = joints_.ends_with(other ^ 1U).size() == 1 && l < 2500;
      if (!across || (l > thickest_wall_mm && !dangles)) return false;
    }
    return true;
  }

  // The nearest end that faces this one across a gap; ends_.size() when none does.
  std::size_t opposite(std::size_t i) const {
    const End& a = ends_[i];
    std::size_t best = ends_.size();
    double best_gap = widest_opening_mm;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      const End& b = ends_[k];
      if (k == i || a.outward.x * b.outward.x + a.outward.y * b.outward.y > -straight_on) continue;
      const Vec2 way = b.at - a.at;
      const double gap = way.x * a.outward.x + way.y * a.outward.y;
      const double aside = std::abs(way.x * a.outward.y - way.y * a.outward.x);
      if (gap < narrowest_opening_mm || gap > best_gap) continue;
      if (aside > std::max(2 * tolerance_.line_mm, 0.01 * gap)) continue;
      best = k;
      best_gap = gap;
    }
    return best;
  }

  const std::vector<Segment>& segments_;
  const Tolerance& tolerance_;
  Joints joints_;
  std::vector<End> ends_;
};

}  // namespace

double length(const Segment& segment) {
  return distance(segment.from, segment.to);
}

double distance(Vec2 p, const Segment& segment) {
  const Vec2 way = segment.to - segment.from, to = p - segment.from;
  const double square = way.x * way.x + way.y * way.y;
  const double t = square > 0 ? std::clamp((way.x * to.x + way.y * to.y) / square, 0.0, 1.0) : 0;
  return distance(p, segment.from + way * t);
}

bool is_door_swing(const Stroke& stroke) {
  if (!stroke.arc) return false;
  const Arc& arc = *stroke.arc;
  return arc.radius >= narrowest_opening_mm && arc.radius <= 2500 &&
         arc.sweep >= 50 * wall_degree && arc.sweep <= 130 * wall_degree;
}

bool is_small_shape(const Stroke& stroke) {
  if (!stroke.closed) return false;
  Vec2 low = stroke.points[0], high = low;
  for (const Vec2& p : stroke.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double w = high.x - low.x, d = high.y - low.y;
  return std::max(w, d) <= largest_small_shape_mm &&
         std::max(w, d) <= slimmest_small_shape * std::min(w, d);
}

Walls walls_of(const Sketch& sketch, const Tolerance& tolerance) {
  Walls walls;
  const Role role = role_of_walls(sketch);
  walls.named = role != Role::unknown;
  for (const Stroke& stroke : sketch.strokes) {
    if (!is_wall(stroke, role) || (sketch.picture && is_small_shape(stroke))) continue;
    if (stroke.line_width < thick_line_mm) {
      add_line(walls.segments, stroke.points, stroke.closed);
      continue;
    }
    for (const std::vector<Vec2>& body :
         thick_line(stroke.points, stroke.closed, stroke.line_width))
      add_line(walls.segments, body, true);
  }
  if (walls.segments.size() <= max_wall_segments) {
    Joints(walls.segments, tolerance.join_mm).snap(walls.segments);
    std::erase_if(walls.segments, [](const Segment& s) { return s.from == s.to; });
  }
  return walls;
}

void bridge_gaps(Walls& walls, const Tolerance& tolerance) {
  walls.bridges = GapFinder(walls.segments, tolerance).run();
}

}  // namespace marketgen::drawing
