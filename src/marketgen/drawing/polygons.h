// What Clipper does for us, in millimetres (polyclipping: Vatti's clipping and offsetting).
#pragma once
#include <vector>

#include "geometry/vector.h"

namespace marketgen::drawing {

using Polygon = std::vector<Vec2>;

// The outlines of a line as wide as that, with square ends cut at its own.
std::vector<Polygon> thick_line(const Polygon& line, bool closed, double width);

// A region that lines enclose, without what lies in it.
struct Face {
  Polygon outline;
  double area_mm2 = 0;   // without the faces and lines in it
  double inner_mm2 = 0;  // of the largest face that lies in it
};
// Every face that the lines enclose. Each line is given as two points.
std::vector<Face> faces_of(const std::vector<Polygon>& lines);

// With every edge moved outwards by that; inwards when it is negative.
Polygon grown(const Polygon& polygon, double by);
// Without slits and spikes narrower than twice `by`.
Polygon closed_slits(const Polygon& polygon, double by);
// Without corners that lie less than `within` off the line between their neighbours.
Polygon simplified(const Polygon& polygon, double within);
// Without edges shorter than that where those on either side meet at a corner near by.
Polygon sharpened(const Polygon& polygon, double shorter);
double area_mm2(const Polygon& polygon);  // positive counter-clockwise
bool contains(const Polygon& polygon, Vec2 p);
// Intersection over union.
double overlap_share(const Polygon& a, const Polygon& b);
// Where two edges that are no neighbours cross; null when none do.
const Vec2* crossing_of(const Polygon& polygon);

}  // namespace marketgen::drawing
