// The languages that prompts are written in: their words and how they go together.
#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "base/result.h"
#include "intake/lexicon.h"
#include "language/grammar.h"

namespace marketgen::intake {

struct SentenceGrammar {
  std::shared_ptr<const language::Grammar> rules;  // never null
  language::Category statement = 0;                // of the rules: what is asked for
};

struct Language {
  Lexicon lexicon;  // of all languages
  SentenceGrammar english, chinese;

  // From the folder of data. Errors: of Lexicon::load and Grammar::load.
  static Result<Language> load(const std::filesystem::path& data);
  // The same for what is said of a store that stands: with edit.grammar, whose statements are
  // changes.
  static Result<Language> load_for_edits(const std::filesystem::path& data);

  // A sentence with any character of Chinese script is a Chinese one.
  const SentenceGrammar& grammar_of(const std::vector<Token>& sentence) const;

  // With the catalogue's own words.
  Language with_words_of(const catalog::Catalog& catalog) const {
    return {lexicon.with_words_of(catalog), english, chinese};
  }
};

}  // namespace marketgen::intake
