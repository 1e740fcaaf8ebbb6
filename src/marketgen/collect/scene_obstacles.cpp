#include "collect/scene_obstacles.h"

#include <algorithm>
#include <cmath>

#include "motion/shape_obstacles.h"
#include "physics/goods/contact_shape.h"
#include "physics/world/shell_pieces.h"
#include "scene/articulation.h"

namespace marketgen::collect {
namespace {

constexpr double floor_half_thickness_m = 0.05;

bool near(const assets::ContactShape& shape, Vec3 middle, double within_m) {
  const Vec3 half = assets::half_extents(shape), apart = shape.pose.position - middle;
  return std::abs(apart.x) - half.x < within_m && std::abs(apart.y) - half.y < within_m &&
         std::abs(apart.z) - half.z < within_m;
}

void add_if_near(const assets::ContactShape& shape,
                 Vec3 middle,
                 double within_m,
                 motion::Obstacles& obstacles) {
  if (near(shape, middle, within_m)) motion::add_shape(shape, obstacles);
}

}  // namespace

motion::Obstacles fixture_obstacles(const GoodsNow& store,
                                    Vec3 middle,
                                    double within_m,
                                    std::optional<std::uint32_t> without) {
  const scene::Scene& scene = store.scene();
  const std::vector<Pose> motions = store.joints().empty()
                                        ? std::vector<Pose>(scene.joints.size())
                                        : scene::joint_motions(scene, store.joints());
  motion::Obstacles obstacles;
  obstacles.boxes.push_back({{{middle.x, middle.y, -floor_half_thickness_m}, {}},
                             {within_m, within_m, floor_half_thickness_m}});
  for (const physics::ShellPiece& piece : physics::shell_pieces(scene.layout.shell))
    add_if_near(
        {assets::CollisionShape::box, piece.pose, piece.half_size}, middle, within_m, obstacles);
  for (const scene::ScenePart& part : scene.parts) {
    Pose moved = scene::world_from_fixture(scene, part.fixture);
    if (part.joint >= 0) {
      const auto joint = static_cast<std::uint32_t>(part.joint);
      if (without == joint) continue;
      if (store.joint(joint) != 0 || scene.joints[joint].parent >= 0)
        moved = moved * motions[joint];
    }
    add_if_near(moved * physics::contact_shape_of(part), middle, within_m, obstacles);
  }
  return obstacles;
}

Result<void> add_product_obstacles(const GoodsNow& goods,
                                   Vec3 middle,
                                   double within_m,
                                   std::span<const std::uint32_t> without,
                                   motion::Obstacles& obstacles) {
  const scene::Scene& scene = goods.scene();
  std::vector<assets::ContactShape> shapes;
  for (const catalog::Product& product : scene.catalog) {
    MARKETGEN_TRY(const assets::CollisionPrimitive primitive, assets::collision_of(product));
    shapes.push_back(assets::contact_shape_of(primitive));
  }
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    if (std::find(without.begin(), without.end(), row) != without.end()) continue;
    const assets::ContactShape& shape = shapes[scene.products[row].sku];
    add_if_near(goods.pose(row) * shape, middle, within_m, obstacles);
  }
  return {};
}

}  // namespace marketgen::collect
