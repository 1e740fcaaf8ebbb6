// Weekdays and hours as people write them.
#include "plan/store_time.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

int minute_of(std::string_view text) {
  const auto time = plan::parse_store_time(text, "plan.bad_value", "/time");
  return time.ok() ? time->minute : -1;
}

std::string refusal_of(std::string_view text) {
  const auto time = plan::parse_store_time(text, "brief.bad_time", "--time");
  if (time.ok()) return "";
  EXPECT_EQ(time.error().code, "brief.bad_time");
  EXPECT_EQ(time.error().where, "--time");
  return time.error().message;
}

TEST(StoreTimes, AreReadAsPeopleWriteThem) {
  EXPECT_EQ(minute_of("Mon 00:00"), 0);
  EXPECT_EQ(minute_of("Mon 8:05"), 8 * 60 + 5);
  EXPECT_EQ(minute_of("Sat 17:30"), (5 * 24 + 17) * 60 + 30);
  EXPECT_EQ(minute_of("  saturday\t17:30 "), minute_of("Sat 17:30"));
  EXPECT_EQ(minute_of("SUN 23:59"), plan::minutes_of_week - 1);
}

TEST(StoreTimes, ComeBackAsTheyWereWritten) {
  for (int minute = 0; minute < plan::minutes_of_week; ++minute)
    ASSERT_EQ(minute_of(plan::text_of({minute})), minute);
  EXPECT_EQ(plan::text_of({(5 * 24 + 9) * 60 + 5}), "Sat 09:05");
}

TEST(StoreTimes, ThatAreNoneSayWhatToWrite) {
  for (const char* text : {"",
                           "Sat",
                           "17:30",
                           "Sat 17",
                           "Sat 17:3",
                           "Sat 17:030",
                           "Sat 117:30",
                           "Sat -1:30",
                           "Sat 17:+5",
                           "Sat 17.30",
                           "Sat evening",
                           "Sat 17:30 h"})
    EXPECT_NE(refusal_of(text).find("write a weekday and an hour, as in \"Sat 17:30\""),
              std::string::npos)
        << text;
  for (const char* text : {"Sat 24:00", "Sat 25:00", "Sat 17:60", "Sat 99:99"})
    EXPECT_NE(refusal_of(text).find("hours are 0 to 23, minutes 0 to 59"), std::string::npos)
        << text;
  EXPECT_NE(refusal_of("Saterday 17:30").find("did you mean \"saturday\"?"), std::string::npos);
  EXPECT_NE(refusal_of("Sa 17:30").find("begins with no weekday"), std::string::npos);
  EXPECT_LT(refusal_of(std::string(100'000, 'x')).size(), 300U);
}

}  // namespace
}  // namespace marketgen
