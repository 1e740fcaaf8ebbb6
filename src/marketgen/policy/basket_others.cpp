#include "policy/basket_others.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace marketgen::policy {
namespace {

constexpr std::size_t likenesses_tried = 8;
constexpr double min_other_score = 0.25;

bool is_of_target(const perception::SurfacePatch& patch,
                  const Sight& sight,
                  const SoughtGoals& goals) {
  const auto explains = [&](const perception::FoundProduct* found) {
    const auto left = perception::other_points(
        patch.points, goals.look_of(*found), found->pose.base_from_product);
    return left.size() < patch.points.size() * 7 / 10;
  };
  for (std::size_t goal = 0; goal < goals.size(); ++goal)
    if (std::ranges::any_of(goals.found_of(sight, goal), explains)) return true;
  return false;
}

// What of the whole catalogue explains the patch best.
std::optional<RecognisedProduct> recognised(const perception::SurfacePatch& patch,
                                            const Sight& sight,
                                            const Recognition& recognition) {
  std::vector<std::pair<double, const perception::ProductLook*>> alike;
  for (const perception::ProductLook* look : recognition.catalogue)
    if (is_of_size(patch, *look))
      alike.emplace_back(perception::color_likeness(patch.colors, *look), look);
  std::ranges::stable_sort(alike, std::greater<>{}, [](const auto& entry) { return entry.first; });
  std::optional<RecognisedProduct> best;
  double best_score = min_other_score;
  for (std::size_t i = 0; i < std::min(likenesses_tried, alike.size()); ++i) {
    const perception::FittedPose pose =
        recognition.poses.pose(*alike[i].second, patch, sight.views);
    if (pose.evidence.score < best_score) continue;
    best_score = pose.evidence.score;
    best = RecognisedProduct{alike[i].second, pose};
  }
  return best;
}

}  // namespace

std::vector<RecognisedProduct> others_in_basket(const Sight& sight,
                                                const SoughtGoals& goals,
                                                const agent::Workplace& place,
                                                const Recognition& recognition,
                                                const std::optional<Vec3>& near,
                                                std::size_t max_others) {
  const perception::MaskedView& masked = sight.masked.back();
  const perception::ViewCloud& cloud = sight.views[masked.view];
  std::vector<std::pair<double, perception::SurfacePatch>> ranked;
  for (const perception::Mask& mask : masked.masks) {
    perception::SurfacePatch patch = perception::patch_of(cloud, mask, sight_patch_points);
    const Vec3 middle = to_double(patch.middle), at = inverse(place.base_from_basket) * middle;
    const Vec3 half = place.inner_half;
    if (std::abs(at.x) > half.x || std::abs(at.y) > half.y || is_of_target(patch, sight, goals))
      continue;
    ranked.emplace_back(near ? length(middle - *near) : -at.z, std::move(patch));
  }
  std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
  std::vector<RecognisedProduct> others;
  for (std::size_t i = 0; i < std::min(max_others, ranked.size()); ++i)
    if (auto other = recognised(ranked[i].second, sight, recognition))
      others.push_back(std::move(*other));
  return others;
}

}  // namespace marketgen::policy
