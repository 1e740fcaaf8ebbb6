// 1,000 random layouts: the planner, the layout rules and the audit judge the same relation on the
// same floor by the same measure. What one of them accepts, the next one does, too; where they
// differ, the slack lies within the named margin between them. What cannot be judged is so for all.
//
// MARKETGEN_PROPERTY_RELATIONS=10000 for the long run.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "audit/requirements.h"
#include "intake/relation_geometry.h"
#include "layout/relations.h"
#include "support/number_of_cases.h"
#include "support/random_plan.h"

namespace marketgen {
namespace {

constexpr int relations_a_layout = 6;

// The names that relations may say, and one that no shop has.
std::vector<std::string> names_in(const plan::Plan& plan) {
  std::vector<std::string> names{"moon"};
  for (const std::string_view place : plan::fixed_places)
    names.emplace_back(place);
  for (const plan::Zone& zone : plan.zones) {
    names.push_back(zone.id);
    names.push_back(zone.type);
  }
  for (const plan::Opening& opening : plan.shell.openings)
    names.emplace_back(name_of(opening.kind));
  return names;
}

plan::Requirement random_wish(const plan::Plan& plan, Stream& draw) {
  const std::vector<std::string> names = names_in(plan);
  const auto any = [&] {
    return names[static_cast<std::size_t>(draw.integer(0, static_cast<int>(names.size()) - 1))];
  };
  plan::Requirement wish;
  wish.kind = plan::RequirementKind::relation;
  constexpr int kinds = static_cast<int>(plan::names_of(plan::RelationKind{}).size());
  wish.relation = static_cast<plan::RelationKind>(draw.integer(0, kinds - 1));
  const auto zone =
      static_cast<std::size_t>(draw.integer(0, static_cast<int>(plan.zones.size()) - 1));
  wish.subject = plan.zones[zone].id;
  wish.object = any();
  if (wish.relation == plan::RelationKind::between) wish.second_object = any();
  return wish;
}

plan::Relation relation_of(const plan::Requirement& wish) {
  plan::Relation relation{
      wish.relation, wish.subject, wish.object, std::nullopt, plan::Strength::must};
  if (wish.relation == plan::RelationKind::between) relation.c = wish.second_object;
  return relation;
}

// ---- The three judges ----

enum class Judgement { broken, holds, not_judged };

// As the planner sees the floor while it still draws it.
Judgement of_planner(const plan::Plan& plan, const plan::Requirement& wish) {
  intake::StoreProgram program;
  for (const plan::Zone& zone : plan.zones) {
    intake::ProgramZone& row = program.zones.emplace_back();
    row.id = zone.id;
    row.type = committed_catalog().zone_type(zone.type);
  }
  intake::Candidate candidate;
  candidate.floor = plan::shell_rect(plan.shell);
  candidate.rects = plan::zone_rectangles(plan);
  candidate.openings = plan.shell.openings;
  const plan::NamedFloor floor = intake::named_floor(candidate, program);
  if (!plan::measure_relation(floor, plan::terms_of(wish))) {
    EXPECT_GT(intake::miss_of(wish, floor), 0) << "what cannot be judged does not hold";
    return Judgement::not_judged;
  }
  return intake::miss_of(wish, floor) <= 0 ? Judgement::holds : Judgement::broken;
}

// By the rules that a layout is checked by.
Judgement of_layout(const layout::Layout& layout, plan::Plan plan, const plan::Requirement& wish) {
  plan.relations = {relation_of(wish)};
  const std::vector<layout::Violation> found =
      layout::check_layout(layout, plan, committed_catalog());
  const auto is_broken = [&](std::string_view code) {
    return std::ranges::find(found, code, &layout::Violation::code) != found.end();
  };
  if (is_broken("RELATION_NOT_JUDGED")) return Judgement::not_judged;
  return is_broken("RELATION_BROKEN") ? Judgement::broken : Judgement::holds;
}

// A scene of the layout with one item on each fixture, so that no zone is empty to the audit.
scene::Scene stocked(const layout::Layout& layout) {
  scene::Scene scene;
  scene.layout = layout;
  for (std::uint32_t i = 0; i < layout.fixtures.size(); ++i) {
    scene::SceneFixture fixture;
    fixture.first_shelf = i;
    fixture.shelf_count = 1;
    scene.fixtures.push_back(fixture);
    scene::SceneShelf shelf;
    shelf.fixture = i;
    scene.shelves.push_back(shelf);
    scene::Facing facing;
    facing.shelf = i;
    facing.product_count = 1;
    scene.facings.push_back(facing);
  }
  return scene;
}

// Nothing for a zone in which no fixture found room: that is another wish.
std::optional<Judgement> of_audit(const scene::Scene& scene, const plan::Requirement& wish) {
  const audit::RequirementResult result =
      audit::check_requirements(scene, committed_catalog(), {wish}).at(0);
  if (result.why.starts_with("there is no ")) return std::nullopt;
  if (result.met) return Judgement::holds;
  const bool judged = result.why.find("cannot be judged") == std::string::npos;
  return judged ? Judgement::broken : Judgement::not_judged;
}

TEST(SlowRelationProperty, ThreeJudgesAgreeUpToTheirMargins) {
  const std::size_t layouts = number_of_cases("MARKETGEN_PROPERTY_RELATIONS", 1000);
  std::map<plan::RelationKind, std::map<Judgement, int>> seen;
  std::size_t laid_out = 0, planned = 0;
  for (std::uint64_t seed = 0; seed < layouts; ++seed) {
    const plan::Plan plan = RandomPlan(seed).make();
    const Result<layout::Layout> layout =
        layout::make_layout(plan, committed_catalog(), Seed(seed));
    if (!layout.ok()) continue;
    ++laid_out;
    const scene::Scene scene = stocked(*layout);
    Stream draw = Seed(seed).child("relations").stream();
    for (int i = 0; i < relations_a_layout; ++i) {
      const plan::Requirement wish = random_wish(plan, draw);
      const plan::NamedFloor floor = layout::named_floor(*layout);
      const auto measure = plan::measure_relation(floor, plan::terms_of(wish));
      SCOPED_TRACE("seed " + std::to_string(seed) + ": " +
                   plan::words_of(floor, plan::terms_of(wish), measure));
      const auto expected = [&](double margin_m) {
        if (!measure) return Judgement::not_judged;
        return measure->slack_m() >= margin_m ? Judgement::holds : Judgement::broken;
      };
      // The planner plans rectangular rooms only: elsewhere walls cut pieces off its zones.
      if (!plan.shell.outline_mm) {
        EXPECT_EQ(of_planner(plan, wish),
                  expected(measure ? intake::planner_margin_m(*measure) : 0));
        ++planned;
      }
      EXPECT_EQ(of_layout(*layout, plan, wish), expected(layout::layout_margin_m));
      const auto audited = of_audit(scene, wish);
      if (!audited) continue;
      EXPECT_EQ(*audited, expected(0));
      ++seen[wish.relation][*audited];
    }
  }
  EXPECT_GT(100 * laid_out, 95 * layouts);  // measured: all
  EXPECT_GT(2 * planned, relations_a_layout * layouts);
  // Every relation was found to hold, to be broken and not to be judged.
  for (std::size_t k = 0; k < plan::names_of(plan::RelationKind{}).size(); ++k) {
    for (const Judgement judgement : {Judgement::broken, Judgement::holds, Judgement::not_judged}) {
      EXPECT_GT(seen[static_cast<plan::RelationKind>(k)][judgement], 0)
          << plan::names_of(plan::RelationKind{})[k] << " " << static_cast<int>(judgement);
    }
  }
}

// The margins go one way: who comes earlier asks for more.
TEST(RelationProperty, MarginsOfEarlierStagesAreWider) {
  for (const double limit_m : {0.0, 1.0, 3.0, 20.0}) {
    const plan::RelationMeasure measure{"gap", 0, limit_m, true, {}};
    EXPECT_GT(intake::planner_margin_m(measure), layout::layout_margin_m);
  }
  EXPECT_GE(layout::layout_margin_m, 0);
}

}  // namespace
}  // namespace marketgen
