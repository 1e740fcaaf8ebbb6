#include "plan/store_time.h"

#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/fields.h"
#include "base/text.h"

namespace marketgen::plan {
namespace {

constexpr std::array<std::string_view, 7> full_days{
    "monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"};

// "sat" or "saturday", in small letters.
std::optional<int> day_called(std::string_view word) {
  for (std::size_t day = 0; day < full_days.size(); ++day)
    if (word == full_days[day] || word == full_days[day].substr(0, 3)) return static_cast<int>(day);
  return std::nullopt;
}

// One or two digits.
std::optional<int> two_digits(std::string_view text) {
  int number = -1;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = fault == std::errc{} && end == text.data() + text.size();
  return whole && number >= 0 && text.size() <= 2 ? std::optional(number) : std::nullopt;
}

// Minutes since midnight of "17:30", whatever the hour is.
struct Clock {
  int hour = 0, minute = 0;
};
std::optional<Clock> clock_of(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::optional<int> hour = two_digits(text.substr(0, colon)),
                           minute = two_digits(text.substr(colon + 1));
  const bool has_both = hour && minute && text.size() == colon + 3;
  return has_both ? std::optional(Clock{*hour, *minute}) : std::nullopt;
}

}  // namespace

Result<StoreTime> parse_store_time(std::string_view text, std::string code, std::string where) {
  const auto refuse = [&](std::string why) {
    return Error{std::move(code), std::move(where), std::move(why)};
  };
  const std::string shown(text.substr(0, 80)), words = lower_ascii(trimmed(text));
  const std::size_t blank = words.find_first_of(" \t");
  const std::string_view all = words, name = all.substr(0, blank),
                         clock = blank == std::string::npos ? "" : trimmed(all.substr(blank));
  const std::optional<Clock> at = clock_of(clock);
  if (!at)
    return refuse(fmt::format(
        "\"{}\" is not a time; write a weekday and an hour, as in \"Sat 17:30\"", shown));
  const std::optional<int> day = day_called(name);
  if (!day)
    return refuse(
        fmt::format("\"{}\" begins with no weekday{}; write Mon, Tue, Wed, Thu, Fri, Sat "
                    "or Sun, as in \"Sat 17:30\"",
                    shown,
                    did_you_mean(name, full_days)));
  if (at->hour > 23 || at->minute > 59)
    return refuse(fmt::format(
        "\"{}\" is no time of the day; hours are 0 to 23, minutes 0 to 59, as in \"Sat 17:30\"",
        shown));
  return StoreTime{*day * minutes_of_day + at->hour * minutes_of_hour + at->minute};
}

std::string text_of(StoreTime time) {
  const int in_day = time.minute % minutes_of_day;
  return fmt::format("{} {:02}:{:02}",
                     name_of(static_cast<Weekday>(time.minute / minutes_of_day)),
                     in_day / minutes_of_hour,
                     in_day % minutes_of_hour);
}

}  // namespace marketgen::plan
