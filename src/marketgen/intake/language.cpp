#include "intake/language.h"

#include "intake/chinese_words.h"

namespace marketgen::intake {
namespace {

Result<SentenceGrammar> load_grammar(const std::filesystem::path& file) {
  MARKETGEN_TRY(language::Grammar rules, language::Grammar::load(file));
  const auto statement = rules.category("statement");
  if (!statement)
    return Error{"grammar.bad_rule",
                 file.string(),
                 "no rule makes a statement; install the data folder again or set MARKETGEN_DATA "
                 "to it"};
  return SentenceGrammar{std::make_shared<const language::Grammar>(std::move(rules)), *statement};
}

}  // namespace

Result<Language> Language::load(const std::filesystem::path& data) {
  MARKETGEN_TRY(Lexicon lexicon, Lexicon::load(data / "lexicon"));
  const std::filesystem::path folder = data / "grammar";
  MARKETGEN_TRY(SentenceGrammar english, load_grammar(folder / "english.grammar"));
  MARKETGEN_TRY(SentenceGrammar chinese, load_grammar(folder / "chinese.grammar"));
  return Language{std::move(lexicon), std::move(english), std::move(chinese)};
}

const SentenceGrammar& Language::grammar_of(const std::vector<Token>& sentence) const {
  return is_chinese(sentence) ? chinese : english;
}

}  // namespace marketgen::intake
