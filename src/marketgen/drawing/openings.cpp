#include <algorithm>
#include <cmath>
#include <numeric>

#include "drawing/recognise.h"

namespace marketgen::drawing {
namespace {

constexpr double symbol_gap_mm = 60;  // lines of one door are no farther apart
constexpr double in_wall_mm = 450;    // a symbol's part within the wall or beside it
constexpr double same_opening = 0.3;  // share of the narrower one that two have in common

struct Box {
  Vec2 low{1e18, 1e18}, high{-1e18, -1e18};

  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool near(const Box& o, double by) const {
    return low.x <= o.high.x + by && o.low.x <= high.x + by && low.y <= o.high.y + by &&
           o.low.y <= high.y + by;
  }
};

// A door or window as it is drawn.
struct Symbol {
  std::vector<Vec2> points;
  Role role = Role::door;
  std::string name;
};

bool is_opening(const Stroke& stroke) {
  return stroke.role == Role::door || stroke.role == Role::window ||
         (stroke.role == Role::unknown && is_door_swing(stroke));
}

Box box_of(const Stroke& stroke) {
  Box box;
  for (const Vec2& p : stroke.points)
    box.add(p);
  if (stroke.arc) box.add(stroke.arc->centre);
  return box;
}

std::vector<Symbol> symbols_of(const Sketch& sketch) {
  constexpr std::size_t most = 4000;
  std::vector<const Stroke*> strokes;
  for (const Stroke& stroke : sketch.strokes)
    if (is_opening(stroke) && strokes.size() < most) strokes.push_back(&stroke);
  std::vector<Box> boxes;
  for (const Stroke* stroke : strokes)
    boxes.push_back(box_of(*stroke));
  std::vector<std::size_t> group(strokes.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (group[i] != i)
      i = group[i] = group[group[i]];
    return i;
  };
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    for (std::size_t k = i + 1; k < strokes.size(); ++k) {
      const bool same =
          strokes[i]->symbol == strokes[k]->symbol && strokes[i]->role == strokes[k]->role;
      if (same && boxes[i].near(boxes[k], symbol_gap_mm)) group[root(k)] = root(i);
    }
  }
  std::vector<Symbol> symbols(strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    Symbol& symbol = symbols[root(i)];
    symbol.points.insert(symbol.points.end(), strokes[i]->points.begin(), strokes[i]->points.end());
    if (strokes[i]->arc) symbol.points.push_back(strokes[i]->arc->centre);
    symbol.role = strokes[i]->role == Role::window ? Role::window : Role::door;
    symbol.name = strokes[i]->name;
  }
  std::erase_if(symbols, [](const Symbol& symbol) { return symbol.points.empty(); });
  return symbols;
}

// An edge of the outline with the distances along it.
struct Edge {
  std::size_t index;
  Vec2 from, way;  // a unit vector
  double length;

  double along(Vec2 p) const { return (p.x - from.x) * way.x + (p.y - from.y) * way.y; }
  double aside(Vec2 p) const { return std::abs((p.x - from.x) * way.y - (p.y - from.y) * way.x); }
  double away(Vec2 p) const {
    const double t = along(p);
    return std::hypot(aside(p), std::max({0.0, -t, t - length}));
  }
  FoundOpening opening(double begin, double end) const {
    return {from + way * begin, from + way * end, index, Role::door, ""};
  }
};

std::vector<Edge> edges_of(const Polygon& outline) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double l = distance(a, b);
    if (l > 0) edges.push_back({i, a, (b - a) * (1 / l), l});
  }
  return edges;
}

// How much of the narrower one the two have in common.
double common_share(const FoundOpening& a, const FoundOpening& b) {
  if (a.edge != b.edge) return 0;
  const double l = distance(a.from, a.to);
  const Vec2 way = (a.to - a.from) * (1 / l);
  const auto along = [&](Vec2 p) { return (p.x - a.from.x) * way.x + (p.y - a.from.y) * way.y; };
  const double common = std::min(l, along(b.to)) - std::max(0.0, along(b.from));
  return common / std::min(l, distance(b.from, b.to));
}

// The gap lies on the outline.
void add_gap(std::vector<FoundOpening>& openings,
             const Bridge& bridge,
             const std::vector<Edge>& edges,
             const Tolerance& tolerance) {
  const double near = 30 + 2 * tolerance.line_mm;
  for (const Edge& edge : edges) {
    if (edge.away(bridge.from) > near || edge.away(bridge.to) > near) continue;
    const double a = edge.along(bridge.from), b = edge.along(bridge.to);
    const FoundOpening gap =
        edge.opening(std::max(0.0, std::min(a, b)), std::min(edge.length, std::max(a, b)));
    if (distance(gap.from, gap.to) < narrowest_opening_mm) return;
    const bool known = std::ranges::any_of(
        openings, [&](const FoundOpening& one) { return common_share(one, gap) > same_opening; });
    if (!known) openings.push_back(gap);
    return;
  }
}

// The stretch of the outline that a symbol takes; nothing when it stands elsewhere.
std::optional<FoundOpening> place_of(const Symbol& symbol, const std::vector<Edge>& edges) {
  std::optional<FoundOpening> best;
  double best_width = narrowest_opening_mm;
  for (const Edge& edge : edges) {
    double begin = edge.length, end = 0;
    for (const Vec2& p : symbol.points) {
      if (edge.aside(p) > in_wall_mm) continue;
      const double t = std::clamp(edge.along(p), 0.0, edge.length);
      begin = std::min(begin, t);
      end = std::max(end, t);
    }
    if (end - begin <= best_width) continue;
    best_width = end - begin;
    best = edge.opening(begin, end);
    best->role = symbol.role;
    best->name = symbol.name;
  }
  return best;
}

}  // namespace

std::vector<FoundOpening> openings_of(const Sketch& sketch,
                                      const Walls& walls,
                                      const Polygon& outline,
                                      const Tolerance& tolerance) {
  const std::vector<Edge> edges = edges_of(outline);
  std::vector<FoundOpening> openings;
  for (const Bridge& bridge : walls.bridges)
    add_gap(openings, bridge, edges, tolerance);
  for (const Symbol& symbol : symbols_of(sketch)) {
    std::optional<FoundOpening> drawn = place_of(symbol, edges);
    if (!drawn) continue;
    const auto same = std::ranges::find_if(openings, [&](const FoundOpening& one) {
      return common_share(one, *drawn) > same_opening;
    });
    if (same == openings.end()) {
      openings.push_back(std::move(*drawn));
    } else if (same->name.empty()) {  // the gap says where, the symbol what
      same->name = drawn->name;
      same->role = drawn->role;
    }
  }
  return openings;
}

}  // namespace marketgen::drawing
