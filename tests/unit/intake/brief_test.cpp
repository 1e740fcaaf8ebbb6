// Briefs that cannot be planned, the choice of planners, and sizes as flags give them.
#include "intake_fixture.h"

namespace marketgen {
namespace {

Error refusal(const intake::Brief& brief) {
  const auto planner = intake::offline_planner();
  if (!planner.ok()) fatal(to_string(planner.error()).c_str());
  const auto planned = intake::plan_from_brief(brief, committed_catalog(), **planner, Seed(1));
  return planned.ok() ? Error{"", "", "it was planned"} : planned.error();
}

intake::Brief brief_of(std::string prompt) {
  intake::Brief brief;
  brief.prompt = std::move(prompt);
  return brief;
}

TEST(Brief, WithoutWordsIsEmpty) {
  EXPECT_EQ(refusal(brief_of("")).code, "brief.empty");
  EXPECT_EQ(refusal(brief_of(" \n\t ")).code, "brief.empty");
}

TEST(Brief, OfTwentyThousandBytesIsTheLongest) {
  EXPECT_EQ(refusal(brief_of(std::string(20'000, ' ') + "a")).code, "brief.too_long");
  EXPECT_NE(refusal(brief_of("shop " + std::string(19'000, '.'))).code, "brief.too_long");
}

TEST(Brief, NamesTheFirstByteThatIsNotUtf8) {
  const Error error = refusal(brief_of("a shop \xFF with bread"));
  EXPECT_EQ(error.code, "input.not_utf8");
  EXPECT_EQ(error.where, "prompt:byte 7");
}

TEST(Brief, SizesMustBeBuildable) {
  intake::Brief brief = brief_of("a shop");
  brief.size_mm = {{3000, 9000}};
  EXPECT_EQ(refusal(brief).code, "brief.bad_size");
  EXPECT_EQ(refusal(brief).where, "--size");
}

TEST(Brief, ASizeInWordsThatCannotBeBuiltIsTheNearestAndSaidSo) {
  const Result<intake::Planned> planned = intake::plan_from_brief(
      brief_of("a kiosk of 4 x 3 m"), committed_catalog(), shipped_planner(), Seed{1});
  ASSERT_TRUE(planned.ok()) << to_string(planned.error());
  EXPECT_EQ(planned->plan.shell.width_mm, 4000);
  EXPECT_EQ(planned->plan.shell.depth_mm, 4000);
  ASSERT_FALSE(planned->conflicts.empty());
  EXPECT_EQ(planned->conflicts.front().what, "the size of the store");
  EXPECT_EQ(planned->conflicts.front().dropped, "4 x 3 m");
}

TEST(Brief, UnknownProfileAndStyleAreNamedWithTheNearest) {
  intake::Brief brief = brief_of("a shop");
  brief.profile = "supermarket-ue";
  EXPECT_EQ(refusal(brief).code, "catalog.unknown_kind");
  EXPECT_NE(refusal(brief).message.find("supermarket-eu"), std::string::npos);
  brief.profile.reset();
  brief.style = "industial";
  EXPECT_EQ(refusal(brief).where, "--style");
  EXPECT_NE(refusal(brief).message.find("industrial"), std::string::npos);
}

TEST(Brief, HasOneDrawingOfZonesAtMost) {
  intake::Brief brief = brief_of("a shop");
  brief.image_files = {"sketch.png", "other.png"};
  EXPECT_EQ(refusal(brief).code, "usage.bad_flag");
  EXPECT_EQ(refusal(brief).where, "--image other.png");
}

TEST(ParseSize, ReadsWhatFlagsSay) {
  using Size = std::array<int, 2>;
  EXPECT_EQ(*intake::parse_size("24x15m", "--size"), (Size{24000, 15000}));
  EXPECT_EQ(*intake::parse_size("24 x 15 m", "--size"), (Size{24000, 15000}));
  EXPECT_EQ(*intake::parse_size("40m x 25m", "--size"), (Size{40000, 25000}));
  EXPECT_EQ(*intake::parse_size("80x50ft", "--size"), (Size{24384, 15240}));
  EXPECT_EQ(*intake::parse_size("12.5x9", "--size"), (Size{12500, 9000}));
  EXPECT_EQ(*intake::parse_size("24000x15000mm", "--size"), (Size{24000, 15000}));
}

TEST(ParseSize, RefusesTheRest) {
  for (const char* bad : {"",
                          "24",
                          "24x",
                          "x15",
                          "24x15x3",
                          "big",
                          "24x15 parsecs",
                          "2x15m",
                          "24x900m",
                          "-24x15m",
                          "24x15m please"}) {
    const auto size = intake::parse_size(bad, "--size");
    ASSERT_FALSE(size.ok()) << bad;
    EXPECT_EQ(size.error().code, "brief.bad_size") << bad;
    EXPECT_EQ(size.error().where, "--size");
  }
}

}  // namespace
}  // namespace marketgen
