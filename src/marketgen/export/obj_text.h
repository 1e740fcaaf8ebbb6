// Meshes as Wavefront OBJ.
#pragma once
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace marketgen::exporters {

// Positions, texture coordinates (v upwards), normals.
std::string obj_text(const Mesh& mesh);

// The convex hull, with the normals of its faces.
Mesh hull_mesh(const std::vector<Vec3f>& points);

// On the surface, spread evenly (a spherical Fibonacci lattice).
std::vector<Vec3f> ellipsoid_points(const Vec3& half);

}  // namespace marketgen::exporters
