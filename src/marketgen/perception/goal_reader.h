// Which product of the catalogue words mean: "two cans of sugar-free cola by Kurano".
#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/net_content.h"
#include "catalog/product.h"
#include "catalog/search_lexicon.h"

namespace marketgen::perception {

class GoalReader {
 public:
  virtual ~GoalReader() = default;
  // SKUs, the likeliest first: one, or as many as the words fit about equally well. Errors:
  // perception.not_understood, they fit no product.
  virtual Result<std::vector<std::string>> read(const std::string& text) const = 0;
};

// Reads by the catalogue's own words. Immutable; any number of threads may ask.
//
//   1. Amounts ("half a litre", "6 x 330 ml", "twenty bags") are read first. A row of as much
//      counts 12 more, one of another amount 12 less, when any row has it.
//   2. Every other word counts by how rare it is among the rows (log of rows over rows with it),
//      times the weight of the best place that has it: name 5, variant 4, brand 4, keywords 3,
//      shape, what people call it (catalog/container_nouns.inc) and group 2, category and colour of
//      the label 1, description 0.5. Endings and order do not matter; words that say nothing
//      (SearchLexicon::skip) are left out, but for those that are a row's shape or what people call
//      it: "can".
//   3. One, two or three words that are `say` of an intent count also as what it means, times 0.6.
//      "without X" is also "X free", "no X" and "zero X".
//   4. A word of a row's name that is not said takes away 0.15 of what it would have given.
//   5. Best first; rows within 2 % of the best are read as well. Ties: by SKU.
class CatalogueReader : public GoalReader {
 public:
  CatalogueReader(const std::vector<catalog::Product>& rows, const catalog::SearchLexicon& lexicon);
  Result<std::vector<std::string>> read(const std::string& text) const override;
  // Whether the word, as of plain_words(), is in a row or has a meaning.
  bool knows(std::string_view word) const;

 private:
  struct Row {
    std::string sku;
    std::map<std::string, double, std::less<>> weights;  // of its words
    std::vector<std::string> name;
    std::string named;  // spaced words of name, variant and keywords
    std::optional<catalog::NetContent> net;
  };
  // Phrases, each as words.
  struct Meaning {
    std::vector<std::string> say;
    std::vector<std::vector<std::string>> means;
  };
  void add_row(const catalog::Product& product);
  void add_intent(const catalog::SearchIntent& intent);
  double rarity(std::string_view word) const;
  double word_worth(const Row& row, const std::string& word) const;
  double meaning_worth(const Row& row, const Meaning& meaning) const;
  double group_worth(const Row& row, const std::vector<std::string>& words, std::size_t at) const;
  double absence_worth(const Row& row, const std::string& word) const;
  double words_worth(const Row& row, const std::vector<std::string>& words) const;
  double unsaid_worth(const Row& row, const std::set<std::string>& said) const;
  bool any_of_amount(const catalog::NetContent& amount) const;

  std::vector<Row> rows_;             // by SKU
  std::vector<std::string> counted_;  // what rows' amounts count: "roll", "bag"
  std::map<std::string, int, std::less<>> rows_with_;
  std::map<std::string, std::vector<Meaning>, std::less<>> meanings_;  // by first word said
  std::set<std::string, std::less<>> skip_, without_;
};

}  // namespace marketgen::perception
