// The tool sets between which the episodes of a station choose.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/station_rows.h"
#include "robots/robot.h"

namespace marketgen::episodes {

// What the robot may carry instead of its row's own tools.
struct ToolSetRow {
  std::string id, picks_with;
  std::vector<ToolChoiceRow> tools;
  std::string source;
  static constexpr auto fields =
      field_list(field("id", &ToolSetRow::id, "as episodes name it", identifier()),
                 field("picks_with",
                       &ToolSetRow::picks_with,
                       "row of the tool that fetches what is asked for",
                       required()),
                 field("tools", &ToolSetRow::tools, "instead of the robot's own", at_most_items(8)),
                 field("source", &ToolSetRow::source, "keys of the sources, by blanks"));
};
using ToolSets = std::vector<ToolSetRow>;

// Error catalog.bad_row at "FILE:/tool_sets...": there is none, or one has a source without a row.
Result<void> check_tool_sets(const ToolSets& sets,
                             const std::vector<robots::SourceRow>& sources,
                             const std::string& file);

// Number of a set; the first when `id` is empty. Error robot.unknown with those that there are.
Result<std::size_t> tool_set_named(const ToolSets& sets,
                                   const std::string& id,
                                   const std::string& file);

// Error robot.unknown, at `where`: the robot carries another set than an episode asks for (empty:
// the first).
Result<void> check_carried(const ToolSets& sets,
                           std::size_t carried,
                           const std::string& asked,
                           const std::string& where);

robots::RobotTools robot_tools(const ToolSetRow& set);

std::vector<std::string> ids_of(const ToolSets& sets);

}  // namespace marketgen::episodes
