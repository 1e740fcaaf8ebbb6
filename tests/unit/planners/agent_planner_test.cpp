// Agents against a scripted server that speaks each provider's wire format: what becomes of good
// answers. What becomes of bad ones: misbehaving_model_test.cpp.
#include "planners/agent_planner.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "scripted_model.h"

namespace marketgen {
namespace {

class Agents : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* key :
         {"OPENAI_API_KEY", "ANTHROPIC_API_KEY", "GEMINI_API_KEY", "DASHSCOPE_API_KEY"})
      setenv(key, "test-key-123", 1);
  }
};

bool has_source(const plan::Plan& plan, std::string_view path, plan::Source source) {
  return std::ranges::any_of(plan.provenance, [&](const plan::Provenance& entry) {
    return entry.path == path && entry.source == source;
  });
}

TEST_F(Agents, PlanOverEveryProvidersWireFormat) {
  const intake::Planned offline = offline_plan();
  const std::vector<std::tuple<std::string, std::string, Wire>> providers = {
      {"openai:gpt-4o-mini", "/v1", Wire::openai},
      {"qwen:qwen-plus", "/v1", Wire::openai},
      {"http:my-model", "/v1", Wire::openai},
      {"anthropic:claude-sonnet-4-5", "", Wire::anthropic},
      {"gemini:gemini-2.5-flash", "/v1beta", Wire::gemini}};
  for (const auto& [name, path, wire] : providers) {
    const MockServer server(sensible_script(wire, offline.plan));
    const auto planned = planned_by(name, reaching(server.url(path)));
    ASSERT_TRUE(planned.ok()) << name << to_string(planned.error());
    ASSERT_TRUE(planned->record.has_value()) << name;
    EXPECT_EQ(planned->record->planner, name);
    EXPECT_EQ(planned->record->kept, "agents") << name << ": " << planned->record->why;
    EXPECT_TRUE(has_source(planned->plan, "/nodes", plan::Source::llm)) << name;
    const std::size_t questions = server.requests().size();
    EXPECT_EQ(planned->record->requests, static_cast<int>(questions));
    EXPECT_EQ(planned->record->tokens_in, static_cast<std::int64_t>(1000 * questions));
    EXPECT_EQ(planned->record->tokens_out, static_cast<std::int64_t>(200 * questions));
    EXPECT_FALSE(planned->record->usd.has_value());
  }
}

TEST_F(Agents, WhatWordsSaidIsKept) {
  const intake::Planned offline = offline_plan();
  planners::FloorProposal floor = floor_of(offline.plan);
  floor.width_mm = 40000;  // the words say 16 x 12 m
  nlohmann::json script = zone_steps(Wire::openai, offline.plan);
  script.push_back({{"body", wrapped(Wire::openai, io::write_json(floor))}});
  const MockServer server(script);
  const auto planned = planned_by("http:m", reaching(server.url()));
  ASSERT_TRUE(planned.ok());
  EXPECT_EQ(planned->record->kept, "agents") << planned->record->why;
  EXPECT_EQ(planned->plan.shell.width_mm, 16000);
  EXPECT_TRUE(has_source(planned->plan, "/shell/width_mm", plan::Source::text));
  EXPECT_TRUE(has_source(planned->plan, "/look", plan::Source::llm));  // nobody said a style
}

TEST_F(Agents, WhatTheyFurnishStandsInThePlan) {
  const intake::Planned offline = offline_plan();
  nlohmann::json script = nlohmann::json::array();
  for (const plan::Zone& zone : offline.plan.zones) {
    planners::ZoneProposal furniture = furniture_of(zone);
    if (zone.type == "snacks") furniture.stock.jitter = 0.35;
    script.push_back({{"for", "The zone: id " + zone.id + ", type"},
                      {"body", wrapped(Wire::openai, io::write_json(furniture))}});
  }
  script.push_back({{"body", wrapped(Wire::openai, io::write_json(floor_of(offline.plan)))}});
  const MockServer server(script);
  const auto planned = planned_by("http:m", reaching(server.url()));
  ASSERT_TRUE(planned.ok());
  ASSERT_EQ(planned->record->kept, "agents") << planned->record->why;
  for (const plan::Zone& zone : planned->plan.zones) {
    const bool snacks = zone.type == "snacks";
    EXPECT_EQ(zone.stock.jitter == 0.35, snacks) << zone.id;
  }
}

TEST_F(Agents, AFloorThatIsNoPlanGoesBackOnceWithWhatIsWrong) {
  const intake::Planned offline = offline_plan();
  planners::FloorProposal wrong = floor_of(offline.plan);
  wrong.zones.front().type = "dary";
  nlohmann::json script = zone_steps(Wire::openai, offline.plan);
  script.push_back({{"body", wrapped(Wire::openai, io::write_json(wrong))}});
  script.push_back({{"body", wrapped(Wire::openai, io::write_json(floor_of(offline.plan)))}});
  const MockServer server(script);
  const auto planned = planned_by("http:m", reaching(server.url()));
  ASSERT_TRUE(planned.ok());
  EXPECT_EQ(planned->record->kept, "agents") << planned->record->why;
  ASSERT_GE(server.requests().size(), 2U);
  EXPECT_NE(server.requests()[1]["body"].get<std::string>().find("\\\"dary\\\""),
            std::string::npos);
}

TEST_F(Agents, AWorsePlanThanTheOfflineOneIsNotTaken) {
  const intake::Planned offline = offline_plan();
  nlohmann::json script = nlohmann::json::array();
  script.push_back(
      {{"body", wrapped(Wire::openai, io::write_json(floor_without_bakery(offline.plan)))}});
  const MockServer server(script);
  const auto planned = planned_by("http:m", reaching(server.url()));
  ASSERT_TRUE(planned.ok());
  EXPECT_EQ(planned->record->kept, "offline planner");
  EXPECT_NE(planned->record->why.find("worse"), std::string::npos) << planned->record->why;
  EXPECT_EQ(io::write_json(planned->plan), io::write_json(offline.plan));
}

TEST_F(Agents, LeaveATraceThatAPersonCanRead) {
  const intake::Planned offline = offline_plan();
  const MockServer server(sensible_script(Wire::openai, offline.plan));
  const auto planned = planned_by("http:m", reaching(server.url()));
  ASSERT_TRUE(planned.ok());
  const auto trace = nlohmann::json::parse(bytes_of(*planned, "agents/trace.json"));
  ASSERT_GE(trace["steps"].size(), 3U);
  EXPECT_EQ(trace["steps"][1]["agent"], "spatial agent");
  const std::string page = bytes_of(*planned, "agents/index.html");
  for (const auto& step : trace["steps"]) {
    if (!step.contains("picture") || step["picture"].get<std::string>().empty()) continue;
    const std::string picture = step["picture"];
    EXPECT_TRUE(bytes_of(*planned, "agents/" + picture).starts_with("\x89PNG"));
    EXPECT_NE(page.find(picture), std::string::npos);
  }
}

TEST_F(Agents, AReplayGivesTheSamePlanAndSendsNothing) {
  const intake::Planned offline = offline_plan();
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path() / "record";
  std::string recorded;
  {
    const MockServer server(sensible_script(Wire::openai, offline.plan));
    const auto planned = planned_by("http:m", reaching(server.url(), folder));
    ASSERT_TRUE(planned.ok()) << to_string(planned.error());
    ASSERT_EQ(planned->record->kept, "agents") << planned->record->why;
    recorded = io::write_json(planned->plan);
  }
  const auto replayed = planned_by("replay:" + folder.string(), {});
  ASSERT_TRUE(replayed.ok()) << to_string(replayed.error());
  EXPECT_EQ(replayed->record->kept, "agents") << replayed->record->why;
  EXPECT_EQ(io::write_json(replayed->plan), recorded);
}

TEST_F(Agents, CostMoneyWherePricesAreGiven) {
  const intake::Planned offline = offline_plan();
  const MockServer server(sensible_script(Wire::openai, offline.plan));
  planners::PlannerAccess access = reaching(server.url());
  access.limits.usd_per_million = {2.0, 10.0};
  const auto planned = planned_by("http:m", access);
  ASSERT_TRUE(planned.ok());
  const double questions = planned->record->requests;
  ASSERT_TRUE(planned->record->usd.has_value());
  EXPECT_NEAR(*planned->record->usd, questions * (1000 * 2.0 + 200 * 10.0) / 1e6, 1e-12);
}

TEST(MakePlanner, KnowsItsNames) {
  EXPECT_TRUE(planners::make_planner("offline", {}, layout_seed()).ok());
  const auto refused = [](const std::string& name, const planners::PlannerAccess& access = {}) {
    const auto made = planners::make_planner(name, access, layout_seed());
    return made.ok() ? Error{} : made.error();
  };
  EXPECT_NE(refused("oflline").message.find("\"offline\""), std::string::npos);
  for (const char* wrong : {"", "openai", "openai:", "offline:x", "parrot:x", "http:m"})
    EXPECT_EQ(refused(wrong).code, "usage.bad_flag") << wrong;
  EXPECT_EQ(refused("offline", reaching("http://localhost:1")).code, "usage.bad_flag");
  EXPECT_EQ(refused("replay:/nowhere/at/all").code, "input.not_found");
  planners::PlannerAccess cheap = reaching("http://localhost:1");
  cheap.limits.max_usd = 1;
  EXPECT_EQ(refused("http:m", cheap).code, "usage.bad_flag");
}

}  // namespace
}  // namespace marketgen
