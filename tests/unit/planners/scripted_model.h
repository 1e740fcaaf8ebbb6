// Answers of a language model as a test writes them, and the server that gives them. What a
// scripted server says measures nothing about models: it shows what becomes of answers.
#pragma once
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "intake/brief.h"
#include "io/json.h"
#include "planners/make_planner.h"
#include "planners/semantic_agent.h"
#include "planners/spatial_agent.h"
#include "support/committed_catalog.h"
#include "support/mock_server.h"

namespace marketgen {

inline intake::Brief small_brief() {
  intake::Brief brief;
  brief.prompt = "a 16 x 12 m shop with dairy, snacks, a bakery and two checkouts";
  return brief;
}

inline Seed plan_seed() {
  return Seed(3).child("plan");
}
inline Seed layout_seed() {
  return Seed(3).child("layout");
}

inline intake::Planned offline_plan() {
  const auto planner = intake::offline_planner();
  auto planned = (*planner)->plan(small_brief(), committed_catalog(), plan_seed(), {});
  return *planned;
}

// The floor of a plan, as a spatial agent would say it.
inline planners::FloorProposal floor_of(const plan::Plan& plan) {
  planners::FloorProposal floor;
  floor.profile = plan.profile;
  floor.style = committed_catalog().styles.front().id;
  floor.width_mm = plan.shell.width_mm;
  floor.depth_mm = plan.shell.depth_mm;
  floor.openings = plan.shell.openings;
  floor.nodes = plan.nodes;
  for (const plan::Zone& zone : plan.zones)
    floor.zones.push_back({zone.id, zone.type, zone.label, zone.area_m2.target.value_or(10)});
  floor.reason = "as it was";
  return floor;
}

// The floor of the plan with a hall of household goods where the bakery was asked for.
inline planners::FloorProposal floor_without_bakery(const plan::Plan& plan) {
  planners::FloorProposal floor = floor_of(plan);
  const auto bakery =
      std::ranges::find(floor.zones, "bakery", &planners::FloorProposal::ProposedZone::type);
  for (plan::Node& node : floor.nodes) {
    if (node.zone == bakery->id) node.zone = "hall";
  }
  bakery->id = "hall";
  bakery->type = "household";
  return floor;
}

inline planners::ZoneProposal furniture_of(const plan::Zone& zone) {
  return {zone.fixture, zone.stock, "as it was"};
}

enum class Wire { openai, anthropic, gemini };

// A text as the body of an answer.
inline nlohmann::json wrapped(Wire wire, const std::string& text) {
  using nlohmann::json;
  switch (wire) {
    case Wire::openai:
      return {{"choices", {{{"message", {{"content", text}}}, {"finish_reason", "stop"}}}},
              {"usage", {{"prompt_tokens", 1000}, {"completion_tokens", 200}}}};
    case Wire::anthropic:
      return {{"content", {{{"type", "text"}, {"text", text}}}},
              {"stop_reason", "end_turn"},
              {"usage", {{"input_tokens", 1000}, {"output_tokens", 200}}}};
    case Wire::gemini:
      return {{"candidates",
               {{{"content", {{"role", "model"}, {"parts", {{{"text", text}}}}}},
                 {"finishReason", "STOP"}}}},
              {"usageMetadata", {{"promptTokenCount", 1000}, {"candidatesTokenCount", 200}}}};
  }
  return {};
}

// Steps for the zones, found by what is asked about each.
inline nlohmann::json zone_steps(Wire wire, const plan::Plan& plan) {
  nlohmann::json steps = nlohmann::json::array();
  for (const plan::Zone& zone : plan.zones)
    steps.push_back({{"for", "The zone: id " + zone.id + ", type"},
                     {"body", wrapped(wire, io::write_json(furniture_of(zone)))}});
  return steps;
}

// What a refiner answers.
inline nlohmann::json refiner_step(const nlohmann::json& patches) {
  const nlohmann::json answer{{"patches", patches}, {"reason", "as it was wished"}};
  return {{"for", "You mend the plan"}, {"body", wrapped(Wire::openai, answer.dump())}};
}

// The script of a model that says what the offline planner planned.
inline nlohmann::json sensible_script(Wire wire, const plan::Plan& plan) {
  nlohmann::json steps = zone_steps(wire, plan);
  steps.push_back({{"for", "You mend the plan"},
                   {"body", wrapped(wire, R"({"patches": [], "reason": "all is well"})")}});
  steps.push_back({{"body", wrapped(wire, io::write_json(floor_of(plan)))}});
  return steps;
}

inline planners::PlannerAccess reaching(const std::string& url,
                                        const std::filesystem::path& record = {}) {
  planners::PlannerAccess access;
  access.url = url;
  access.record = record;
  return access;
}

inline Result<intake::Planned> planned_by(const std::string& name,
                                          const planners::PlannerAccess& access) {
  MARKETGEN_TRY(const auto planner, planners::make_planner(name, access, layout_seed()));
  return planner->plan(small_brief(), committed_catalog(), plan_seed(), {});
}

inline std::string bytes_of(const intake::Planned& planned, std::string_view path) {
  const auto file = std::ranges::find(planned.files, path, &intake::PlannerFile::path);
  return file == planned.files.end() ? "" : file->bytes;
}

}  // namespace marketgen
