#include "intake/plan_writer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "intake/fixture_wishes.h"
#include "intake/goods_words.h"
#include "intake/plan_look.h"
#include "intake/plan_provenance.h"
#include "intake/plan_zones.h"
#include "intake/relation_geometry.h"
#include "plan/egress.h"

namespace marketgen::intake {
namespace {

constexpr int min_ceiling_mm = 2300, max_ceiling_mm = 12000;  // limits of Shell::ceiling_mm

// Where that many columns stand in a grid that is nearly square: three by three are nine.
std::vector<plan::Column> grid_of_columns(int count, int width_mm, int depth_mm) {
  const double abreast = std::sqrt(static_cast<double>(count) * width_mm / std::max(1, depth_mm));
  int columns = std::clamp(static_cast<int>(std::lround(abreast)), 1, std::max(1, count));
  while (count % columns != 0)
    --columns;
  const int rows = count / columns;
  std::vector<plan::Column> grid;
  for (int i = 0; i < count; ++i) {
    plan::Column& column = grid.emplace_back();
    column.x_mm = width_mm * (2 * (i % columns) + 1) / (2 * columns);
    column.y_mm = depth_mm * (2 * (i / columns) + 1) / (2 * rows);
  }
  return grid;
}

bool is_before_door(const plan::Shell& shell, const plan::Column& column) {
  constexpr int free_mm = 1500;
  const RectMm floor{0, 0, shell.width_mm, shell.depth_mm};
  return std::ranges::any_of(shell.openings, [&](const plan::Opening& door) {
    const PointMm at = plan::point_inside(floor, door, 0);
    return std::hypot(at[0] - column.x_mm, at[1] - column.y_mm) < door.width_mm / 2 + free_mm;
  });
}

// As many that stand with their backs to the walls, away from doors.
std::vector<plan::Column> columns_at_walls(int count, const plan::Shell& shell) {
  constexpr int step_mm = 1000;
  std::vector<plan::Column> places;
  const int half = plan::Column{}.size_mm / 2;
  const auto add = [&](int x_mm, int y_mm) {
    const plan::Column column{x_mm, y_mm};
    if (!is_before_door(shell, column)) places.push_back(column);
  };
  for (const int x : {half, shell.width_mm - half})
    for (int y = 2 * step_mm; y < shell.depth_mm - step_mm; y += step_mm)
      add(x, y);
  for (int x = 2 * step_mm; x < shell.width_mm - step_mm; x += step_mm)
    add(x, shell.depth_mm - half);
  std::vector<plan::Column> chosen;
  const auto most = std::min(static_cast<std::size_t>(count), places.size());
  for (std::size_t i = 0; i < most; ++i)
    chosen.push_back(places[(2 * i + 1) * places.size() / (2 * most)]);
  return chosen;
}

// As many as the words want, where no drawing says where they stand.
void add_columns(plan::Shell& shell, const Understanding& found, bool at_walls) {
  constexpr int max_columns = 40;
  const plan::Requirement* wish = found.find(plan::RequirementKind::fixture_count, "pillar");
  if (wish == nullptr || asks_for_none(*wish) || !shell.columns.empty()) return;
  const bool only_named = wish->comparison == plan::Comparison::at_least && wish->value <= 1;
  if (only_named) return;
  const int count = std::clamp(static_cast<int>(std::lround(wish->value)), 1, max_columns);
  shell.columns = at_walls ? columns_at_walls(count, shell)
                           : grid_of_columns(count, shell.width_mm, shell.depth_mm);
}

plan::Shell shell_of(const PlanSources& sources) {
  plan::Shell shell = sources.program.shell.value_or(plan::Shell{});
  shell.width_mm = sources.program.width_mm;
  shell.depth_mm = sources.program.depth_mm;
  shell.ceiling_mm = sources.program.profile->ceiling_mm;
  if (const plan::Requirement* wish =
          sources.understanding.find(plan::RequirementKind::height, "ceiling")) {
    shell.ceiling_mm =
        std::clamp(static_cast<int>(std::lround(wish->value)), min_ceiling_mm, max_ceiling_mm);
  }
  shell.openings = sources.candidate.openings;
  add_columns(shell, sources.understanding, sources.program.columns_at_walls);
  return shell;
}

// The relations that were asked for, between things that the store has.
std::vector<plan::Relation> relations_of(const PlanSources& sources) {
  const plan::NamedFloor floor = named_floor(sources.candidate, sources.program);
  std::vector<plan::Relation> relations;
  for (const plan::Requirement& wish : sources.understanding.requirements) {
    if (wish.kind != plan::RequirementKind::relation) continue;
    if (!plan::missing_place(floor, plan::terms_of(wish)).empty()) continue;
    plan::Relation& relation = relations.emplace_back();
    relation.kind = wish.relation;
    relation.a = wish.subject;
    relation.b = wish.object;
    if (wish.relation == plan::RelationKind::between) relation.c = wish.second_object;
    relation.strength = wish.strength;
  }
  return relations;
}

// A hall has the ways out that so many people need, where no floor plan shows its doors and nobody
// says how many emergency exits there are.
void add_lacking_exits(plan::Shell& shell, const PlanSources& sources) {
  const std::optional<plan::Shell>& drawn = sources.program.shell;
  const auto speaks_of_exits = [](const plan::Requirement& wish) {
    return wish.kind == plan::RequirementKind::opening &&
           wish.subject == name_of(plan::OpeningKind::emergency);
  };
  if (drawn && !drawn->openings.empty()) return;
  if (std::ranges::any_of(sources.understanding.requirements, speaks_of_exits)) return;
  std::ranges::move(plan::lacking_exits(shell), std::back_inserter(shell.openings));
}

// Shelves are no higher than the ceiling lets them be.
void fit_under_ceiling(plan::Plan& plan) {
  constexpr int clearance_mm = 300;
  for (plan::Zone& zone : plan.zones) {
    if (!zone.fixture.height_mm) continue;
    const int highest = plan.shell.ceiling_mm - clearance_mm;
    if (*zone.fixture.height_mm <= highest) continue;
    zone.fixture.height_mm = highest;
    zone.fixture.spacing_mm.reset();  // the boards share what height is left
  }
}

// The flag's, or that of a kind of shop that is named by its country: "American supermarket".
std::optional<std::string> country_of(const PlanSources& sources) {
  if (sources.brief.country) return sources.brief.country;
  const plan::Requirement* shop = sources.understanding.find(plan::RequirementKind::profile);
  if (shop == nullptr) return std::nullopt;
  const std::string words = lower_ascii(shop->text);
  if (names_any(words, {"american", "us", "\u7f8e\u56fd", "\u7f8e\u5f0f"})) return "us";
  if (names_any(
          words,
          {"chinese", "china", "shanghai", "beijing", "shenzhen", "\u4e2d\u56fd", "\u4e2d\u5f0f"}))
    return "cn";
  return std::nullopt;
}

}  // namespace

plan::Plan write_plan(const PlanSources& sources) {
  plan::Plan plan;
  if (sources.understanding.name) plan.name = sources.understanding.name->text;
  plan.profile = sources.program.profile->id;
  plan.country = country_of(sources);
  if (const auto* time = sources.understanding.find(plan::RequirementKind::time))
    plan.time = time->object;
  plan.shell = shell_of(sources);
  add_lacking_exits(plan.shell, sources);
  plan.look = look_of(sources);
  std::vector<std::string> ids;
  for (const ProgramZone& zone : sources.program.zones)
    ids.push_back(zone.id);
  plan.nodes = nodes_of(sources.candidate.root, ids);
  plan.zones = zones_of(sources);
  fit_under_ceiling(plan);
  if (!sources.program.equipment.empty()) plan.equipment = sources.program.equipment;
  plan.relations = relations_of(sources);
  plan.provenance = provenance_of(plan, sources);
  return plan;
}

}  // namespace marketgen::intake
