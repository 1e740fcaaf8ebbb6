#include "render/cameras/viewpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "assets/product_model.h"
#include "render/stage/room.h"

namespace marketgen::render {
namespace {

std::string written(Vec3 p) {
  return fmt::format("({:.3f}, {:.3f}, {:.3f}) m", p.x, p.y, p.z);
}

bool is_in_room(const plan::Shell& shell, Vec3 p) {
  if (!(p.z >= 0 && p.z <= shell.ceiling_mm * 1e-3)) return false;
  if (std::fabs(p.x) > 1e4 || std::fabs(p.y) > 1e4)
    return false;  // beyond what fits in millimetres
  return contains(raytrace::room_of(shell).outline, floor_mm(p));
}

bool is_in_part(const scene::ScenePart& part, Vec3 fixture_point) {
  const Vec3 p = inverse(scene::fixture_from_part(part)) * fixture_point;
  const double x = part.half_size_m[0], y = part.half_size_m[1], z = part.half_size_m[2];
  if (std::fabs(p.z) > z) return false;
  return part.shape == assets::PartShape::cylinder ? std::hypot(p.x, p.y) <= x
                                                   : std::fabs(p.x) <= x && std::fabs(p.y) <= y;
}

// +1 where the ray from `eye` leaves through the triangle, -1 where it enters, 0 past it.
int crossing(Vec3 eye, Vec3 direction, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, across = cross(direction, ac);
  const double det = dot(ab, across);  // < 0: seen from behind (Möller and Trumbore 1997)
  if (std::fabs(det) < 1e-18) return 0;
  const Vec3 off = eye - a;
  const double u = dot(off, across) / det;
  const Vec3 q = cross(off, ab);
  const double v = dot(direction, q) / det;
  if (u < 0 || v < 0 || u + v > 1 || dot(ac, q) / det <= 0) return 0;
  return det < 0 ? 1 : -1;
}

// Parts of a pack run into one another: it has been left as often as entered only outside all.
bool is_in_mesh(const Mesh& mesh, Vec3 p) {
  const Vec3 direction = normalized(Vec3{0.3141, 0.2718, 0.9123});  // along no edge
  int depth = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    depth += crossing(p,
                      direction,
                      to_double(mesh.positions[a]),
                      to_double(mesh.positions[b]),
                      to_double(mesh.positions[c]));
  }
  return depth > 0;
}

Result<bool> is_in_product(const scene::Scene& scene, const scene::SceneProduct& item, Vec3 eye) {
  const catalog::Product& product = scene.catalog[item.sku];
  const Vec3 p = inverse(scene::world_from_product(item)) * eye;
  const double slack_m = 1e-3;  // meshes keep to their row's sizes within it
  if (p.z < -slack_m || p.z > product.height_m() + slack_m ||
      std::fabs(p.x) > product.width_m() / 2 + slack_m ||
      std::fabs(p.y) > product.depth_m() / 2 + slack_m)
    return false;
  MARKETGEN_TRY(const assets::ProductModel model, assets::make_product_model(product));
  return is_in_mesh(model.mesh, p);
}

// The name of what holds the eye.
Result<std::optional<std::string>> holder_of(const scene::Scene& scene, Vec3 eye) {
  for (const plan::Column& column : scene.layout.shell.columns) {
    const double half = column.size_mm * 0.5e-3;
    if (std::fabs(eye.x - column.x_mm * 1e-3) <= half &&
        std::fabs(eye.y - column.y_mm * 1e-3) <= half)
      return std::optional(fmt::format("the column at {}, {} mm", column.x_mm, column.y_mm));
  }
  for (std::uint32_t i = 0; i < scene.fixtures.size(); ++i) {
    const Vec3 p = inverse(scene::world_from_fixture(scene, i)) * eye;
    for (std::uint32_t k = 0; k < scene.fixtures[i].part_count; ++k) {
      const scene::ScenePart& part = scene.parts[scene.fixtures[i].first_part + k];
      if (is_in_part(part, p))
        return std::optional(
            fmt::format("the {} of \"{}\"", name_of(part.unit), scene.layout.fixtures[i].id));
    }
  }
  for (std::uint32_t i = 0; i < scene.products.size(); ++i) {
    MARKETGEN_TRY(const bool inside, is_in_product(scene, scene.products[i], eye));
    if (inside)
      return std::optional(fmt::format("the product \"{}\"", scene::product_id(scene, i)));
  }
  return std::optional<std::string>{};
}

}  // namespace

Result<void> check_viewpoint(const scene::Scene& scene,
                             const Camera& camera,
                             const std::string& where) {
  if (camera.ortho_height_m > 0) return {};
  const plan::Shell& shell = scene.layout.shell;
  const Vec3 eye = place_of(camera);
  if (!is_in_room(shell, eye)) {
    return Error{
        "camera.outside_store",
        where,
        fmt::format("it stands at {}, and the store spans 0 to {:.4g} m east, 0 to {:.4g} m north "
                    "and 0 to {:.4g} m up within its walls; move it inside, or take "
                    "--camera top",
                    written(eye),
                    shell.width_mm * 1e-3,
                    shell.depth_mm * 1e-3,
                    shell.ceiling_mm * 1e-3)};
  }
  MARKETGEN_TRY(const std::optional<std::string> holder, holder_of(scene, eye));
  if (!holder) return {};
  return Error{
      "camera.inside_object",
      where,
      fmt::format("it stands at {}, inside {}; move it out of there", written(eye), *holder)};
}

}  // namespace marketgen::render
