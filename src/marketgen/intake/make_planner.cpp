#include <array>

#include "base/text.h"
#include "intake/brief.h"
#include "intake/offline_planner.h"
#include "io/file.h"

namespace marketgen::intake {
namespace {

// Planners of later versions, by the part of their name before the colon.
constexpr std::array<std::string_view, 6> announced = {
    "openai", "anthropic", "gemini", "qwen", "http", "replay"};
constexpr std::array<std::string_view, 7> known = {
    "offline", "openai", "anthropic", "gemini", "qwen", "http", "replay"};

}  // namespace

Result<std::unique_ptr<Planner>> make_planner(std::string_view name) {
  if (name == "offline") {
    MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
    MARKETGEN_TRY(Language language, Language::load(data));
    return std::unique_ptr<Planner>(std::make_unique<OfflinePlanner>(std::move(language)));
  }
  const std::string_view family = name.substr(0, name.find(':'));
  for (const std::string_view later : announced) {
    if (family != later) continue;
    return Error{"usage.unavailable",
                 "--planner",
                 "\"" + std::string(name) +
                     "\" needs a language model; this version ships the offline planner only: "
                     "use --planner offline"};
  }
  return Error{"usage.bad_flag",
               "--planner",
               "there is no planner \"" + std::string(name) + "\"" + did_you_mean(family, known) +
                   "; this version has \"offline\""};
}

}  // namespace marketgen::intake
