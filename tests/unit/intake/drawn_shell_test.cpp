// A floor plan beside flags and words: who wins, and that it is said.
#include "intake/drawn_shell.h"

#include <filesystem>
#include <fstream>

#include "intake/offline_planner.h"
#include "intake_fixture.h"

namespace marketgen {
namespace {

// An L of 30 x 20 m with an entrance in the south, a door in the east and a column.
intake::Brief brief_with_l(const std::string& prompt) {
  plan::Shell shell;
  shell.width_mm = 30000;
  shell.depth_mm = 20000;
  shell.outline_mm =
      PolygonMm{{0, 0}, {30000, 0}, {30000, 12000}, {20000, 12000}, {20000, 20000}, {0, 20000}};
  shell.openings = {{"entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.25, 2000},
                    {"service", plan::OpeningKind::service, plan::Wall::east, 0.3, 1500}};
  shell.columns = {{10000, 10000, 400}};
  intake::Brief brief;
  brief.prompt = prompt;
  brief.floor_plan = "shop.dxf";
  brief.shell = shell;
  return brief;
}

Result<intake::Planned> planned(const intake::Brief& brief) {
  const intake::OfflinePlanner planner{shipped_language()};
  return intake::plan_from_brief(brief, committed_catalog(), planner, Seed(1));
}

plan::Source source_of(const plan::Plan& plan, const std::string& path) {
  for (const plan::Provenance& entry : plan.provenance)
    if (entry.path == path) return entry.source;
  return plan::Source::unset;
}

TEST(DrawnShell, IsThePlansShell) {
  const intake::Brief brief = brief_with_l("a supermarket with dairy at the back");
  const auto result = planned(brief);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  const plan::Shell& shell = result->plan.shell;
  EXPECT_EQ(shell.outline_mm, brief.shell->outline_mm);
  EXPECT_EQ(shell.columns.size(), 1U);
  ASSERT_EQ(shell.openings.size(), 2U);
  EXPECT_EQ(shell.openings[0].center, 0.25);
  EXPECT_TRUE(result->conflicts.empty());
  for (const char* path :
       {"/shell/width_mm", "/shell/outline_mm", "/shell/columns", "/shell/openings/0"})
    EXPECT_EQ(source_of(result->plan, path), plan::Source::drawing) << path;
}

// What is counted makes a floor larger where nobody said how large it is; the drawing says it.
TEST(DrawnShell, DoesNotGrowWithWhatIsCounted) {
  const auto result = planned(brief_with_l("a supermarket with ninety chest freezers"));
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->plan.shell.width_mm, 30000);
  EXPECT_EQ(result->plan.shell.depth_mm, 20000);
  const bool told = std::ranges::any_of(result->trace, [](const std::string& line) {
    return line.find("30 x 20 m") != std::string::npos;
  });
  EXPECT_TRUE(told) << "the floor that was planned on";
}

TEST(DrawnShell, NeedsNoWords) {
  const auto result = planned(brief_with_l(""));
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_TRUE(result->understood);
}

TEST(DrawnShell, WordsStretchItAndSaySo) {
  const auto result = planned(brief_with_l("a 24 x 15 m supermarket"));
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->plan.shell.width_mm, 24000);
  EXPECT_EQ(result->plan.shell.depth_mm, 15000);
  ASSERT_EQ(result->conflicts.size(), 1U);
  EXPECT_EQ(result->conflicts[0].what, "size");
  EXPECT_NE(result->conflicts[0].dropped.find("30 x 20 m"), std::string::npos)
      << result->conflicts[0].dropped;
  EXPECT_EQ(source_of(result->plan, "/shell/width_mm"), plan::Source::text);
}

TEST(DrawnShell, TheSameSizeInWordsIsNoConflict) {
  const auto result = planned(brief_with_l("a 30 x 20 m supermarket"));
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_TRUE(result->conflicts.empty());
}

TEST(DrawnShell, ADoorThatWordsPutElsewhereTakesADrawnOne) {
  const auto result = planned(brief_with_l("a supermarket with the entrance in the east wall"));
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  ASSERT_EQ(result->conflicts.size(), 1U);
  EXPECT_EQ(result->plan.shell.openings[0].kind, plan::OpeningKind::entrance);
  EXPECT_EQ(result->plan.shell.openings[0].wall, plan::Wall::east);
  const auto none = planned(brief_with_l("a supermarket with the entrance in the west wall"));
  ASSERT_TRUE(none.ok()) << to_string(none.error());
  EXPECT_EQ(none->plan.shell.openings[0].wall, plan::Wall::west);
  EXPECT_EQ(none->conflicts.size(), 1U);
}

TEST(DrawnShell, IsReadWithTheSizeInTheWords) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "room.svg";
  std::ofstream(file)
      << R"(<svg xmlns="http://www.w3.org/2000/svg"><rect width="300" height="200"/></svg>)";
  intake::Brief brief;
  brief.prompt = "a supermarket 24 m wide";
  brief.floor_plan = file.string();
  const auto drawn = intake::with_drawing(brief, committed_catalog());
  ASSERT_TRUE(drawn.ok()) << to_string(drawn.error());
  EXPECT_EQ(drawn->brief.shell->width_mm, 24000);
  EXPECT_EQ(drawn->brief.shell->depth_mm, 16000);
  brief.prompt = "a supermarket";
  EXPECT_EQ(intake::with_drawing(brief, committed_catalog()).error().code, "drawing.no_scale");
}

}  // namespace
}  // namespace marketgen
