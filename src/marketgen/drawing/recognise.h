// What the lines of a floor plan mean: the floor, its columns and its openings.
#pragma once
#include <string>
#include <vector>

#include "drawing/polygons.h"
#include "drawing/sketch.h"
#include "drawing/walls.h"

namespace marketgen::drawing {

// Along an edge of the outline.
struct FoundOpening {
  Vec2 from, to;
  std::size_t edge = 0;  // from corner `edge` to the next
  Role role = Role::door;
  std::string name;  // of the layer, block or id; empty when it is a bare gap
};

struct FoundColumn {
  Vec2 centre;
  double size_mm = 0;  // side of a square with its area
};

struct Found {
  Polygon outline;  // counter-clockwise, inner faces of the walls
  std::vector<FoundOpening> openings;
  std::vector<FoundColumn> columns;
  bool walls_named = false;
  std::vector<std::string> warnings;
};

// Precondition: a sketch in millimetres. Errors: drawing.no_outline, drawing.bad_outline.
Result<Found> recognise(const Sketch& sketch, const Tolerance& tolerance, const std::string& where);

// Steps of it.
// Without the depth of the wall at gaps that are bridged at its outer face only.
Polygon without_recesses(const Polygon& outline, std::vector<Bridge>& bridges);
// Of a picture, where a door's leaf and swing are ink like the walls: the outline without them.
// Each that is taken away becomes a bridge.
Polygon without_swings(const Polygon& outline,
                       const Tolerance& tolerance,
                       std::vector<Bridge>& bridges);
std::vector<FoundOpening> openings_of(const Sketch& sketch,
                                      const Walls& walls,
                                      const Polygon& outline,
                                      const Tolerance& tolerance);
std::vector<FoundColumn> columns_of(const Sketch& sketch,
                                    const Polygon& outline,
                                    std::vector<std::string>& warnings);

}  // namespace marketgen::drawing
