// Words of a prompt with the bytes they came from.
//
// Text is folded per token (Unicode NFKC and case folding, typographic quotes made plain), so
// "ＢＡＫＥＲＹ", "Bakery" and "bakery" are one word, and every span still points into the prompt
// as it was written.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"

namespace marketgen::intake {

enum class TokenKind { word, number, symbol, sentence_end };

struct Token {
  TokenKind kind = TokenKind::word;
  std::string text;      // folded; numbers without thousands separators
  std::string stem;      // words: the singular, of Chinese script the simplified character;
                         // otherwise the text
  double number = 0;     // of a number token
  IntRange span{0, 0};   // bytes of the prompt: first, past the last
  bool capital = false;  // starts with an upper-case letter, as names do
  bool han = false;      // one character of Chinese script
};

// Precondition: valid UTF-8. Hyphens inside a word join nothing: "self-checkout" is two words.
// "24x15m" is four tokens, "m²" and "m2" are one. Of Chinese, which has no spaces, every character
// is a word of its own; phrases of the lexicon span several (lexical_input.h). Sentences end at
// . ! ? ; and theirs of full width, at blank, bulleted or numbered lines, and at each line of
// Chinese.
std::vector<Token> tokenize(std::string_view prompt);

// Folds one word or phrase as tokens are folded.
std::string fold(std::string_view text);

}  // namespace marketgen::intake
