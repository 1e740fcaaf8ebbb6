#include "planners/make_planner.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "intake/offline_planner.h"
#include "io/file.h"
#include "io/json.h"
#include "llm/language_model.h"
#include "planners/agent_planner.h"

namespace marketgen::planners {
namespace {

constexpr std::array<std::string_view, 7> families = {
    "offline", "openai", "anthropic", "gemini", "qwen", "http", "replay"};

// FOLDER/model.json: with which model a recording was made.
struct RecordedModel {
  std::string planner, url;
  static constexpr auto fields =
      field_list(field("planner", &RecordedModel::planner, "--planner", required()),
                 field("url", &RecordedModel::url, "--planner-url"));
};

constexpr const char* model_file = "model.json";
constexpr std::uint64_t max_model_file_bytes = 1U << 16;

Error bad_name(const std::string& name) {
  return {"usage.bad_flag",
          "--planner",
          fmt::format("there is no planner \"{}\"{}; known are offline, openai:MODEL, "
                      "anthropic:MODEL, gemini:MODEL, qwen:MODEL, http:MODEL and replay:FOLDER",
                      name,
                      did_you_mean(name.substr(0, name.find(':')), families))};
}

Result<void> check_access(const std::string& name,
                          std::string_view family,
                          const PlannerAccess& access) {
  const bool any = !access.url.empty() || !access.record.empty();
  if (family == "offline" && any) {
    return Error{"usage.bad_flag",
                 "--planner",
                 "the offline planner asks no model: --planner-url and --record need a language "
                 "model, as in --planner openai:gpt-4o-mini"};
  }
  if (family == "replay" && any) {
    return Error{"usage.bad_flag",
                 "--planner",
                 "a replay sends nothing: it goes with neither --planner-url nor --record"};
  }
  if (access.limits.max_usd && !access.limits.usd_per_million) {
    return Error{"usage.bad_flag",
                 "--max-usd",
                 "no provider tells its prices: say them with --usd-per-million 0.15 0.6"};
  }
  if (family == "http" && access.url.empty()) {
    return Error{"usage.bad_flag",
                 "--planner",
                 fmt::format("\"{}\" needs the server's address, as in --planner-url "
                             "http://localhost:8000/v1",
                             name)};
  }
  return {};
}

// As llm::open_language_model names it: a server of one's own speaks as OpenAI's does.
std::string provider_name(const std::string& name) {
  constexpr std::string_view own = "http:";
  return name.starts_with(own) ? "openai:" + name.substr(own.size()) : name;
}

Result<llm::LanguageModel> opened(const std::string& name, llm::ModelChoice choice) {
  choice.model = provider_name(name);
  MARKETGEN_TRY(llm::LanguageModel model, llm::open_language_model(choice));
  model.name = name;
  return model;
}

Result<llm::LanguageModel> live_model(const std::string& name, const PlannerAccess& access) {
  llm::ModelChoice choice;
  choice.url = access.url;
  choice.record = access.record;
  choice.limits.total_s = std::min(choice.limits.total_s, access.limits.max_seconds);
  MARKETGEN_TRY(llm::LanguageModel model, opened(name, choice));
  if (!access.record.empty()) {
    const RecordedModel recorded{name, access.url};
    MARKETGEN_CHECK(io::write_file(access.record / model_file, io::write_json(recorded)));
  }
  return model;
}

Result<llm::LanguageModel> recorded_model(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / model_file;
  MARKETGEN_TRY(const std::string text, io::read_file(file, max_model_file_bytes));
  MARKETGEN_TRY(const RecordedModel recorded, io::read_json<RecordedModel>(text, file.string()));
  llm::ModelChoice choice;
  choice.url = recorded.url;
  choice.replay = folder;
  return opened(recorded.planner, choice);
}

}  // namespace

Result<std::optional<llm::LanguageModel>> open_planner_model(const std::string& name,
                                                             const PlannerAccess& access) {
  const std::size_t colon = name.find(':');
  const std::string family = name.substr(0, colon);
  const bool named = colon != std::string::npos && colon + 1 < name.size();
  if (std::ranges::find(families, family) == families.end() || named == (family == "offline"))
    return bad_name(name);
  MARKETGEN_CHECK(check_access(name, family, access));
  if (family == "offline") return std::optional<llm::LanguageModel>{};
  MARKETGEN_TRY(
      llm::LanguageModel model,
      family == "replay" ? recorded_model(name.substr(colon + 1)) : live_model(name, access));
  return std::optional(std::move(model));
}

Result<std::unique_ptr<intake::Planner>> make_planner(const std::string& name,
                                                      const PlannerAccess& access,
                                                      Seed layout_seed) {
  MARKETGEN_TRY(std::optional<llm::LanguageModel> model, open_planner_model(name, access));
  if (!model) return intake::offline_planner();
  MARKETGEN_TRY(intake::OfflinePlanner offline, intake::OfflinePlanner::load());
  return std::unique_ptr<intake::Planner>(std::make_unique<AgentPlanner>(
      std::move(offline), std::move(*model), access.limits, layout_seed));
}

}  // namespace marketgen::planners
