#include "export/usd_solids.h"

#include <cmath>
#include <numbers>

namespace marketgen::exporters {
namespace {

constexpr int ellipsoid_points = 64;

const std::vector<std::string> collider_schemas{
    "prepend apiSchemas = [\"PhysicsCollisionAPI\", \"MaterialBindingAPI\"]"};

void write_contact(UsdText& out, std::string_view material) {
  out.line("rel material:binding:physics = <{}>", material);
  out.line("uniform token purpose = \"guide\"");
}

// Spread evenly (a spherical Fibonacci lattice), on the surface.
std::vector<Vec3f> points_of_ellipsoid(const Vec3& half) {
  std::vector<Vec3f> points;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < ellipsoid_points; ++i) {
    const double z = 1 - (2 * i + 1.0) / ellipsoid_points, r = std::sqrt(1 - z * z);
    points.push_back(to_float(
        Vec3{half.x * r * std::cos(turn * i), half.y * r * std::sin(turn * i), half.z * z}));
  }
  return points;
}

void write_hull(UsdText& out,
                UsdGeometry& geometry,
                std::string_view name,
                const std::vector<Vec3f>& points,
                const Pose& pose,
                std::string_view material) {
  const UsdShape shape = geometry.add_hull(points);
  out.open(fmt::format("def Xform \"{}\"", name),
           {fmt::format("prepend references = {}", shape.reference)});
  write_usd_pose(out, pose);
  for (const std::uint16_t surface : shape.surfaces) {
    out.open(fmt::format("over \"part_{}\"", surface),
             {"prepend apiSchemas = [\"PhysicsCollisionAPI\", \"PhysicsMeshCollisionAPI\", "
              "\"MaterialBindingAPI\"]"});
    write_contact(out, material);
    out.line("uniform token physics:approximation = \"convexHull\"");
    out.close();
  }
  out.close();
}

void write_box(UsdText& out,
               std::string_view name,
               const assets::ContactShape& shape,
               std::string_view material) {
  out.open(fmt::format("def Cube \"{}\"", name), collider_schemas);
  out.line("float3[] extent = [(-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)]");
  write_contact(out, material);
  out.line("double size = 1");
  write_usd_pose(out, shape.pose, shape.size * 2);
  out.close();
}

void write_cylinder(UsdText& out,
                    std::string_view name,
                    const assets::ContactShape& shape,
                    std::string_view material) {
  const auto radius = static_cast<float>(shape.size.x), half = static_cast<float>(shape.size.y);
  out.open(fmt::format("def Cylinder \"{}\"", name), collider_schemas);
  out.line("uniform token axis = \"Z\"");
  out.line("float3[] extent = {}", usd_extent({{-radius, -radius, -half}, {radius, radius, half}}));
  out.line("double height = {}", 2 * half);
  write_contact(out, material);
  out.line("double radius = {}", radius);
  write_usd_pose(out, shape.pose);
  out.close();
}

}  // namespace

void write_usd_collider(UsdText& out,
                        UsdGeometry& geometry,
                        std::string_view name,
                        const assets::ContactShape& shape,
                        std::string_view material) {
  if (shape.shape == assets::CollisionShape::box)
    write_box(out, name, shape, material);
  else if (shape.shape == assets::CollisionShape::cylinder)
    write_cylinder(out, name, shape, material);
  else
    write_hull(out, geometry, name, points_of_ellipsoid(shape.size), shape.pose, material);
}

void write_usd_collider(UsdText& out,
                        UsdGeometry& geometry,
                        std::string_view name,
                        const assets::ContactPiece& piece,
                        std::string_view material) {
  if (piece.shape == assets::PieceShape::hull)
    write_hull(out, geometry, name, piece.points, {}, material);
  else
    write_usd_collider(out, geometry, name, assets::contact_shape_of(piece), material);
}

}  // namespace marketgen::exporters
