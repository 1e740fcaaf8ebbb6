// Bodies with six printed faces: cartons, bags, bundles, loaves. A grid on each face of a box, bent
// by a shape function.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "assets/shapes/archetypes/pack_builder.h"

namespace marketgen::assets {

// Where the grid lines lie along X (0 left, 1 right), Y (0 front, 1 back) and Z (0 bottom, 1 top):
// shares from 0 to 1.
struct BoxGrid {
  std::vector<float> x, y, z;
};

// The surface of each face.
struct BoxSurfaces {
  std::uint16_t front, right, back, left, top, bottom;
};

// From shares of the box to its place in the product frame. Continuous, so that the faces stay
// joined at their edges.
using BoxShape = std::function<Vec3f(Vec3f share)>;

// A face with the printed surface takes its panel of the sheet, any other 0..1.
void add_panel_box(PackBuilder& pack,
                   const BoxGrid& grid,
                   const BoxSurfaces& surfaces,
                   const BoxShape& shape,
                   const Placement& place = PartFrame{});

// Lines for an edge rounded with `radius` on a side of length `length`: `arc` cells in each
// rounding, `inner` cells between.
std::vector<float> rounded_lines(float length, float radius, int arc, int inner);
std::vector<float> even_lines(int cells);

// The point of a box of that size, standing on z = 0, with edges and corners rounded by `radius`
// (at most half the least size).
Vec3f rounded_box_point(Vec3f share, Vec3f size, float radius);

// A closed plain box with rounded edges: caps, tabs and flaps. Three by three cells a face.
inline constexpr int plain_box_triangles = 6 * 3 * 3 * 2;
void add_plain_box(
    PackBuilder& pack, Vec3f size, float radius, std::uint16_t surface, const Placement& place);

}  // namespace marketgen::assets
