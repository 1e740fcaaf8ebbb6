// What a policy decided, beside the truth: which module was first wrong, and what is kept of it.
#include <gtest/gtest.h>

#include "evaluation/decision_judge.h"
#include "evaluation/decision_recorder.h"
#include "evaluation/decisions_page.h"
#include "evaluation/modules_table.h"
#include "evaluation/run_recorded.h"
#include "io/file.h"
#include "io/json.h"
#include "support/pool_ground.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

using agent::DecisionKind;
using evaluation::DecisionRecord;
using evaluation::PolicyModule;
using evaluation::TruthThere;

const TruthThere right{"tea", 0.005, 0.005};

DecisionRecord decision(DecisionKind kind, double time_s, std::string outcome = "None") {
  DecisionRecord made;
  made.kind = kind;
  made.time_s = time_s;
  made.goal = kind == DecisionKind::look || kind == DecisionKind::stop ? -1 : 0;
  made.sku = "tea";
  made.outcome = std::move(outcome);
  return made;
}

DecisionRecord read_as(std::vector<std::string> readings) {
  DecisionRecord made = decision(DecisionKind::read, 0);
  made.readings = std::move(readings);
  return made;
}

DecisionRecord look(bool finds) {
  DecisionRecord made = decision(DecisionKind::look, 1);
  if (finds) made.found.push_back({0, "tea", {}, 0.8, right});
  return made;
}

DecisionRecord reach(double time_s, const TruthThere& truth, std::string outcome = "None") {
  DecisionRecord made = decision(DecisionKind::reach, time_s, std::move(outcome));
  made.truth = truth;
  return made;
}

DecisionRecord hold(double time_s, std::string outcome = "None", std::string sku = "tea") {
  DecisionRecord made = decision(DecisionKind::hold, time_s, std::move(outcome));
  made.truth = TruthThere{std::move(sku), 0, {}};
  return made;
}

// Of one packet of tea that was asked for.
evaluation::JudgedGoal judged(const std::vector<DecisionRecord>& decisions, int reached = 0) {
  episodes::EpisodeResult result;
  episodes::add_outcome({{{"tea", 1, reached}}, 1, reached}, result);
  result.simulated_s = 60;
  const auto goals = evaluation::judged_goals(decisions, result);
  EXPECT_EQ(goals.size(), 1U);
  return goals.front();
}

struct Story {
  const char* name;
  std::vector<DecisionRecord> decisions;
  PolicyModule module;
  double time_s;
};

void PrintTo(const Story& story, std::ostream* out) {
  *out << story.name;
}

class FirstWrong : public testing::TestWithParam<Story> {};

TEST_P(FirstWrong, IsNamedWithItsTime) {
  const evaluation::JudgedGoal goal = judged(GetParam().decisions);
  EXPECT_EQ(name_of(goal.module), name_of(GetParam().module)) << goal.why;
  EXPECT_EQ(goal.time_s, GetParam().time_s);
  EXPECT_FALSE(goal.why.empty());
}

const DecisionRecord timeout = decision(DecisionKind::stop, 50, "Timeout");
const DecisionRecord gives_up = decision(DecisionKind::stop, 40, "NotFound");

INSTANTIATE_TEST_SUITE_P(
    ,
    FirstWrong,
    testing::Values(
        Story{"not_understood", {read_as({}), gives_up}, PolicyModule::language, 0},
        Story{"misread", {read_as({"coffee"}), look(false), gives_up}, PolicyModule::language, 0},
        Story{"never_seen", {read_as({"tea"}), look(false), gives_up}, PolicyModule::search, 40},
        Story{"other_product",
              {look(true), reach(5, {"coffee", 0.004, 0.4}), hold(6, "None", "coffee"), gives_up},
              PolicyModule::target,
              5},
        Story{"off", {look(true), reach(5, {"tea", 0.05, 0.05}), gives_up}, PolicyModule::pose, 5},
        Story{
            "no_grasp", {look(true), reach(5, right, "NoGrasp"), gives_up}, PolicyModule::grasp, 5},
        Story{"empty_hand",
              {look(true), reach(5, right), hold(6, "Missed", ""), gives_up},
              PolicyModule::grasp,
              6},
        Story{"wrong_in_hand",
              {look(true), reach(5, right), hold(6, "None", "coffee"), gives_up},
              PolicyModule::target,
              6},
        Story{"no_way", {look(true), reach(5, right, "NoPath"), gives_up}, PolicyModule::motion, 5},
        Story{"slipped",
              {look(true), reach(5, right), hold(6), decision(DecisionKind::place, 8, "Slipped")},
              PolicyModule::carry,
              8},
        Story{"no_place",
              {look(true), reach(5, right), hold(6), decision(DecisionKind::place, 8, "NoPath")},
              PolicyModule::place,
              8},
        Story{"fell_over",
              {look(true), reach(5, right), hold(6), decision(DecisionKind::place, 8), timeout},
              PolicyModule::place,
              8},
        Story{"late", {look(true), timeout}, PolicyModule::time, 50},
        // The hand comes back empty, takes hold the next time, and loses it: that counts.
        Story{"put_right",
              {look(true),
               reach(5, right),
               hold(6, "Missed", ""),
               reach(9, right),
               hold(10),
               decision(DecisionKind::place, 12, "Slipped")},
              PolicyModule::carry,
              12},
        // What was wrong first, of two that were never put right.
        Story{"two_wrong",
              {look(true), reach(5, right, "NoPath"), reach(9, right, "NoGrasp"), gives_up},
              PolicyModule::motion,
              5}),
    [](const auto& story) { return std::string(story.param.name); });

TEST(DecisionJudge, NothingIsWrongOfAGoalThatWasReached) {
  const auto goal = judged({look(true), reach(5, right, "NoPath")}, 1);
  EXPECT_EQ(goal.module, PolicyModule::done);
  EXPECT_TRUE(goal.why.empty());
}

TEST(DecisionJudge, APolicyThatFailedIsNamedSo) {
  episodes::EpisodeResult result;
  episodes::add_outcome({{{"tea", 1, 0}}, 1, 0}, result);
  result.detail = "episode.policy_failed at policy: out of tea";
  EXPECT_EQ(evaluation::judged_goals({}, result).front().module, PolicyModule::error);
  EXPECT_EQ(evaluation::judged_goals({look(true)}, result).front().module, PolicyModule::error);
  EXPECT_EQ(evaluation::judged_goals({look(false)}, result).front().module, PolicyModule::search)
      << "it was not seen before that";
}

// Another's goal does not count for this one.
TEST(DecisionJudge, GoalsAreJudgedApart) {
  episodes::EpisodeResult result;
  episodes::add_outcome({{{"coffee", 1, 0}, {"tea", 1, 0}}, 2, 0}, result);
  DecisionRecord other = reach(5, right, "NoPath");
  other.goal = 1;
  const auto goals = evaluation::judged_goals({other}, result);
  ASSERT_EQ(goals.size(), 2U);
  EXPECT_EQ(goals[0].module, PolicyModule::search);
  EXPECT_EQ(goals[1].module, PolicyModule::motion);
}

// `classical` at a counter: it acts as it does unrecorded, and what is kept says what became of it.
TEST(DecisionRecorder, KeepsWhatClassicalDecides) {
  const ScratchFolder scratch;
  environments::Arena& arena = pool_ground(episodes::Track::checkout)->arena();
  const episodes::EpisodeSpec spec = pool_episode(episodes::Track::checkout, 3);
  const auto plain = evaluation::run_recorded(arena, spec, "classical", {}, {});
  ASSERT_TRUE(plain.ok()) << to_string(plain.error());
  const auto result =
      evaluation::run_recorded(arena, spec, "classical", {}, {"", scratch.path().string()});
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->state_hash, plain->state_hash);

  const auto kept = evaluation::read_decisions(scratch.path(), spec.id);
  ASSERT_TRUE(kept.ok()) << to_string(kept.error());
  EXPECT_EQ(kept->episode_hash, episodes::episode_hash(arena.header(), spec));
  ASSERT_EQ(kept->goals.size(), result->goals.size());
  for (std::size_t i = 0; i < kept->goals.size(); ++i) {
    EXPECT_EQ(kept->goals[i].sku, result->goals[i].sku);
    EXPECT_EQ(kept->goals[i].module == PolicyModule::done,
              result->goals[i].reached >= result->goals[i].count);
  }
  std::size_t looks = 0, pictures = 0, right_finds = 0, finds = 0;
  for (const DecisionRecord& each : kept->decisions) {
    if (each.kind != DecisionKind::look) continue;
    ++looks;
    pictures += each.pictures.size();
    for (const evaluation::FoundRecord& found : each.found) {
      ++finds;
      if (found.truth.own_m && *found.truth.own_m < evaluation::right_place_m) ++right_finds;
    }
  }
  EXPECT_GE(looks, 1U);
  EXPECT_EQ(pictures, 2 * looks);
  EXPECT_GE(finds, 1U);
  EXPECT_GT(2 * right_finds, finds);  // of a simple basket most is found where it lies
  const auto page = io::read_file(scratch.path() / "decisions" / (spec.id + ".html"));
  ASSERT_TRUE(page.ok());
  EXPECT_NE(page->find("data:image/jpeg;base64,"), std::string::npos);
  EXPECT_EQ(page->find("src=\"http"), std::string::npos) << "it loads nothing";
}

TEST(DecisionRecorder, APolicyThatTellsNothingIsJudgedByItsResult) {
  const ScratchFolder scratch;
  const episodes::EpisodeSpec spec = pool_episode(episodes::Track::checkout, 3);
  const auto result = evaluation::run_recorded(pool_ground(episodes::Track::checkout)->arena(),
                                               spec,
                                               "stop",
                                               {},
                                               {"", scratch.path().string()});
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  const auto kept = evaluation::read_decisions(scratch.path(), spec.id);
  ASSERT_TRUE(kept.ok()) << to_string(kept.error());
  EXPECT_TRUE(kept->decisions.empty());
  for (const evaluation::JudgedGoal& goal : kept->goals)
    EXPECT_EQ(goal.module, PolicyModule::unknown);
}

TEST(DecisionsPage, EscapesWhatFilesSay) {
  evaluation::EpisodeDecisions decisions;
  decisions.episode = "a";
  decisions.instruction = "take <script>";
  decisions.decisions.push_back(read_as({"<b>tea</b>"}));
  const std::string page = evaluation::decisions_html(decisions);
  EXPECT_EQ(page.find("<script>"), std::string::npos);
  EXPECT_EQ(page.find("<b>tea"), std::string::npos);
}

// Two episodes of two goals each, of which one was misread and one slipped.
TEST(ModulesTable, CountsGoalsByWhatWasWrongFirst) {
  const ScratchFolder scratch;
  evaluation::FinishedRun run;
  run.folder = scratch.path();
  run.record.policy = "classical";
  run.record.version = "1.0";
  for (int i = 0; i < 2; ++i) {
    episodes::EpisodeResult result;
    result.episode = "episode-" + std::to_string(i);
    result.episode_hash = "hash";
    result.store = "store-" + std::to_string(i);
    result.policy = "classical";
    episodes::add_outcome({{{"tea", 1, 1}, {"milk", 1, 0}}, 2, 1}, result);
    run.record.episodes.push_back({result.episode, "hash", episodes::Track::checkout});
    run.results.push_back(result);
    evaluation::EpisodeDecisions kept;
    kept.episode = result.episode, kept.episode_hash = "hash", kept.policy = "classical";
    kept.goals = {{"tea", 1, 1, PolicyModule::done, "", 0},
                  {"milk", 1, 0, i == 0 ? PolicyModule::language : PolicyModule::carry, "", 9}};
    ASSERT_TRUE(evaluation::write_decisions(scratch.path(), kept).ok());
  }
  const auto table = evaluation::modules_table({run});
  ASSERT_TRUE(table.ok()) << to_string(table.error());
  ASSERT_EQ(table->rows.size(), 1U);
  const evaluation::ModulesRow& row = table->rows.front();
  EXPECT_EQ(row.goals, 4);
  EXPECT_EQ(row.missed, 2);
  ASSERT_EQ(row.modules.size(), 2U);
  EXPECT_EQ(row.modules[0].module, PolicyModule::language);
  EXPECT_DOUBLE_EQ(row.modules[0].share.value, 0.25);
  EXPECT_EQ(row.modules[1].module, PolicyModule::carry);
  const evaluation::TextTable text = evaluation::text_of(*table);
  EXPECT_EQ(text.rows.front().size(), text.columns.size());

  run.results[1].episode_hash = "other";
  const auto changed = evaluation::modules_table({run});
  ASSERT_FALSE(changed.ok());
  EXPECT_EQ(changed.error().code, "results.changed");
  run.results[1].episode_hash = "hash";
  std::filesystem::remove_all(scratch.path() / "decisions");
  const auto none = evaluation::modules_table({run});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().code, "results.no_decisions");
}

}  // namespace
}  // namespace marketgen
