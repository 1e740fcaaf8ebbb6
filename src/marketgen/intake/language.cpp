#include "intake/language.h"

#include "io/file.h"

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

Result<Language> Language::load_for_edits(const std::filesystem::path& data) {
  MARKETGEN_TRY(Lexicon lexicon, Lexicon::load(data / "lexicon"));
  MARKETGEN_TRY(const std::string english, io::read_file(data / "grammar" / "english.grammar"));
  const std::filesystem::path file = data / "grammar" / "edit.grammar";
  MARKETGEN_TRY(const std::string edits, io::read_file(file));
  MARKETGEN_TRY(language::Grammar grammar,
                language::Grammar::parse(english + "\n" + edits, file.string()));
  const auto change = grammar.category("change");
  if (!change) return Error{"grammar.bad_rule", file.string(), "no rule makes a change"};
  return Language{
      std::move(lexicon), std::make_shared<const language::Grammar>(std::move(grammar)), *change};
}

}  // namespace marketgen::intake
