// The lines of the walls, and the gaps in them.
#pragma once
#include <vector>

#include "drawing/sketch.h"

namespace marketgen::drawing {

// Millimetres from here on.
struct Segment {
  Vec2 from, to;
};

// A straight piece that carries a wall's line on over an opening.
struct Bridge {
  Vec2 from, to;
};

struct Walls {
  std::vector<Segment> segments;
  std::vector<Bridge> bridges;
  bool named = false;  // told by a layer, class or id
};

// How far a line may be off: what the drawing is drawn to.
struct Tolerance {
  double join_mm = 20;  // ends this near meet
  double line_mm = 10;  // corners less far off a line are none
};

// Openings that a drawing may have.
constexpr double narrowest_opening_mm = 500, widest_opening_mm = 8000;
// A wall's end at an opening is no longer than the wall is thick.
constexpr double thickest_wall_mm = 700;
// More are searched for gaps in no bearable time.
constexpr std::size_t max_wall_segments = 6000;

double length(const Segment& segment);
double distance(Vec2 p, const Segment& segment);
// Radius and angle of a door's swing.
bool is_door_swing(const Stroke& stroke);
// A closed shape as small as a column or a label, not as long as a wall.
bool is_small_shape(const Stroke& stroke);

// What is drawn as walls; where nothing is named so, whatever has no other name and is no door's
// swing and no small shape.
Walls walls_of(const Sketch& sketch, const Tolerance& tolerance);
// Finds the gaps. Precondition: at most max_wall_segments.
void bridge_gaps(Walls& walls, const Tolerance& tolerance);

}  // namespace marketgen::drawing
