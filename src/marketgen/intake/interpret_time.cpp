// When the shelves are seen: "on a Saturday evening", "at 17:30 on a Friday", "before opening".
#include <algorithm>
#include <cmath>
#include <optional>

#include "intake/interpret.h"
#include "plan/store_time.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using plan::minutes_of_day;
using plan::minutes_of_hour;

// Where words leave it open. On Wednesday morning staff fill shelves of every category, so that the
// hour alone decides what is gone.
constexpr int usual_day = static_cast<int>(plan::Weekday::Wed) + 1;
constexpr int noon = 12, noon_minute = noon * minutes_of_hour;
constexpr int first_open_hour = 7;  // "five o'clock" is seventeen: no shop is open at five

bool is_whole_between(double number, int least, int most) {
  return number == std::floor(number) && number >= least && number <= most;
}

// Of a clock of twelve hours where the words say which half of the day, or where the hour is one at
// which shops are closed (slot loose). Nothing for what is no time of the day.
std::optional<int> clock_minute(const Meaning& said) {
  const double hour_said = said.number("hour"), minute = said.number("minute");
  if (!is_whole_between(hour_said, 0, 23) || !is_whole_between(minute, -59, 59))
    return std::nullopt;
  int hour = static_cast<int>(hour_said);
  const bool after_noon = said.has("part") ? said.number("part") >= noon_minute
                                           : said.has("loose") && hour < first_open_hour;
  if (after_noon && hour < noon) hour += noon;
  if (said.has("part") && !after_noon && hour == noon) hour = 0;
  const int in_day = hour * minutes_of_hour + static_cast<int>(minute);
  return in_day >= 0 && in_day < minutes_of_day ? std::optional(in_day) : std::nullopt;
}

}  // namespace

// Slots: weekday (1 is Monday); hour and minute of a clock; part, the usual minute of a part of the
// day.
bool interpret_time(Reading& reading, const Meaning& statement) {
  const double weekday = statement.number("weekday", usual_day);
  if (!is_whole_between(weekday, 1, static_cast<int>(names_of(plan::Weekday{}).size())))
    return false;
  const std::optional<int> in_day =
      statement.has("hour")
          ? clock_minute(statement)
          : std::optional(static_cast<int>(statement.number("part", noon_minute)));
  if (!in_day) return false;
  const plan::StoreTime time{(static_cast<int>(weekday) - 1) * minutes_of_day + *in_day};
  reading.add(plan::RequirementKind::time, statement.span).object = plan::text_of(time);
  return true;
}

}  // namespace marketgen::intake
