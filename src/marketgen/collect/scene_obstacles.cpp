#include "collect/scene_obstacles.h"

#include <algorithm>
#include <cmath>

#include "motion/shape_obstacles.h"
#include "physics/goods/contact_shape.h"
#include "physics/world/shell_pieces.h"

namespace marketgen {
namespace {

constexpr double floor_half_thickness_m = 0.05;

bool near(const ContactShape& shape, Vec3 middle, double within_m) {
  const Vec3 half = half_extents(shape), apart = shape.pose.position - middle;
  return std::abs(apart.x) - half.x < within_m && std::abs(apart.y) - half.y < within_m &&
         std::abs(apart.z) - half.z < within_m;
}

void add_if_near(const ContactShape& shape, Vec3 middle, double within_m, Obstacles& obstacles) {
  if (near(shape, middle, within_m)) add_shape(shape, obstacles);
}

}  // namespace

Obstacles fixture_obstacles(const Scene& scene, Vec3 middle, double within_m) {
  Obstacles obstacles;
  obstacles.boxes.push_back({{{middle.x, middle.y, -floor_half_thickness_m}, {}},
                             {within_m, within_m, floor_half_thickness_m}});
  for (const ShellPiece& piece : shell_pieces(scene.layout.shell))
    add_if_near({CollisionShape::box, piece.pose, piece.half_size}, middle, within_m, obstacles);
  for (const ScenePart& part : scene.parts) {
    const ContactShape shape = world_from_fixture(scene, part.fixture) * contact_shape_of(part);
    add_if_near(shape, middle, within_m, obstacles);
  }
  return obstacles;
}

Result<void> add_product_obstacles(const GoodsNow& goods,
                                   Vec3 middle,
                                   double within_m,
                                   std::span<const std::uint32_t> without,
                                   Obstacles& obstacles) {
  const Scene& scene = goods.scene();
  std::vector<ContactShape> shapes;
  for (const Product& product : scene.catalog) {
    MARKETGEN_TRY(const CollisionPrimitive primitive, collision_of(product));
    shapes.push_back(contact_shape_of(primitive));
  }
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    if (std::find(without.begin(), without.end(), row) != without.end()) continue;
    const ContactShape& shape = shapes[scene.products[row].sku];
    add_if_near(goods.pose(row) * shape, middle, within_m, obstacles);
  }
  return {};
}

}  // namespace marketgen
