// The grasp study: what each tool can take hold of, product by product, tried in physics.
//
// For a product and a tool, candidates come from motion/grasp_candidates.h and the best k of them
// are tried by grasping/grasp_trial.h, each with an error of the tool drawn from the seed. A
// product for which there is no candidate is excluded, and so is one that cannot be tried in a
// setting; the reason is kept. Success is read from the simulation only.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/progress.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "grasping/grasp_trial.h"
#include "motion/grasp_candidates.h"
#include "robots/grasp_tool.h"

namespace marketgen::grasping {

// Why a product is not counted among those that fit a tool; `none` for one that is. Those that
// GraspRefusal has too mean the same. unstable: it does not stand by itself, or does not come to
// rest in a basket. unshelved: it lies in heaps or hangs from pegs, and is no case for a shelf.
// does_not_fit: the basket is too small for it.
enum class GraspExclusion {
  none,
  too_wide,
  not_opposed,
  turns,
  no_seal,
  too_heavy,
  no_room,
  unstable,
  unshelved,
  does_not_fit
};
constexpr std::array<std::string_view, 10> names_of(GraspExclusion) {
  return {"none",
          "too_wide",
          "not_opposed",
          "turns",
          "no_seal",
          "too_heavy",
          "no_room",
          "unstable",
          "unshelved",
          "does_not_fit"};
}

// One try of one candidate.
struct GraspTry {
  motion::GraspStrategy strategy = motion::GraspStrategy::side;
  GraspEnd end = GraspEnd::held;
  double width_mm = 0, force_n = 0, slip_mm = 0, turned_deg = 0, neighbour_n = 0;

  static constexpr auto fields = field_list(
      field("strategy", &GraspTry::strategy, "how the product is taken"),
      field("end", &GraspTry::end, "what became of it"),
      field("width_mm", &GraspTry::width_mm, "between the pads; 0 for a cup"),
      field("force_n", &GraspTry::force_n, "on each pad, or greatest pull of the cup, N"),
      field("slip_mm", &GraspTry::slip_mm, "greatest, of the product under pads or cup"),
      field("turned_deg", &GraspTry::turned_deg, "of the product in the tool, degrees"),
      field("neighbour_n", &GraspTry::neighbour_n, "greatest push on a neighbour, N"));
};

// What one tool does with one product in one setting.
struct GraspRate {
  std::string sku, archetype, tool;
  GraspSetting setting = GraspSetting::free;
  GraspExclusion excluded = GraspExclusion::none;
  std::string reason;           // of the exclusion, a sentence
  std::vector<GraspTry> tries;  // best candidate first

  int held() const;                     // how many of the tries
  std::vector<int> held_tries() const;  // their numbers
  bool first_held() const;              // the best candidate's
  bool fits() const { return excluded == GraspExclusion::none; }

  static constexpr auto fields =
      field_list(field("sku", &GraspRate::sku, "product"),
                 field("archetype", &GraspRate::archetype, "container shape"),
                 field("tool", &GraspRate::tool, "row of the tool"),
                 field("setting", &GraspRate::setting, "free, stocked, spaced or basket"),
                 field("excluded", &GraspRate::excluded, "why it was not tried; none = it was"),
                 field("reason", &GraspRate::reason, "of the exclusion"),
                 field("tries", &GraspRate::tries, "best candidate first"));
};

struct StudyOptions {
  std::vector<GraspSetting> settings{GraspSetting::free};
  int tries = 3;  // candidates of each product, 1..20
  // Over 0: no more of a product's candidates are tried once so many held, or once so many cannot
  // hold any more.
  int enough_held = 0;
  std::uint64_t seed = 1;
  // Told each product's rates as they are finished, from any thread; may be none.
  std::function<void(const std::vector<GraspRate>&)> finished;
};

// For the candidates that the study tries in a setting, which is not `basket`, in their order.
motion::GraspQuery grasp_query(GraspSetting setting,
                               const catalog::Product& product,
                               double friction);

// Sliding friction of rubber (pads, lips) on the product's material: data/friction.json.
double rubber_friction(const std::vector<catalog::FrictionRow>& frictions,
                       const catalog::Product& product);

// Every product with every tool in every setting: products in their order, then tools, then
// settings. The same for any number of threads. Errors: assets.* and catalog.bad_row of a product,
// motion.bad_configuration, physics.failed.
Result<std::vector<GraspRate>> study_grasps(const std::vector<const catalog::Product*>& products,
                                            const std::vector<robots::GraspTool>& tools,
                                            const std::vector<catalog::FrictionRow>& frictions,
                                            const StudyOptions& options,
                                            Progress& progress);

}  // namespace marketgen::grasping
