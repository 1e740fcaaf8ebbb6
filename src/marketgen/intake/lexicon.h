// The planner's dictionary: which words of a prompt mean what.
//
// Rows are data (data/lexicon/*.json). The catalogue adds the words it knows itself: keywords of
// zone types, fixture kinds and styles, and names of products, also with their variants ("basmati
// rice") and how they are kept ("tinned peaches"), and their subcategories.
// Rows of the lexicon win over the catalogue's words.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "intake/tokens.h"

namespace marketgen::intake {

// What part a phrase plays in a sentence; `value` and `number` of the row say which one. A `word`
// is one of the grammar's own: `value` is the category by which rules name it, and one with a
// `number` says something, so that it is not passed over.
enum class Sense {
  zone,
  product,
  fixture,
  shop,
  profile,
  style,
  material,
  part,
  color,
  light,
  place,
  relation,
  opening,
  unit,
  number,
  fraction,
  times,
  counted,
  dimension,
  comparison,
  strength,
  negation,
  amount,
  size,
  stock,
  separator,
  naming,
  suffix,
  filler,
  word,
  ordinary
};
constexpr std::array<std::string_view, 31> names_of(Sense) {
  return {"zone",     "product",  "fixture", "shop",    "profile",   "style",      "material",
          "part",     "color",    "light",   "place",   "relation",  "opening",    "unit",
          "number",   "fraction", "times",   "counted", "dimension", "comparison", "strength",
          "negation", "amount",   "size",    "stock",   "separator", "naming",     "suffix",
          "filler",   "word",     "ordinary"};
}

struct LexiconRow {
  Sense sense = Sense::filler;
  std::string value;               // what it stands for, in the program's words
  double number = 0;               // value of a number, millimetres of a unit, factor of an amount
  std::string zone;                // of a product or fixture: the zone type it implies
  std::vector<std::string> words;  // phrases, singular or plural

  static constexpr auto fields = field_list(
      field("sense", &LexiconRow::sense, "part in the sentence", required()),
      field("value", &LexiconRow::value, "what it stands for", at_most_bytes(80)),
      field("number", &LexiconRow::number, "value, factor or millimetres", range(-100, 10000000)),
      field("zone", &LexiconRow::zone, "zone type it implies", at_most_bytes(80)),
      field("words", &LexiconRow::words, "phrases that mean it", required(), at_most_items(400)));
};

struct LexiconFile {
  std::string schema = "market-lexicon/1";
  std::vector<LexiconRow> rows;

  static constexpr auto fields =
      field_list(field("schema", &LexiconFile::schema, "schema tag", constant("market-lexicon/1")),
                 field("rows", &LexiconFile::rows, "one meaning each", required()));
};

class Lexicon {
 public:
  struct Match {
    const LexiconRow* row;
    std::size_t tokens;  // how many it covers
  };

  // Reads every .json file of `folder`, sorted by name. Errors: catalog.missing_data,
  // catalog.bad_row, json.*.
  static Result<Lexicon> load(const std::filesystem::path& folder);

  // The lexicon with the catalogue's own words added.
  Lexicon with_words_of(const catalog::Catalog& catalog) const;

  // All phrases that start at `at`, longest first.
  std::vector<Match> matches(const std::vector<Token>& tokens, std::size_t at) const;
  // The longest phrase that starts at `at`.
  std::optional<Match> longest_match(const std::vector<Token>& tokens, std::size_t at) const;

  // The word that `word` is one slip of the pen away from; nothing for words of fewer than 5
  // letters and for known words.
  std::optional<std::string> corrected(std::string_view word) const;

  bool knows_word(std::string_view stem) const { return vocabulary_.contains(std::string(stem)); }

 private:
  struct Phrase {
    std::vector<std::string> stems;
    std::size_t row;
  };
  Result<void> add_row(LexiconRow row, const std::string& where);
  void add_phrase(std::vector<std::string> stems, std::size_t row);
  // Names of goods, and what variants say of them.
  void add_goods(const catalog::Catalog& catalog);
  void add_if_new(Sense sense,
                  const std::string& value,
                  const std::string& zone,
                  const std::string& words);
  void add_if_new(Sense sense,
                  const std::string& value,
                  const std::string& zone,
                  const std::string& words,
                  std::vector<std::string> stems);

  std::vector<LexiconRow> rows_;
  std::map<std::string, std::vector<Phrase>, std::less<>> phrases_;  // by first stem, longest first
  std::map<std::string, std::uint32_t, std::less<>> vocabulary_;     // stem -> letters it has
};

}  // namespace marketgen::intake
