#include "planner_flags.h"

#include "command.h"

namespace marketgen::app {

void add_planner_choice(CLI::App& command, std::string& planner, planners::PlannerAccess& access) {
  command
      .add_option("--planner",
                  planner,
                  "who plans: offline, or a language model: openai:MODEL, anthropic:MODEL, "
                  "gemini:MODEL, qwen:MODEL, http:MODEL with --planner-url, replay:FOLDER")
      ->type_name("PLANNER")
      ->capture_default_str();
  command.add_option("--planner-url", access.url, "base URL of another server of that kind")
      ->type_name("URL");
}

void add_planner_limits(CLI::App& command, planners::PlannerAccess& access) {
  command.add_option("--max-tokens", access.limits.max_tokens, "of the model, read and written")
      ->capture_default_str();
  command.add_option("--max-seconds", access.limits.max_seconds, "of waiting for the model")
      ->capture_default_str();
  command.add_option("--max-usd", access.limits.max_usd, "needs --usd-per-million");
  command
      .add_option("--usd-per-million",
                  access.limits.usd_per_million,
                  "price of a million tokens read, and written: 0.15 0.6")
      ->type_name("FLOAT");
}

void add_planner_flags(CLI::App& command,
                       std::string& planner,
                       planners::PlannerAccess& access,
                       std::string& record) {
  add_planner_choice(command, planner, access);
  add_output(command, "--record", record, "folder to keep the exchange with the model in");
  add_planner_limits(command, access);
}

}  // namespace marketgen::app
