// `assets import --vlm`: the program asks a server on this machine, records what was said, and
// makes the same asset from the record when the server has gone.
#include <gtest/gtest.h>

#include "support/glb_bytes.h"
#include "support/mock_server.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* secret = "e2e-test-key-456";

json step_saying(const std::string& category) {
  const json verdict = {{"name", "Tomato soup"},
                        {"category", category},
                        {"subcategory", "soup"},
                        {"archetype", "food_tin"},
                        {"material", "tin"},
                        {"storage", "ambient"},
                        {"rigidity", "rigid"},
                        {"keywords", json::array({"soup"})},
                        {"confidence", 0.9},
                        {"reason", "The print says soup."}};
  return {{"expect", {{"path", "/v1/messages"}, {"headers", {{"x-api-key", secret}}}}},
          {"body", {{"content", json::array({{{"type", "text"}, {"text", verdict.dump()}}})}}}};
}

class Vlm : public testing::Test {
 protected:
  void SetUp() override {
    setenv("ANTHROPIC_API_KEY", secret, 1);
    std::ofstream(scratch_.path() / "mesh_001.glb", std::ios::binary)
        << box_glb(0.075F, 0.11F, 0.075F, R"({"mesh": 0})");
  }
  void TearDown() override { unsetenv("ANTHROPIC_API_KEY"); }

  Ran import(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {"assets", "import", "mesh_001.glb", "--no-coacd"};
    all.insert(all.end(), more.begin(), more.end());
    return marketgen_run(all, scratch_.path());
  }
  ScratchFolder scratch_;
};

TEST_F(Vlm, RecordsAndReplays) {
  MockServer server(json::array({step_saying("caned"), step_saying("canned")}));
  const std::string url = server.url();
  const Ran live =
      import({"--vlm", "anthropic:seer", "--vlm-url", url, "--vlm-record", "tape", "-o", "one"});
  ASSERT_EQ(live.status, 0) << live.err;
  EXPECT_NE(live.out.find("anthropic:seer"), std::string::npos);
  EXPECT_EQ(server.requests().size(), 2U);  // the second mends the first
  server.stop();
  unsetenv("ANTHROPIC_API_KEY");
  const Ran again =
      import({"--vlm", "anthropic:seer", "--vlm-url", url, "--vlm-replay", "tape", "-o", "two"});
  ASSERT_EQ(again.status, 0) << again.err;
  const std::string asset = contents_of(scratch_.path() / "one/asset.json");
  EXPECT_EQ(contents_of(scratch_.path() / "two/asset.json"), asset);
  EXPECT_EQ(json::parse(asset)["annotation"]["annotator"], "anthropic:seer");
  EXPECT_EQ(json::parse(asset)["product"]["category"], "canned");
  EXPECT_EQ(all_text_in(scratch_.path()).find(secret), std::string::npos);
}

TEST_F(Vlm, ErrorsLeaveNothingBehind) {
  const MockServer server(json::array({step_saying("stationery")}));
  struct Case {
    std::vector<std::string> arguments;
    int status;
    const char* says;
  };
  const Case cases[] = {
      {{"--vlm", "anthropic:seer", "--vlm-url", server.url()}, 3, "error[llm.bad_answer]"},
      {{"--vlm", "antropic:seer"}, 2, "did you mean \"anthropic\""},
      {{"--vlm", "gemini:seer", "--vlm-replay", "."}, 2, "error[net.not_recorded]"},
      {{"--vlm", "gemini:seer", "--vlm-replay", "nowhere"}, 2, "error[input.not_found]"},
      {{"--vlm-record", "tape"}, 2, "--vlm"},
      {{"--vlm", "gemini:x", "--vlm-record", "a", "--vlm-replay", "b"}, 2, "--vlm-re"}};
  for (const Case& c : cases) {
    std::vector<std::string> arguments = c.arguments;
    arguments.insert(arguments.end(), {"-o", "out"});
    const Ran ran = import(arguments);
    EXPECT_EQ(ran.status, c.status) << ran.err;
    EXPECT_NE(ran.err.find(c.says), std::string::npos) << ran.err;
    EXPECT_EQ(ran.err.find(secret), std::string::npos);
    EXPECT_FALSE(fs::exists(scratch_.path() / "out"));
  }
  unsetenv("ANTHROPIC_API_KEY");
  const Ran keyless = import({"--vlm", "anthropic:seer", "-o", "out"});
  EXPECT_EQ(keyless.status, 2);
  EXPECT_NE(keyless.err.find("ANTHROPIC_API_KEY"), std::string::npos) << keyless.err;
}

}  // namespace
}  // namespace marketgen
