#include "evaluation/measure_perception.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <variant>

#include <fmt/format.h>

#include "episodes/checkout/checkout_senses.h"
#include "episodes/pictured_products.h"
#include "geometry/rotation_axes.h"
#include "perception/look_library.h"
#include "perception/target_choice.h"
#include "policy/checkout_pictures.h"

namespace marketgen::evaluation {
namespace {

constexpr double right_within_m = 0.03;  // of the true middle
constexpr int min_visible_px = 150;

double seconds_since(std::chrono::steady_clock::time_point began) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

// `truth`: which item each pixel shows.
double best_iou(const std::vector<perception::Mask>& masks,
                const std::vector<int>& truth,
                int item) {
  const auto shown = static_cast<double>(std::ranges::count(truth, item));
  double best = 0;
  for (const perception::Mask& mask : masks) {
    double common = 0;
    for (const std::uint32_t pixel : mask.pixels)
      common += truth[pixel] == item ? 1 : 0;
    best = std::max(best, common / (shown + static_cast<double>(mask.pixels.size()) - common));
  }
  return best;
}

Vec3 middle_at(const perception::ProductLook& look, const Pose& pose) {
  return pose * to_double((look.low() + look.high()) * 0.5F);
}

// How far the outside of the one pose is from that of the other: symmetry does not matter.
double surface_distance(const perception::ProductLook& look, const Pose& found, const Pose& truth) {
  const Pose true_from_found = inverse(truth) * found;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < look.surfels().size(); i += 7, ++count) {
    const Vec3f at = to_float(true_from_found * to_double(look.surfels()[i].point));
    const int nearest = look.nearest(at);
    constexpr double far_m = 0.03;
    sum += nearest < 0 ? far_m
                       : static_cast<double>(
                             length(look.surfels()[static_cast<std::size_t>(nearest)].point - at));
  }
  return sum / count;
}

double middle_value(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[values.size() / 2];
}

// One basket, looked at as `classical` looks at it at first: its steps, each timed.
class PerceptionTrial {
 public:
  PerceptionTrial(episodes::TrackWorld& world, const episodes::EpisodeSpec& spec)
      : track_world_(world),
        world_(*std::get<const episodes::CheckoutWorld*>(world.any())),
        spec_(spec),
        eyes_(world_),
        place_(episodes::workplace_of(world_.station())) {
    measure_.episode = spec.id;
  }

  Result<void> learn_goals(perception::LookLibrary& library,
                           const std::vector<catalog::Product>& products,
                           const std::vector<catalog::FrictionRow>& frictions) {
    const auto began = std::chrono::steady_clock::now();
    const episodes::PicturedProducts known(products, frictions);
    std::vector<const catalog::Product*> rows;
    for (const episodes::EpisodeGoal& goal : spec_.goals) {
      MARKETGEN_TRY(rows.emplace_back(), known.row(goal.sku));
    }
    MARKETGEN_TRY(looks_, library.of(rows, known));
    measure_.pictures_s = seconds_since(began);
    return {};
  }

  // The arm holds still meanwhile.
  Result<void> look() {
    const auto began = std::chrono::steady_clock::now();
    const agent::Action hold = episodes::still_action(track_world_.observe());
    policy::CheckoutPictures pictures;
    for (;;) {
      MARKETGEN_TRY(auto views, pictures.take(eyes_, place_));
      if (views) {
        views_ = std::move(*views);
        break;
      }
      MARKETGEN_CHECK(track_world_.step(hold));
    }
    const Pose off = inverse(world_.basket_pose()) * place_.base_from_basket;
    measure_.basket_off_m = length(off.position);
    measure_.basket_off_deg = turn_between({}, off.rotation) * 180 / std::numbers::pi;
    measure_.look_s = seconds_since(began);
    return {};
  }

  void find() {
    const auto began = std::chrono::steady_clock::now();
    for (std::size_t v = 0; v < views_.size(); ++v)
      masked_.push_back(
          {v,
           perception::GeometricMasks().masks(
               views_[v],
               perception::goods_in_basket(views_[v], place_, place_.base_from_basket))});
    std::vector<perception::WantedProduct> wanted;
    for (const perception::ProductLook* look : looks_)
      wanted.push_back({look, {}});
    const perception::SweptPoses poses;
    found_ = perception::CatalogueMatching(poses).find(wanted, views_, masked_);
    measure_.find_s = seconds_since(began);
  }

  // With what there is.
  PerceptionMeasure compared() {
    for (std::size_t look = 0; look < looks_.size(); ++look)
      measure_.targets.push_back(compared(look));
    return std::move(measure_);
  }

 private:
  PerceivedTarget compared(std::size_t look) const {
    const std::vector<int>&in_scene = eyes_.items_shown(views_[0].view().camera),
          &in_wrist = eyes_.items_shown(views_[1].view().camera);
    PerceivedTarget target;
    target.sku = looks_[look]->sku();
    const auto item = std::ranges::find(spec_.items, target.sku, &episodes::EpisodeItem::sku);
    const auto number = static_cast<int>(item - spec_.items.begin());
    const auto scene_px = static_cast<int>(std::ranges::count(in_scene, number));
    const auto wrist_px = static_cast<int>(std::ranges::count(in_wrist, number));
    target.visible_px = scene_px + wrist_px;
    target.mask_iou = scene_px > wrist_px ? best_iou(masked_[0].masks, in_scene, number)
                                          : best_iou(masked_[1].masks, in_wrist, number);
    for (const perception::FoundProduct& found : found_)
      if (found.look == look)
        add_pose(found, world_.item_pose(static_cast<std::size_t>(number)), target);
    return target;
  }

  void add_pose(const perception::FoundProduct& found,
                const Pose& true_pose,
                PerceivedTarget& target) const {
    const perception::ProductLook& look = *looks_[found.look];
    const Pose& pose = found.pose.base_from_product;
    target.found = true;
    target.offset_m = length(middle_at(look, pose) - middle_at(look, true_pose));
    target.right = target.offset_m < right_within_m;
    target.surface_m = surface_distance(look, pose, true_pose);
    const perception::PoseEvidence& e = found.pose.evidence;
    target.score = e.score;
    target.fit = e.fit;
    target.seen = e.seen;
    target.covered = e.covered;
    target.color_error = e.color_error;
  }

  episodes::TrackWorld& track_world_;
  const episodes::CheckoutWorld& world_;
  const episodes::EpisodeSpec& spec_;
  episodes::CheckoutEyes eyes_;
  agent::Workplace place_;
  PerceptionMeasure measure_;
  perception::Looks looks_;  // one a goal
  std::vector<perception::ViewCloud> views_;
  std::vector<perception::MaskedView> masked_;
  std::vector<perception::FoundProduct> found_;
};

Result<PerceptionMeasure> measured(environments::Arena& arena,
                                   perception::LookLibrary& library,
                                   const episodes::EpisodeSpec& spec,
                                   const episodes::Realism& realism) {
  if (spec.track != episodes::Track::checkout)
    return Error{"episode.unknown_track",
                 spec.id,
                 fmt::format("perception is measured at a counter, it is of the track {}",
                             name_of(spec.track))};
  MARKETGEN_TRY(const auto opened, arena.open(spec, {}, realism));
  PerceptionTrial trial(*opened, spec);
  MARKETGEN_CHECK(trial.learn_goals(library, arena.header().products, arena.catalog().frictions));
  MARKETGEN_CHECK(trial.look());
  trial.find();
  return trial.compared();
}

}  // namespace

Result<std::vector<PerceptionMeasure>> measure_perception(
    environments::Arena& arena,
    const std::vector<episodes::EpisodeSpec>& episodes,
    const episodes::Realism& realism) {
  perception::LookLibrary library;
  std::vector<PerceptionMeasure> measures;
  for (const episodes::EpisodeSpec& spec : episodes) {
    auto measure = measured(arena, library, spec, realism);
    if (measure.ok()) {
      measures.push_back(std::move(measure).value());
      continue;
    }
    if (ends_the_run(measure.error())) return measure.error();
    PerceptionMeasure& failed = measures.emplace_back();
    failed.episode = spec.id;
    failed.error = measure.error().code;
    failed.detail = to_string(measure.error());
  }
  return measures;
}

PerceptionSummary summarize(const std::vector<PerceptionMeasure>& measures) {
  PerceptionSummary summary;
  std::vector<std::string> errors;
  for (const PerceptionMeasure& measure : measures) {
    errors.push_back(measure.error);
    summary.baskets += measure.error.empty() ? 1 : 0;
  }
  summary.errors = counted_errors(errors);
  int targets = 0, found = 0, right = 0, visible = 0;
  std::vector<double> offsets, surfaces, baskets;
  for (const PerceptionMeasure& measure : measures) {
    if (measure.error.empty()) baskets.push_back(measure.basket_off_m);
    for (const PerceivedTarget& target : measure.targets) {
      ++targets;
      found += target.found ? 1 : 0;
      right += target.right ? 1 : 0;
      if (target.visible_px >= min_visible_px) {
        ++visible;
        summary.mean_mask_iou += target.mask_iou;
      }
      if (!target.right) continue;
      offsets.push_back(target.offset_m);
      surfaces.push_back(target.surface_m);
    }
  }
  if (visible > 0) summary.mean_mask_iou /= visible;
  summary.found = grasping::share_of(found, targets);
  summary.right = grasping::share_of(right, found);
  if (!baskets.empty()) summary.max_basket_off_m = std::ranges::max(baskets);
  summary.median_basket_off_m = middle_value(std::move(baskets));
  summary.median_offset_m = middle_value(std::move(offsets));
  summary.median_surface_m = middle_value(std::move(surfaces));
  return summary;
}

}  // namespace marketgen::evaluation
