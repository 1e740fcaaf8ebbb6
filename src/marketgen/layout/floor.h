// The bare room: where nothing can stand, and what must stay free before doors.
#pragma once
#include <vector>

#include "base/result.h"
#include "geometry/rectangle.h"
#include "layout/side.h"
#include "plan/plan.h"

namespace marketgen::layout {

// Free floor inside each door: 2 m deep, half a metre wider than the door on either side. Width and
// depth of a landing people can pass each other on while the door is in use (Neufert, Architects'
// Data: entrances of shops).
constexpr int approach_depth_mm = 2000;
constexpr int approach_side_mm = 500;
// Fixtures keep off columns: guards and cladding need room.
constexpr int column_clearance_mm = 100;

struct Doorway {
  std::size_t opening;  // index into Shell::openings
  Side wall;
  Span span;          // of the opening along its wall
  RectMm approach;    // empty for windows
  PointMm threshold;  // middle of the opening, on the wall's line
};

struct Floor {
  RectMm bounds;
  PolygonMm outline;            // counter-clockwise, always set
  std::vector<RectMm> outside;  // the part of bounds that is not floor
  std::vector<RectMm> columns;
  std::vector<Doorway> doorways;  // in the order of Shell::openings
};

// Slanted walls are laid out in steps: what is outside them is this many rectangles at most.
constexpr std::size_t max_pieces_outside = 10'000;
// Whether a layout of the room can be made in time. Error: plan.bad_shell.
Result<void> check_floor(const plan::Shell& shell);
Floor make_floor(const plan::Shell& shell);

// The stretches of the rectangle's side, lengthened by `more` at either end, that have a wall
// within `reach_mm` behind them.
std::vector<Span> wall_spans(
    const Floor& floor, const RectMm& rect, Side side, Span more, int reach_mm = 50);

// The rectangle lies on the floor altogether.
bool on_floor(const Floor& floor, const RectMm& rect);

// Null when there is none. The exit of a shop with one door is its entrance.
const Doorway* entrance_of(const Floor& floor, const plan::Shell& shell);
const Doorway* exit_of(const Floor& floor, const plan::Shell& shell);

}  // namespace marketgen::layout
