#include "intake/language.h"

namespace marketgen::intake {

Result<Language> Language::load(const std::filesystem::path& data) {
  MARKETGEN_TRY(Lexicon lexicon, Lexicon::load(data / "lexicon"));
  MARKETGEN_TRY(language::Grammar grammar,
                language::Grammar::load(data / "grammar" / "english.grammar"));
  const auto statement = grammar.category("statement");
  if (!statement)
    return Error{"grammar.bad_rule", (data / "grammar").string(), "no rule makes a statement"};
  return Language{std::move(lexicon),
                  std::make_shared<const language::Grammar>(std::move(grammar)),
                  *statement};
}

}  // namespace marketgen::intake
