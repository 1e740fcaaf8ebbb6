#include "oracle/checkout_truth.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "oracle/oracle_grasps.h"

namespace marketgen::oracle {
namespace {

constexpr double same_item_m = 0.12;  // between where it is thought to lie and where it lies
constexpr std::size_t seen_surfels = 400;

}  // namespace

std::vector<perception::Mask> TrueMasks::masks(const perception::ViewCloud& cloud,
                                               const std::vector<std::uint8_t>& wanted) const {
  const std::vector<int>& items = eyes_.items_shown(cloud.view().camera);
  std::map<int, perception::Mask> of_item;
  for (std::size_t pixel = 0; pixel < wanted.size(); ++pixel)
    if (wanted[pixel] != 0 && items[pixel] >= 0)
      of_item[items[pixel]].pixels.push_back(static_cast<std::uint32_t>(pixel));
  std::vector<perception::Mask> masks;
  for (auto& [item, mask] : of_item)
    masks.push_back(std::move(mask));
  std::ranges::stable_sort(
      masks, std::greater<>{}, [](const perception::Mask& mask) { return mask.pixels.size(); });
  return masks;
}

std::vector<perception::FoundProduct> TrueTargets::find(
    const std::vector<perception::WantedProduct>& wanted,
    const std::vector<perception::ViewCloud>& views,
    const std::vector<perception::MaskedView>&) const {
  const episodes::AreaRow unloading = world_.station().unloading.area();
  std::vector<perception::FoundProduct> found;
  for (std::size_t number = 0; number < wanted.size(); ++number) {
    const perception::ProductLook& look = *wanted[number].look;
    std::vector<std::pair<double, perception::FoundProduct>> of_product;
    for (std::size_t item = 0; item < world_.item_count(); ++item) {
      if (world_.goods(item).product.sku != look.sku()) continue;
      const Pose pose = world_.item_pose(item);
      perception::PoseEvidence evidence =
          perception::evidence_of(look, pose, {}, views, seen_surfels);
      evidence.score = 1;
      const double worth =
          evidence.seen + (unloading.holds(pose.position.x, pose.position.y) ? 1 : 0);
      of_product.push_back({worth, {number, 0, 0, {pose, evidence}}});
    }
    std::ranges::stable_sort(
        of_product, std::greater<>{}, [](const auto& each) { return each.first; });
    const auto count = std::min(of_product.size(), static_cast<std::size_t>(wanted[number].count));
    for (std::size_t i = 0; i < count; ++i)
      found.push_back(of_product[i].second);
  }
  return found;
}

Result<std::vector<perception::SeenGrasp>> TrueGrasps::grasps(
    const perception::GraspQuestion& question) const {
  const OracleScene scene(world_, tool_);
  std::optional<std::size_t> nearest;
  double least = same_item_m;
  for (std::size_t item = 0; item < scene.items(); ++item) {
    const double off =
        length(world_.item_pose(item).position - question.base_from_product.position);
    if (world_.goods(item).product.sku != question.known.product.sku || off >= least) continue;
    nearest = item;
    least = off;
  }
  std::vector<perception::SeenGrasp> grasps;
  if (!nearest) return grasps;
  MARKETGEN_TRY(const auto lone, lone_grasps(scene, *nearest));
  for (const GraspChoice& choice : item_grasps(scene, *nearest, lone).choices) {
    const std::vector<robots::ToolSolid> hand = skills::open_hand(tool_, choice.opening_m);
    double deepest = 0;
    for (const std::size_t other : choice.blockers)
      deepest =
          std::max(deepest, skills::hand_overlap(hand, choice.base_from_tip, scene.body(other)));
    grasps.push_back({static_cast<const skills::HandGrasp&>(choice), deepest});
  }
  return grasps;
}

}  // namespace marketgen::oracle
