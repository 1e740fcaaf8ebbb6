#include "audit/fixture_requirements.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "audit/metrics.h"
#include "audit/straight_runs.h"
#include "layout/floor.h"
#include "layout/makes.h"

namespace marketgen::audit {
namespace {

// Within a few steps of such a door.
bool stands_by(const Facts& facts, const layout::Fixture& fixture, plan::OpeningKind kind) {
  constexpr double steps_mm = 6000;
  const RectMm rect = layout::footprint_of(fixture);
  const layout::Floor floor = layout::make_floor(facts.scene.layout.shell);
  return std::any_of(floor.doorways.begin(), floor.doorways.end(), [&](const auto& door) {
    return facts.scene.layout.shell.openings[door.opening].kind == kind &&
           distance_mm(rect, point_rect(door.threshold)) <= steps_mm + door.span.length() / 2.0;
  });
}

// Of the kind, in the zone type or by the door that the wish names (second_object).
bool is_counted(const Facts& facts, const plan::Requirement& r, const layout::Fixture& fixture) {
  const std::string kind = r.subject == "checkout" ? "checkout_lane" : r.subject;
  const bool counter = kind == "checkout_lane" && fixture.kind == "till-counter";  // small shops
  if (!layout::counts_as(facts.scene.layout, fixture, kind) && !counter) return false;
  const auto door = value_named<plan::OpeningKind>(r.second_object);
  return door ? stands_by(facts, fixture, *door) : in_zone(facts, fixture, r.second_object);
}

bool is_gondola(const Facts& facts, const layout::Fixture& fixture) {
  return layout::counts_as(facts.scene.layout, fixture, "gondola");
}

// The shelves of a zone, or all gondolas.
bool levels_count(const Facts& facts, const plan::Requirement& r, std::size_t i) {
  const layout::Fixture& fixture = facts.scene.layout.fixtures[i];
  const bool meant = r.subject.empty() ? is_shelving(facts, fixture) && is_gondola(facts, fixture)
                                       : facts.scene.fixtures[i].shelf_count > 0;
  return meant && fixture.endcap_of.empty() && holds_for(facts, r, r.subject, fixture);
}

// Heights of the boards of one side over the floor, lowest first.
std::vector<double> boards_mm(const Facts& facts, std::size_t i) {
  const scene::SceneFixture& row = facts.scene.fixtures[i];
  std::vector<double> heights;
  for (std::uint32_t s = row.first_shelf; s < row.first_shelf + row.shelf_count; ++s) {
    if (facts.scene.shelves[s].side == 0)
      heights.push_back(1e3 * static_cast<double>(facts.scene.shelves[s].position_m[2]));
  }
  std::ranges::sort(heights);
  return heights;
}

// On the fixtures that the wish is about.
StockCount stock_meant(const Facts& facts, const plan::Requirement& r) {
  std::vector<bool> meant;
  for (const layout::Fixture& fixture : facts.scene.layout.fixtures)
    meant.push_back(holds_for(facts, r, r.object, fixture));
  return stock_on(facts.scene, meant);
}

double share_of(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

// Disorder shows as items in the wrong place: some when it was asked for, no more than the share
// that was allowed.
Verdict check_order(const plan::Requirement& r, const StockCount& count) {
  const bool wanted = r.comparison == plan::Comparison::at_least ||
                      (r.comparison == plan::Comparison::equal && r.value > 0);
  const double most = r.value * static_cast<double>(count.items);
  return {wanted ? count.misplaced > 0 : static_cast<double>(count.misplaced) <= most,
          fmt::format("{} items stand in the wrong place", count.misplaced)};
}

Verdict check_gaps(const plan::Requirement& r, const StockCount& count) {
  const double share =
      share_of(static_cast<double>(count.empty_blocks), static_cast<double>(count.blocks));
  const double tolerance = 0.01 + r.value / 4;  // which blocks are sold out is drawn by chance
  return {compares(r, share, tolerance),
          fmt::format("{:.0f} % of the facing blocks are sold out", 100 * share)};
}

// Which tags have a fault is drawn by chance, and two hang only where a block is wide enough.
Verdict check_tags(const plan::Requirement& r, std::size_t faulty, std::size_t blocks) {
  const double share = share_of(static_cast<double>(faulty), static_cast<double>(blocks));
  const std::string measured = fmt::format("{} of {} places for price tags", faulty, blocks);
  if (r.comparison == plan::Comparison::at_least || r.subject == "tags_doubled")
    return {r.value > 0 ? faulty > 0 : faulty == 0, measured};
  return {compares(r, share, r.value > 0 ? 0.02 + r.value / 4 : 0), measured};
}

}  // namespace

Verdict check_fixture_count(const Facts& facts, const plan::Requirement& r) {
  const auto& fixtures = facts.scene.layout.fixtures;
  const auto number = std::count_if(fixtures.begin(), fixtures.end(), [&](const auto& fixture) {
    return is_counted(facts, r, fixture);
  });
  // Pillars are the room's own as often as they are put up.
  const std::size_t of_room = r.subject == "pillar" ? facts.scene.layout.shell.columns.size() : 0;
  return number_verdict(
      r, static_cast<double>(number) + static_cast<double>(of_room), r.subject + ":", "");
}

Verdict check_run_count(const Facts& facts, const plan::Requirement& r) {
  std::vector<layout::Fixture> counted;
  for (const layout::Fixture& fixture : facts.scene.layout.fixtures) {
    if (is_counted(facts, r, fixture)) counted.push_back(fixture);
  }
  const std::vector<StraightRun> runs = straight_runs(counted);
  int single = 0, paired = 0, twofold = 0;
  for (const StraightRun& run : runs) {
    if (run.sides == 2)
      ++twofold;
    else
      ++(run.back_to_back ? paired : single);
  }
  if (r.second_value == 0) return number_verdict(r, static_cast<double>(runs.size()), "runs:", "");
  const int both = twofold + paired / 2;
  const bool two = r.second_value == 2;
  Verdict verdict =
      number_verdict(r, two ? both : single, two ? "double-sided runs:" : "single-sided runs:", "");
  const int others = two ? single : both;
  if (others == 0) return verdict;
  return {false, verdict.why + fmt::format("; {} others", others)};
}

Verdict check_levels(const Facts& facts, const plan::Requirement& r) {
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < facts.scene.fixtures.size(); ++i) {
    if (levels_count(facts, r, i)) seen.insert(boards_mm(facts, i).size());
  }
  const bool met = !seen.empty() && std::ranges::all_of(seen, [&](std::size_t n) {
    return compares(r, static_cast<double>(n));
  });
  return {met,
          fmt::format("shelves have {} levels; asked for {}{:g}",
                      fmt::join(seen, " or "),
                      sign(r.comparison),
                      r.value)};
}

Verdict check_shelf_pitch(const Facts& facts, const plan::Requirement& r) {
  constexpr double tolerance_mm = 5;  // boards hang in slots
  std::set<long> seen;                // whole millimetres
  bool met = true;
  for (std::size_t i = 0; i < facts.scene.fixtures.size(); ++i) {
    if (!levels_count(facts, r, i)) continue;
    const std::vector<double> heights = boards_mm(facts, i);
    for (std::size_t k = 1; k < heights.size(); ++k) {
      const double pitch = heights[k] - heights[k - 1];
      met = met && compares(r, pitch, tolerance_mm);
      seen.insert(std::lround(pitch));
    }
  }
  if (seen.empty()) return {false, "there are no such shelves with several levels"};
  return {met,
          fmt::format("boards are {} to {} mm apart; asked for {}{:g} mm",
                      *seen.begin(),
                      *seen.rbegin(),
                      sign(r.comparison),
                      r.value)};
}

Verdict check_endcaps(const Facts& facts, const plan::Requirement& r) {
  const auto& fixtures = facts.scene.layout.fixtures;
  const auto number =
      std::count_if(fixtures.begin(), fixtures.end(), [&](const layout::Fixture& f) {
        return !f.endcap_of.empty() && in_zone(facts, f, r.subject);
      });
  const bool unwanted = r.comparison == plan::Comparison::at_most && r.value == 0;
  return {unwanted ? number == 0 : number > 0, fmt::format("{} endcaps", number)};
}

Verdict check_height(const Facts& facts, const plan::Requirement& r) {
  if (r.subject == "ceiling")
    return number_verdict(r, facts.scene.layout.shell.ceiling_mm, "the ceiling is at", " mm", 10);
  double lowest = 0, highest = 0;
  for (const layout::Fixture& f : facts.scene.layout.fixtures) {
    const bool counted = r.subject.empty() || r.subject == "shelf" ||
                                 facts.catalog.fixture_kind(r.subject) == nullptr
                             ? is_gondola(facts, f)
                             : layout::counts_as(facts.scene.layout, f, r.subject);
    if (!counted || !holds_for(facts, r, r.object, f)) continue;
    lowest = lowest == 0 ? f.height_mm : std::min<double>(lowest, f.height_mm);
    highest = std::max<double>(highest, f.height_mm);
  }
  if (highest == 0) return {false, "there are no such fixtures"};
  const bool low_is_worse =
      r.comparison == plan::Comparison::at_least ||
      (r.comparison == plan::Comparison::equal && r.value - lowest > highest - r.value);
  return number_verdict(r, low_is_worse ? lowest : highest, "shelves are high", " mm", 10);
}

Verdict check_stock(const Facts& facts, const plan::Requirement& r) {
  const StockCount count = stock_meant(facts, r);
  if (count.blocks == 0) return {false, "no goods stand there"};
  if (r.subject == "misplaced" || r.subject == "jitter") return check_order(r, count);
  if (r.subject == "out_of_stock") return check_gaps(r, count);
  if (r.subject == "tags_missing") return check_tags(r, count.no_tag, count.tagged_blocks);
  if (r.subject == "tags_wrong_price") return check_tags(r, count.wrong_price, count.tagged_blocks);
  if (r.subject == "tags_wrong_product")
    return check_tags(r, count.wrong_product, count.tagged_blocks);
  if (r.subject == "tags_doubled") return check_tags(r, count.two_tags, count.tagged_blocks);
  const double fill = share_of(count.stocked_m, count.front_m);
  constexpr double tolerance = 0.12;  // packs do not divide a shelf evenly
  return {compares(r, fill, tolerance),
          fmt::format("{:.0f} % of the shelf front is stocked", 100 * fill)};
}

}  // namespace marketgen::audit
