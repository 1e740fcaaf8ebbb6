#include "perception/model_targets.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace marketgen::perception {
namespace {

constexpr std::size_t marked_patch_points = 160;
// The model has said that it lies there. Only what fits in no way is refused: a wrong product of
// another size or shape scores 0.
constexpr double min_chosen_score = 0.1;

// Masks of what was found are no marks of a further copy.
void take_away(const ProductLook& look,
               const FoundProduct& found,
               const std::vector<ViewCloud>& views,
               std::vector<MaskedView>& masked) {
  const Vec3 middle = middle_of(look, found.pose.base_from_product);
  const double within = 0.5 * static_cast<double>(look.diagonal_m());
  for (MaskedView& of_view : masked) {
    for (std::size_t m = 0; m < of_view.masks.size(); ++m) {
      Mask& mask = of_view.masks[m];
      if (mask.pixels.empty()) continue;
      const SurfacePatch patch = patch_of(views[of_view.view], mask, marked_patch_points);
      const bool is_it = of_view.view == found.view && m == found.mask;
      if (is_it || length(to_double(patch.middle) - middle) < within) mask.pixels.clear();
    }
  }
}

// Of every mask that is left.
std::vector<SurfacePatch> patches_of(const std::vector<ViewCloud>& views,
                                     const std::vector<MaskedView>& masked) {
  std::vector<SurfacePatch> patches;
  for (const MaskedView& of_view : masked)
    for (const Mask& mask : of_view.masks)
      if (!mask.pixels.empty())
        patches.push_back(patch_of(views[of_view.view], mask, marked_patch_points));
  return patches;
}

}  // namespace

std::string words_of(const WantedProduct& wanted, const ProductWords& by_sku) {
  return wanted.words.empty() ? by_sku(wanted.look->sku()) : wanted.words;
}

std::vector<ModelTargets::Goal> ModelTargets::goals_of(
    const std::vector<WantedProduct>& wanted) const {
  std::vector<Goal> goals;
  for (std::size_t number = 0; number < wanted.size(); ++number) {
    const std::string words = words_of(wanted[number], by_sku_);
    auto goal = std::ranges::find(goals, words, &Goal::words);
    if (goal == goals.end()) goal = goals.insert(goal, Goal{words, {}});
    goal->readings.push_back(number);
  }
  return goals;
}

std::optional<FoundProduct> ModelTargets::best_reading(const Goal& goal,
                                                       const std::vector<WantedProduct>& wanted,
                                                       const std::vector<ViewCloud>& views,
                                                       const std::vector<MaskedView>& masked,
                                                       const Mark& mark) const {
  const auto of_view = std::ranges::find(masked, mark.view, &MaskedView::view);
  const Vec3f place =
      patch_of(views[mark.view], of_view->masks[mark.mask], marked_patch_points).middle;
  const std::vector<SurfacePatch> patches = patches_of(views, masked);
  std::optional<FoundProduct> best;
  double best_score = min_chosen_score;
  for (const std::size_t number : goal.readings) {
    const ProductLook& look = *wanted[number].look;
    const auto is_there = [&](Vec3f at) { return length(at - place) <= look.diagonal_m() / 2; };
    for (const SurfacePatch& patch : patches) {
      if (!is_there(patch.middle)) continue;
      const FittedPose pose = poses_.pose(look, patch, views);
      if (pose.evidence.score < best_score ||
          !is_there(to_float(middle_of(look, pose.base_from_product))))
        continue;
      best_score = pose.evidence.score;
      best = FoundProduct{number, mark.view, mark.mask, pose};
    }
  }
  return best;
}

std::optional<std::vector<FoundProduct>> ModelTargets::chosen(
    const Goal& goal,
    const std::vector<WantedProduct>& wanted,
    const std::vector<ViewCloud>& views,
    std::vector<MaskedView> masked) const {
  std::vector<FoundProduct> found;
  const int count = wanted[goal.readings.front()].count;
  while (std::cmp_less(found.size(), count)) {
    const MarkedPictures marked = marked_pictures(views, masked);
    const MarkChoice choice = questioner_->which(goal.words, marked, views, masked);
    if (choice.outcome == MarkOutcome::absent) return found;
    const bool failed = !has_answered(choice.outcome);
    std::optional<FoundProduct> place;
    if (!failed) {
      const Mark& mark = marked.marks[choice.mark];
      place = best_reading(goal, wanted, views, masked, mark);
      if (!place) questioner_->count_no_pose(choice);
    }
    if (!place) return found.empty() ? std::nullopt : std::optional(found);
    take_away(*wanted[place->look].look, *place, views, masked);
    found.push_back(*std::move(place));
  }
  return found;
}

std::vector<FoundProduct> ModelTargets::found_offline(const std::vector<std::size_t>& numbers,
                                                      const std::vector<WantedProduct>& wanted,
                                                      const std::vector<ViewCloud>& views,
                                                      const std::vector<MaskedView>& masked) const {
  std::vector<WantedProduct> left;
  for (const std::size_t number : numbers)
    left.push_back(wanted[number]);
  std::vector<FoundProduct> found = offline_->find(left, views, masked);
  for (FoundProduct& each : found)
    each.look = numbers[each.look];
  return found;
}

std::vector<FoundProduct> ModelTargets::find(const std::vector<WantedProduct>& wanted,
                                             const std::vector<ViewCloud>& views,
                                             const std::vector<MaskedView>& masked) const {
  std::vector<FoundProduct> all;
  std::vector<std::size_t> failed;
  for (const Goal& goal : goals_of(wanted)) {
    const auto found = chosen(goal, wanted, views, masked);
    if (found) {
      std::ranges::copy(*found, std::back_inserter(all));
      continue;
    }
    questioner_->count_offline();
    std::ranges::copy(goal.readings, std::back_inserter(failed));
  }
  if (!failed.empty())
    std::ranges::copy(found_offline(failed, wanted, views, masked), std::back_inserter(all));
  return one_at_a_place(wanted, std::move(all));
}

}  // namespace marketgen::perception
