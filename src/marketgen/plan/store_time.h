// The time at which a store is shown: a weekday and an hour of the day, "Sat 17:30".
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "base/result.h"

namespace marketgen::plan {

enum class Weekday { Mon, Tue, Wed, Thu, Fri, Sat, Sun };
constexpr std::array<std::string_view, 7> names_of(Weekday) {
  return {"Mon", "Tue", "Wed", "Thu", "Fri", "Sat", "Sun"};
}

constexpr int minutes_of_hour = 60, minutes_of_day = 24 * minutes_of_hour,
              minutes_of_week = 7 * minutes_of_day;

// A minute of the week, Monday 0:00 being 0.
struct StoreTime {
  int minute = 0;  // 0 .. minutes_of_week - 1
};

// "Sat 17:30", "saturday 9:05". Error `code` at `where`, with what to write.
Result<StoreTime> parse_store_time(std::string_view text, std::string code, std::string where);

// As plans have it: "Sat 09:05".
std::string text_of(StoreTime time);

}  // namespace marketgen::plan
