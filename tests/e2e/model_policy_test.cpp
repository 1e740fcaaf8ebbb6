// `eval --policy vlm` and `hybrid` with a server on this machine in the place of a model or of a
// part: whatever it says, an episode ends with a result that says so; what was recorded needs
// neither key nor server.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "small_store.h"
#include "support/mock_server.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* model_key = "e2e-test-key-789";
constexpr double counter_limit_s = 6, aisle_limit_s = 75;  // a look or two
constexpr double grasp_limit_s = 11;                       // a look and a grasp

json model_saying(const std::string& text) {
  return {{"expect", {{"path", "/chat/completions"}}},
          {"body",
           {{"choices", json::array({{{"message", {{"content", text}}}}})},
            {"usage", {{"prompt_tokens", 1000}, {"completion_tokens", 20}}}}}};
}

json model_marking(int number) {
  return model_saying(json{{"seen", "a pack"}, {"mark", number}}.dump());
}

// One episode of the small store with little time.
fs::path short_task(const std::string& track, double limit_s) {
  static const ScratchFolder scratch;
  fs::path file = scratch.path() / fmt::format("{}-{:g}-s.jsonl", track, limit_s);
  if (fs::exists(file)) return file;
  const fs::path drawn = scratch.path() / (track + "-drawn.jsonl");
  const Ran made = marketgen_run({"episodes",
                                  small_store().string(),
                                  "--track",
                                  track,
                                  "--count",
                                  "1",
                                  "--seed",
                                  "2",
                                  "--quiet",
                                  "-o",
                                  drawn.string()});
  EXPECT_EQ(made.status, 0) << made.err;
  std::istringstream lines(contents_of(drawn));
  std::ofstream out(file);
  std::string line;
  std::getline(lines, line);
  out << line << "\n";
  while (std::getline(lines, line)) {
    json spec = json::parse(line);
    spec["limit_s"] = limit_s;
    out << spec.dump() << "\n";
  }
  return file;
}

class ModelPolicy : public testing::Test {
 protected:
  void SetUp() override { setenv("OPENAI_API_KEY", model_key, 1); }
  void TearDown() override { unsetenv("OPENAI_API_KEY"); }

  Ran eval(const fs::path& task, const std::string& folder, std::vector<std::string> more) const {
    std::vector<std::string> all = {"eval", "--episodes", task.string(), "-o", folder};
    all.insert(all.end(), more.begin(), more.end());
    return marketgen_run(all, scratch_.path());
  }
  json result_in(const std::string& folder) const {
    std::istringstream lines(contents_of(scratch_.path() / folder / "results.jsonl"));
    std::string line;
    std::getline(lines, line);
    return json::parse(line);
  }
  ScratchFolder scratch_;
};

const std::vector<std::string> seer{"--policy", "vlm", "--model", "openai:seer"};

std::vector<std::string> seer_at(const std::string& url, std::vector<std::string> more = {}) {
  std::vector<std::string> all = seer;
  all.insert(all.end(), {"--model-url", url});
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST_F(ModelPolicy, AsksAtTheCounterRecordsAndReplays) {
  const fs::path task = short_task("checkout", counter_limit_s);
  MockServer server(json::array({model_marking(1)}));
  const std::string url = server.url();
  const Ran live = eval(task, "live", seer_at(url, {"--model-record", "tape"}));
  ASSERT_EQ(live.status, 0) << live.err;
  EXPECT_NE(live.out.find("questions in"), std::string::npos) << live.out;
  const json result = result_in("live");
  EXPECT_EQ(result["policy"], "vlm(openai:seer)");
  const json& model = result["model"];
  EXPECT_GT(model["questions"].get<int>(), 0);
  EXPECT_EQ(model["requests"].get<std::size_t>(), server.requests().size());
  EXPECT_EQ(model["tokens_in"].get<std::size_t>(), 1000 * server.requests().size());
  const std::string asked = server.requests().front().dump();
  EXPECT_NE(asked.find("image_url"), std::string::npos);
  EXPECT_EQ(asked.find(result["goals"][0]["sku"].get<std::string>()), std::string::npos);
  server.stop();
  unsetenv("OPENAI_API_KEY");
  const Ran again = eval(task, "again", seer_at(url, {"--model-replay", "tape"}));
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(result_in("again")["state_hash"], result["state_hash"]);
  EXPECT_EQ(result_in("again")["model"], model);
  EXPECT_EQ(all_text_in(scratch_.path()).find(model_key), std::string::npos);
}

TEST_F(ModelPolicy, GarbageIsNoWorseThanNoModel) {
  const fs::path task = short_task("checkout", counter_limit_s);
  const MockServer server(json::array({model_saying("{\"mark\": NaN, I think")}));
  const Ran asked = eval(task, "asked", seer_at(server.url()));
  ASSERT_EQ(asked.status, 0) << asked.err;
  ASSERT_EQ(eval(task, "alone", {"--policy", "classical"}).status, 0);
  const json result = result_in("asked");
  EXPECT_EQ(result["state_hash"], result_in("alone")["state_hash"]);
  EXPECT_GT(result["model"]["bad_answer"].get<int>(), 0);
  EXPECT_GT(result["model"]["offline"].get<int>(), 0);
  EXPECT_FALSE(result_in("alone").contains("model"));
}

TEST_F(ModelPolicy, NotThereIsBelieved) {
  const fs::path task = short_task("checkout", counter_limit_s);
  const MockServer server(json::array({model_marking(-1)}));
  ASSERT_EQ(eval(task, "none", seer_at(server.url())).status, 0);
  const json model = result_in("none")["model"];
  EXPECT_EQ(model["absent"], model["questions"]);
  EXPECT_EQ(model["offline"], 0);
}

using SlowModelPolicy = ModelPolicy;

TEST_F(SlowModelPolicy, AsksInTheAisles) {
  const fs::path task = short_task("aisle", aisle_limit_s);
  const MockServer server(json::array({model_marking(1)}));
  const Ran ran = eval(task, "aisle", seer_at(server.url(), {"--truth", "language"}));
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json result = result_in("aisle");
  EXPECT_EQ(result["policy"], "vlm(openai:seer)+language");
  EXPECT_EQ(result["model"]["requests"].get<std::size_t>(), server.requests().size());
}

TEST_F(SlowModelPolicy, PartsInServersAreAskedRecordedAndReplayed) {
  const fs::path task = short_task("checkout", grasp_limit_s);
  MockServer server(
      json::array({{{"for", "form-data"}, {"body", {{"masks", json::array()}}}},
                   {{"for", "\"depths\""}, {"body", {{"grasp_groups", json::array()}}}}}));
  const std::string url = server.url();
  const Ran live = eval(task,
                        "live",
                        {"--policy",
                         "hybrid",
                         "--masks-url",
                         url,
                         "--grasps-url",
                         url + "/grasps",
                         "--truth",
                         "target",
                         "--model-record",
                         "tape"});
  ASSERT_EQ(live.status, 0) << live.err;
  EXPECT_NE(live.out.find("masks       "), std::string::npos) << live.out;
  const json result = result_in("live");
  const std::string name = "hybrid(masks=" + url + ",grasps=" + url + "/grasps)+target";
  EXPECT_EQ(result["policy"], name);
  std::map<std::string, int> asked;
  for (const json& request : server.requests())
    ++asked[request["path"].get<std::string>()];
  EXPECT_GT(asked["/generate_masks"], 0);
  EXPECT_GT(asked["/grasps"], 0);
  EXPECT_EQ(result["parts"]["masks"]["answered"], asked["/generate_masks"]);
  EXPECT_EQ(result["parts"]["grasps"]["answered"], asked["/grasps"]);
  EXPECT_EQ(result["parts"]["masks"]["offline"], 0);
  server.stop();
  const Ran again = eval(task, "again", {"--policy", name, "--model-replay", "tape"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(result_in("again")["state_hash"], result["state_hash"]);
  EXPECT_EQ(result_in("again")["parts"], result["parts"]);
}

TEST_F(ModelPolicy, APartThatIsDownIsNoWorseThanNone) {
  const fs::path task = short_task("checkout", counter_limit_s);
  const std::vector<std::string> parts{"--policy",
                                       "hybrid",
                                       "--masks-url",
                                       "http://127.0.0.1:9",
                                       "--grasps-url",
                                       "http://127.0.0.1:9"};
  ASSERT_EQ(eval(task, "down", parts).status, 0);
  ASSERT_EQ(eval(task, "alone", {"--policy", "classical"}).status, 0);
  const json result = result_in("down");
  EXPECT_EQ(result["state_hash"], result_in("alone")["state_hash"]);
  EXPECT_GT(result["parts"]["masks"]["unreachable"].get<int>(), 0);
  EXPECT_EQ(result["parts"]["masks"]["answered"], 0);
}

TEST_F(ModelPolicy, GraspServersAreAskedInTheAisles) {
  const fs::path task = short_task("aisle", aisle_limit_s);
  const MockServer server(json::array({{{"body", {{"grasp_groups", json::array()}}}}}));
  const Ran ran = eval(
      task,
      "aisle",
      {"--policy", "hybrid", "--grasps-url", server.url(), "--truth", "language,target,masks"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json result = result_in("aisle");
  EXPECT_EQ(result["parts"]["grasps"]["questions"].get<std::size_t>(), server.requests().size());
  EXPECT_FALSE(server.requests().empty());
  EXPECT_EQ(result["parts"]["grasps"]["offline"], 0);
  const Ran refused = eval(task, "refused", {"--policy", "hybrid", "--masks-url", server.url()});
  EXPECT_NE(refused.err.find("places on boards"), std::string::npos) << refused.err;
}

TEST_F(ModelPolicy, ErrorsComeBeforeAnyWork) {
  const fs::path task = short_task("checkout", counter_limit_s);
  unsetenv("OPENAI_API_KEY");
  struct Case {
    std::vector<std::string> flags;
    int status;
    const char* says;
  };
  const std::vector<Case> cases{
      {seer, 2, "OPENAI_API_KEY"},
      {{"--policy", "vlm"}, 2, "--model openai:gpt-4o"},
      {{"--policy", "vlm", "--model", "opnai:x"}, 2, "did you mean \"openai\""},
      {{"--policy", "hybrid"}, 2, "hybrid needs a part"},
      {{"--policy", "hybrid", "--masks-url", "localhost:5002"}, 2, "error[net.bad_url]"},
      {{"--policy", "classical", "--masks-url", "http://h"}, 2, "goes with --policy hybrid"},
      {{"--policy", "hybrid(masks=http://h"}, 2, "no closing bracket"},
      {{"--policy", "hybrid", "--grasps-url", "http://h/a?b=1,2"}, 2, "with a comma"},
      {{"--perception", "--masks-url", "http://h"}, 2, "as they are"},
      {{"--policy", "hybrid(masks=http://h)", "--grasps-url", "http://h"}, 2, "its parts already"},
      {{"--policy", "hybrid", "--masks-url", "http://h", "--model-url", "http://g"}, 2, "--model"},
      {{"--policy", "hybrid", "--masks-url", "http://h", "--truth", "masks"}, 2, "a server's"},
      {{"--policy", "classical", "--model", "openai:x"}, 2, "goes with --policy vlm"},
      {{"--policy", "classical", "--model-url", "http://localhost:1"}, 2, "--policy vlm"},
      {{"--policy", "vlm(openai:x)", "--model", "openai:y"}, 2, "names its model already"},
      {{"--policy", "vlm(openai:x)", "--truth", "target"}, 2, "take classical"},
      {{"--policy", "oracle(openai:x)"}, 2, "vlm alone"},
      {{"--policy", "vlm(openai:x)", "--model-replay", "nowhere"}, 2, "error[input.not_found]"}};
  for (const Case& each : cases) {
    const Ran ran = eval(task, "out", each.flags);
    EXPECT_EQ(ran.status, each.status) << each.says << ran.err;
    EXPECT_NE(ran.err.find(each.says), std::string::npos) << ran.err;
    EXPECT_FALSE(fs::exists(scratch_.path() / "out")) << each.says;
  }
}

}  // namespace
}  // namespace marketgen
