// The audit of a finished store: metrics, rules and requirements, all measured on the scene and
// never on the plan.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "layout/layout.h"
#include "plan/requirement.h"
#include "scene/scene.h"

namespace marketgen::audit {

struct RequirementResult {
  std::string text;
  IntRange span{0, 0};
  bool met = false;
  std::string why;  // what was measured

  static constexpr auto fields =
      field_list(field("text", &RequirementResult::text, "the wish"),
                 field("span", &RequirementResult::span, "bytes of the prompt"),
                 field("met", &RequirementResult::met, "does it hold"),
                 field("why", &RequirementResult::why, "what was measured"));
};

// Definitions: docs/metrics.md. A metric that was not measured is absent.
struct Metrics {
  double COL =
      0;  // share of item pairs with > 1 mm non-support penetration, out of pairs that are near
  std::uint64_t colliding_pairs = 0;
  std::uint64_t OOB = 0;  // products outside their shelf or the room
  double NAV = 1;         // largest free component / free area, for a 0.42 m radius robot
  double reachable_shelves =
      1;             // share of shelves with free floor in front, connected to the entrance
  double REACH = 1;  // the same of bays: sides of modules of which a shelf can be reached
  double fill = 0;   // occupied / available shelf front
  double DENS = 0;   // items per m2 of selling area
  double selling_area_m2 = 0, gross_area_m2 = 0;
  double facings_per_sku = 0;
  double prompt = 1;          // share of requirements met
  std::optional<double> STB;  // share of products that drift < 5 cm; `report` only
  std::optional<int> stb_products;

  static constexpr auto fields = field_list(
      field("COL", &Metrics::COL, "share of near item pairs that interpenetrate by more than 1 mm"),
      field("colliding_pairs", &Metrics::colliding_pairs, "how many pairs"),
      field("OOB", &Metrics::OOB, "products outside shelf or room"),
      field("NAV",
            &Metrics::NAV,
            "largest free floor component over free floor, 0.42 m robot radius"),
      field("reachable_shelves",
            &Metrics::reachable_shelves,
            "share of shelves with free floor before them, connected to the entrance"),
      field("REACH",
            &Metrics::REACH,
            "share of bays (sides of modules) of which one shelf at least is reachable"),
      field("fill", &Metrics::fill, "occupied over available shelf front"),
      field("DENS", &Metrics::DENS, "items per m2 of selling area"),
      field("selling_area_m2", &Metrics::selling_area_m2, "floor area of the zones that sell"),
      field("gross_area_m2", &Metrics::gross_area_m2, "floor area of the room"),
      field("facings_per_sku", &Metrics::facings_per_sku, "mean facings of a product on offer"),
      field("prompt", &Metrics::prompt, "share of requirements met"),
      field("STB", &Metrics::STB, "share of products that drift less than 5 cm"),
      field("stb_products", &Metrics::stb_products, "products that were let go"));
};

struct Audit {
  Metrics metrics;
  std::vector<layout::Violation> rules;  // of the layout and of the scene
  std::vector<RequirementResult> requirements;
};

// Deterministic; does not need the plan. Scene rules are the rows of scene_rules.inc.
// Errors: assets.bad_row, physics.failed.
Result<Audit> audit_store(const scene::Scene& scene,
                          const catalog::Catalog& catalog,
                          const std::vector<plan::Requirement>& requirements);

// With which patches a person or a model mends a broken rule of the scene: "set_look: a light_lux
// of 300 and more". Empty for rules of the layout, whose repairs are tried by themselves.
std::string_view remedy_of(std::string_view code);

}  // namespace marketgen::audit
