// Words for the time at which a shop is seen, and for how tidy it is then.
#include "intake/conflicts.h"
#include "intake/understanding.h"
#include "intake_fixture.h"

namespace marketgen {
namespace {

struct TimeCase {
  const char* prompt;
  const char* time;  // "": none
};

void PrintTo(const TimeCase& row, std::ostream* out) {
  *out << row.prompt;
}

intake::Understanding understanding_at(std::string_view prompt) {
  return intake::understand(prompt, shipped_language(), committed_catalog());
}

std::string time_in(const intake::Understanding& found) {
  const plan::Requirement* wish = found.find(plan::RequirementKind::time);
  return wish == nullptr ? "" : wish->object;
}

std::string unparsed_of(const intake::Understanding& found) {
  std::string words;
  for (const intake::UnparsedWord& word : found.unparsed)
    words += word.text + " ";
  return words;
}

class TimeWords : public testing::TestWithParam<TimeCase> {};

TEST_P(TimeWords, AreATimeOfTheWeek) {
  const intake::Understanding found = understanding_at(GetParam().prompt);
  EXPECT_EQ(time_in(found), GetParam().time);
  EXPECT_EQ(unparsed_of(found), "");
}

INSTANTIATE_TEST_SUITE_P(
    English,
    TimeWords,
    testing::Values(TimeCase{"A supermarket on Saturday evening", "Sat 18:00"},
                    TimeCase{"A supermarket on a Saturday evening with a bakery", "Sat 18:00"},
                    TimeCase{"Saturday evening in a discounter", "Sat 18:00"},
                    TimeCase{"A kiosk, Friday, 17:30", "Fri 17:30"},
                    TimeCase{"A kiosk at 17:30 on a Friday", "Fri 17:30"},
                    TimeCase{"A kiosk on Friday at 5:30 pm", "Fri 17:30"},
                    TimeCase{"A kiosk on Friday at 5 p.m. with a coffee counter", "Fri 17:00"},
                    TimeCase{"A kiosk on Friday at 9 a.m. It has snacks.", "Fri 09:00"},
                    TimeCase{"A kiosk, Sat 17:30", "Sat 17:30"},
                    TimeCase{"A kiosk on Monday at half past five", "Mon 17:30"},
                    TimeCase{"A kiosk on Monday at quarter to eight in the evening", "Mon 19:45"},
                    TimeCase{"A kiosk on Sunday at five o'clock", "Sun 17:00"},
                    TimeCase{"A kiosk on Sunday at nine o'clock", "Sun 09:00"},
                    TimeCase{"A kiosk on Saturday evening at 6", "Sat 18:00"},
                    TimeCase{"A kiosk on Tuesday morning", "Tue 09:00"},
                    TimeCase{"A kiosk on Thursday late afternoon", "Thu 17:00"},
                    TimeCase{"A kiosk at noon", "Wed 12:00"},
                    TimeCase{"A kiosk in the evening", "Wed 18:00"},
                    TimeCase{"A kiosk at 17:30", "Wed 17:30"},
                    TimeCase{"A kiosk at 12 pm", "Wed 12:00"},
                    TimeCase{"A kiosk before opening", "Wed 06:00"},
                    TimeCase{"A kiosk before opening on Saturday", "Sat 06:00"},
                    TimeCase{"A kiosk that has just opened", "Wed 08:00"},
                    TimeCase{"A kiosk just before closing", "Wed 20:00"},
                    TimeCase{"A kiosk at closing time on Friday", "Fri 20:00"},
                    TimeCase{"A kiosk in the rush hour", "Wed 17:30"},
                    TimeCase{"A kiosk on a Saturday", "Sat 12:00"},
                    TimeCase{"A kiosk at the end of a busy Saturday", "Sat 20:00"},
                    TimeCase{"A kiosk on a weekday morning", "Wed 09:00"},
                    TimeCase{"A kiosk at the weekend afternoon", "Sat 15:00"}));

INSTANTIATE_TEST_SUITE_P(Chinese,
                         TimeWords,
                         testing::Values(TimeCase{"周六傍晚的超市", "Sat 18:00"},
                                         TimeCase{"星期五下午五点半，一家便利店", "Fri 17:30"},
                                         TimeCase{"一家便利店，周日17:30", "Sun 17:30"},
                                         TimeCase{"便利店，晚上八点", "Wed 20:00"},
                                         TimeCase{"便利店，开门前", "Wed 06:00"},
                                         TimeCase{"便利店，周末快打烊时", "Sat 20:00"},
                                         TimeCase{"便利店，星期一早上九点", "Mon 09:00"},
                                         TimeCase{"便利店，下班高峰", "Wed 17:30"}));

// Times at which something happens, and clocks that are none.
INSTANTIATE_TEST_SUITE_P(Others,
                         TimeWords,
                         testing::Values(TimeCase{"A kiosk, closed on Sundays", ""},
                                         TimeCase{"A kiosk open from 8 am to 8 pm", ""},
                                         TimeCase{"A kiosk open until 10 pm", ""},
                                         TimeCase{"A kiosk, open Monday to Saturday", ""},
                                         TimeCase{"A kiosk with five tills", ""},
                                         TimeCase{"便利店，营业到晚上十点", ""}));

TEST(TimeWordsAlone, AClockThatIsNoneIsNotUnderstood) {
  EXPECT_EQ(time_in(understanding_at("A kiosk at 25:00")), "");
  EXPECT_EQ(time_in(understanding_at("A kiosk at 17:75")), "");
  EXPECT_NE(unparsed_of(understanding_at("A kiosk at 25:00")), "");
}

TEST(TimeWordsAlone, SpansPointAtTheWords) {
  const std::string prompt = "A supermarket on Saturday evening, messy";
  const intake::Understanding found = understanding_at(prompt);
  const plan::Requirement* time = found.find(plan::RequirementKind::time);
  ASSERT_NE(time, nullptr);
  EXPECT_EQ(time->text, "on Saturday evening");
  EXPECT_EQ(prompt.substr(static_cast<std::size_t>(time->span[0]), 19), "on Saturday evening");
}

TEST(TimeWordsAlone, OfTwoTimesTheLastHolds) {
  const intake::Understanding found =
      understanding_at("A kiosk on Saturday evening. It is Monday morning.");
  EXPECT_EQ(time_in(found), "Mon 09:00");
  ASSERT_EQ(found.conflicts.size(), 1U);
  EXPECT_TRUE(intake::is_contradiction(found.conflicts.front()));
}

TEST(TimeWordsAlone, WhatIsDeniedIsNoTime) {
  EXPECT_EQ(time_in(understanding_at("A kiosk, not on Saturday evening.")), "");
}

// "Just faced up" is tidy to the last pack, "picked through" is not.
TEST(TidyWords, SetTheDisorder) {
  const auto jitter = [](std::string_view prompt) {
    intake::Brief brief;
    brief.prompt = prompt;
    const auto planned =
        intake::plan_from_brief(brief, committed_catalog(), shipped_planner(), Seed(7));
    EXPECT_TRUE(planned.ok() && planned->unparsed.empty());
    return planned.ok() ? planned->plan.zones.front().stock.jitter : -1;
  };
  EXPECT_EQ(jitter("A kiosk, just faced up"), 0);
  EXPECT_EQ(jitter("A kiosk with freshly faced up shelves"), 0);
  EXPECT_EQ(jitter("便利店，刚理过货"), 0);
  EXPECT_GE(jitter("A kiosk, messy"), 0.5);
  EXPECT_GE(jitter("A kiosk with the shelves picked through"), 0.5);
}

// The plan has what words say; a flag wins over them and the wish goes.
TEST(TimeOfABrief, IsThePlansAndGivesWayToAFlag) {
  intake::Brief brief;
  brief.prompt = "A kiosk on Saturday evening";
  const auto planned =
      intake::plan_from_brief(brief, committed_catalog(), shipped_planner(), Seed(7));
  ASSERT_TRUE(planned.ok());
  EXPECT_EQ(planned->plan.time, "Sat 18:00");
  const auto& sources = planned->plan.provenance;
  EXPECT_NE(std::ranges::find(sources, "/time", &plan::Provenance::path), sources.end());
  brief.time = "Mon 08:00";
  const auto flagged =
      intake::plan_from_brief(brief, committed_catalog(), shipped_planner(), Seed(7));
  ASSERT_TRUE(flagged.ok());
  EXPECT_FALSE(std::ranges::any_of(flagged->requirements, [](const plan::Requirement& wish) {
    return wish.kind == plan::RequirementKind::time;
  }));
  ASSERT_EQ(flagged->conflicts.size(), 1U);
  EXPECT_EQ(flagged->conflicts.front().kept, "--time Mon 08:00");
  brief.time = "saturday 18:00";  // says the same
  const auto agreed =
      intake::plan_from_brief(brief, committed_catalog(), shipped_planner(), Seed(7));
  ASSERT_TRUE(agreed.ok());
  EXPECT_TRUE(agreed->conflicts.empty());
}

}  // namespace
}  // namespace marketgen
