#include "oracle/true_reader.h"

namespace marketgen::oracle {

TrueReader::TrueReader(const episodes::EpisodeSpec& spec) {
  for (const episodes::EpisodeGoal& goal : spec.goals)
    if (goal.text) skus_.emplace(*goal.text, goal.sku);
}

Result<std::vector<std::string>> TrueReader::read(const std::string& text) const {
  if (const auto found = skus_.find(text); found != skus_.end())
    return std::vector<std::string>{found->second};
  return Error{"perception.not_understood", text, "the episode asks for nothing in these words"};
}

}  // namespace marketgen::oracle
