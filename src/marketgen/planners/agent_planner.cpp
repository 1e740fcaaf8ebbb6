#include "planners/agent_planner.h"

#include <fmt/format.h>

#include <utility>

#include "planners/plan_score.h"
#include "planners/refiner.h"
#include "planners/semantic_agent.h"
#include "planners/spatial_agent.h"
#include "planners/trace.h"

namespace marketgen::planners {
namespace {

constexpr const char* agents_kept = "agents";
constexpr const char* offline_kept = "offline planner";

// One planning: the offline plan, the agents' plan, and which of them the store gets.
class Planning {
 public:
  Planning(const llm::LanguageModel& model,
           const intake::Planned& offline,
           const intake::Brief& brief,
           const catalog::Catalog& catalog,
           Seed layout_seed)
      : model_(model), assignment_{brief, offline, catalog}, layout_seed_(layout_seed) {}

  // The agents' plan where it is no worse; nothing, and why() says why, otherwise.
  std::optional<plan::Plan> run() {
    const Result<JudgedPlan> offline = judged(assignment_.offline.plan);
    note(offline_kept, "planned from the words it understood", offline);
    const Result<plan::Plan> floor = plan_floor(model_, assignment_);
    if (!floor.ok()) return failed("spatial agent", floor.error());
    trace_.add("spatial agent",
               fmt::format("{} zones on {} x {} mm",
                           floor->zones.size(),
                           floor->shell.width_mm,
                           floor->shell.depth_mm));
    std::vector<std::string> failures;
    const Result<JudgedPlan> furnished =
        judged(furnish_zones(model_, *floor, assignment_, failures));
    note("semantic agents", told(failures), furnished);
    if (!furnished.ok()) return failed("agents", furnished.error());
    JudgedPlan agents = refined(model_, *furnished, assignment_, layout_seed_, trace_);
    if (!is_taken(agents, offline)) return std::nullopt;
    return std::move(agents.plan);
  }

  const std::string& why() const { return why_; }
  const Trace& trace() const { return trace_; }

 private:
  Result<JudgedPlan> judged(const plan::Plan& plan) const {
    return judge_plan(plan, assignment_.offline.requirements, assignment_.catalog, layout_seed_);
  }

  // Says why, or why not.
  bool is_taken(const JudgedPlan& agents, const Result<JudgedPlan>& offline) {
    if (agents.score.hard_rules > 0) {
      why_ = "the agents' plan breaks " + first_hard_rule(agents);
      return false;
    }
    if (!offline.ok()) {
      why_ = "the offline planner found no floor";
      return true;
    }
    const bool worse = offline->score < agents.score;
    why_ = fmt::format("{}: {} against {}",
                       worse ? "the agents' plan is worse" : "no worse than the offline planner's",
                       words_of(agents.score),
                       words_of(offline->score));
    return !worse;
  }

  void note(const char* agent, std::string what, const Result<JudgedPlan>& plan) {
    if (!plan.ok()) return trace_.add(agent, to_string(plan.error()));
    const Result<void> drawn = trace_.add(agent, std::move(what), *plan, assignment_.catalog);
    if (!drawn.ok()) trace_.add(agent, to_string(drawn.error()));
  }

  std::optional<plan::Plan> failed(const char* agent, const Error& error) {
    why_ = fmt::format("the {} failed: {}", agent, to_string(error));
    trace_.add(agent, why_);
    return std::nullopt;
  }

  static std::string told(const std::vector<std::string>& failures) {
    std::string text = failures.empty() ? "every zone has its fixtures and goods" : "";
    for (const std::string& failure : failures)
      text += (text.empty() ? "" : "; ") + failure;
    return text;
  }

  static std::string first_hard_rule(const JudgedPlan& plan) {
    for (const layout::Violation& rule : plan.rules) {
      if (rule.severity == layout::Severity::hard)
        return fmt::format("{}: {}", rule.code, rule.message);
    }
    return "a hard rule";
  }

  const llm::LanguageModel& model_;
  Assignment assignment_;
  Seed layout_seed_;
  Trace trace_;
  std::string why_;
};

intake::PlannerRecord record_of(const std::string& name, const Spent& spent) {
  intake::PlannerRecord record;
  record.planner = name;
  record.requests = spent.requests;
  record.tokens_in = spent.tokens_in;
  record.tokens_out = spent.tokens_out;
  record.seconds = spent.seconds;
  record.usd = spent.usd;
  return record;
}

}  // namespace

AgentPlanner::AgentPlanner(intake::OfflinePlanner offline,
                           llm::LanguageModel model,
                           Limits limits,
                           Seed layout_seed)
    : offline_(std::move(offline)),
      model_(std::move(model)),
      limits_(limits),
      layout_seed_(layout_seed) {}

Result<intake::Planned> AgentPlanner::plan(const intake::Brief& brief,
                                           const catalog::Catalog& catalog,
                                           Seed seed,
                                           const intake::Concessions& concessions) const {
  MARKETGEN_TRY(intake::Planned planned, offline_.plan(brief, catalog, seed, concessions));
  if (concessions != intake::Concessions{}) return planned;
  const Budget budget(model_, limits_);
  Planning planning(budget.model(), planned, brief, catalog, layout_seed_);
  std::optional<plan::Plan> plan = planning.run();
  intake::PlannerRecord record = record_of(model_.name, budget.spent());
  record.kept = plan ? agents_kept : offline_kept;
  record.why = planning.why();
  planned.files = planning.trace().files(record);
  planned.record = std::move(record);
  if (plan) planned.plan = std::move(*plan);
  return planned;
}

}  // namespace marketgen::planners
