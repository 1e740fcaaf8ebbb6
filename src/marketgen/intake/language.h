// A language that prompts are written in: its words and how they go together.
#pragma once
#include <filesystem>
#include <memory>

#include "base/result.h"
#include "intake/lexicon.h"
#include "language/grammar.h"

namespace marketgen::intake {

struct Language {
  Lexicon lexicon;
  std::shared_ptr<const language::Grammar> grammar;  // never null
  language::Category statement = 0;                  // of the grammar: what is asked for

  // From the folder of data. Errors: of Lexicon::load and Grammar::load.
  static Result<Language> load(const std::filesystem::path& data);
  // The same for what is said of a store that stands: with edit.grammar, whose statements are
  // changes.
  static Result<Language> load_for_edits(const std::filesystem::path& data);

  // With the catalogue's own words.
  Language with_words_of(const catalog::Catalog& catalog) const {
    return {lexicon.with_words_of(catalog), grammar, statement};
  }
};

}  // namespace marketgen::intake
