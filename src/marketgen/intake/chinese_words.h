// The words of a sentence in Chinese, which writes no spaces: which phrases of the lexicon stand in
// it, and where they are but parts of longer ones.
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "intake/chinese_numbers.h"
#include "intake/lexicon.h"
#include "intake/tokens.h"

namespace marketgen::intake {

// Whether any character is of Chinese script.
bool is_chinese(const std::vector<Token>& sentence);

// 茶叶蛋 hides 茶 and 蛋: a phrase or number within a longer one of Chinese characters is no word
// there. Two that overlap both stand. Of sentences without Chinese nothing is hidden.
class ChineseWords {
 public:
  ChineseWords(const std::vector<Token>& sentence, const Lexicon& lexicon);

  const std::vector<ChineseNumber>& numbers() const { return numbers_; }
  // The number that begins at the token, if it is no part of a longer phrase.
  const ChineseNumber* number_at(std::size_t at) const;
  // Tokens [first, last).
  bool hides(std::size_t first, std::size_t last) const;

 private:
  std::vector<ChineseNumber> numbers_;
  std::vector<std::pair<std::size_t, std::size_t>> compounds_;  // first, past the last
};

}  // namespace marketgen::intake
