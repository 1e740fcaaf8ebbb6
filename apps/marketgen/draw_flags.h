// Flags that say how episodes are drawn and which of them are kept.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "command.h"
#include "episodes/draw_rules.h"

namespace marketgen::app {

struct DrawFlags {
  std::string station, split = "planned", instructions = "words", difficulty = "standard";
  std::string unseen = "products,layouts,looks";
  std::vector<std::string> trained_on;
  bool doors = false;
};

void add_draw_flags(CLI::App& command, DrawFlags& flags);

// For a track, by its name. Errors: usage.bad_flag for what the track has not, or is no choice;
// those of load_difficulty and TrainingSet::read.
Result<episodes::DrawRules> draw_rules_of(const DrawFlags& flags,
                                          const std::string& track,
                                          const std::filesystem::path& data);

}  // namespace marketgen::app
