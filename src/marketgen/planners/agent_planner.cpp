#include "planners/agent_planner.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "intake/photo_wishes.h"
#include "intake/settled_look.h"
#include "io/file.h"
#include "photo/bank.h"
#include "planners/photo_reader.h"
#include "planners/plan_score.h"
#include "planners/refiner.h"
#include "planners/semantic_agent.h"
#include "planners/shown_pictures.h"
#include "planners/spatial_agent.h"
#include "planners/trace.h"

namespace marketgen::planners {
namespace {

constexpr const char* photo_reader_name = "photo reader";
constexpr const char* agents_kept = "agents";
constexpr const char* offline_kept = "offline planner";

// What a model made of the pictures of a brief.
struct Look {
  ShownPictures shown;
  std::vector<photo::PhotoReading> seen;  // of the photos; empty where it read none
  std::vector<std::string> warnings;
};

Result<std::vector<photo::PhotoReading>> ask_for_look(const llm::LanguageModel& model,
                                                      const std::vector<ShownPicture>& photos,
                                                      const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const photo::Bank bank, photo::load_bank(data));
  return seen_by(model, photos, bank, catalog);
}

// What both readers read of a photo, for a person.
std::string read_of(const intake::Brief& brief, const photo::PhotoReading& seen) {
  const auto bank = std::ranges::find(brief.photos, seen.file, &photo::PhotoReading::file);
  return fmt::format("the model reads {}; the bank of renderings {}",
                     intake::words_of(seen),
                     bank != brief.photos.end() ? intake::words_of(*bank) : "nothing");
}

// Asks for the photos' look. A model that fails leaves what the bank read.
Look look_at_pictures(const llm::LanguageModel& model,
                      const intake::Brief& brief,
                      const catalog::Catalog& catalog,
                      Trace& trace) {
  Look look;
  look.shown = shown_pictures(brief);
  look.warnings = look.shown.left_out;
  const std::vector<ShownPicture> photos = photos_of(look.shown.pictures);
  if (photos.empty()) return look;
  Result<std::vector<photo::PhotoReading>> seen = ask_for_look(model, photos, catalog);
  if (!seen.ok()) {
    std::string why =
        fmt::format("the photo reader failed, what the bank of renderings read holds: {}",
                    to_string(seen.error()));
    trace.add(photo_reader_name, why, photos, {});
    look.warnings.push_back(std::move(why));
    return look;
  }
  look.seen = std::move(*seen);
  std::vector<std::string> disagreements =
      intake::settled_look(brief.photos, look.seen).disagreements;
  std::vector<std::string> read;
  for (const photo::PhotoReading& photo : look.seen)
    read.push_back(read_of(brief, photo));
  trace.add(photo_reader_name,
            disagreements.empty()
                ? "it and the bank of renderings are nowhere sure of different things"
                : fmt::format("{}", fmt::join(disagreements, "; ")),
            photos,
            read);
  for (std::string& one : disagreements)
    look.warnings.push_back("photos: " + std::move(one));
  return look;
}

// One planning: the offline plan, the agents' plan, and which of them the store gets.
class Planning {
 public:
  Planning(const llm::LanguageModel& model,
           const intake::Planned& offline,
           const intake::Brief& brief,
           const catalog::Catalog& catalog,
           const std::vector<ShownPicture>& pictures,
           Seed layout_seed,
           Trace& trace)
      : model_(model),
        assignment_{brief, offline, catalog, pictures},
        layout_seed_(layout_seed),
        trace_(trace) {}

  // The agents' plan where it is no worse; nothing, and why() says why, otherwise.
  std::optional<plan::Plan> run() {
    const Result<JudgedPlan> offline = judged(assignment_.offline.plan);
    note(offline_kept, "planned from the words it understood", offline);
    const Result<plan::Plan> floor = plan_floor(model_, assignment_);
    if (!floor.ok()) return failed("spatial agent", floor.error(), assignment_.pictures);
    trace_.add("spatial agent",
               fmt::format("{} zones on {} x {} mm",
                           floor->zones.size(),
                           floor->shell.width_mm,
                           floor->shell.depth_mm),
               assignment_.pictures,
               {});
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

  std::optional<plan::Plan> failed(const char* agent,
                                   const Error& error,
                                   const std::vector<ShownPicture>& pictures = {}) {
    why_ = fmt::format("the {} failed: {}", agent, to_string(error));
    trace_.add(agent, why_, pictures, {});
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
  Trace& trace_;
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
  Trace trace;
  Look look = look_at_pictures(budget.model(), brief, catalog, trace);
  intake::Brief seen = brief;
  if (!look.seen.empty()) {
    seen.seen = std::move(look.seen);
    MARKETGEN_TRY(planned, offline_.plan(seen, catalog, seed, concessions));
  }
  Planning planning(
      budget.model(), planned, seen, catalog, look.shown.pictures, layout_seed_, trace);
  std::optional<plan::Plan> plan = planning.run();
  intake::PlannerRecord record = record_of(model_.name, budget.spent());
  record.kept = plan ? agents_kept : offline_kept;
  record.why = planning.why();
  record.warnings = std::move(look.warnings);
  planned.files = trace.files(record);
  planned.record = std::move(record);
  planned.seen = std::move(seen.seen);
  if (plan) planned.plan = std::move(*plan);
  return planned;
}

}  // namespace marketgen::planners
