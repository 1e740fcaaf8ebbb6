#include "export/usd_solids.h"

#include "export/obj_text.h"

namespace marketgen::exporters {
namespace {

std::string schemas_of(const UsdContact& contact, std::string_view more = {}) {
  return fmt::format("prepend apiSchemas = [\"PhysicsCollisionAPI\", \"MaterialBindingAPI\"{}{}]",
                     more,
                     contact.mass_kg ? ", \"PhysicsMassAPI\"" : "");
}

void write_contact(UsdText& out, const UsdContact& contact) {
  out.line("rel material:binding:physics = <{}>", contact.material);
  if (contact.mass_kg) out.line("float physics:mass = {}", static_cast<float>(*contact.mass_kg));
  out.line("uniform token purpose = \"guide\"");
}

void write_hull(UsdText& out,
                UsdGeometry& geometry,
                std::string_view name,
                const std::vector<Vec3f>& points,
                const Pose& pose,
                const UsdContact& contact) {
  const UsdShape shape = geometry.add_hull(points);
  out.open(fmt::format("def Xform \"{}\"", name),
           {fmt::format("prepend references = {}", shape.reference)});
  write_usd_pose(out, pose);
  for (const UsdShape::Part& part : shape.parts) {
    out.open(fmt::format("over \"{}\"", part.name),
             {schemas_of(contact, ", \"PhysicsMeshCollisionAPI\"")});
    write_contact(out, contact);
    out.line("uniform token physics:approximation = \"convexHull\"");
    out.close();
  }
  out.close();
}

void write_box(UsdText& out,
               std::string_view name,
               const assets::ContactShape& shape,
               const UsdContact& contact) {
  out.open(fmt::format("def Cube \"{}\"", name), {schemas_of(contact)});
  out.line("float3[] extent = [(-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)]");
  write_contact(out, contact);
  out.line("double size = 1");
  write_usd_pose(out, shape.pose, shape.size * 2);
  out.close();
}

void write_cylinder(UsdText& out,
                    std::string_view name,
                    const assets::ContactShape& shape,
                    const UsdContact& contact) {
  const auto radius = static_cast<float>(shape.size.x), half = static_cast<float>(shape.size.y);
  out.open(fmt::format("def Cylinder \"{}\"", name), {schemas_of(contact)});
  out.line("uniform token axis = \"Z\"");
  out.line("float3[] extent = {}", usd_extent({{-radius, -radius, -half}, {radius, radius, half}}));
  out.line("double height = {}", 2 * half);
  write_contact(out, contact);
  out.line("double radius = {}", radius);
  write_usd_pose(out, shape.pose);
  out.close();
}

}  // namespace

void write_usd_collider(UsdText& out,
                        UsdGeometry& geometry,
                        std::string_view name,
                        const assets::ContactShape& shape,
                        const UsdContact& contact) {
  if (shape.shape == assets::CollisionShape::box)
    write_box(out, name, shape, contact);
  else if (shape.shape == assets::CollisionShape::cylinder)
    write_cylinder(out, name, shape, contact);
  else
    write_hull(out, geometry, name, ellipsoid_points(shape.size), shape.pose, contact);
}

void write_usd_collider(UsdText& out,
                        UsdGeometry& geometry,
                        std::string_view name,
                        const assets::ContactPiece& piece,
                        const UsdContact& contact) {
  if (piece.shape == assets::PieceShape::hull)
    write_hull(out, geometry, name, piece.points, {}, contact);
  else
    write_usd_collider(out, geometry, name, assets::contact_shape_of(piece), contact);
}

}  // namespace marketgen::exporters
