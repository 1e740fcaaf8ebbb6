// What planning is worth: 100 prompts with ten seeds each, one prompt with 100, and plans that are
// broken on purpose.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/progress.h"
#include "bench/bench.h"
#include "geometry/rectangle.h"
#include "plan/patch.h"
#include "store/design.h"
#include "store/store.h"

namespace marketgen::bench {
namespace {

constexpr std::array<std::string_view, 10> shops = {
    "a 24 x 15 m neighbourhood supermarket",
    "a 30 x 20 m discounter",
    "a 45 x 35 m American supermarket",
    "a kiosk of 60 m2",
    "a 16 x 11 m convenience store",
    "a forecourt shop of 180 m2",
    "a 50 x 40 m cash and carry",
    "a pharmacy of 220 m2",
    "a dark store of 700 m2",
    "a 22 x 18 m organic supermarket",
};
constexpr std::array<std::string_view, 10> wishes = {
    "",
    " with the entrance in the west wall",
    " with six-tier shelves, filled to 60 %",
    " with drinks along the back wall",
    " with snacks next to the drinks, and no alcohol",
    " with drinks far from the entrance and snacks at the front",
    " with a concrete floor, white walls and warm light",
    " with aisles at least 1.8 m wide",
    " with two chest freezers and a bakery with one display table",
    " with dairy behind the snacks and household goods on the left wall",
};
constexpr int seeds = 10, seeds_of_one = 100, breaks_of_each = 5;
// One whose zones no word puts anywhere.
constexpr std::string_view free_prompt = "a 30 x 20 m supermarket";

struct Measured {
  std::vector<double> seconds, nav, reach, col;
  double hard = 0, out_of_bounds = 0, asked = 0, met = 0;
};

double worst_low(const std::vector<double>& values) {
  return *std::ranges::min_element(values);
}
double worst_high(const std::vector<double>& values) {
  return *std::ranges::max_element(values);
}

// To a layout that keeps its rules; no goods.
Result<double> planning_seconds(const store::CreateOptions& options,
                                const catalog::Catalog& catalog) {
  const double start = monotonic_seconds();
  MARKETGEN_CHECK(store::design_store(options.brief, catalog, Seed(options.seed)));
  return monotonic_seconds() - start;
}

Result<void> measure(const store::CreateOptions& options,
                     const catalog::Catalog& catalog,
                     Measured& all) {
  MARKETGEN_TRY(const double seconds, planning_seconds(options, catalog));
  all.seconds.push_back(seconds);
  MARKETGEN_TRY(const store::StoreReport report, store::try_store(options, catalog));
  all.nav.push_back(report.metrics.NAV);
  all.reach.push_back(report.metrics.REACH);
  all.col.push_back(report.metrics.COL);
  all.out_of_bounds += static_cast<double>(report.metrics.OOB);
  all.hard += static_cast<double>(
      std::ranges::count(report.rules, layout::Severity::hard, &layout::Violation::severity));
  all.asked += static_cast<double>(report.requirements.size());
  all.met += static_cast<double>(
      std::ranges::count(report.requirements, true, &audit::RequirementResult::met));
  return {};
}

// The type of the zone on each square of the floor, by its number in `types`; 0 for none.
std::vector<int> zone_map(const layout::Layout& layout, std::vector<std::string>& types) {
  constexpr int square_mm = 250;
  std::vector<int> map;
  for (int y = square_mm / 2; y < layout.shell.depth_mm; y += square_mm) {
    for (int x = square_mm / 2; x < layout.shell.width_mm; x += square_mm) {
      const auto zone = std::ranges::find_if(layout.zones, [&](const layout::LayoutZone& z) {
        return geometry::contains(z.polygon_mm, {x, y});
      });
      if (zone == layout.zones.end()) {
        map.push_back(0);
        continue;
      }
      auto type = std::ranges::find(types, zone->type);
      if (type == types.end()) type = types.insert(types.end(), zone->type);
      map.push_back(static_cast<int>(type - types.begin()) + 1);
    }
  }
  return map;
}

// Squares of the same zone type over squares that have a zone in either: the micro-IoU.
double overlap_of(const std::vector<int>& a, const std::vector<int>& b) {
  double same = 0, either = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == 0 && b[i] == 0) continue;
    const bool agree = a[i] == b[i];
    same += agree ? 1 : 0;
    either += agree ? 1 : (a[i] != 0 ? 1 : 0) + (b[i] != 0 ? 1 : 0);  // a union of two areas
  }
  return either > 0 ? same / either : 1;
}

Result<double> diversity(const catalog::Catalog& catalog) {
  std::vector<std::string> types;
  std::vector<std::vector<int>> maps;
  intake::Brief brief;
  brief.prompt = free_prompt;
  for (std::uint64_t seed = 1; seed <= seeds_of_one; ++seed) {
    MARKETGEN_TRY(const store::Designed made, store::design_store(brief, catalog, Seed(seed)));
    maps.push_back(zone_map(made.layout, types));
  }
  double sum = 0;
  int pairs = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j, ++pairs)
      sum += overlap_of(maps[i], maps[j]);
  }
  return 1 - sum / pairs;
}

// ---- Plans that are broken on purpose -----------------------------------------------------------

using Faults = std::pair<int, int>;  // hard and soft

Faults faults_of(const std::optional<layout::Layout>& layout) {
  if (!layout) return {1'000'000, 0};  // no layout at all
  Faults faults;
  for (const layout::Violation& v : layout->violations)
    ++(v.severity == layout::Severity::hard ? faults.first : faults.second);
  return faults;
}

std::optional<layout::Layout> laid_out(const plan::Plan& plan,
                                       const catalog::Catalog& catalog,
                                       Seed seed) {
  Result<layout::Layout> layout = layout::make_layout(plan, catalog, seed);
  if (!layout.ok()) return std::nullopt;
  return std::move(layout).value();
}

// A cut in the wrong place, an aisle that is gone, two zones changed about, aisles that are too
// narrow.
plan::Patch breaking(const plan::Plan& plan, Stream& draw) {
  std::vector<const plan::Node*> cuts;
  for (const plan::Node& node : plan.nodes) {
    if (node.split) cuts.push_back(&node);
  }
  const auto any = [&](const auto& list) -> const auto& {
    return list[static_cast<std::size_t>(draw.integer(0, static_cast<int>(list.size()) - 1))];
  };
  plan::Patch patch;
  switch (cuts.empty() ? 3 : draw.integer(0, 3)) {
    case 0:
      patch.set_ratio = plan::SetRatio{any(cuts)->id, draw.chance(0.5) ? 0.1 : 0.9};
      break;
    case 1:
      patch.set_gap = plan::SetGap{any(cuts)->id, 0};
      break;
    case 2:
      patch.swap_leaves = plan::SwapLeaves{any(plan.zones).id, any(plan.zones).id};
      break;
    default:
      patch.set_fixture = plan::SetFixture{};
      patch.set_fixture->zone = any(plan.zones).id;
      patch.set_fixture->aisle_mm = 700;
  }
  return patch;
}

struct Mended {
  int broken = 0, raised = 0, lowered = 0, lawful = 0, were_unlawful = 0;
};

Result<void> break_and_mend(const store::CreateOptions& options,
                            const catalog::Catalog& catalog,
                            Mended& count) {
  const Seed seed(options.seed);
  MARKETGEN_TRY(const store::Designed whole, store::design_store(options.brief, catalog, seed));
  const Faults before = faults_of(whole.layout);
  Stream draw = seed.child("breaks", options.brief.prompt).stream();
  for (int i = 0; i < breaks_of_each; ++i) {
    const auto patched =
        plan::patched(whole.repaired.plan, breaking(whole.repaired.plan, draw), catalog, "break");
    if (!patched.ok() || !plan::validate_plan(patched->plan, "break", catalog).ok()) continue;
    const Faults broken = faults_of(laid_out(patched->plan, catalog, seed));
    if (broken <= before) continue;
    MARKETGEN_TRY(const layout::Repaired repaired,
                  layout::repair_plan(patched->plan, catalog, seed));
    const Faults then = faults_of(repaired.layout);
    ++count.broken;
    count.raised += then < broken ? 1 : 0;
    count.lowered += broken < then ? 1 : 0;
    if (broken.first == 0) continue;
    ++count.were_unlawful;
    count.lawful += then.first == 0 ? 1 : 0;
  }
  return {};
}

}  // namespace

Figures run_planning(const catalog::Catalog& catalog) {
  Measured all;
  Mended mended;
  for (const std::string_view shop : shops) {
    for (const std::string_view wish : wishes) {
      store::CreateOptions options;
      options.brief.prompt = std::string(shop) + std::string(wish);
      options.previews = false;
      for (options.seed = 1; options.seed <= seeds; ++options.seed)
        MARKETGEN_CHECK(measure(options, catalog, all));
      options.seed = 1;
      MARKETGEN_CHECK(break_and_mend(options, catalog, mended));
    }
  }
  MARKETGEN_TRY(const double different, diversity(catalog));
  std::vector<Figure> figures;
  const auto add = [&](std::string name, double value, std::string unit, int n) {
    figures.push_back(
        {std::move(name), value, std::move(unit), n, std::nullopt, std::nullopt, machine_name()});
  };
  const int stores = static_cast<int>(all.seconds.size());
  add("planning_median_s", median(all.seconds), "s", stores);
  add("planning_worst_s", worst_high(all.seconds), "s", stores);
  add("planning_hard_violations", all.hard, "rules", stores);
  add("planning_COL_worst", worst_high(all.col), "share", stores);
  add("planning_OOB", all.out_of_bounds, "items", stores);
  add("planning_NAV_median", median(all.nav), "share", stores);
  add("planning_NAV_worst", worst_low(all.nav), "share", stores);
  add("planning_REACH_median", median(all.reach), "share", stores);
  add("planning_REACH_worst", worst_low(all.reach), "share", stores);
  add("planning_wishes_met", all.met / all.asked, "share", static_cast<int>(all.asked));
  add("planning_DIV", different, "1 - IoU", seeds_of_one);
  add("planning_mended", 1.0 * mended.raised / mended.broken, "share", mended.broken);
  add("planning_made_lawful",
      1.0 * mended.lawful / mended.were_unlawful,
      "share",
      mended.were_unlawful);
  add("planning_made_worse", mended.lowered, "plans", mended.broken);
  return figures;
}

}  // namespace marketgen::bench
