// What people say when they look for something, and what the catalogue calls it:
// data/asset_intents.json.
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"

namespace marketgen::catalog {

// "wash dishes" -> "dish soap". Plurals and endings do not matter on either side.
struct SearchIntent {
  std::vector<std::string> say;    // one of these words or phrases in the question ...
  std::vector<std::string> means;  // ... may also be any of these in a row
  static constexpr auto fields = field_list(
      field("say", &SearchIntent::say, "words or phrases of a question", required()),
      field("means", &SearchIntent::means, "words or phrases of the catalogue", required()));
};

struct SearchLexicon {
  std::vector<std::string> skip;     // words that say nothing: "something", "to"
  std::vector<std::string> without;  // words that turn the next one round: "without", "no"
  std::vector<SearchIntent> intents;
  static constexpr auto fields =
      field_list(field("skip", &SearchLexicon::skip, "words that say nothing"),
                 field("without", &SearchLexicon::without, "words that turn the next one round"),
                 field("intents", &SearchLexicon::intents, "what words of a question may mean"));
};

}  // namespace marketgen::catalog
