#include "intake/chinese_words.h"

#include <algorithm>

namespace marketgen::intake {

bool is_chinese(const std::vector<Token>& sentence) {
  return std::ranges::any_of(sentence, &Token::han);
}

ChineseWords::ChineseWords(const std::vector<Token>& sentence, const Lexicon& lexicon) {
  if (!is_chinese(sentence)) return;
  std::vector<bool> inside(sentence.size(), false);
  for (std::size_t at = 0; at < sentence.size(); ++at) {
    const auto match = lexicon.longest_match(sentence, at);
    if (!match || match->tokens < 2 || !sentence[at].han) continue;
    compounds_.emplace_back(at, at + match->tokens);
    std::fill_n(inside.begin() + static_cast<std::ptrdiff_t>(at) + 1, match->tokens - 1, true);
  }
  numbers_ = chinese_numbers(sentence, inside);
  for (const ChineseNumber& number : numbers_)
    compounds_.emplace_back(number.first, number.last);
}

const ChineseNumber* ChineseWords::number_at(std::size_t at) const {
  const auto found = std::ranges::find(numbers_, at, &ChineseNumber::first);
  return found == numbers_.end() || hides(found->first, found->last) ? nullptr : &*found;
}

bool ChineseWords::hides(std::size_t first, std::size_t last) const {
  return std::ranges::any_of(compounds_, [&](const auto& compound) {
    return compound.first <= first && last <= compound.second &&
           last - first < compound.second - compound.first;
  });
}

}  // namespace marketgen::intake
