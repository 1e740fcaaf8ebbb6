// What a policy decided in an episode, beside what was true: market-decisions/1, one file an
// episode, decisions/ID.json.gz of a folder of results (eval --record-decisions).
//
// Places are in the frame of the track: of the station at a counter, of the store in an aisle.
// Metres.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agent/decision.h"
#include "base/fields.h"
#include "base/result.h"

namespace marketgen::evaluation {

// The parts of a policy, in the order in which a goal goes through them. done: nothing was wrong.
//
// language  words were read as other products
// search    pictures showed it nowhere
// target    another product was taken for it
// pose      it was taken to lie or stand elsewhere than it does
// grasp     there was no grasp, or the hand shut and did not hold it
// motion    no way led to where the hand was to go, or something was met on it
// carry     it was lost on its way
// place     there was no way to put it down, or it was not in place at the end
// time      the time was over before anything was wrong
// error     the policy failed
// unknown   none of this can be told
enum class PolicyModule {
  done,
  language,
  search,
  target,
  pose,
  grasp,
  motion,
  carry,
  place,
  time,
  error,
  unknown
};
constexpr std::array<std::string_view, 12> names_of(PolicyModule) {
  return {"done",
          "language",
          "search",
          "target",
          "pose",
          "grasp",
          "motion",
          "carry",
          "place",
          "time",
          "error",
          "unknown"};
}

// What is truly where the policy takes a product to be.
struct TruthThere {
  std::string sku;              // of what is nearest, within near_truth_m; empty: nothing is
  double off_m = 0;             // that its middle is off
  std::optional<double> own_m;  // that the nearest of the product itself is off, wherever it is
  static constexpr auto fields =
      field_list(field("sku", &TruthThere::sku, "what is nearest; empty: nothing is near"),
                 field("off_m", &TruthThere::off_m, "how far off its middle is"),
                 field("own_m",
                       &TruthThere::own_m,
                       "how far off the nearest of the product itself is; absent: there is none"));
};
constexpr double near_truth_m = 0.15;

struct FoundRecord {
  int goal = 0;
  std::string sku;
  std::array<double, 3> middle_m{};
  double score = 0;
  TruthThere truth;
  static constexpr auto fields =
      field_list(field("goal", &FoundRecord::goal, "number of the task's goal"),
                 field("sku", &FoundRecord::sku, "product that it is taken to be"),
                 field("middle_m", &FoundRecord::middle_m, "middle of its bounds"),
                 field("score", &FoundRecord::score, "of the policy, 0..1"),
                 field("truth", &FoundRecord::truth, "what is there"));
};

struct PictureRecord {
  std::string camera, jpeg;
  std::vector<agent::PictureMark> marks;
  static constexpr auto fields =
      field_list(field("camera", &PictureRecord::camera, "of the robot"),
                 field("jpeg", &PictureRecord::jpeg, "in base64", at_most_bytes(2'000'000)),
                 field("marks", &PictureRecord::marks, "masks, and what was found"));
};

struct DecisionRecord {
  agent::DecisionKind kind = agent::DecisionKind::look;
  double time_s = 0, computed_s = 0;
  int goal = -1;
  std::string sku, outcome;
  std::optional<std::array<double, 3>> middle_m;
  std::optional<TruthThere> truth;
  std::vector<std::string> readings;
  std::vector<FoundRecord> found;
  std::vector<agent::TriedGrasp> tried;
  std::vector<PictureRecord> pictures;
  static constexpr auto fields = field_list(
      field("kind", &DecisionRecord::kind, "what was decided"),
      field("time_s", &DecisionRecord::time_s, "simulated seconds"),
      field("computed_s",
            &DecisionRecord::computed_s,
            "wall seconds that it took: alone of all fields, not the same twice"),
      field("goal", &DecisionRecord::goal, "number of the task's goal; -1: none"),
      field("sku", &DecisionRecord::sku, "product that is meant"),
      field("outcome", &DecisionRecord::outcome, "None, or a failure code"),
      field("middle_m", &DecisionRecord::middle_m, "of the product, as the policy takes it"),
      field("truth",
            &DecisionRecord::truth,
            "of a reach what is there, of a hold what is in the hand"),
      field("readings", &DecisionRecord::readings, "products that words may mean"),
      field("found", &DecisionRecord::found, "goals that pictures show"),
      field("tried", &DecisionRecord::tried, "grasps that were thought of"),
      field("pictures", &DecisionRecord::pictures, "that were looked at, half their size"));
};

struct JudgedGoal {
  std::string sku;
  int count = 0, reached = 0;
  PolicyModule module = PolicyModule::done;
  std::string why;
  double time_s = 0;
  static constexpr auto fields =
      field_list(field("sku", &JudgedGoal::sku, "product that is asked for"),
                 field("count", &JudgedGoal::count, "how many"),
                 field("reached", &JudgedGoal::reached, "how many are in place"),
                 field("module", &JudgedGoal::module, "that was wrong first, and not put right"),
                 field("why", &JudgedGoal::why, "in words"),
                 field("time_s", &JudgedGoal::time_s, "when"));
};

struct EpisodeDecisions {
  std::string schema = "market-decisions/1";
  std::string episode, episode_hash, policy, realism, instruction;
  std::vector<JudgedGoal> goals;
  std::vector<DecisionRecord> decisions;
  static constexpr auto fields = field_list(
      field("schema", &EpisodeDecisions::schema, "schema tag", constant("market-decisions/1")),
      field("episode", &EpisodeDecisions::episode, "its id", identifier()),
      field("episode_hash", &EpisodeDecisions::episode_hash, "over all that decides it"),
      field("policy", &EpisodeDecisions::policy, "who acted"),
      field("realism", &EpisodeDecisions::realism, "what stood between the world and the robot"),
      field("instruction", &EpisodeDecisions::instruction, "the task in words"),
      field("goals", &EpisodeDecisions::goals, "one by one, with what was wrong"),
      field("decisions", &EpisodeDecisions::decisions, "in their order"));
};

// decisions/ID.json.gz of a folder of results.
std::filesystem::path decisions_file(const std::filesystem::path& results,
                                     const std::string& episode);
// Error results.no_decisions when there is none, with what makes one; those of read_json.
Result<EpisodeDecisions> read_decisions(const std::filesystem::path& results,
                                        const std::string& episode);

}  // namespace marketgen::evaluation
