// `marketgen view` as people start it: the address that it prints answers, faults say what mends
// them, Ctrl-C ends it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "small_store.h"
#include "support/raw_client.h"

namespace marketgen {
namespace {

using Words = std::vector<std::string>;

class View : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(scratch_.path() / "index.html") << "<!doctype html><title>page</title>";
  }
  Words command(const Words& arguments) const {
    Words words{"env",
                "MARKETGEN_CACHE=" + (scratch_.path() / "cache").string(),
                "MARKETGEN_VIEWER=" + scratch_.path().string(),
                MARKETGEN_BINARY,
                "view"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return words;
  }
  // Of the address that it has printed; 0 when it does not come.
  static int port_of(const Started& server) {
    for (int looks = 0; looks < 6000; ++looks) {
      const std::string out = server.output_so_far();
      const std::string before = "http://127.0.0.1:";
      const std::size_t at = out.find(before);
      if (at != std::string::npos && out.find('\n', at) != std::string::npos)
        return std::stoi(out.substr(at + before.size()));
      usleep(5'000);
    }
    return 0;
  }

  ScratchFolder scratch_;
};

TEST_F(View, ServesAStoreUntilCtrlC) {
  Started server(command({small_store().string(), "--no-open"}));
  const int port = port_of(server);
  ASSERT_GT(port, 0) << server.errors_so_far();
  EXPECT_EQ(get(port, "/").body, "<!doctype html><title>page</title>");
  const RawAnswer list = get(port, "/api/stores");
  EXPECT_EQ(nlohmann::json::parse(list.body)["stores"][0]["folder"], "shop");
  EXPECT_EQ(get(port, "/api/stores/0/goods.bin").body.substr(0, 4), "MGV1");
  EXPECT_EQ(get(port, "/api/stores/0/room.bin").body.substr(0, 4), "MGV1");
  server.interrupt();
  const Ran ran = server.wait();
  EXPECT_EQ(ran.status, 0) << ran.err;  // it was told to serve until then
  EXPECT_EQ(ran.err, "");
}

// Two runs in a store that nobody has as a folder: it travels with the set.
TEST_F(View, ShowsResultsOfASetWithoutAStore) {
  const std::string one = (scratch_.path() / "one").string(),
                    two = (scratch_.path() / "two").string();
  for (const std::string& folder : {one, two}) {
    const Ran ran = run({MARKETGEN_BINARY,
                         "eval",
                         "--episodes",
                         "v1/checkout",
                         "--policy",
                         "stop",
                         "--shard",
                         "1/1000",
                         "--record-motion",
                         "--quiet",
                         "-o",
                         folder});
    ASSERT_EQ(ran.status, 0) << ran.err;
  }
  Started server(command({one, two, "--no-open"}));
  const int port = port_of(server);
  ASSERT_GT(port, 0) << server.errors_so_far();
  EXPECT_NE(server.output_so_far().find("/?store=0&replay="), std::string::npos)
      << "the list of episodes opens";
  const auto json = [&](const std::string& path) {
    return nlohmann::json::parse(get(port, path).body);
  };
  const nlohmann::json stores = json("/api/stores")["stores"];
  ASSERT_EQ(stores.size(), 1U);
  EXPECT_GT(stores[0]["products"], 1000);
  const nlohmann::json summary = json("/api/stores/0");
  EXPECT_EQ(summary["may_edit"], false) << "it would be saved beside a folder";
  EXPECT_EQ(summary["may_drive"], false);
  const nlohmann::json runs = json("/api/stores/0/runs")["runs"];
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[1]["folder"], "two");
  const nlohmann::json ids = {json("/api/stores/0/runs/0")["episodes"][0]["id"],
                              json("/api/stores/0/runs/1")["episodes"][0]["id"]};
  EXPECT_EQ(ids[0], ids[1]);
  const nlohmann::json episode = json("/api/stores/0/runs/1/episodes/0");
  EXPECT_GT(episode["steps"], 1) << episode;
  EXPECT_FALSE(episode["things"].empty());
  EXPECT_EQ(get(port, "/api/stores/0/runs/1/episodes/0/motion.bin").body.substr(0, 4), "MGV1");
  EXPECT_EQ(get(port, "/api/stores/0/runs/1/episodes/0/meshes.bin").body.substr(0, 4), "MGV1");
  EXPECT_EQ(get(port, "/api/stores/0/places/0/goods.bin").body.substr(0, 4), "MGV1");
  server.interrupt();
  EXPECT_EQ(server.wait().status, 0);
}

TEST_F(View, NeedsAFreePort) {
  Started first(command({small_store().string(), "--no-open"}));
  const int port = port_of(first);
  ASSERT_GT(port, 0);
  const Ran second =
      run(command({small_store().string(), "--no-open", "--port", std::to_string(port)}));
  EXPECT_EQ(second.status, 2);
  EXPECT_NE(second.err.find("error[server.cannot_listen]"), std::string::npos) << second.err;
  first.interrupt();
  first.wait();
}

TEST_F(View, NeedsAStoreAPageAndASecret) {
  const auto error_of = [&](const Words& arguments) { return run(command(arguments)).err; };
  EXPECT_NE(error_of({scratch_.path().string(), "--no-open"}).find("error[store.not_a_store]"),
            std::string::npos);
  EXPECT_NE(error_of({small_store().string(), "--no-open", "--host", "0.0.0.0"})
                .find("error[usage.bad_flag] --token"),
            std::string::npos);
  std::filesystem::remove(scratch_.path() / "index.html");
  const std::string pageless = error_of({small_store().string(), "--no-open"});
  EXPECT_NE(pageless.find("error[usage.unavailable]"), std::string::npos);
  EXPECT_NE(pageless.find("MARKETGEN_VIEWER"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
