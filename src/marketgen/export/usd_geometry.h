// The meshes of a USD export: one binary layer that the text layers refer to, equal meshes once.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"
#include "io/usd_crate.h"

namespace marketgen::exporters {

constexpr const char* usd_geometry_file = "geometry.usdc";

// Triangles of one surface of a mesh. Pieces that touch lie on different sheets: in one mesh, more
// than two faces would meet at an edge. Corners at one place are one point; normals and texture
// coordinates are lists of their own, by corner.
struct UsdMesh {
  std::uint16_t surface = 0, sheet = 0;
  std::vector<Vec3f> points, normals;
  std::vector<Vec2f> st;  // v upwards; empty without `textured`
  std::vector<std::int32_t> corners, corner_normals, corner_st;
};

// One for every surface and sheet that has triangles with an area. `textured`: by surface, whether
// it needs texture coordinates. `pieces`: first vertex of each solid of which the mesh is made up.
std::vector<UsdMesh> usd_meshes(const Mesh& mesh,
                                const std::vector<bool>& textured,
                                const std::vector<std::uint32_t>& pieces = {0});

// A prim of the layer and the meshes below it.
struct UsdShape {
  struct Part {
    std::string name;
    std::uint16_t surface = 0;
  };
  std::string reference;  // @./geometry.usdc@</Geometry/pack_...>
  std::vector<Part> parts;
};

class UsdGeometry {
 public:
  UsdShape add(std::string_view kind, const std::vector<UsdMesh>& meshes);
  // The convex hull of `points` as one mesh.
  UsdShape add_hull(const std::vector<Vec3f>& points);
  std::uint64_t meshes() const { return meshes_; }
  std::string finish() { return crate_.finish(); }

 private:
  void add_mesh(int prim, const UsdMesh& mesh);

  io::UsdCrate crate_{"Geometry"};
  std::map<std::string, UsdShape> known_;  // by hash
  std::uint64_t meshes_ = 0;
};

}  // namespace marketgen::exporters
