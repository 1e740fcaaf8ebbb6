// Workers that hang, crash or never begin: the run goes on, and says what became of their episodes.
// The workers are shell scripts that speak as evaluation/episode_worker.h says.
#include "evaluation/worker_process.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

#include "base/call_interrupt.h"
#include "evaluation/evaluate.h"
#include "io/file.h"
#include "support/drawn_checkout.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

// After it was told the header of the file.
std::vector<std::string> script(const std::string& text) {
  return {"/bin/sh", "-c", "read -r header; " + text};
}

Result<std::unique_ptr<evaluation::WorkerProcess>> started(
    const std::vector<std::string>& command) {
  return evaluation::WorkerProcess::start(command, R"({"schema": "market-episodes/1"})", {20, 20});
}

episodes::EpisodeFile three_named() {
  episodes::EpisodeFile file;
  for (const char* id : {"a", "b", "c"}) {
    episodes::EpisodeSpec spec;
    spec.id = id;
    spec.store = "corner";
    spec.goals = {{"can-cola", 2}};
    file.episodes.push_back(spec);
  }
  return file;
}

// As a shell's word in double quotes.
std::string result_line(const std::string& more = {}) {
  return R"(result {\"schema\": \"market-result/1\", \"episode\": \"e\", \"hits\": 0, \"asked\": 2)" +
         more + "}";
}

// Answers every episode but that of the id, where it does `instead`.
std::vector<std::string> all_but(const std::string& id, const std::string& instead) {
  return script(R"(echo ready; while read -r spec; do echo asked
                 if echo "$spec" | grep -q '"id": *")" +
                id + "\"'; then " + instead + R"(; fi; echo "answered 0.1"
                 echo ")" +
                result_line(R"(, \"policy\": \"p\")") + R"("; done)");
}

Result<std::vector<episodes::EpisodeResult>> evaluated_by(const std::vector<std::string>& worker,
                                                          const std::filesystem::path& folder) {
  evaluation::EvaluationOptions options{"p", folder};
  options.jobs = 1;
  options.worker = worker;
  options.answer = {20, 0.5};
  return evaluation::evaluate(
      data_rows(), three_named(), committed_catalog(), options, silent_progress());
}

// It computes nothing, so that only the guard can find it.
TEST(WorkerProcess, AnAnswerThatNeverComesEndsTheWorker) {
  const auto worker = started(script("echo ready; read -r spec; echo asked; exec sleep 1000"));
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  const auto result = (*worker)->run("{}", {20, 0.4});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "episode.policy_hung");
  EXPECT_FALSE((*worker)->alive());
}

// It is never silent, so that nobody has to wait for it.
TEST(WorkerProcess, AnInterruptEndsOneThatAnswersWithoutEnd) {
  const auto worker =
      started(script("echo ready; read -r spec; while :; do echo asked; echo 'answered 0'; done"));
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  std::atomic<bool> stop = false;
  const CallInterrupt call(&stop);
  std::jthread stopping([&stop] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    stop = true;
  });
  const auto result = (*worker)->run("{}", {20, 1000});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "internal.interrupted");
  EXPECT_FALSE((*worker)->alive());
}

// It computes without end, however long the guard would wait.
TEST(WorkerProcess, AnAnswerThatTakesTooMuchComputingEndsTheWorker) {
  const auto worker = started(script("echo ready; read -r spec; echo asked; while :; do :; done"));
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  const auto result = (*worker)->run("{}", {0.3, 1000});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "episode.policy_slow");
  EXPECT_NE(result.error().message.find("0.3 s"), std::string::npos) << result.error().message;
  EXPECT_FALSE((*worker)->alive());
}

// On a machine that has no turn for it a policy answers late; that is no fault of its own.
TEST(WorkerProcess, TimeInWhichItDoesNotComputeIsNotCounted) {
  const auto worker = started(script(R"(echo ready; read -r spec; echo asked; sleep 1.2
                echo "answered 0.1"; echo ")" +
                                     result_line() + "\""));
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  const auto result = (*worker)->run("{}", {0.5, 100});
  ASSERT_TRUE(result.ok()) << to_string(result.error());
}

// Whether it is late must not depend on when we look.
TEST(WorkerProcess, AnAnswerThatTookTooMuchIsTooLateThoughItCame) {
  for (const auto& [told, code] : {std::pair{"answered 0.51", "episode.policy_slow"},
                                   std::pair{"answered ", "program.failed"}}) {
    const auto worker =
        started(script(std::string("echo ready; read -r spec; echo asked; echo '") + told +
                       "'; echo \"" + result_line() + "\"; exec sleep 1000"));
    ASSERT_TRUE(worker.ok()) << to_string(worker.error());
    const auto result = (*worker)->run("{}", {0.5, 100});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, code);
    EXPECT_FALSE((*worker)->alive());
  }
}

TEST(WorkerProcess, OnlyThePolicysTimeCounts) {  // resets and physics may take as long as they do
  const auto worker =
      started(script(R"(echo ready; read -r spec; sleep 1; echo asked; echo "answered 0"; sleep 1
                echo ")" +
                     result_line() + "\""));
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  const auto result = (*worker)->run("{}", {0.5, 0.5});
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->episode, "e");
}

TEST(WorkerProcess, ErrorsComeThroughAndTheWorkerLivesOn) {
  const auto worker = started(script(
      R"(echo ready; while read -r spec; do printf 'error a.b\twhere\twhat happened\n'; done)"));
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  for (int i = 0; i < 2; ++i) {
    const auto result = (*worker)->run("{}", {1, 1});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(to_string(result.error()), "error[a.b] where: what happened");
    EXPECT_TRUE((*worker)->alive());
  }
}

TEST(WorkerProcess, OneThatCannotBeginIsAnError) {
  EXPECT_EQ(started(script("exit 3")).error().code, "episode.no_policy");
  EXPECT_EQ(started({"/no/such/program"}).error().code, "usage.unavailable");
}

// It neither reads nor speaks: a header larger than any pipe must not keep us waiting, either.
TEST(WorkerProcess, OneThatIsNeverReadyIsEnded) {
  for (const std::size_t size : {10UL, 3'000'000UL}) {
    const auto worker = evaluation::WorkerProcess::start(
        {"/bin/sh", "-c", "exec sleep 1000"}, std::string(size, 'x'), {0.3, 0.5});
    ASSERT_FALSE(worker.ok());
    EXPECT_EQ(worker.error().code, "episode.no_policy");
    EXPECT_NE(worker.error().message.find("after 0.5 s of wall time"), std::string::npos)
        << worker.error().message;
  }
}

// What counts is what it computes: a busy machine does not make it late.
TEST(WorkerProcess, OneThatComputesTooMuchBeforeItIsReadyIsEnded) {
  const auto busy = evaluation::WorkerProcess::start(script("while :; do :; done"), "", {0.3, 60});
  ASSERT_FALSE(busy.ok());
  EXPECT_EQ(busy.error().code, "episode.no_policy");
  EXPECT_NE(busy.error().message.find("after 0.3 s of processor time"), std::string::npos)
      << busy.error().message;
  EXPECT_TRUE(evaluation::WorkerProcess::start(script("sleep 1; echo ready"), "", {0.9, 60}).ok());
}

TEST(WorkerProcess, ItIsToldTheHeaderAndTheEpisode) {
  const std::string header(300'000, 'h');
  const auto worker = evaluation::WorkerProcess::start(
      {"/bin/sh",
       "-c",
       R"(read -r header; echo ready; read -r spec; printf 'error a.b\twhere\t%s %s\n' ${#header} "$spec")"},
      header,
      {20, 20});
  ASSERT_TRUE(worker.ok()) << to_string(worker.error());
  EXPECT_EQ((*worker)->run(R"({"id": "a\\b"})", {1, 1}).error().message,
            R"(300000 {"id": "a\\b"})");
}

TEST(Evaluate, AHangIsAFailureAndTheNextEpisodeFollows) {
  const ScratchFolder scratch;
  const auto results = evaluated_by(all_but("b", "exec sleep 1000"), scratch.path());
  ASSERT_TRUE(results.ok()) << to_string(results.error());
  EXPECT_EQ((*results)[0].failure, episodes::FailureCode::none);
  const episodes::EpisodeResult& hung = (*results)[1];
  EXPECT_EQ(hung.episode, "b");
  EXPECT_EQ(hung.policy, "p");
  EXPECT_EQ(hung.failure, episodes::FailureCode::policy_error);
  EXPECT_NE(hung.detail.find("policy_hung"), std::string::npos) << hung.detail;
  ASSERT_EQ(hung.goals.size(), 1U);
  EXPECT_EQ(hung.goals[0].reached, 0);
  EXPECT_EQ((*results)[2].failure, episodes::FailureCode::none) << "a new worker goes on";
}

TEST(Evaluate, ACrashIsAFailureAndTheNextEpisodeFollows) {
  const ScratchFolder scratch;
  const auto results = evaluated_by(all_but("b", "kill -SEGV $$"), scratch.path());
  ASSERT_TRUE(results.ok()) << to_string(results.error());
  EXPECT_EQ((*results)[1].failure, episodes::FailureCode::policy_error);
  EXPECT_NE((*results)[1].detail.find("signal 11"), std::string::npos) << (*results)[1].detail;
  EXPECT_EQ((*results)[2].failure, episodes::FailureCode::none);
  EXPECT_EQ((*results)[2].episode, "c") << "whatever the worker says";
}

// A policy that does not start would not for the next episode, either.
TEST(Evaluate, APolicyThatDoesNotStartEndsTheRun) {
  const ScratchFolder scratch;
  const auto ended = evaluated_by(script("exit 3"), scratch.path());
  ASSERT_FALSE(ended.ok());
  EXPECT_EQ(ended.error().code, "episode.no_policy");
  EXPECT_NE(ended.error().message.find("no episode had been finished"), std::string::npos);
  EXPECT_NE(io::read_file(scratch.path() / "summary.json")->find("\"unfinished\": 3"),
            std::string::npos);
}

// An episode that cannot be run is a result of its own kind: the others are run and summed up.
TEST(Evaluate, AnEpisodeThatCannotBeRunIsAResult) {
  const ScratchFolder scratch;
  const std::vector<std::string> worker =
      all_but("b", R"(printf 'error episode.impossible\tb\tno room\n'; continue)");
  const auto results = evaluated_by(worker, scratch.path());
  ASSERT_TRUE(results.ok()) << to_string(results.error());
  ASSERT_EQ(results->size(), 3U);
  EXPECT_EQ((*results)[1].episode, "b");
  EXPECT_EQ((*results)[1].error, "episode.impossible");
  EXPECT_EQ((*results)[1].failure, episodes::FailureCode::not_run);
  EXPECT_NE((*results)[1].detail.find("no room"), std::string::npos);
  const auto summary = evaluation::summarize(*results);
  EXPECT_EQ(summary.episodes, 2);
  EXPECT_EQ(summary.strict.of, 2) << "it counts in no share";
  ASSERT_EQ(summary.errors.size(), 1U);
  EXPECT_EQ(summary.errors[0].error, "episode.impossible");
  EXPECT_EQ(summary.errors[0].episodes, 1);
}

TEST(Evaluate, ResultsOfAnotherPolicyAreNotGoneOnWith) {
  const ScratchFolder scratch;
  ASSERT_TRUE(evaluated_by(all_but("z", "true"), scratch.path()).ok());
  evaluation::EvaluationOptions other{"random", scratch.path(), true};
  const auto refused = evaluation::evaluate(
      data_rows(), three_named(), committed_catalog(), other, silent_progress());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "usage.bad_flag");
}

}  // namespace
}  // namespace marketgen
