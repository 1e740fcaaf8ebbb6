// Workers that hang, crash or never begin: the run goes on, and says what became of their episodes.
// The workers are shell scripts that speak as evaluation/episode_worker.h says.
#include "evaluation/worker_process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "drawn_checkout.h"
#include "evaluation/evaluate.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

std::vector<std::string> script(const std::string& text) {
  return {"/bin/sh", "-c", text};
}

EpisodeFile three_named() {
  EpisodeFile file;
  for (const char* id : {"a", "b", "c"}) {
    EpisodeSpec spec;
    spec.id = id;
    spec.store = "corner";
    spec.goals = {{"can-cola", 2}};
    file.episodes.push_back(spec);
  }
  return file;
}

// Answers every episode but that of `number`, where it does `instead`.
std::vector<std::string> all_but(int number, const std::string& instead) {
  return script(R"(echo ready; while read n; do echo asked; if [ $n = )" + std::to_string(number) +
                " ]; then " + instead + R"(; fi; echo answered
                 echo "result {\"schema\": \"market-result/1\", \"episode\": \"e\", \"policy\": \"p\"}"; done)");
}

Result<std::vector<EpisodeResult>> evaluated_by(const std::vector<std::string>& worker,
                                                const std::filesystem::path& folder) {
  EvaluationOptions options{"p", folder};
  options.jobs = 1;
  options.worker = worker;
  options.act_limit_s = 0.5;
  return evaluate(data_rows(), three_named(), committed_catalog(), options, silent_progress());
}

TEST(WorkerProcess, AnAnswerThatNeverComesEndsTheWorker) {
  const auto worker =
      WorkerProcess::start(script("echo ready; read n; echo asked; exec sleep 1000"));
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  const auto result = (*worker)->run(0, 0.4);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "episode.policy_hung");
  EXPECT_FALSE((*worker)->alive());
}

TEST(WorkerProcess, OnlyThePolicysTimeCounts) {  // resets and physics may take as long as they do
  const auto worker =
      WorkerProcess::start(script(R"(echo ready; read n; sleep 1; echo asked; echo answered; sleep 1
                echo "result {\"schema\": \"market-result/1\", \"episode\": \"e\"}")"));
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  const auto result = (*worker)->run(0, 0.5);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->episode, "e");
}

TEST(WorkerProcess, ErrorsComeThroughAndTheWorkerLivesOn) {
  const auto worker = WorkerProcess::start(
      script(R"(echo ready; while read n; do printf 'error a.b\twhere\twhat happened\n'; done)"));
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  for (int i = 0; i < 2; ++i) {
    const auto result = (*worker)->run(0, 1);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(to_string(result.error()), "error[a.b] where: what happened");
    EXPECT_TRUE((*worker)->alive());
  }
}

TEST(WorkerProcess, OneThatCannotBeginIsAnError) {
  for (const auto& command : {script("exit 3"), {"/no/such/program"}}) {
    const auto worker = WorkerProcess::start(command);
    ASSERT_FALSE(worker.ok());
    EXPECT_EQ(worker.error().code, "program.failed");
  }
}

TEST(Evaluate, AHangIsAFailureAndTheNextEpisodeFollows) {
  const ScratchFolder scratch;
  const auto results = evaluated_by(all_but(1, "exec sleep 1000"), scratch.path());
  ASSERT_TRUE(results.ok()) << to_string(results.error());
  EXPECT_EQ((*results)[0].episode, "e");
  const EpisodeResult& hung = (*results)[1];
  EXPECT_EQ(hung.episode, "b");
  EXPECT_EQ(hung.policy, "p");
  EXPECT_EQ(hung.failure, FailureCode::policy_error);
  EXPECT_NE(hung.detail.find("policy_hung"), std::string::npos) << hung.detail;
  ASSERT_EQ(hung.goals.size(), 1U);
  EXPECT_EQ(hung.goals[0].reached, 0);
  EXPECT_EQ((*results)[2].episode, "e") << "a new worker goes on";
}

TEST(Evaluate, ACrashIsAFailureAndTheNextEpisodeFollows) {
  const ScratchFolder scratch;
  const auto results = evaluated_by(all_but(1, "kill -SEGV $$"), scratch.path());
  ASSERT_TRUE(results.ok()) << to_string(results.error());
  EXPECT_EQ((*results)[1].failure, FailureCode::policy_error);
  EXPECT_NE((*results)[1].detail.find("signal 11"), std::string::npos) << (*results)[1].detail;
  EXPECT_EQ((*results)[2].episode, "e");
}

TEST(Evaluate, ResultsOfAnotherPolicyAreNotGoneOnWith) {
  const ScratchFolder scratch;
  ASSERT_TRUE(evaluated_by(all_but(9, "true"), scratch.path()).ok());
  EvaluationOptions other{"random", scratch.path(), true};
  const auto refused =
      evaluate(data_rows(), three_named(), committed_catalog(), other, silent_progress());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "usage.bad_flag");
}

}  // namespace
}  // namespace marketgen
