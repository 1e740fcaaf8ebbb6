#include "episodes/tool_sets.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "episodes/source_keys.h"

namespace marketgen::episodes {

Result<void> check_tool_sets(const ToolSets& sets,
                             const std::vector<robots::SourceRow>& sources,
                             const std::string& file) {
  if (sets.empty()) return Error{"catalog.bad_row", file + ":/tool_sets", "expected one or more"};
  for (std::size_t i = 0; i < sets.size(); ++i)
    MARKETGEN_CHECK(
        check_source_keys(sources, sets[i].source, file, fmt::format("/tool_sets/{}", i)));
  return {};
}

Result<std::size_t> tool_set_named(const ToolSets& sets,
                                   const std::string& id,
                                   const std::string& file) {
  if (id.empty()) return 0;
  const auto chosen = std::ranges::find(sets, id, &ToolSetRow::id);
  if (chosen != sets.end()) return static_cast<std::size_t>(chosen - sets.begin());
  const std::vector<std::string> ids = ids_of(sets);
  const std::vector<std::string_view> known(ids.begin(), ids.end());
  return Error{"robot.unknown",
               id,
               fmt::format("{} has no such tools{}; there are: {}",
                           file,
                           did_you_mean(id, known),
                           fmt::join(known, ", "))};
}

Result<void> check_carried(const ToolSets& sets,
                           std::size_t carried,
                           const std::string& asked,
                           const std::string& where) {
  const std::string& wanted = asked.empty() ? sets.front().id : asked;
  const std::string& there = sets[carried].id;
  if (wanted == there) return {};
  return Error{"robot.unknown",
               where,
               fmt::format("the robot carries the tools \"{}\", the episode is for \"{}\": open "
                           "the store with those",
                           there,
                           wanted)};
}

robots::RobotTools robot_tools(const ToolSetRow& set) {
  robots::RobotTools tools;
  for (const ToolChoiceRow& tool : set.tools)
    tools.emplace(tool.slot, tool.row);
  return tools;
}

std::vector<std::string> ids_of(const ToolSets& sets) {
  std::vector<std::string> ids;
  for (const ToolSetRow& set : sets)
    ids.push_back(set.id);
  return ids;
}

}  // namespace marketgen::episodes
