#include "perception/said_amounts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "base/text.h"
#include "base/words.h"

namespace marketgen::perception {
namespace {

using Words = std::vector<std::string>;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

// Runs of letters and runs of digits, a point only between digits: "500g" is "500" and "g".
Words pieces_of(std::string_view text) {
  enum class Run { none, letters, digits };
  const std::string low = lower_ascii(text);
  Words words;
  Run run = Run::none;
  for (std::size_t i = 0; i < low.size(); ++i) {
    const char c = low[i];
    const bool point = c == '.' && run == Run::digits && i + 1 < low.size() && is_digit(low[i + 1]);
    const bool apostrophe = c == '\'' && run == Run::letters;
    const Run now = is_digit(c) || point         ? Run::digits
                    : is_letter(c) || apostrophe ? Run::letters
                                                 : Run::none;
    if (now != Run::none && now == run)
      words.back() += c;
    else if (now != Run::none)
      words.emplace_back(1, c);
    run = now;
  }
  return words;
}

struct ReadAmount {
  catalog::NetContent content;
  std::size_t words = 0;
};

// A number, "a" or "half a" before a measure.
std::optional<ReadAmount> measure_at(const Words& words, std::size_t at) {
  const auto has = [&](std::size_t i) { return i < words.size(); };
  std::size_t next = at;
  double number = 1;
  if (words[at] == "half" && has(at + 1) && (words[at + 1] == "a" || words[at + 1] == "an"))
    number = 0.5, next = at + 2;
  else if (words[at] == "a")
    next = at + 1;
  else if (const auto told = said_number(words[at]))
    number = *told, next = at + 1;
  else
    return std::nullopt;
  if (!has(next)) return std::nullopt;
  const auto measure = catalog::net_measure(words[next]);
  if (!measure) return std::nullopt;
  return ReadAmount{{1, number * measure->factor, measure->unit}, next + 1 - at};
}

std::optional<ReadAmount> amount_at(const Words& words, std::size_t at, const Words& counted) {
  const auto number = said_number(words[at]);
  const auto is = [&](std::size_t i, std::string_view word) {
    return i < words.size() && words[i] == word;
  };
  if (number && (is(at + 1, "x") || is(at + 1, "time") || is(at + 1, "times")) &&
      at + 2 < words.size()) {
    if (auto each = measure_at(words, at + 2)) {
      each->content.packs = static_cast<int>(*number);
      each->words += 2;
      return each;
    }
  }
  if (auto measure = measure_at(words, at)) return measure;
  if (!number || at + 1 >= words.size()) return std::nullopt;
  const std::string thing = singular(words[at + 1]);
  if (std::ranges::find(counted, thing) == counted.end()) return std::nullopt;
  return ReadAmount{{1, *number, catalog::NetUnit::piece, thing}, 2};
}

std::string without_possessive(std::string word) {
  if (word.ends_with("'s")) word.resize(word.size() - 2);
  std::erase(word, '\'');
  return word;
}

}  // namespace

std::optional<double> said_number(std::string_view word) {
  constexpr std::array<std::string_view, 13> counted{"",
                                                     "one",
                                                     "two",
                                                     "three",
                                                     "four",
                                                     "five",
                                                     "six",
                                                     "seven",
                                                     "eight",
                                                     "nine",
                                                     "ten",
                                                     "eleven",
                                                     "twelve"};
  for (std::size_t i = 1; i < counted.size(); ++i)
    if (counted[i] == word) return static_cast<double>(i);
  if (word == "twenty") return 20;
  double number = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  if (read.ec != std::errc{} || read.ptr != word.data() + word.size() || !(number > 0))
    return std::nullopt;
  return number;
}

Words plain_words(std::string_view text) {
  Words words;
  for (std::string& piece : pieces_of(text))
    if (std::string word = singular(without_possessive(std::move(piece))); !word.empty())
      words.push_back(std::move(word));
  return words;
}

SaidWords said_words(std::string_view text, const Words& counted) {
  const Words pieces = pieces_of(text);
  SaidWords said;
  std::size_t i = 0;
  if (!pieces.empty() && !measure_at(pieces, 0)) said.count = said_number(pieces.front());
  if (said.count) i = 1;
  while (i < pieces.size()) {
    if (const auto amount = amount_at(pieces, i, counted)) {
      said.amounts.push_back(amount->content);
      i += amount->words;
      continue;
    }
    if (std::string word = singular(without_possessive(pieces[i])); !word.empty())
      said.words.push_back(std::move(word));
    ++i;
  }
  return said;
}

}  // namespace marketgen::perception
