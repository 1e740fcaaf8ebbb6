// What of an episode a policy from outside may know: market-task/1.
//
// It is all that leaves the process that simulates, beside observations. Made of what is named
// here, never of an episode with something taken away: what a later episode has besides (poses,
// seeds, a witness, ids and hashes by which a store can be found) does not get out unnoticed. With
// instructions in words it has no SKU of a goal.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "episodes/told_goals.h"

namespace marketgen::environments {

struct ToldTask {
  std::string schema = "market-task/1";
  episodes::Track track = episodes::Track::checkout;
  std::optional<std::string> station;
  std::string robot, tools;
  std::vector<std::string> cameras;
  std::string instruction;
  std::vector<episodes::ToldGoal> goals;
  std::vector<episodes::ToldCategory> categories;
  double limit_s = 0;

  static constexpr auto fields = field_list(
      field("schema", &ToldTask::schema, "schema tag", constant("market-task/1")),
      field("track", &ToldTask::track, "what kind of task"),
      field("station", &ToldTask::station, "checkout: as of the episode"),
      field("robot", &ToldTask::robot, "row in data/robots"),
      field("tools",
            &ToldTask::tools,
            "a tool set of market-checkout/1 or market-aisle/1; empty: the first"),
      field("cameras", &ToldTask::cameras, "that the agent has"),
      field("instruction", &ToldTask::instruction, "what is to be done"),
      field("goals", &ToldTask::goals, "what the instruction names"),
      field("categories", &ToldTask::categories, "aisle: where products of these stand on average"),
      field("limit_s", &ToldTask::limit_s, "simulated seconds"));
};

ToldTask told_task(const episodes::EpisodeSpec& spec);

}  // namespace marketgen::environments
