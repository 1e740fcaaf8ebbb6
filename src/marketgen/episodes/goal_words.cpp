#include "episodes/goal_words.h"

#include <fmt/format.h>

#include "episodes/episode_origin.h"

namespace marketgen::episodes {

bool tell_goals(const Offer& offer, InstructionVerb verb, Seed seed, EpisodeSpec& spec) {
  std::vector<std::string> names;
  for (EpisodeGoal& goal : spec.goals) {
    const std::size_t number = offer.number_of(goal.sku);
    if (spec.instructions == Instructions::ids) {
      const std::string name = spoken_product(offer.row(number));
      names.push_back(goal.count == 1 ? name : fmt::format("{} of {}", goal.count, name));
      continue;
    }
    const auto told = refer_to(offer, number, goal.count, seed.child(goal.sku));
    if (!told) return false;
    goal.text = told->text;
    names.push_back(told->text);
  }
  spec.instruction = instruction_of(verb, spec.instructions, names, seed.child("instruction"));
  return true;
}

}  // namespace marketgen::episodes
