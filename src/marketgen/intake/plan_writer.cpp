#include "intake/plan_writer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "intake/plan_look.h"
#include "intake/plan_provenance.h"
#include "intake/plan_zones.h"
#include "intake/relation_geometry.h"
#include "plan/egress.h"

namespace marketgen::intake {
namespace {

constexpr int min_ceiling_mm = 2300, max_ceiling_mm = 12000;  // limits of Shell::ceiling_mm

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

}  // namespace

plan::Plan write_plan(const PlanSources& sources) {
  plan::Plan plan;
  if (sources.understanding.name) plan.name = sources.understanding.name->text;
  plan.profile = sources.program.profile->id;
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
