// Shelves and tills of drawings of zones, and how much of a drawing a plan keeps.
#include "intake/drawn_runs.h"

#include "intake/drawn_fit.h"
#include "intake/drawn_tills.h"
#include "intake/offline_planner.h"
#include "intake_fixture.h"
#include "layout/layout.h"
#include "plan/bsp.h"
#include "support/painted_map.h"

namespace marketgen {
namespace {

constexpr int wide_mm = 24000, deep_mm = 15000;
const std::vector<RectMm> drawn_rects{
    {0, 4000, 12000, 15000}, {12000, 4000, 24000, 15000}, {0, 0, 24000, 4000}};
const std::vector<std::string> drawn_types{"dry_goods", "snacks", "checkout"};

intake::Brief drawn_brief(const std::string& prompt,
                          const std::vector<std::string>& zones,
                          const std::vector<RectMm>& floors,
                          std::optional<drawing::DrawnRuns> first_runs = std::nullopt) {
  intake::Brief brief;
  brief.prompt = prompt;
  brief.image_files = {"sketch.png"};
  plan::Shell shell;
  shell.width_mm = wide_mm;
  shell.depth_mm = deep_mm;
  shell.openings = {{"entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.1, 2000},
                    {"exit", plan::OpeningKind::exit, plan::Wall::south, 0.8, 2000}};
  brief.shell = shell;
  brief.zones = intake::DrawnZones{zones, painted_map(wide_mm, deep_mm, floors), {}, {first_runs}};
  return brief;
}

intake::Planned planned_of(const intake::Brief& brief) {
  auto result = intake::plan_from_brief(brief, committed_catalog(), shipped_planner(), Seed(1));
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

const plan::Zone& zone_in(const plan::Plan& plan, const std::string& id) {
  const plan::Zone* zone = plan::find_zone(plan, id);
  if (zone == nullptr) fatal(id.c_str());
  return *zone;
}

int lines_of(const plan::Plan& plan, const std::string& zone) {
  const auto layout = layout::make_layout(plan, committed_catalog(), Seed(1));
  if (!layout.ok()) fatal(to_string(layout.error()).c_str());
  for (const layout::Violation& fault : layout->violations)
    if (fault.code == "COUNT_SHORT" && fault.where == zone + "/runs")
      return static_cast<int>(fault.value);
  return zone_in(plan, zone).fixture.runs.value_or(-1);
}

bool said_by_drawing(const plan::Plan& plan, const std::string& end) {
  return std::ranges::any_of(plan.provenance, [&](const plan::Provenance& entry) {
    return entry.path.ends_with(end) && entry.source == plan::Source::drawing;
  });
}

const intake::Conflict* shown_conflict(const intake::Planned& planned, const std::string& what) {
  const auto found = std::ranges::find(planned.conflicts, what, &intake::Conflict::what);
  return found == planned.conflicts.end() ? nullptr : &*found;
}

TEST(DrawnRuns, BecomeRunsOfThePlanInTheirDirection) {
  for (const bool along_x : {true, false}) {
    const auto planned =
        planned_of(drawn_brief("", drawn_types, drawn_rects, drawing::DrawnRuns{3, along_x, 0.9}));
    const plan::Zone& zone = zone_in(planned.plan, "dry_goods");
    EXPECT_EQ(zone.fixture.runs, 3);
    EXPECT_EQ(zone.fixture.axis, along_x ? plan::RunAxis::x : plan::RunAxis::y);
    EXPECT_EQ(lines_of(planned.plan, "dry_goods"), 3);
    EXPECT_FALSE(zone_in(planned.plan, "snacks").fixture.runs.has_value());
    EXPECT_TRUE(said_by_drawing(planned.plan, "/fixture/runs"));
    EXPECT_TRUE(said_by_drawing(planned.plan, "/fixture/axis"));
    EXPECT_TRUE(planned.conflicts.empty());
  }
}

TEST(DrawnRuns, ALoneStrokeSaysNothing) {
  const auto planned =
      planned_of(drawn_brief("", drawn_types, drawn_rects, drawing::DrawnRuns{1, true, 0.5}));
  EXPECT_FALSE(zone_in(planned.plan, "dry_goods").fixture.runs.has_value());
  EXPECT_FALSE(said_by_drawing(planned.plan, "/fixture/axis"));
}

TEST(DrawnRuns, MoreThanThereIsRoomForAreLoweredAndSaid) {
  const auto planned =
      planned_of(drawn_brief("", drawn_types, drawn_rects, drawing::DrawnRuns{9, true, 0.9}));
  const plan::Zone& zone = zone_in(planned.plan, "dry_goods");
  ASSERT_TRUE(zone.fixture.runs.has_value());
  EXPECT_GE(*zone.fixture.runs, 2);
  EXPECT_LT(*zone.fixture.runs, 9);
  EXPECT_EQ(lines_of(planned.plan, "dry_goods"), *zone.fixture.runs);
  const intake::Conflict* conflict = shown_conflict(planned, "runs of dry_goods");
  ASSERT_NE(conflict, nullptr);
  EXPECT_EQ(conflict->dropped, "the drawing: 9 runs");
}

TEST(DrawnRuns, WordsWin) {
  const auto planned = planned_of(drawn_brief("two rows of gondolas",
                                              {"dry_goods", "bakery", "checkout"},
                                              drawn_rects,
                                              drawing::DrawnRuns{3, true, 0.9}));
  EXPECT_EQ(zone_in(planned.plan, "dry_goods").fixture.runs, 2);
  const intake::Conflict* conflict = shown_conflict(planned, "runs of dry_goods");
  ASSERT_NE(conflict, nullptr);
  EXPECT_EQ(conflict->dropped, "the drawing: 3 runs");
}

RectMm rect_of(const plan::Plan& plan, const std::string& id) {
  const std::vector<RectMm> all = plan::zone_rectangles(plan);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (plan.zones[i].id == id) return all[i];
  return {0, 0, 0, 0};
}

TEST(DrawnTills, StandAtTheExitAndLeaveOtherZonesAlone) {  // the exit is at 19.2 m in the south
  const std::vector<RectMm> three{
      {0, 0, 8000, 15000}, {8000, 0, 16000, 15000}, {16000, 0, 24000, 15000}};
  const auto planned = planned_of(drawn_brief("", {"bakery", "dairy", "snacks"}, three));
  const RectMm tills = rect_of(planned.plan, "checkout");
  EXPECT_GE(tills.x0, 15900);
  EXPECT_EQ(tills.y0, 0);
  const intake::DrawnFit fit = intake::drawn_fit(*planned.drawn, planned.plan);
  EXPECT_GE(fit.zones[0].iou, 0.99);
  EXPECT_GE(fit.zones[1].iou, 0.99);
  EXPECT_LT(fit.zones[2].iou, 0.8);
}

TEST(DrawnTills, TakeBareFloorBeforeTheExitFirst) {
  const std::vector<RectMm> two{{0, 0, 12000, 15000}, {12000, 7000, 24000, 15000}};
  const auto planned = planned_of(drawn_brief("", {"bakery", "snacks"}, two));
  const RectMm tills = rect_of(planned.plan, "checkout");
  EXPECT_GE(tills.x0, 11900);
  EXPECT_LE(tills.y1, 7100);
  const intake::DrawnFit fit = intake::drawn_fit(*planned.drawn, planned.plan);
  EXPECT_GE(fit.zones[0].iou, 0.98);
  EXPECT_GE(fit.zones[1].iou, 0.98);
}

TEST(DrawnTills, LanesThatNobodyAskedForGiveWayToTheDoor) {
  const catalog::ZoneTypeRow* type = committed_catalog().zone_type("checkout");
  intake::StoreProgram program;
  program.width_mm = wide_mm;
  program.depth_mm = deep_mm;
  program.zones.resize(3);
  program.zones[2].type = type;
  program.zones[2].kind = committed_catalog().fixture_kind(type->fixture);
  program.zones[2].stance = intake::Stance::front;
  program.zones[2].count = 6;
  // Only the far zone has room for six lanes.
  const drawing::ZoneMap map =
      painted_map(wide_mm, deep_mm, {{0, 0, 16000, 15000}, {16000, 0, 24000, 15000}});
  const PointMm door{235, 0};
  const auto free = intake::place_for_tills(map, program, 2, door, false);
  ASSERT_TRUE(free.has_value());
  EXPECT_EQ(free->giver, 1);
  EXPECT_LT(free->lanes, 6);
  const auto asked = intake::place_for_tills(map, program, 2, door, true);
  ASSERT_TRUE(asked.has_value());
  EXPECT_EQ(asked->giver, 0);
  EXPECT_EQ(asked->lanes, 6);
}

TEST(DrawnFit, IsMeasuredOnThePlanAsItIs) {
  plan::Plan plan;
  plan.shell.width_mm = 20000;
  plan.shell.depth_mm = 10000;
  plan.zones.resize(2);
  plan.zones[0].id = "bakery";
  plan.zones[0].fixture.runs = 2;
  plan.zones[1].id = "dairy";
  plan::Node cut, west, east;
  cut.id = "floor";
  cut.split = plan::Axis::x;
  cut.ratio = 0.25;  // drawn: a half
  cut.children = {"floor/1", "floor/2"};
  west.id = "floor/1";
  west.zone = "bakery";
  east.id = "floor/2";
  east.zone = "dairy";
  plan.nodes = {cut, west, east};
  intake::DrawnZones drawn{
      {"bakery", "dairy", "wine"},
      painted_map(20000, 10000, {{0, 0, 10000, 10000}, {10000, 0, 20000, 10000}}),
      {},
      {drawing::DrawnRuns{3, true, 0.9}}};
  const intake::DrawnFit fit = intake::drawn_fit(drawn, plan);
  ASSERT_EQ(fit.zones.size(), 3U);
  EXPECT_DOUBLE_EQ(fit.zones[0].iou, 0.5);          // 5 of 10 m
  EXPECT_NEAR(fit.zones[1].iou, 10.0 / 15, 0.001);  // 10 of 15 m
  EXPECT_DOUBLE_EQ(fit.zones[2].iou, 0);            // not in the plan
  EXPECT_NEAR(fit.iou, 15.0 / 25, 0.001);
  EXPECT_EQ(fit.zones[0].drawn_runs, 3);
  EXPECT_EQ(fit.zones[0].runs, 2);
  EXPECT_DOUBLE_EQ(fit.zones[0].drawn_m2, 100);
}

}  // namespace
}  // namespace marketgen
