// How well each module of perception does by itself, against the truth: on the basket of an episode
// as it lies at the beginning, from the cameras as they then stand.
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "environments/arena.h"
#include "episodes/episode_spec.h"
#include "evaluation/evaluation_summary.h"
#include "grasping/grasp_shares.h"

namespace marketgen::evaluation {

// Of one product that is looked for.
struct PerceivedTarget {
  std::string sku;
  int visible_px = 0;    // of both pictures together
  double mask_iou = 0;   // of the mask that fits it best, in the picture that shows most of it
  bool found = false;    // something was taken for it
  bool right = false;    // and it is
  double offset_m = 0;   // of the found pose's middle, when right
  double surface_m = 0;  // mean distance between the found and the true outside, when right
  double score = 0, fit = 0, seen = 0, covered = 0, color_error = 0;

  static constexpr auto fields = field_list(
      field("sku", &PerceivedTarget::sku, "product"),
      field("visible_px", &PerceivedTarget::visible_px, "of both pictures"),
      field("mask_iou", &PerceivedTarget::mask_iou, "of the mask that fits it best"),
      field("found", &PerceivedTarget::found, "something was taken for it"),
      field("right", &PerceivedTarget::right, "and it is"),
      field("offset_m", &PerceivedTarget::offset_m, "of the middle, when right"),
      field("surface_m", &PerceivedTarget::surface_m, "between outsides, when right"),
      field("score", &PerceivedTarget::score, "of what was found"),
      field("fit", &PerceivedTarget::fit, "share of the surface that is where it should be"),
      field("seen", &PerceivedTarget::seen, "share that nothing hides"),
      field("covered", &PerceivedTarget::covered, "share of the mask that it explains"),
      field("color_error", &PerceivedTarget::color_error, "root mean square"));
};

struct PerceptionMeasure {
  std::string episode;
  double pictures_s = 0, look_s = 0, find_s = 0;  // of computing
  double basket_off_m = 0, basket_off_deg = 0;
  std::vector<PerceivedTarget> targets;
  std::string error, detail;  // of a basket that could not be looked at: its code, and the error
  static constexpr auto fields =
      field_list(field("episode", &PerceptionMeasure::episode, "its id"),
                 field("pictures_s", &PerceptionMeasure::pictures_s, "making the catalogue's"),
                 field("look_s", &PerceptionMeasure::look_s, "taking pictures, finding the basket"),
                 field("find_s", &PerceptionMeasure::find_s, "masks, recognition and poses"),
                 field("basket_off_m",
                       &PerceptionMeasure::basket_off_m,
                       "of where the basket is taken to stand"),
                 field("basket_off_deg", &PerceptionMeasure::basket_off_deg, "the same, turned"),
                 field("targets", &PerceptionMeasure::targets, "one by one"),
                 field("error",
                       &PerceptionMeasure::error,
                       "code of the error for which it could not be looked at"),
                 field("detail", &PerceptionMeasure::detail, "that error"));
};

// One for each episode, also for those that cannot be looked at: of the aisle, say. Errors: those
// that would befall every episode (ends_the_run).
Result<std::vector<PerceptionMeasure>> measure_perception(
    environments::Arena& arena,
    const std::vector<episodes::EpisodeSpec>& episodes,
    const episodes::Realism& realism = {});

// All but `errors` is of the baskets that were looked at.
struct PerceptionSummary {
  int baskets = 0;
  grasping::Share found, right;  // of all targets; right: of those found
  double mean_mask_iou = 0, median_offset_m = 0, median_surface_m = 0;
  double median_basket_off_m = 0, max_basket_off_m = 0;
  std::vector<ErrorCount> errors;
  static constexpr auto fields = field_list(
      field("baskets", &PerceptionSummary::baskets, "how many"),
      field("found", &PerceptionSummary::found, "of the targets"),
      field("right", &PerceptionSummary::right, "of what was found"),
      field("mean_mask_iou", &PerceptionSummary::mean_mask_iou, "of the targets seen"),
      field("median_offset_m", &PerceptionSummary::median_offset_m, "when right"),
      field("median_surface_m", &PerceptionSummary::median_surface_m, "when right"),
      field("median_basket_off_m",
            &PerceptionSummary::median_basket_off_m,
            "of where baskets are taken to stand"),
      field("max_basket_off_m", &PerceptionSummary::max_basket_off_m, "the same, at most"),
      field("errors", &PerceptionSummary::errors, "baskets that are in none of these"));
};
PerceptionSummary summarize(const std::vector<PerceptionMeasure>& measures);

}  // namespace marketgen::evaluation
