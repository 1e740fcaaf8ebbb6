// Which planner a brief names.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "base/seed.h"
#include "intake/brief.h"
#include "llm/language_model.h"
#include "planners/budget.h"

namespace marketgen::planners {

// How a language model is reached; no part of a brief, because none of it changes what is asked.
struct PlannerAccess {
  std::string url;               // of a server of that kind; empty: the provider's own
  std::filesystem::path record;  // folder for every exchange with the model
  Limits limits;
};

// By the name in the brief: "offline", or a language model:
//   openai:MODEL anthropic:MODEL gemini:MODEL qwen:MODEL
//   http:MODEL     any server that speaks OpenAI's chat completions; needs access.url
//   replay:FOLDER  as access.record kept it: nothing is sent
// Errors: usage.bad_flag for other names and for what does not go with the name; those of
// llm::open_language_model, Language::load, and of reading FOLDER/model.json.
Result<std::unique_ptr<intake::Planner>> make_planner(const std::string& name,
                                                      const PlannerAccess& access,
                                                      Seed layout_seed);

// The language model of that name alone; nothing for "offline". Errors: as make_planner.
Result<std::optional<llm::LanguageModel>> open_planner_model(const std::string& name,
                                                             const PlannerAccess& access);

}  // namespace marketgen::planners
