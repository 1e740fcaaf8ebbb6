// What the scene's rules say mends them (audit/scene_rules.inc) does, on whole stores.
#include <gtest/gtest.h>

#include "plan/patch.h"
#include "planners/plan_score.h"
#include "scripted_model.h"

namespace marketgen {
namespace {

bool breaks(const plan::Plan& plan, std::string_view code) {
  const auto judged = planners::judge_plan(plan, {}, committed_catalog(), layout_seed());
  if (!judged.ok()) fatal(to_string(judged.error()).c_str());
  return std::ranges::any_of(judged->rules,
                             [&](const layout::Violation& rule) { return rule.code == code; });
}

struct Remedy {
  std::string code;
  std::function<void(plan::Plan&)> fault;
  std::string patch;  // as market-patch/1 has it
};

std::vector<Remedy> remedies() {
  const auto all_zones = [](plan::Plan& plan, const auto& change) {
    for (plan::Zone& zone : plan.zones)
      change(zone);
  };
  const std::string door = offline_plan().plan.shell.openings.front().id;
  return {{"LIGHT_DIM",
           [](plan::Plan& plan) { plan.look.light_lux = 200; },
           R"({"set_look": {"light_lux": 300}})"},
          {"DOOR_NARROW",
           [](plan::Plan& plan) { plan.shell.openings.front().width_mm = 780; },
           R"({"move_opening": {"opening": ")" + door + R"(", "width_mm": 900}})"},
          {"CEILING_TIGHT",
           [](plan::Plan& plan) { plan.shell.ceiling_mm = 2200; },
           R"({"set_shell": {"ceiling_mm": 3600}})"},
          {"DENSITY_LOW",
           [&](plan::Plan& plan) {
             all_zones(plan, [](plan::Zone& zone) { zone.stock.out_of_stock = 0.95; });
           },
           ""}};
}

TEST(Remedies, MendWhatTheySay) {
  for (const Remedy& one : remedies()) {
    plan::Plan plan = offline_plan().plan;
    EXPECT_FALSE(breaks(plan, one.code)) << one.code;
    one.fault(plan);
    EXPECT_TRUE(breaks(plan, one.code)) << one.code;
    std::string patches = one.patch;
    if (patches.empty()) {  // of every zone
      for (const plan::Zone& zone : plan.zones)
        patches += (patches.empty() ? "" : ", ") + (R"({"set_stock": {"zone": ")" + zone.id) +
                   R"(", "out_of_stock": 0}})";
    }
    const auto set = plan::read_patches(
        R"({"schema": "market-patch/1", "patches": [)" + patches + "]}", "patches");
    ASSERT_TRUE(set.ok()) << to_string(set.error());
    const auto mended =
        plan::apply_patches(plan, *set, "patches", plan::Source::flag, committed_catalog());
    ASSERT_TRUE(mended.ok()) << to_string(mended.error());
    EXPECT_FALSE(breaks(*mended, one.code)) << one.code;
  }
}

TEST(Remedies, AreToldToTheRefiner) {
  intake::Brief brief = small_brief();
  brief.prompt += ", 200 lux";
  const auto offline =
      (*intake::offline_planner())->plan(brief, committed_catalog(), plan_seed(), {});
  ASSERT_TRUE(offline.ok());
  const MockServer server(sensible_script(Wire::openai, offline->plan));
  const auto planner = planners::make_planner("http:m", reaching(server.url()), layout_seed());
  ASSERT_TRUE((*planner)->plan(brief, committed_catalog(), plan_seed(), {}).ok());
  EXPECT_TRUE(std::ranges::any_of(server.requests(), [](const nlohmann::json& request) {
    const std::string body = request["body"];
    return body.find("You mend the plan") != std::string::npos &&
           body.find("what mends it: set_look: a light_lux of 300 and more") != std::string::npos;
  }));
}

}  // namespace
}  // namespace marketgen
