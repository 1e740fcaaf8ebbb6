// The room as walls: its outline's edges, each with a frame to build in and the openings that
// pierce it.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "layout/layout.h"
#include "render/stage/world.h"

namespace marketgen::render::raytrace {

// An opening in its wall: from `low` to `high` along the wall, `sill` to `head` above the floor.
// Metres.
struct WallOpening {
  plan::OpeningKind kind = plan::OpeningKind::entrance;
  float low = 0, high = 0, sill = 0, head = 2.1F;
  bool glazed() const {
    return kind == plan::OpeningKind::entrance || kind == plan::OpeningKind::exit ||
           kind == plan::OpeningKind::window;
  }
  bool is_door() const { return kind != plan::OpeningKind::window; }
};

// One edge of the outline. Its frame: x along the wall (to the left for someone inside who looks at
// it), y into the room, z up.
struct WallEdge {
  Placement world_from_wall;
  float length = 0;
  std::vector<WallOpening> openings;  // by `low`, apart from one another
};

struct Room {
  PolygonMm outline;  // counter-clockwise
  float ceiling = 3;
  std::vector<WallEdge> walls;
};

Room room_of(const plan::Shell& shell);

inline float metres(int mm) {
  return static_cast<float>(mm) * 1e-3F;
}

// Triangles (counter-clockwise) of a simple polygon, by ear clipping.
std::vector<std::array<std::uint32_t, 3>> triangulated(const PolygonMm& polygon);

// Adds a box given in `frame`; metric UVs divided by `uv_extent`.
void add_framed_box(Mesh& mesh,
                    const Placement& frame,
                    Vec3f low,
                    Vec3f high,
                    float bevel,
                    std::uint16_t surface,
                    float uv_extent = 1);
// Adds a rectangle on the wall plane at `y`, facing the room, between (x0, z0) and (x1, z1); UVs
// run with the wall, in units of `uv_extent`.
void add_wall_panel(Mesh& mesh,
                    const Placement& frame,
                    float x0,
                    float x1,
                    float y,
                    float z0,
                    float z1,
                    std::uint16_t surface,
                    float uv_extent);
// The same with one picture across it, upright for someone in the room.
void add_wall_picture(Mesh& mesh,
                      const Placement& frame,
                      float x0,
                      float x1,
                      float y,
                      float z0,
                      float z1,
                      std::uint16_t surface);

}  // namespace marketgen::render::raytrace
