// What a goal's words mean, from the episode that asks: the truth in place of a reader.
#pragma once
#include <map>

#include "episodes/episode_spec.h"
#include "perception/goal_reader.h"

namespace marketgen::oracle {

class TrueReader : public perception::GoalReader {
 public:
  explicit TrueReader(const episodes::EpisodeSpec& spec);
  // Errors: perception.not_understood, the episode asks for nothing in these words.
  Result<std::vector<std::string>> read(const std::string& text) const override;

 private:
  std::map<std::string, std::string> skus_;  // by text
};

}  // namespace marketgen::oracle
