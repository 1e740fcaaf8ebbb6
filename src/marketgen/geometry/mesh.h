// Triangle meshes with smooth normals, texture coordinates and one surface index per triangle.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/pose.h"

namespace marketgen {
inline namespace geometry {

struct Bounds3 {
  Vec3f low{1e30F, 1e30F, 1e30F};
  Vec3f high{-1e30F, -1e30F, -1e30F};
  void include(Vec3f p);
  Vec3f size() const { return high - low; }
  Vec3f center() const { return (low + high) * 0.5F; }
  bool empty() const { return high.x < low.x; }
};

// Triangles are counter-clockwise seen from outside. Vertices are shared where the normal and UV
// agree. UV (0, 0) is the top left of a texture, v grows downwards (as in glTF).
struct Mesh {
  std::vector<Vec3f> positions;  // metres
  std::vector<Vec3f> normals;    // unit, per vertex
  std::vector<Vec2f> uvs;        // per vertex
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint16_t> surfaces;  // per triangle: index into the owner's surface list

  std::uint32_t add_vertex(Vec3f position, Vec3f normal, Vec2f uv);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint16_t surface);
  void append(const Mesh& other);  // surface indices as they are
};

Bounds3 bounds_of(const Mesh& mesh);
// Volume enclosed by a closed mesh (divergence theorem), cubic metres.
double volume_of(const Mesh& mesh);
// Positions nearer than this are one corner.
inline constexpr double weld_distance_m = 1e-6;

// True when, after welding positions closer than `weld_m`, every edge is used by exactly two
// triangles, once each way.
bool is_watertight(const Mesh& mesh, double weld_m = weld_distance_m);

// ---- Builders. Each adds to `mesh`. ----

// Box centred at (cx, cy), standing on z = low.z .. high.z, with a `bevel` of smooth shared normals
// (0 = sharp). UVs: each face 0..1 unless `uv_per_metre` > 0, then metric.
void add_box(
    Mesh& mesh, Vec3f low, Vec3f high, float bevel, std::uint16_t surface, float uv_per_metre = 0);

// A quad a, b, c, d counter-clockwise seen from outside, uv (0,1) (1,1) (1,0) (0,0).
void add_quad(Mesh& mesh, Vec3f a, Vec3f b, Vec3f c, Vec3f d, std::uint16_t surface);

// One point of a lathe profile, from bottom to top. `crease` makes a hard edge at this point.
struct ProfilePoint {
  float radius;
  float z;
  std::uint16_t surface;  // of the band that starts here
  bool crease = false;
};
// Surface of revolution about Z. u runs once around starting at the back (+Y) so that the seam is
// behind and u = 0.5 faces the front (-Y); v is 0 at the profile's top and 1 at its bottom. Closed
// when the profile starts and ends at radius 0.
void add_lathe(Mesh& mesh, const std::vector<ProfilePoint>& profile, int segments);

void translate(Mesh& mesh, Vec3f by);
// Moves the vertices from `first` on, with their normals.
void place(Mesh& mesh, const Pose& pose, std::size_t first = 0);
void recompute_normals(Mesh& mesh, float crease_cos = 0.5F);

}  // namespace geometry
}  // namespace marketgen
