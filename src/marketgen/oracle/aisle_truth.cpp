#include "oracle/aisle_truth.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace marketgen::oracle {
namespace {

constexpr double same_pack_m = 0.10;  // between where it is thought to stand and where it stands
constexpr double on_board_m = 0.02, before_edge_m = 0.06;
constexpr float hidden_m = 0.03F;  // what is measured so far before a pack's front hides it
constexpr double near_m = 3;

Pose base_from_pack(const episodes::AisleWorld& world, std::uint32_t row) {
  return inverse(world.world_from_base()) * world.world().product_pose(row);
}

const catalog::Product& goods_of(const episodes::AisleWorld& world, std::uint32_t row) {
  const scene::Scene& scene = world.store().scene;
  return scene.catalog[scene.products[row].sku];
}

// The board on which it stands, perhaps on others, and where its front is.
std::optional<perception::ShelfSpot> spot_on(const std::vector<perception::BoardAhead>& boards,
                                             const Pose& base_from_product,
                                             double depth_m) {
  for (std::size_t b = 0; b < boards.size(); ++b) {
    const Vec3 at = inverse(boards[b].base_from_board) * base_from_product.position;
    const double front = at.y - depth_m / 2;
    if (std::abs(at.x) < boards[b].width_m / 2 && front > -before_edge_m &&
        at.y < boards[b].depth_m && at.z > -on_board_m && at.z < boards[b].clearance_m)
      return perception::ShelfSpot{b, at.x, front};
  }
  return std::nullopt;
}

// Whether a picture shows the middle of its front.
bool is_seen(const std::vector<perception::ViewCloud>& views,
             const Pose& base_from_product,
             const catalog::Product& p) {
  const Vec3f front = to_float(base_from_product * Vec3{0, -p.depth_m() / 2, p.height_m() / 2});
  return std::ranges::any_of(views, [&](const perception::ViewCloud& view) {
    const auto at = view.project(front);
    return at && (!view.has(at->pixel) || view.view().depth_m[at->pixel] > at->depth_m - hidden_m);
  });
}

// Row of the pack of a product that stands nearest to a place.
std::optional<std::uint32_t> pack_at(const episodes::AisleWorld& world,
                                     const std::string& sku,
                                     Vec3 world_position) {
  std::optional<std::uint32_t> nearest;
  double least = same_pack_m;
  for (const std::uint32_t row : world.store().front_items(sku)) {
    const double off = length(world.world().product_pose(row).position - world_position);
    if (off >= least) continue;
    nearest = row;
    least = off;
  }
  return nearest;
}

perception::FittedPose certain(const Pose& pose) {
  perception::FittedPose fitted{pose, {}};
  fitted.evidence.fit = fitted.evidence.seen = fitted.evidence.covered = fitted.evidence.score = 1;
  fitted.evidence.color_error = 0;
  return fitted;
}

}  // namespace

std::vector<perception::ShelfSpot> TrueSpots::spots(
    const std::vector<perception::ViewCloud>&,
    const std::vector<perception::BoardAhead>& boards,
    Vec3f) const {
  const scene::Scene& scene = world_.store().scene;
  std::vector<perception::ShelfSpot> spots;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    if ((scene.products[row].flags & scene::product_front_row) == 0) continue;
    const Pose pose = base_from_pack(world_, row);
    if (std::hypot(pose.position.x, pose.position.y) > near_m) continue;
    const auto spot = spot_on(boards, pose, goods_of(world_, row).depth_m());
    if (spot) spots.push_back(*spot);
  }
  return spots;
}

std::vector<perception::FoundOnShelf> TrueShelfChoice::find(
    const perception::WantedProduct& wanted,
    const std::vector<perception::ViewCloud>& views,
    const std::vector<perception::BoardAhead>& boards,
    const std::vector<perception::ShelfSpot>&) const {
  std::vector<perception::FoundOnShelf> found;
  for (const std::uint32_t row : world_.store().front_items(wanted.look->sku())) {
    const catalog::Product& goods = goods_of(world_, row);
    const Pose pose = base_from_pack(world_, row);
    const auto spot = spot_on(boards, pose, goods.depth_m());
    if (spot && is_seen(views, pose, goods)) found.push_back({*spot, certain(pose)});
  }
  return found;
}

perception::FittedPose TrueShelfChoice::again(const perception::WantedProduct& wanted,
                                              const std::vector<perception::ViewCloud>&,
                                              const Pose& base_from_product) const {
  const auto row =
      pack_at(world_, wanted.look->sku(), (world_.world_from_base() * base_from_product).position);
  return row ? certain(base_from_pack(world_, *row))
             : perception::FittedPose{base_from_product, {}};
}

Result<std::vector<perception::SeenGrasp>> TrueShelfGrasps::grasps(
    const perception::ShelfGraspQuestion& question) const {
  std::vector<perception::SeenGrasp> grasps;
  const auto row = pack_at(world_, question.known.product.sku, question.base_from_product.position);
  if (!row) return grasps;
  MARKETGEN_TRY(const auto known, world_.known_grasps(*row, tool_));
  const Pose store_from_product = world_.world().product_pose(*row);
  for (const motion::GraspCandidate& candidate : known)
    grasps.push_back({skills::carrying_grasp(store_from_product, candidate, tool_.force_n)});
  return grasps;
}

}  // namespace marketgen::oracle
