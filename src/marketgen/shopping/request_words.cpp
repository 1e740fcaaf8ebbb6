#include "shopping/request_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/text.h"
#include "base/words.h"
#include "catalog/country.h"
#include "perception/said_amounts.h"
#include "shopping/assortment.h"

namespace marketgen::shopping {
namespace {

constexpr int max_persons = 200;
constexpr std::array<std::string_view, 21> before_sums{
    "under", "below", "up",   "to",     "at",  "most", "max",    "maximum", "less", "than", "no",
    "not",   "more",  "with", "within", "for", "a",    "budget", "of",      "is",   "my"};
constexpr std::array<std::string_view, 3> excluding_words{"no", "without", "except"};
constexpr std::array<std::string_view, 8> limits{
    "under", "below", "most", "max", "maximum", "less", "within", "budget"};
constexpr std::array<std::string_view, 16> person_words{"person",
                                                        "people",
                                                        "adult",
                                                        "child",
                                                        "children",
                                                        "kid",
                                                        "guest",
                                                        "friend",
                                                        "diner",
                                                        "men",
                                                        "women",
                                                        "us",
                                                        "student",
                                                        "colleague",
                                                        "eater",
                                                        "neighbour"};

template <std::size_t N>
bool is_any(const std::array<std::string_view, N>& names, std::string_view word) {
  return std::ranges::find(names, word) != names.end();
}

bool digit(char c) {
  return c >= '0' && c <= '9';
}
bool ascii_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool letter(char c) {
  return ascii_letter(c) || static_cast<unsigned char>(c) >= 0x80;
}

// The sign of some money there, but for those that are letters.
std::string_view sign_at(std::string_view text, std::size_t at) {
  for (const catalog::Country& country : catalog::countries())
    if (!ascii_letter(country.sign.front()) && text.substr(at).starts_with(country.sign))
      return country.sign;
  return {};
}

// Bytes of the word there; 0 when there is none. A comma or point between digits is of a number
// when one or two digits follow it.
std::size_t word_length(std::string_view text, std::size_t at) {
  if (const std::string_view sign = sign_at(text, at); !sign.empty()) return sign.size();
  std::size_t end = at;
  if (digit(text[at])) {
    while (end < text.size() && digit(text[end]))
      ++end;
    if (end + 1 < text.size() && (text[end] == '.' || text[end] == ',') && digit(text[end + 1])) {
      std::size_t after = end + 1;
      while (after < text.size() && digit(text[after]))
        ++after;
      if (text[end] == '.' || after - end <= 3) end = after;
    }
    return end - at;
  }
  while (end < text.size() && sign_at(text, end).empty() &&
         (letter(text[end]) || (end > at && text[end] == '\'')))
    ++end;
  return end - at;
}

Break break_of(char c) {
  constexpr std::string_view sentences = ";.!?\n()", chunks = ",:&+/";
  if (sentences.find(c) != std::string_view::npos) return Break::sentence;
  return chunks.find(c) != std::string_view::npos ? Break::comma : Break::none;
}

// Words that part what stands before and after them. "or" does where things are excluded: "bread or
// rolls" is one wish.
Break break_word(std::string_view plain, bool excluding) {
  if (plain == "but") return Break::sentence;
  constexpr std::array<std::string_view, 4> names{"and", "plus", "also", "then"};
  const bool either = excluding && (plain == "or" || plain == "nor");
  return either || is_any(names, plain) ? Break::joined : Break::none;
}

// Lower case and singular; numbers and signs as they are.
std::string plain_of(const std::string& text) {
  if (!letter(text.front())) return text;
  return std::string(trimmed(spaced_words(text)));
}

std::optional<double> number_in(const RequestWord& word) {
  std::string text = word.plain;
  std::ranges::replace(text, ',', '.');
  return perception::said_number(text);
}

struct Sum {
  std::size_t from = 0, to = 0;
  Budget budget;
};

// "10 €", "€10", or "10" alone behind a word of a limit and before nothing more.
std::optional<Sum> sum_at(const std::vector<RequestWord>& words, std::size_t at) {
  const auto number = number_in(words[at]);
  if (!number) return std::nullopt;
  if (at + 1 < words.size() && words[at + 1].before == Break::none &&
      is_money(words[at + 1].text, words[at + 1].plain))
    return Sum{at, at + 2, {*number, words[at + 1].plain}};
  if (at > 0 && words[at].before == Break::none &&
      is_money(words[at - 1].text, words[at - 1].plain))
    return Sum{at - 1, at + 1, {*number, words[at - 1].plain}};
  const bool last =
      at + 1 == words.size() || words[at + 1].before != Break::none || words[at + 1].plain == "for";
  if (at > 0 && last && is_any(limits, words[at - 1].plain)) return Sum{at, at + 1, {*number, ""}};
  const bool than = at > 1 && words[at - 1].plain == "than" && words[at - 2].plain == "less";
  const bool of = at > 1 && words[at - 2].plain == "budget" &&
                  (words[at - 1].plain == "of" || words[at - 1].plain == "is");
  if (last && (than || of)) return Sum{at, at + 1, {*number, ""}};
  return std::nullopt;
}

// Marks the sum and the words of a limit before it.
void use_sum(std::vector<RequestWord>& words, const Sum& sum) {
  for (std::size_t i = sum.from; i < sum.to; ++i)
    words[i].used = true;
  for (std::size_t i = sum.from; i > 0 && is_any(before_sums, words[i - 1].plain); --i) {
    words[i - 1].used = true;
    if (words[i - 1].before != Break::none) break;
  }
}

bool is_person_word(const RequestWord& word) {
  return is_any(person_words, word.plain);
}

}  // namespace

std::vector<RequestWord> words_of(std::string_view request) {
  std::vector<RequestWord> words;
  Break before = Break::none;
  bool excluding = false;
  for (std::size_t at = 0; at < request.size();) {
    const std::size_t length = word_length(request, at);
    if (length == 0) {
      before = std::max(before, break_of(request[at]));
      ++at;
      continue;
    }
    RequestWord word;
    word.text = request.substr(at, length);
    word.plain = plain_of(word.text);
    word.begin = at;
    word.end = at += length;
    if (const Break breaks = break_word(word.plain, excluding); breaks != Break::none) {
      before = std::max(before, breaks);
      continue;
    }
    if (before == Break::sentence) excluding = false;
    excluding = excluding || is_any(excluding_words, word.plain);
    word.before = std::exchange(before, Break::none);
    words.push_back(std::move(word));
  }
  return words;
}

std::string text_of(const std::vector<RequestWord>& words, std::size_t from, std::size_t to) {
  std::string text;
  for (std::size_t i = from; i < to; ++i)
    if (!words[i].used) text += (text.empty() ? "" : " ") + words[i].text;
  return text;
}

Error not_understood(const std::vector<RequestWord>& words,
                     std::size_t from,
                     std::size_t to,
                     std::string message) {
  std::string said;
  for (std::size_t i = from; i < to; ++i)
    said += (said.empty() ? "" : " ") + words[i].text;
  return {"shopping.not_understood",
          fmt::format("\"{}\" (bytes {} to {})", said, words[from].begin, words[to - 1].end),
          std::move(message)};
}

Result<std::optional<Budget>> take_budget(std::vector<RequestWord>& words) {
  std::optional<Budget> budget;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto sum = words[i].used ? std::nullopt : sum_at(words, i);
    if (!sum) continue;
    if (budget)
      return not_understood(
          words, sum->from, sum->to, "it is the second sum; say one that all may cost together");
    budget = sum->budget;
    use_sum(words, *sum);
  }
  return budget;
}

Result<std::optional<int>> take_persons(std::vector<RequestWord>& words,
                                        std::size_t from,
                                        std::size_t to) {
  constexpr double family = 4, couple = 2;
  double persons = 0;
  for (std::size_t i = from; i < to; ++i) {
    if (words[i].used) continue;
    const bool led = i > from && (words[i - 1].plain == "for" || words[i - 1].plain == "of");
    auto number = number_in(words[i]);
    const bool named = i + 1 < to && is_person_word(words[i + 1]);
    const bool last = i + 1 == to || words[i + 1].used || words[i + 1].plain == "with" ||
                      words[i + 1].plain == "without";
    const bool group = words[i].plain == "family" || words[i].plain == "couple";
    const bool alone = words[i].plain == "me" || words[i].plain == "myself";
    if (group && i > from &&
        (words[i - 1].plain == "a" || words[i - 1].plain == "my" || words[i - 1].plain == "the") &&
        !(i + 2 < to && words[i + 1].plain == "of"))
      number = words[i].plain == "family" ? family : couple;
    else if (alone && led)
      number = 1;
    else if (!number || !(named || (led && last)))
      continue;
    if (*number != std::floor(*number) || persons + *number > max_persons)
      return not_understood(
          words, i, i + 1, fmt::format("say a whole number of persons up to {}", max_persons));
    persons += *number;
    words[i].used = true;
    if (named) words[i + 1].used = true;
    constexpr std::array<std::string_view, 6> leads{"for", "of", "family", "a", "my", "the"};
    for (std::size_t k = i; k > from && is_any(leads, words[k - 1].plain); --k)
      words[k - 1].used = true;
  }
  return persons > 0 ? std::optional(static_cast<int>(persons)) : std::nullopt;
}

}  // namespace marketgen::shopping
