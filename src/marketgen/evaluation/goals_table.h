// How much of what stores offer tasks may ask for, track by track and tool by tool, and why not the
// rest: market-goals/1.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/episode_spec.h"
#include "evaluation/text_table.h"
#include "store/open_stores.h"

namespace marketgen::evaluation {

// A track with one of its robot's tool sets, and where goals stand.
struct GoalVariant {
  episodes::Track track = episodes::Track::checkout;
  std::string tools = {};
  std::optional<episodes::Doors> doors = {};
  std::vector<episodes::EpisodeExclusion> left_out = {};
  static constexpr auto fields = field_list(
      field("track", &GoalVariant::track, "what kind of task"),
      field("tools", &GoalVariant::tools, "tool set; empty: there is one"),
      field("doors", &GoalVariant::doors, "what its goals stand behind; none when absent"),
      field("left_out", &GoalVariant::left_out, "products, by why not, most first"));
};

// Products of a kind; a product that two stores offer counts twice.
struct GoalGroup {
  std::string name = {};
  int on_offer = 0;
  std::vector<int> goals = {};
  int any = 0;
  static constexpr auto fields =
      field_list(field("name", &GoalGroup::name, "category, shape or kind of fixture"),
                 field("on_offer", &GoalGroup::on_offer, "products in the stores"),
                 field("goals", &GoalGroup::goals, "that may be asked for, variant by variant"),
                 field("any", &GoalGroup::any, "that may be asked for in one variant or more"));
};

struct GoalsTable {
  std::string schema = "market-goals/1";
  std::string version = {};
  std::vector<std::string> stores = {};
  std::vector<GoalVariant> variants = {};
  GoalGroup all = {};
  std::vector<GoalGroup> categories = {}, shapes = {}, fixtures = {};
  static constexpr auto fields = field_list(
      field("schema", &GoalsTable::schema, "schema tag", constant("market-goals/1")),
      field("version", &GoalsTable::version, "of the program"),
      field("stores", &GoalsTable::stores, "their names"),
      field("variants", &GoalsTable::variants, "tracks and tools"),
      field("all", &GoalsTable::all, "all that is on offer; it has no name"),
      field("categories", &GoalsTable::categories, "by category"),
      field("shapes", &GoalsTable::shapes, "by shape"),
      field("fixtures",
            &GoalsTable::fixtures,
            "by kind of fixture: products that stand on it, and those that are taken off it"));
};

// Of episodes that are drawn by themselves (Split::planned): where products stand, and whether the
// tool holds them. A plan past an item's neighbours may still not be found. Products that no study
// of grasps knows are tried in physics. Errors: those of EnvironmentEntry::sampler and
// StoreSampler::goal_chance.
Result<GoalsTable> goals_table(const store::OpenedStores& opened,
                               const std::filesystem::path& data);

// Shares in percent, with what is left out, and why, as notes.
TextTable text_of(const GoalsTable& table);

}  // namespace marketgen::evaluation
