#include "intake/limits.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/fields.h"
#include "intake/store_size.h"
#include "plan/plan.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

// What market-plan/1 allows a field to be.
template <class Struct>
FieldRules rules_of(std::string_view name) {
  for (const FieldInfo& field : type_of<Struct>().fields) {
    if (field.name == name) return field.rules;
  }
  return {};
}

// Of a floor that is said in square metres alone.
constexpr double smallest_m2 = 1e-6 * min_store_side_mm * min_store_side_mm;
constexpr double largest_m2 = 1e-6 * max_store_side_mm * max_store_side_mm;

struct Limits {
  double min = 0, max = 0;
  std::string_view of, unit = {};
};

// A plan holds 40 openings in all.
constexpr double max_doors = 6, max_emergency_exits = 10, max_windows = 12;

Limits opening_limits(std::string_view kind) {
  if (kind == "window") return {0, max_windows, "windows"};
  if (kind == "emergency") return {0, max_emergency_exits, "emergency exits"};
  return {0, max_doors, "doors of one kind"};
}

std::optional<Limits> limits_of(const plan::Requirement& wish) {
  constexpr double max_zones_of_a_type = 12, max_aisles = 60;
  const auto within_plan = [](const FieldRules& rules, std::string_view of, std::string_view unit) {
    return Limits{rules.min, rules.max, of, unit};
  };
  switch (wish.kind) {
    case Kind::zone_count:
      return Limits{0, max_zones_of_a_type, "zones of one type"};
    case Kind::fixture_count:
      return Limits{0, rules_of<plan::FixtureSpec>("count").max, "fixtures in a zone"};
    case Kind::run_count:
      return within_plan(rules_of<plan::FixtureSpec>("runs"), "runs in a zone", "");
    case Kind::aisle_count:
      return Limits{1, max_aisles, "aisles"};
    case Kind::levels:
      return within_plan(rules_of<plan::FixtureSpec>("levels"), "levels", "");
    case Kind::aisle_width:
      return within_plan(rules_of<plan::FixtureSpec>("aisle_mm"), "the width of aisles", " mm");
    case Kind::height:
      if (wish.subject == "ceiling")
        return within_plan(rules_of<plan::Shell>("ceiling_mm"), "the height of the ceiling", " mm");
      return within_plan(rules_of<plan::FixtureSpec>("height_mm"), "the height of shelves", " mm");
    case Kind::opening:
      return opening_limits(wish.subject);
    case Kind::area:
      if (wish.subject.empty()) return Limits{smallest_m2, largest_m2, "the floor", " m2"};
      return within_plan(rules_of<plan::AreaRange>("target"), "the floor of a zone", " m2");
    default:
      return std::nullopt;
  }
}

std::string written(double value, std::string_view unit) {
  return fmt::format("{:g}{}", value, unit);
}

// A count of 0 stands for "any" or "none" and is no number that was asked for.
void keep_number(plan::Requirement& wish, Understanding& found, BeyondLimits& beyond) {
  const auto limits = limits_of(wish);
  if (!limits || wish.value == 0) return;
  const double kept = std::clamp(wish.value, limits->min, limits->max);
  if (kept == wish.value) return;
  beyond.changed.push_back(wish);
  found.conflicts.push_back({std::string(limits->of),
                             written(kept, limits->unit),
                             wish.text,
                             fmt::format("{}: {} to {}",
                                         limits->of,
                                         written(limits->min, limits->unit),
                                         written(limits->max, limits->unit))});
  wish.value = kept;
}

// Both sides of the shop; one that was not said is 0.
void keep_size(plan::Requirement& wish, Understanding& found, BeyondLimits& beyond) {
  const auto buildable = [](double side) {
    return side > 0 ? std::clamp(side, min_store_side_mm, max_store_side_mm) : side;
  };
  const double width = buildable(wish.value), depth = buildable(wish.second_value);
  if (width == wish.value && depth == wish.second_value) return;
  beyond.changed.push_back(wish);
  found.conflicts.push_back({"the size of the store",
                             metres(width) + " x " + metres(depth) + " m",
                             wish.text,
                             "a store is 4 to 200 m wide and deep"});
  wish.value = width;
  wish.second_value = depth;
}

void keep_rows(Understanding& found) {
  constexpr int max_rows = 20;
  for (WantedRows& rows : found.rows) {
    if (rows.rows <= max_rows) continue;
    found.conflicts.push_back({"rows of " + rows.zone,
                               std::to_string(max_rows),
                               std::to_string(rows.rows) + " rows",
                               fmt::format("rows: 1 to {}", max_rows)});
    rows.rows = max_rows;
  }
}

void set_relations_aside(Understanding& found, BeyondLimits& beyond) {
  std::size_t weighed = 0;
  std::vector<plan::Requirement> kept;
  for (plan::Requirement& wish : found.requirements) {
    const bool surplus = wish.kind == Kind::relation && ++weighed > max_weighed_relations;
    (surplus ? beyond.set_aside : kept).push_back(std::move(wish));
  }
  found.requirements = std::move(kept);
  if (beyond.set_aside.empty()) return;
  found.conflicts.push_back(
      {"relations",
       fmt::format("the first {}", max_weighed_relations),
       fmt::format(
           "{} more, from \"{}\" on", beyond.set_aside.size(), beyond.set_aside.front().text),
       fmt::format("at most {} wishes about places are weighed", max_weighed_relations)});
}

}  // namespace

BeyondLimits keep_within_limits(Understanding& found) {
  BeyondLimits beyond;
  for (plan::Requirement& wish : found.requirements) {
    if (wish.kind == Kind::size)
      keep_size(wish, found, beyond);
    else
      keep_number(wish, found, beyond);
  }
  keep_rows(found);
  set_relations_aside(found, beyond);
  return beyond;
}

std::vector<plan::Requirement> as_asked(std::vector<plan::Requirement> wishes,
                                        const BeyondLimits& beyond) {
  for (plan::Requirement& wish : wishes) {
    const auto asked = std::ranges::find_if(beyond.changed, [&](const plan::Requirement& other) {
      return other.kind == wish.kind && other.span == wish.span && other.subject == wish.subject;
    });
    if (asked == beyond.changed.end()) continue;
    wish.value = asked->value;
    wish.second_value = asked->second_value;
  }
  wishes.insert(wishes.end(), beyond.set_aside.begin(), beyond.set_aside.end());
  return wishes;
}

}  // namespace marketgen::intake
