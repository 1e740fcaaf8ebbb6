// Shells: closed skins over a grid of points, for what grows or is baked: fruit, leaves, stalks,
// loaves.
#pragma once
#include <functional>
#include <vector>

#include "assets/shapes/archetypes/pack_builder.h"

namespace marketgen::assets {

// How a shell is covered. The printed surface takes its UVs from the sheet's `skin` panel: u once
// around, v from `v_high` at the upper end to `v_low` at the lower.
struct ShellSkin {
  std::uint16_t surface = 0;
  float v_high = 0, v_low = 1;
  int first_segment = 0;  // where u = 0 lies, counted in segments
};

// A point of the shell. `turn` 0..1 goes once around counter-clockwise seen from the upper end,
// `along` 0..1 from the lower end to the upper.
using ShellPoint = std::function<Vec3f(double turn, double along)>;

struct ShellGrid {
  int segments = 32;             // around
  std::vector<double> stations;  // values of `along`, rising from 0 to 1
  bool closed = false;           // the ends meet, as a ring's; otherwise each shrinks to a point
};

// `count` bands of one length.
std::vector<double> even_stations(int count);

// 2 * segments * (bands - 1) triangles; a closed ring has a band's more.
void add_shell(PackBuilder& pack,
               const ShellSkin& skin,
               const ShellGrid& grid,
               const ShellPoint& point);

// A place on the line along which a tube runs, with its half sizes there.
struct TubeKnot {
  Vec3f at;
  float across = 0;  // half size along cross(up, direction)
  float thick = 0;   // half size along `up`, as far as that is square to the line
};

struct TubeForm {
  std::vector<TubeKnot> knots;  // a smooth curve runs through them
  Vec3f up{0, 0, 1};            // u = 0.5 lies on this side; never along the line
  float low_round_m = 0;        // the ends round off over so much of the line…
  float high_round_m = 0;       // …or run out flat when it is 0
  float fold = 0;               // edges bent towards `up`, in half sizes across: a gutter
  float ruffle = 0;             // edges wave by so much of the half size across
  int ruffles = 0;              // waves along the line
  bool closed = false;          // the line ends where it began
};

// A tube round a curve. `bands` between its rounded ends, each of which adds four. Precondition: at
// least two knots.
void add_tube(PackBuilder& pack,
              const ShellSkin& skin,
              int segments,
              int bands,
              const TubeForm& form,
              const Placement& place = PartFrame{});

}  // namespace marketgen::assets
