#include "assets/shapes/mesh_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/circle.h"
#include "geometry/convex_hull.h"

namespace marketgen::assets {
namespace {

// Directions in which a hull's points are sought: to compare cuts, and of the parts that were made.
constexpr std::size_t few = 64, many = 320;
constexpr int max_slabs = 24;  // cuts that are tried along one axis, and one more

// The directions to both sides along each axis, and others spread evenly over the sphere.
template <std::size_t count>
struct Directions {
  std::array<float, count> x, y, z;

  static const Directions& all() {
    static const Directions directions = spread();
    return directions;
  }

 private:
  static Directions spread() {
    Directions spread{};
    std::size_t n = 0;
    const auto add = [&](double to_x, double to_y, double to_z) {
      spread.x[n] = static_cast<float>(to_x);
      spread.y[n] = static_cast<float>(to_y);
      spread.z[n] = static_cast<float>(to_z);
      ++n;
    };
    for (const double side : {-1.0, 1.0})
      add(side, 0, 0), add(0, side, 0), add(0, 0, side);
    constexpr double golden_turn = 1 - 1 / std::numbers::phi;
    constexpr std::size_t others = count - 6;
    for (std::size_t i = 0; i < others; ++i) {
      const double z = 1 - (2.0 * static_cast<double>(i) + 1) / others;
      const double radius = std::sqrt(1 - z * z);
      const Vec2 around = unit_circle(golden_turn * static_cast<double>(i));
      add(radius * around.x, radius * around.y, z);
    }
    return spread;
  }
};

// Into a frame in which a part's bounds are a cube: flat and long parts are sampled as evenly.
struct CubeFrame {
  Vec3f center, scale;
  explicit CubeFrame(const Bounds3& bounds) : center(bounds.center()) {
    const Vec3f size = bounds.size();
    const auto inverse = [](float s) { return s > 0 ? 2 / s : 0.0F; };
    scale = {inverse(size.x), inverse(size.y), inverse(size.z)};
  }
  Vec3f operator()(Vec3f p) const { return (p - center) * scale; }
};

// The farthest of the points shown so far, in each direction.
template <std::size_t count>
class Extremes {
 public:
  Extremes() { reach_.fill(-1e30F); }

  void add(Vec3f point, const CubeFrame& frame) {
    const Vec3f p = frame(point);
    const Directions<count>& d = Directions<count>::all();
    std::array<float, count> reach;
    for (std::size_t i = 0; i < count; ++i)
      reach[i] = d.x[i] * p.x + d.y[i] * p.y + d.z[i] * p.z;
    for (std::size_t i = 0; i < count; ++i) {
      if (reach[i] > reach_[i]) reach_[i] = reach[i], points_[i] = point;
    }
  }
  void add(const ConvexPolygon& polygon, const CubeFrame& frame) {
    for (int i = 0; i < polygon.count; ++i)
      add(polygon.points[static_cast<std::size_t>(i)], frame);
  }

  void include(const Extremes& other) {
    for (std::size_t i = 0; i < count; ++i) {
      if (other.reach_[i] > reach_[i]) reach_[i] = other.reach_[i], points_[i] = other.points_[i];
    }
  }

  // Each once.
  std::vector<Vec3f> points() const {
    std::vector<Vec3f> all;
    for (std::size_t i = 0; i < count; ++i) {
      if (reach_[i] > -1e30F) all.push_back(points_[i]);
    }
    const auto before = [](Vec3f a, Vec3f b) {
      return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
    };
    std::sort(all.begin(), all.end(), before);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

 private:
  std::array<float, count> reach_;
  std::array<Vec3f, count> points_;
};

float along(Vec3f p, CutAxis axis) {
  return axis == CutAxis::x ? p.x : axis == CutAxis::y ? p.y : p.z;
}

// What lies on the side of `place` to which `sign` points.
ConvexPolygon clipped(const ConvexPolygon& polygon, CutAxis axis, float place, float sign) {
  ConvexPolygon kept;
  for (int i = 0; i < polygon.count; ++i) {
    const Vec3f a = polygon.points[static_cast<std::size_t>(i)],
                b = polygon.points[static_cast<std::size_t>((i + 1) % polygon.count)];
    const float da = sign * (along(a, axis) - place), db = sign * (along(b, axis) - place);
    const auto keep = [&](Vec3f p) {
      if (kept.count < static_cast<int>(kept.points.size()))
        kept.points[static_cast<std::size_t>(kept.count++)] = p;
    };
    if (da >= 0) keep(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) keep(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

struct Reach {
  float low, high;
};
Reach reach_of(const ConvexPolygon& polygon, CutAxis axis) {
  Reach reach{1e30F, -1e30F};
  for (int i = 0; i < polygon.count; ++i) {
    const float at = along(polygon.points[static_cast<std::size_t>(i)], axis);
    reach = {std::min(reach.low, at), std::max(reach.high, at)};
  }
  return reach;
}

// The places at which a part may be cut along an axis, its two ends included.
struct Planes {
  std::vector<float> places;
  std::vector<int> columns;  // X and Y
};

Planes planes_of(const MeshPart& part, const Solid& solid, CutAxis axis) {
  Planes planes;
  if (axis == CutAxis::z) {
    const float low = part.bounds.low.z, span = part.bounds.high.z - low;
    for (int i = 0; i <= max_slabs; ++i)
      planes.places.push_back(low + span * static_cast<float>(i) / max_slabs);
    return planes;
  }
  const Solid::Range range = axis == CutAxis::x ? part.box.x : part.box.y;
  const int slabs = std::min(max_slabs, range.last - range.first);
  for (int i = 0; i <= slabs; ++i) {
    const int column = range.first + (range.last - range.first) * i / std::max(slabs, 1);
    planes.columns.push_back(column);
    planes.places.push_back(axis == CutAxis::x ? solid.column_x(column) : solid.column_y(column));
  }
  return planes;
}

template <class Visit>  // (x, y, low, high) of each span in the box
void for_each_span(const PartBox& box, const Solid& solid, const Visit& visit) {
  for (int y = box.y.first; y < box.y.last; ++y) {
    for (int x = box.x.first; x < box.x.last; ++x) {
      for (const Solid::Span& span : solid.spans(x, y)) {
        const float low = std::max(span.low, box.low_z), high = std::min(span.high, box.high_z);
        if (high > low) visit(x, y, low, high);
      }
    }
  }
}

// Of the solid below each of the planes.
std::vector<double> volumes_below(const MeshPart& part,
                                  const Solid& solid,
                                  CutAxis axis,
                                  const Planes& planes) {
  std::vector<double> below(planes.places.size(), 0);
  for_each_span(part.box, solid, [&](int x, int y, float low, float high) {
    for (std::size_t k = 1; k < below.size(); ++k) {
      if (axis == CutAxis::z) {
        below[k] += std::max(0.0F, std::min(high, planes.places[k]) - low);
      } else if ((axis == CutAxis::x ? x : y) < planes.columns[k]) {
        below[k] += high - low;
      }
    }
  });
  for (double& volume : below)
    volume *= solid.column_area();
  return below;
}

// The extremes of what lies between each plane and the next.
std::vector<Extremes<few>> extremes_of_slabs(const MeshPart& part,
                                             CutAxis axis,
                                             const Planes& planes) {
  const CubeFrame frame(part.bounds);
  const std::size_t slabs = planes.places.size() - 1;
  std::vector<Extremes<few>> extremes(slabs);
  for (const ConvexPolygon& polygon : part.skin) {
    const Reach reach = reach_of(polygon, axis);
    for (std::size_t k = 0; k < slabs; ++k) {
      const float low = planes.places[k], high = planes.places[k + 1];
      const bool from_below = k == 0 || reach.high >= low,
                 to_above = k + 1 == slabs || reach.low <= high;
      if (!from_below || !to_above) continue;
      ConvexPolygon cut = polygon;
      if (k > 0 && reach.low < low) cut = clipped(cut, axis, low, 1);
      if (k + 1 < slabs && reach.high > high) cut = clipped(cut, axis, high, -1);
      extremes[k].add(cut, frame);
    }
  }
  return extremes;
}

double hull_volume_of(const Extremes<few>& extremes) {
  return convex_hull(extremes.points()).volume;
}

PartCut best_cut_along(const MeshPart& part, const Solid& solid, CutAxis axis) {
  PartCut best;
  const Planes planes = planes_of(part, solid, axis);
  const std::size_t slabs = planes.places.size() - 1;
  if (slabs < 2) return best;
  const std::vector<double> below = volumes_below(part, solid, axis, planes);
  const std::vector<Extremes<few>> extremes = extremes_of_slabs(part, axis, planes);
  std::vector<double> far_hull(slabs + 1, 0);
  Extremes<few> far;
  for (std::size_t k = slabs; k-- > 1;) {
    far.include(extremes[k]);
    far_hull[k] = hull_volume_of(far);
  }
  Extremes<few> near;
  for (std::size_t k = 1; k < slabs; ++k) {
    near.include(extremes[k - 1]);
    const double left = excess(part.sampling * hull_volume_of(near), below[k]) +
                        excess(part.sampling * far_hull[k], part.volume - below[k]);
    if (left >= best.excess) continue;
    best = {axis, axis == CutAxis::z ? 0 : planes.columns[k], planes.places[k], left};
  }
  return best;
}

void measure(MeshPart& part, const Solid& solid) {
  double length = 0;
  for_each_span(part.box, solid, [&](int, int, float low, float high) { length += high - low; });
  part.volume = length * solid.column_area();
  for (const ConvexPolygon& polygon : part.skin) {
    for (int i = 0; i < polygon.count; ++i)
      part.bounds.include(polygon.points[static_cast<std::size_t>(i)]);
  }
  if (part.skin.empty()) return;
  const CubeFrame frame(part.bounds);
  Extremes<many> closely;
  Extremes<few> coarsely;
  for (const ConvexPolygon& polygon : part.skin) {
    closely.add(polygon, frame);
    coarsely.add(polygon, frame);
  }
  part.hull_points = closely.points();
  part.hull_volume = convex_hull(part.hull_points).volume;
  const double coarse = hull_volume_of(coarsely);
  if (coarse > 0) part.sampling = part.hull_volume / coarse;
}

// A line through the body, as a polygon of two points.
ConvexPolygon line(Vec3f a, Vec3f b) {
  ConvexPolygon both;
  both.points[0] = a, both.points[1] = b;
  both.count = 2;
  return both;
}

// Lines over the face that a cut across Z opens, one for each row of columns.
void add_level_face(MeshPart& side, const Solid& solid, float height) {
  const auto middle = [](float a, float b) { return 0.5F * (a + b); };
  for (int y = side.box.y.first; y < side.box.y.last; ++y) {
    const float at_y = middle(solid.column_y(y), solid.column_y(y + 1));
    int first = -1;
    for (int x = side.box.x.first; x <= side.box.x.last; ++x) {
      const bool inside = x < side.box.x.last &&
                          std::ranges::any_of(solid.spans(x, y), [&](const Solid::Span& span) {
                            return span.low <= height && height <= span.high;
                          });
      if (inside && first < 0) first = x;
      if (inside || first < 0) continue;
      side.skin.push_back(
          line({middle(solid.column_x(first), solid.column_x(first + 1)), at_y, height},
               {middle(solid.column_x(x - 1), solid.column_x(x)), at_y, height}));
      first = -1;
    }
  }
}

// The same for a cut across X or Y: the spans of the columns beside it.
void add_upright_face(MeshPart& side, const Solid& solid, const PartCut& cut, bool near) {
  PartBox beside = side.box;
  const bool across_x = cut.axis == CutAxis::x;
  (across_x ? beside.x : beside.y) =
      near ? Solid::Range{cut.column - 1, cut.column} : Solid::Range{cut.column, cut.column + 1};
  for_each_span(beside, solid, [&](int x, int y, float low, float high) {
    const float at_x =
        across_x ? solid.column_x(cut.column) : 0.5F * (solid.column_x(x) + solid.column_x(x + 1));
    const float at_y =
        across_x ? 0.5F * (solid.column_y(y) + solid.column_y(y + 1)) : solid.column_y(cut.column);
    side.skin.push_back(line({at_x, at_y, low}, {at_x, at_y, high}));
  });
}

void add_cut_face(MeshPart& side, const Solid& solid, const PartCut& cut, bool near) {
  if (cut.axis == CutAxis::z) {
    add_level_face(side, solid, cut.height);
  } else {
    add_upright_face(side, solid, cut, near);
  }
}

}  // namespace

double excess(double hull_volume, double volume) {
  return std::max(0.0, hull_volume - volume);
}

MeshPart whole_part(const Mesh& mesh, const Solid& solid) {
  const Solid::Range all{0, solid.columns()};
  MeshPart part{.box = {all, all, -1e30F, 1e30F}};
  for (const auto& t : mesh.triangles) {
    ConvexPolygon& polygon = part.skin.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      polygon.points[i] = mesh.positions[t[i]];
    polygon.count = 3;
  }
  measure(part, solid);
  return part;
}

std::array<MeshPart, 2> split(const MeshPart& part, const Solid& solid, const PartCut& cut) {
  std::array<MeshPart, 2> sides{MeshPart{.box = part.box}, MeshPart{.box = part.box}};
  switch (cut.axis) {
    case CutAxis::x:
      sides[0].box.x.last = sides[1].box.x.first = cut.column;
      break;
    case CutAxis::y:
      sides[0].box.y.last = sides[1].box.y.first = cut.column;
      break;
    case CutAxis::z:
      sides[0].box.high_z = sides[1].box.low_z = cut.height;
  }
  const float place = cut.axis == CutAxis::x   ? solid.column_x(cut.column)
                      : cut.axis == CutAxis::y ? solid.column_y(cut.column)
                                               : cut.height;
  for (std::size_t side = 0; side < 2; ++side) {
    for (const ConvexPolygon& polygon : part.skin) {
      const ConvexPolygon kept = clipped(polygon, cut.axis, place, side == 0 ? -1.0F : 1.0F);
      if (kept.count > 0) sides[side].skin.push_back(kept);
    }
    add_cut_face(sides[side], solid, cut, side == 0);
    measure(sides[side], solid);
  }
  return sides;
}

std::vector<PartFoot> feet_of(const MeshPart& part, const Solid& solid) {
  const Planes planes = planes_of(part, solid, CutAxis::z);
  const std::vector<double> below = volumes_below(part, solid, CutAxis::z, planes);
  const std::vector<Extremes<few>> slabs = extremes_of_slabs(part, CutAxis::z, planes);
  std::vector<PartFoot> feet;
  Extremes<few> so_far;
  for (std::size_t k = 1; k < slabs.size(); ++k) {
    so_far.include(slabs[k - 1]);
    PartFoot& foot = feet.emplace_back();
    foot.height = planes.places[k];
    foot.volume = below[k];
    foot.hull_points = so_far.points();
    for (const Vec3f p : foot.hull_points)
      foot.bounds.include(p);
  }
  return feet;
}

PartCut best_cut(const MeshPart& part, const Solid& solid) {
  PartCut best;
  for (const CutAxis axis : {CutAxis::z, CutAxis::x, CutAxis::y}) {
    const PartCut cut = best_cut_along(part, solid, axis);
    if (cut.excess < best.excess) best = cut;
  }
  return best;
}

}  // namespace marketgen::assets
