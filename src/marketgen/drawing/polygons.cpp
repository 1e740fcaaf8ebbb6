#include "drawing/polygons.h"

#include <algorithm>
#include <cmath>

#include <polyclipping/clipper.hpp>

namespace marketgen::drawing {
namespace {

namespace cl = ClipperLib;

constexpr double steps_per_mm = 100;
constexpr double line_mm = 1;  // half the width of a line that has none
constexpr double miter_limit = 4;

cl::Path path_of(const Polygon& polygon) {
  cl::Path path;
  for (const Vec2& p : polygon)
    path.emplace_back(std::llround(p.x * steps_per_mm), std::llround(p.y * steps_per_mm));
  return path;
}

Polygon polygon_of(const cl::Path& path) {
  Polygon polygon;
  for (const cl::IntPoint& p : path)
    polygon.push_back(
        {static_cast<double>(p.X) / steps_per_mm, static_cast<double>(p.Y) / steps_per_mm});
  return polygon;
}

cl::Paths offset(const cl::Paths& paths, double by_mm) {
  cl::ClipperOffset grow(miter_limit);
  grow.AddPaths(paths, cl::jtMiter, cl::etClosedPolygon);
  cl::Paths grown;
  grow.Execute(grown, by_mm * steps_per_mm);
  return grown;
}

// The one that encloses most.
cl::Path largest(const cl::Paths& paths) {
  const auto best = std::ranges::max_element(
      paths, {}, [](const cl::Path& path) { return std::abs(cl::Area(path)); });
  return best == paths.end() ? cl::Path{} : *best;
}

double mm2(double area) {
  return std::abs(area) / (steps_per_mm * steps_per_mm);
}

// Of a node that is a hole, with the faces deeper down. Returns the largest of them.
double add_faces(const cl::PolyNode& node, std::vector<Face>& faces) {
  double best = 0, taken = 0;
  for (const cl::PolyNode* child : node.Childs) {
    best = std::max(best, add_faces(*child, faces));
    taken += mm2(cl::Area(child->Contour));
  }
  if (!node.IsHole()) return best;
  Face face;
  face.outline = polygon_of(largest(offset({node.Contour}, line_mm)));
  if (area_mm2(face.outline) < 0) std::ranges::reverse(face.outline);
  face.area_mm2 = mm2(cl::Area(node.Contour)) - taken;
  face.inner_mm2 = best;
  const double own = face.area_mm2;
  faces.push_back(std::move(face));
  return std::max(best, own);
}

double off_line(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 way = b - a;
  const double length = std::hypot(way.x, way.y);
  if (length == 0) return std::hypot(p.x - a.x, p.y - a.y);
  return std::abs(way.x * (p.y - a.y) - way.y * (p.x - a.x)) / length;
}

// A little longer at both ends, so that it meets what it nearly meets.
Polygon reaching(const Polygon& line) {
  constexpr double reach_mm = 5;
  const Vec2 a = line.front(), b = line.back();
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length == 0) return line;
  const Vec2 more = (b - a) * (reach_mm / length);
  return {a - more, b + more};
}

double left_turn(Vec2 a, Vec2 b, Vec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

std::vector<Polygon> thick_line(const Polygon& line, bool closed, double width) {
  cl::ClipperOffset grow(miter_limit);
  grow.AddPath(path_of(line), cl::jtMiter, closed ? cl::etClosedLine : cl::etOpenButt);
  cl::Paths bodies;
  grow.Execute(bodies, width / 2 * steps_per_mm);
  std::vector<Polygon> polygons;
  for (const cl::Path& body : bodies)
    polygons.push_back(polygon_of(body));
  return polygons;
}

std::vector<Face> faces_of(const std::vector<Polygon>& lines) {
  cl::ClipperOffset grow(miter_limit);
  for (const Polygon& line : lines)
    grow.AddPath(path_of(reaching(line)), cl::jtMiter, cl::etOpenSquare);
  cl::PolyTree tree;
  grow.Execute(tree, line_mm * steps_per_mm);
  std::vector<Face> faces;
  for (const cl::PolyNode* child : tree.Childs)
    add_faces(*child, faces);
  return faces;
}

Polygon grown(const Polygon& polygon, double by) {
  cl::Path path = path_of(polygon);
  if (!cl::Orientation(path)) cl::ReversePath(path);
  return polygon_of(largest(offset({path}, by)));
}

Polygon closed_slits(const Polygon& polygon, double by) {
  const cl::Path grown = largest(offset({path_of(polygon)}, by));
  Polygon closed = polygon_of(largest(offset({grown}, -by)));
  if (area_mm2(closed) < 0) std::ranges::reverse(closed);
  return closed;
}

Polygon simplified(const Polygon& polygon, double within) {
  Polygon left = polygon;
  while (left.size() > 3) {  // the least corner first
    std::size_t least = 0;
    double off = within;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const std::size_t n = left.size();
      const double one = off_line(left[i], left[(i + n - 1) % n], left[(i + 1) % n]);
      if (one >= off) continue;
      off = one;
      least = i + 1;
    }
    if (least == 0) break;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(least) - 1);
  }
  return left;
}

Polygon sharpened(const Polygon& polygon, double shorter) {
  Polygon left = polygon;
  for (std::size_t i = 0; i < left.size() && left.size() > 4;) {
    const std::size_t n = left.size();
    const Vec2 before = left[(i + n - 1) % n], a = left[i], b = left[(i + 1) % n],
               after = left[(i + 2) % n];
    const auto apart = [](Vec2 p, Vec2 q) { return std::hypot(p.x - q.x, p.y - q.y); };
    const Vec2 u = a - before, v = after - b;
    const double cross = u.x * v.y - u.y * v.x;
    const double sizes = std::hypot(u.x, u.y) * std::hypot(v.x, v.y);
    const bool cut = apart(a, b) < shorter && apart(before, a) > 2 * shorter &&
                     apart(b, after) > 2 * shorter && std::abs(cross) > 0.2 * sizes;
    if (cut) {
      const double t = ((b.x - a.x) * v.y - (b.y - a.y) * v.x) / cross;
      const Vec2 corner = a + u * t;
      if (apart(corner, a) < 2 * shorter) {
        left[i] = corner;
        left.erase(left.begin() + static_cast<std::ptrdiff_t>((i + 1) % n));
        continue;
      }
    }
    ++i;
  }
  return left;
}

double area_mm2(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

bool contains(const Polygon& polygon, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

double overlap_share(const Polygon& a, const Polygon& b) {
  const auto area_of = [&](cl::ClipType kind) {
    cl::Clipper clipper;
    clipper.AddPath(path_of(a), cl::ptSubject, true);
    clipper.AddPath(path_of(b), cl::ptClip, true);
    cl::Paths result;
    clipper.Execute(kind, result, cl::pftNonZero, cl::pftNonZero);
    double area = 0;
    for (const cl::Path& path : result)
      area += cl::Area(path);
    return area;
  };
  const double all = area_of(cl::ctUnion);
  return all > 0 ? area_of(cl::ctIntersection) / all : 0;
}

const Vec2* crossing_of(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % n];
    for (std::size_t k = i + 2; k < n; ++k) {
      if ((k + 1) % n == i) continue;
      const Vec2 c = polygon[k], d = polygon[(k + 1) % n];
      if (left_turn(a, b, c) * left_turn(a, b, d) < 0 &&
          left_turn(c, d, a) * left_turn(c, d, b) < 0)
        return &polygon[i];
    }
  }
  return nullptr;
}

}  // namespace marketgen::drawing
