// Numbers as Chinese writes them: 二百五十, 1米35, 八成五, 三分之一.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "intake/tokens.h"

namespace marketgen::intake {

struct ChineseNumber {
  std::size_t first = 0, last = 0;  // tokens, past the last
  // Of the grammar: number; share (0 to 1); length (millimetres); quantity ("两三", with `upper`).
  std::string_view category = "number";
  double value = 0;
  std::optional<double> upper;
};

// The longest number at each place, in their order, without overlap. None begins at a token that is
// `inside` a word: the 一 of 统一. Numbers of digits alone are not among them: they are read as in
// any language.
std::vector<ChineseNumber> chinese_numbers(const std::vector<Token>& tokens,
                                           const std::vector<bool>& inside);

}  // namespace marketgen::intake
