#include "intake/plan_writer.h"

#include <algorithm>
#include <cmath>

#include "intake/plan_look.h"
#include "intake/plan_provenance.h"
#include "intake/plan_zones.h"
#include "intake/relation_geometry.h"

namespace marketgen {
namespace {

constexpr int min_ceiling_mm = 2300, max_ceiling_mm = 12000;  // limits of Shell::ceiling_mm

Shell shell_of(const PlanSources& sources) {
  Shell shell;
  shell.width_mm = sources.program.width_mm;
  shell.depth_mm = sources.program.depth_mm;
  shell.ceiling_mm = sources.program.profile->ceiling_mm;
  if (const Requirement* wish = sources.understanding.find(RequirementKind::height, "ceiling")) {
    shell.ceiling_mm =
        std::clamp(static_cast<int>(std::lround(wish->value)), min_ceiling_mm, max_ceiling_mm);
  }
  shell.openings = sources.candidate.openings;
  return shell;
}

// The relations that were asked for, between things that the store has.
std::vector<Relation> relations_of(const PlanSources& sources) {
  const NamedFloor floor = named_floor(sources.candidate, sources.program);
  std::vector<Relation> relations;
  for (const Requirement& wish : sources.understanding.requirements) {
    if (wish.kind != RequirementKind::relation) continue;
    if (!missing_place(floor, terms_of(wish)).empty()) continue;
    Relation& relation = relations.emplace_back();
    relation.kind = wish.relation;
    relation.a = wish.subject;
    relation.b = wish.object;
    if (wish.relation == RelationKind::between) relation.c = wish.second_object;
    relation.strength = wish.strength;
  }
  return relations;
}

// Shelves are no higher than the ceiling lets them be.
void fit_under_ceiling(Plan& plan) {
  constexpr int clearance_mm = 300;
  for (Zone& zone : plan.zones) {
    if (!zone.fixture.height_mm) continue;
    zone.fixture.height_mm =
        std::min(*zone.fixture.height_mm, plan.shell.ceiling_mm - clearance_mm);
  }
}

}  // namespace

Plan write_plan(const PlanSources& sources) {
  Plan plan;
  if (sources.understanding.name) plan.name = sources.understanding.name->text;
  plan.profile = sources.program.profile->id;
  plan.shell = shell_of(sources);
  plan.look = look_of(sources);
  std::vector<std::string> ids;
  for (const ProgramZone& zone : sources.program.zones)
    ids.push_back(zone.id);
  plan.nodes = nodes_of(sources.candidate.root, ids);
  plan.zones = zones_of(sources);
  fit_under_ceiling(plan);
  plan.relations = relations_of(sources);
  plan.provenance = provenance_of(plan, sources);
  return plan;
}

}  // namespace marketgen
