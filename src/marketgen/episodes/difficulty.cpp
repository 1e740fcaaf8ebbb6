#include "episodes/difficulty.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "episodes/difficulty_rows.h"
#include "episodes/named_dials.h"

namespace marketgen::episodes {
namespace {

Error contradiction(const std::string& called, std::string_view field, std::string what) {
  return {"catalog.bad_row", fmt::format("{}:/{}", called, field), std::move(what)};
}

Result<void> check_difficulty(const Difficulty& read, const std::string& called) {
  for (const auto& [name, count] : {std::pair{"goals", read.goals}, {"others", read.others}})
    if (count.max < count.min)
      return contradiction(
          called,
          fmt::format("{}/max", name),
          fmt::format("is {}, less than min, {}: give the larger one", count.max, count.min));
  if (read.goals.min < 1 || read.goals.max > max_goal_kinds)
    return contradiction(called,
                         "goals",
                         fmt::format("is {} to {}: a task asks for 1 to {} kinds of goods",
                                     read.goals.min,
                                     read.goals.max,
                                     max_goal_kinds));
  for (std::size_t i = 0; i < read.levels.size(); ++i)
    if (read.levels[i].high_m < read.levels[i].low_m)
      return contradiction(called,
                           fmt::format("levels/{}/high_m", i),
                           fmt::format("is {}, less than low_m, {}: give the larger one",
                                       read.levels[i].high_m,
                                       read.levels[i].low_m));
  return {};
}

}  // namespace

bool Difficulty::has_level(double height_m) const {
  return levels.empty() || std::ranges::any_of(levels, [&](const LevelBand& band) {
           return height_m >= band.low_m && height_m <= band.high_m;
         });
}

std::string Difficulty::kind_of(const std::string& kind) const {
  return is_standard() ? kind : kind + "/" + name;
}

std::optional<std::string> Difficulty::told() const {
  return is_standard() ? std::nullopt : std::optional(name);
}

Result<Difficulty> load_difficulty(const std::filesystem::path& data, const std::string& asked) {
  return load_named_dials<Difficulty>(
      data, {"difficulty", difficulty_rows}, asked, check_difficulty);
}

}  // namespace marketgen::episodes
