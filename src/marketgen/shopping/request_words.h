// The words of a request with their places, and the numbers, sums and persons among them.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "shopping/request.h"

namespace marketgen::shopping {

// "and", "or"; ","; ";" and "but".
enum class Break { none, joined, comma, sentence };

struct RequestWord {
  std::string text;                // as it was said
  std::string plain;               // lower case, singular
  std::size_t begin = 0, end = 0;  // bytes of the request
  Break before = Break::none;      // what stands between it and the word before
  bool used = false;               // it was read
};

std::vector<RequestWord> words_of(std::string_view request);

// Their texts with blanks between them, without those that were used.
std::string text_of(const std::vector<RequestWord>& words, std::size_t from, std::size_t to);

// Error shopping.not_understood about these words.
Error not_understood(const std::vector<RequestWord>& words,
                     std::size_t from,
                     std::size_t to,
                     std::string message);

// Reads and marks as used "under 10 €", "at most 15 euros", "with a budget of $20". Nothing when
// none is said. Error: two of them.
Result<std::optional<Budget>> take_budget(std::vector<RequestWord>& words);

// Reads and marks as used "for two", "for four people", "for a family of five" among the words
// [from, to). Error: a number that is none of persons.
Result<std::optional<int>> take_persons(std::vector<RequestWord>& words,
                                        std::size_t from,
                                        std::size_t to);

}  // namespace marketgen::shopping
