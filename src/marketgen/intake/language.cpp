#include "intake/language.h"

#include "intake/chinese_words.h"
#include "io/file.h"

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

Result<Language> Language::load_for_edits(const std::filesystem::path& data) {
  MARKETGEN_TRY(Language language, load(data));
  MARKETGEN_TRY(const std::string english, io::read_file(data / "grammar" / "english.grammar"));
  const std::filesystem::path file = data / "grammar" / "edit.grammar";
  MARKETGEN_TRY(const std::string edits, io::read_file(file));
  MARKETGEN_TRY(language::Grammar grammar,
                language::Grammar::parse(english + "\n" + edits, file.string()));
  const auto change = grammar.category("change");
  if (!change) return Error{"grammar.bad_rule", file.string(), "no rule makes a change"};
  language.english = {std::make_shared<const language::Grammar>(std::move(grammar)), *change};
  return language;
}

}  // namespace marketgen::intake
