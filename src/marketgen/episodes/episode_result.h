// What became of an episode: market-result/1.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agent/model_use.h"
#include "agent/part_use.h"
#include "base/fields.h"
#include "episodes/failure_code.h"
#include "episodes/goal_judge.h"
#include "episodes/side_effects.h"

namespace marketgen::episodes {

// What kept an agent from reading what it must not know. own: it is a policy of the program's own,
// whose code is known. none: nothing did. landlock: it acted in a process that opens no file of the
// episodes and stores, nor another process (landlock(7)).
enum class PolicyIsolation { own, none, landlock };
constexpr std::array<std::string_view, 3> names_of(PolicyIsolation) {
  return {"own", "none", "landlock"};
}

struct EpisodeResult {
  std::string schema = "market-result/1";
  std::string episode, episode_hash, store, scene_hash, policy;
  std::string realism = "ideal";
  std::optional<int> repetition = {};  // the first when there is none
  PolicyIsolation isolation = PolicyIsolation::own;
  std::vector<GoalOutcome> goals;
  int hits = 0, asked = 0;
  double success_partial = 0;
  bool success_strict = false, success_clean = false, is_void = false;
  FailureCode failure = FailureCode::none;
  std::string error;   // of an episode that could not be run: the error's code
  std::string detail;  // of an episode that broke off, or could not be run: the error
  SideEffects side_effects;
  double path_m = 0, shortest_m = 0, spl = 0, spl_subset = 0;
  int steps = 0;
  double simulated_s = 0, wall_s = 0;
  std::string state_hash;
  std::optional<agent::ModelUse> model;
  std::optional<agent::PartsUse> parts;

  static constexpr auto fields = field_list(
      field("schema", &EpisodeResult::schema, "schema tag", constant("market-result/1")),
      field("episode", &EpisodeResult::episode, "its id", identifier()),
      field("episode_hash",
            &EpisodeResult::episode_hash,
            "over the episode as it was run; a result is gone on with only if it is the same"),
      field("store", &EpisodeResult::store, "the store's name"),
      field("scene_hash", &EpisodeResult::scene_hash, "of the store's scene: which store it is"),
      field("policy", &EpisodeResult::policy, "who acted"),
      field("realism",
            &EpisodeResult::realism,
            "what stood between the world and the robot: a row's name, or own- and a hash"),
      field("repetition",
            &EpisodeResult::repetition,
            "which run of the episode with draws of its own; the first when absent",
            range(2, 1000)),
      field("isolation",
            &EpisodeResult::isolation,
            "what kept it from reading what it must not know; own: it is the program's own"),
      field("goals", &EpisodeResult::goals, "one by one"),
      field(
          "hits", &EpisodeResult::hits, "goals that count: in place, less wrong ones", required()),
      field("asked", &EpisodeResult::asked, "goals that there are", required()),
      field("success_partial", &EpisodeResult::success_partial, "hits of asked", range(0, 1)),
      field("success_strict", &EpisodeResult::success_strict, "all goals"),
      field("success_clean",
            &EpisodeResult::success_clean,
            "strict, and within the limits on side effects"),
      field("void", &EpisodeResult::is_void, "the basket was tilted too far, or somebody was hurt"),
      field("failure", &EpisodeResult::failure, "what kept the agent from its goals"),
      field("error",
            &EpisodeResult::error,
            "code of the error for which the episode could not be run: it counts in no share"),
      field("detail",
            &EpisodeResult::detail,
            "the error of an episode that broke off or could not be run"),
      field("side_effects", &EpisodeResult::side_effects, "the ledger"),
      field("path_m", &EpisodeResult::path_m, "driven by the robot's base"),
      field("shortest_m",
            &EpisodeResult::shortest_m,
            "shortest way past all goals; 0 when there is none"),
      field("spl", &EpisodeResult::spl, "success_partial by shortest_m over path_m", range(0, 1)),
      field("spl_subset",
            &EpisodeResult::spl_subset,
            "the same with the shortest way past the goals that were reached",
            range(0, 1)),
      field("steps", &EpisodeResult::steps, "of control"),
      field("simulated_s", &EpisodeResult::simulated_s, "simulated seconds"),
      field("wall_s", &EpisodeResult::wall_s, "seconds that it took"),
      field("state_hash", &EpisodeResult::state_hash, "of the physics at the end"),
      field("model",
            &EpisodeResult::model,
            "what a policy asked of a model outside of the program, and what came of it"),
      field("parts",
            &EpisodeResult::parts,
            "what a policy asked of parts that run in servers of their own, and what came of it"));
};

// Sets goals, shares and verdicts; the side effects are there already, without `wrong_items`.
void add_outcome(const EpisodeOutcome& outcome, EpisodeResult& result);

}  // namespace marketgen::episodes
