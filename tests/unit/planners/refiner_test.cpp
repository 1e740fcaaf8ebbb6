// The refiner on plans that were broken on purpose: patches that help are kept, others rolled back.
#include "planners/refiner.h"

#include <gtest/gtest.h>

#include "scripted_model.h"

namespace marketgen {
namespace {

using nlohmann::json;

// What the agents make of that floor with a refiner that answers so.
intake::Planned refined_with(const json& patches) {
  const intake::Planned offline = offline_plan();
  json script = json::array({refiner_step(patches)});
  for (const json& step : zone_steps(Wire::openai, offline.plan))
    script.push_back(step);
  script.push_back(
      {{"body", wrapped(Wire::openai, io::write_json(floor_without_bakery(offline.plan)))}});
  const MockServer server(script);
  const auto planned = planned_by("http:m", reaching(server.url()));
  EXPECT_TRUE(planned.ok()) << to_string(planned.error());
  return planned.ok() ? *planned : intake::Planned{};
}

json steps_of_refiner(const intake::Planned& planned) {
  json steps = json::array();
  const json trace = json::parse(bytes_of(planned, "agents/trace.json"));
  for (const json& step : trace["steps"]) {
    if (step["agent"] == "refiner") steps.push_back(step);
  }
  return steps;
}

const plan::Zone& zone_of_type(const plan::Plan& plan, std::string_view type) {
  return *std::ranges::find(plan.zones, type, &plan::Zone::type);
}

std::string largest_zone(const plan::Plan& plan) {
  return std::ranges::max_element(
             plan.zones, {}, [](const plan::Zone& zone) { return zone.area_m2.target.value_or(0); })
      ->id;
}

TEST(Refiner, KeepsPatchesThatHelp) {
  const std::string beside = largest_zone(offline_plan().plan);
  const json bakery{{"id", "oven"}, {"type", "bakery"}, {"fixture", {{"kind", "bakery_rack"}}}};
  const intake::Planned planned = refined_with({{{"add_zone",
                                                  {{"zone", bakery},
                                                   {"beside", beside},
                                                   {"side", "south"},
                                                   {"share", 0.4},
                                                   {"gap_mm", 1400}}}}});
  const json steps = steps_of_refiner(planned);
  ASSERT_FALSE(steps.empty());
  EXPECT_TRUE(steps[0]["what"].get<std::string>().starts_with("taken")) << steps[0];
  // The same patch again has no place: its zone is there.
  EXPECT_LE(steps.size(), static_cast<std::size_t>(planners::max_refiner_rounds) + 1);
}

TEST(Refiner, RollsBackPatchesThatDoNot) {
  const intake::Planned offline = offline_plan();
  const std::string dairy = zone_of_type(offline.plan, "dairy").id;
  const intake::Planned planned = refined_with({{{"drop_zone", {{"zone", dairy}}}}});
  const json steps = steps_of_refiner(planned);
  ASSERT_FALSE(steps.empty());
  EXPECT_TRUE(steps[0]["what"].get<std::string>().starts_with("rolled back")) << steps[0];
  EXPECT_EQ(planned.record->kept, "offline planner");  // the bakery is still missing
}

TEST(Refiner, EndsWhenAPlanComesASecondTime) {
  const intake::Planned offline = offline_plan();
  const std::string dairy = zone_of_type(offline.plan, "dairy").id;
  const intake::Planned planned = refined_with({{{"drop_zone", {{"zone", dairy}}}}});
  const json steps = steps_of_refiner(planned);
  ASSERT_EQ(steps.size(), 2U) << steps;
  EXPECT_NE(steps[1]["what"].get<std::string>().find("judged before"), std::string::npos);
}

TEST(Refiner, PatchesOfThingsThatAreNotThereGoBackWithWhatIsWrong) {
  const intake::Planned planned = refined_with({{{"drop_zone", {{"zone", "no-such-zone"}}}}});
  const json steps = steps_of_refiner(planned);
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_NE(steps[0]["what"].get<std::string>().find("llm.bad_answer"), std::string::npos);
  EXPECT_NE(steps[0]["what"].get<std::string>().find("no-such-zone"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
