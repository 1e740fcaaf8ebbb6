// Words of a question, and their full-text expressions.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace marketgen::catalog {

// What counts as one word: a run of letters and digits, or of Chinese characters, each of which is
// a token of its own.
struct SearchWord {
  std::vector<std::string> tokens;
  bool chinese = false;
  std::string text() const;  // as it was written, in lower case
};

// The words of a text in UTF-8, in order. A Chinese run of more than two characters is followed by
// its pairs of neighbours.
std::vector<SearchWord> search_words_of(std::string_view text);

// The text with spaces round each Chinese character, so that each becomes a token of its own.
std::string with_spaced_characters(std::string_view text);

// FTS5 expressions, whatever the tokens are: those tokens side by side, or all of them anywhere.
std::string phrase_expression(const std::vector<std::string>& tokens);
std::string all_expression(const std::vector<std::string>& tokens);

}  // namespace marketgen::catalog
