// Stores whose zones stand where a drawing has them.
#include "intake/drawn_zones.h"

#include "intake/fit_slices.h"
#include "intake/offline_planner.h"
#include "intake_fixture.h"
#include "plan/bsp.h"
#include "support/painted_map.h"

namespace marketgen {
namespace {

drawing::DrawnZone with_words(const std::string& words) {
  drawing::DrawnZone zone;
  zone.words = words;
  zone.area_m2 = 60;
  return zone;
}

intake::DrawnZones named(const std::vector<std::string>& words,
                         const drawing::ZoneMap& map,
                         const std::vector<std::string>& usual = {}) {
  drawing::ZoneDrawing drawing;
  for (const std::string& one : words)
    drawing.zones.push_back(with_words(one));
  drawing.map = map;
  return intake::named_by_words(drawing, shipped_language(), committed_catalog(), usual);
}

const std::vector<RectMm> three{
    {0, 4000, 10000, 15000}, {10000, 4000, 24000, 15000}, {0, 0, 24000, 4000}};

TEST(DrawnZones, WordsNameTypesInBothLanguages) {
  const auto drawn = named({"BAKERY", "乳制品", "Checkout"}, painted_map(24000, 15000, three));
  EXPECT_EQ(drawn.types, (std::vector<std::string>{"bakery", "dairy", "checkout"}));
  EXPECT_TRUE(drawn.warnings.empty());
}

TEST(DrawnZones, TwoOfATypeAreTwoZones) {
  const auto drawn = named({"bakery", "bakery", "dairy"}, painted_map(24000, 15000, three));
  EXPECT_EQ(drawn.ids(), (std::vector<std::string>{"bakery", "bakery-2", "dairy"}));
}

TEST(DrawnZones, FloorWithoutANameGoesToTheLongestBorder) {
  // The third zone has 10 m of border with the first one and 14 m with the second.
  const auto drawn = named({"bakery", "dairy", "xqzt"}, painted_map(24000, 15000, three));
  EXPECT_EQ(drawn.types, (std::vector<std::string>{"bakery", "dairy"}));
  EXPECT_EQ(drawn.map.at(5, 5), 1);
  ASSERT_EQ(drawn.warnings.size(), 1U);
  EXPECT_EQ(drawn.warnings[0], "\"xqzt\" names no zone; its floor goes to dairy");
}

TEST(DrawnZones, OneWithoutANameIsWhatSuchShopsHave) {
  const auto drawn = named({"bakery", "", "dairy"},
                           painted_map(24000, 15000, three),
                           {"checkout", "bakery", "produce", "snacks"});
  EXPECT_EQ(drawn.types, (std::vector<std::string>{"bakery", "dairy", "produce"}));
  EXPECT_EQ(drawn.map.at(150, 100), 2);
  ASSERT_EQ(drawn.warnings.size(), 1U);
  EXPECT_EQ(drawn.warnings[0], "nothing is written on a zone; it is taken for produce");
}

intake::Brief brief_with(const std::string& prompt,
                         const std::vector<std::string>& types,
                         const std::vector<RectMm>& rects) {
  intake::Brief brief;
  brief.prompt = prompt;
  brief.image_files = {"sketch.png"};
  plan::Shell shell;
  shell.width_mm = 24000;
  shell.depth_mm = 15000;
  shell.openings = {{"entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.2, 2000}};
  brief.shell = shell;
  brief.zones = intake::DrawnZones{types, painted_map(24000, 15000, rects), {}};
  return brief;
}

intake::Planned plan_of(const intake::Brief& brief) {
  const intake::OfflinePlanner planner{shipped_language()};
  auto result = intake::plan_from_brief(brief, committed_catalog(), planner, Seed(1));
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

bool plan_has_zone(const plan::Plan& plan, const std::string& id) {
  return plan::find_zone(plan, id) != nullptr;
}

bool has_conflict(const intake::Planned& planned, const std::string& what) {
  return std::ranges::any_of(planned.conflicts,
                             [&](const intake::Conflict& one) { return one.what == what; });
}

TEST(DrawnFloor, ZonesStandWhereTheyAreDrawn) {
  const auto brief = brief_with("", {"bakery", "dairy", "checkout"}, three);
  const auto result = plan_of(brief);
  ASSERT_EQ(result.plan.zones.size(), 3U);
  std::vector<RectMm> rects(3);
  const std::vector<RectMm> built = plan::zone_rectangles(result.plan);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (result.plan.zones[i].id == brief.zones->types[k]) rects[k] = built[i];
  EXPECT_GE(intake::micro_iou(brief.zones->map, rects, 24000, 15000), 0.98);
  EXPECT_TRUE(result.conflicts.empty());
  const auto drawn =
      std::ranges::find(result.plan.provenance, std::string("/nodes"), &plan::Provenance::path);
  ASSERT_NE(drawn, result.plan.provenance.end());
  EXPECT_EQ(drawn->source, plan::Source::drawing);
}

TEST(DrawnFloor, WordsAddAndRefuseZones) {
  const auto result =
      plan_of(brief_with("with frozen food, no bakery", {"bakery", "dairy", "checkout"}, three));
  EXPECT_FALSE(plan_has_zone(result.plan, "bakery"));
  EXPECT_TRUE(plan_has_zone(result.plan, "frozen"));
  EXPECT_TRUE(has_conflict(result, "zone bakery"));
  EXPECT_TRUE(has_conflict(result, "zone frozen"));
}

TEST(DrawnFloor, TillsThatAreNotDrawnTakeFloorOfADrawnZone) {
  const auto result = plan_of(
      brief_with("", {"bakery", "dairy"}, {{0, 0, 12000, 15000}, {12000, 0, 24000, 15000}}));
  EXPECT_TRUE(plan_has_zone(result.plan, "checkout"));
}

TEST(DrawnFloor, ADoorThatWordsPutElsewhereIsAConflictWithThePicture) {
  const auto result = plan_of(
      brief_with("the entrance is in the east wall", {"bakery", "dairy", "checkout"}, three));
  const auto conflict =
      std::ranges::find(result.conflicts, "opening entrance", &intake::Conflict::what);
  ASSERT_NE(conflict, result.conflicts.end());
  EXPECT_EQ(conflict->dropped, "sketch.png: in the south wall");
}

TEST(DrawnFloor, RelationsThatTheDrawingContradictsAreConflicts) {
  const auto result = plan_of(brief_with(
      "the bakery is to the right of the dairy", {"bakery", "dairy", "checkout"}, three));
  EXPECT_TRUE(has_conflict(result, "relation"));
}

}  // namespace
}  // namespace marketgen
