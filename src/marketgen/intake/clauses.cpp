#include "intake/clauses.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace marketgen::intake {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::array<std::string_view, 12> clause_ends = {
    ",", ".", ";", "!", "?", "(", ")", "\n", "，", "。", "；", "！"};
constexpr std::array<std::string_view, 9> sentence_ends = {
    ".", ";", "!", "?", "\n", "。", "；", "！", "？"};

// What follows is no longer wanted, and so is what stands in a clause with these.
constexpr std::array<std::string_view, 14> outdated_after = {"instead of",
                                                             "rather than",
                                                             "scrap",
                                                             "forget",
                                                             "ignore",
                                                             "in place of",
                                                             "moves from",
                                                             "down from",
                                                             "up from",
                                                             "而不是",
                                                             "代替",
                                                             "取代",
                                                             "取消",
                                                             "从原来"};
constexpr std::array<std::string_view, 41> outdated_with = {"is out",
                                                            "are out",
                                                            "ruled out",
                                                            "out of the question",
                                                            "used to",
                                                            "earlier",
                                                            "originally",
                                                            "previously",
                                                            "formerly",
                                                            "at first",
                                                            "no longer",
                                                            "first sketch",
                                                            "first draft",
                                                            "first plan",
                                                            "old plan",
                                                            "old sketch",
                                                            "old draft",
                                                            "last version",
                                                            "rev",
                                                            "revision",
                                                            "at the beginning",
                                                            "once wanted",
                                                            "old version",
                                                            "first version",
                                                            "before that",
                                                            "原来",
                                                            "原先",
                                                            "原本",
                                                            "本来",
                                                            "之前",
                                                            "以前",
                                                            "上一版",
                                                            "旧版",
                                                            "老版",
                                                            "曾经",
                                                            "过去",
                                                            "不再",
                                                            "初稿",
                                                            "先前",
                                                            "起初",
                                                            "一开始"};
// Whoever says these takes something back, also when it stands a sentence before.
constexpr std::array<std::string_view, 32> taken_back = {"no wait",
                                                         "sorry",
                                                         "scratch that",
                                                         "scrap that",
                                                         "forget that",
                                                         "correction",
                                                         "i mean",
                                                         "i meant",
                                                         "my mistake",
                                                         "i was wrong",
                                                         "got that wrong",
                                                         "that was wrong",
                                                         "mixed up",
                                                         "changed my mind",
                                                         "changed her mind",
                                                         "changed his mind",
                                                         "changed our minds",
                                                         "on second thought",
                                                         "on second thoughts",
                                                         "搞错",
                                                         "说错",
                                                         "写错",
                                                         "弄错",
                                                         "记错",
                                                         "不对",
                                                         "哦不",
                                                         "更正",
                                                         "改主意",
                                                         "算了",
                                                         "收回",
                                                         "打错",
                                                         "口误"};
constexpr std::array<std::string_view, 39> replacing = {
    "revised",        "newest",       "new version", "instead",     "actually",   "or rather",
    "make that",      "but now",      "now i want",  "now we want", "now wants",  "now want",
    "is now",         "are now",      "becomes",     "become",      "changed to", "change to",
    "moved to",       "that's final", "after all",   "update",      "updated",    "new plan",
    "latest version", "改成",         "改为",        "改到",        "改放",       "改用",
    "换成",           "改",           "还是",        "现在要",      "后来",       "最后决定",
    "最终",           "以这个为准",   "应该是"};
constexpr std::array<std::string_view, 26> one_more = {
    "another",  "second", "third",  "also", "too",  "additional",   "further", "extra", "as well",
    "one more", "other",  "others", "each", "both", "respectively", "再",      "也",    "另",
    "还",       "第二",   "第三",   "各",   "其他", "其余",         "分别",    "都"};
constexpr std::array<std::string_view, 13> fallback = {"otherwise",
                                                       "failing that",
                                                       "or else",
                                                       "if not",
                                                       "if that",
                                                       "alternatively",
                                                       "plan b",
                                                       "否则",
                                                       "不行就",
                                                       "要不",
                                                       "实在不行",
                                                       "不然",
                                                       "要么"};

constexpr std::array<std::string_view, 19> denying = {"no",
                                                      "not",
                                                      "without",
                                                      "never",
                                                      "don't want",
                                                      "instead of",
                                                      "rather than",
                                                      "nothing",
                                                      "anything but",
                                                      "不要",
                                                      "不是",
                                                      "不用",
                                                      "无",
                                                      "没",
                                                      "别用",
                                                      "别",
                                                      "而不是",
                                                      "不",
                                                      "没有"};
constexpr std::array<std::string_view, 9> between_denial = {
    "a", "an", "any", "the", "like the", "like a", "like", "too", "做成"};
constexpr std::array<std::string_view, 15> no_more = {"only",
                                                      "exactly",
                                                      "just",
                                                      "single",
                                                      "precisely",
                                                      "altogether",
                                                      "in all",
                                                      "in total",
                                                      "no more",
                                                      "只",
                                                      "仅",
                                                      "就",
                                                      "唯一",
                                                      "总共",
                                                      "一共"};

constexpr std::array<std::string_view, 5> abbreviations = {"rev", "ver", "approx", "i.e", "e.g"};

bool is_latin(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

char lowered(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string_view without_blanks(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t\r\"") + 1);
}

// How long the one of the words is that ends the text; 0 where none does.
std::size_t last_word_among(std::string_view text, Words words) {
  for (const std::string_view word : words) {
    if (text.size() < word.size()) continue;
    const std::size_t begin = text.size() - word.size();
    const std::size_t letter = begin > 0 && is_latin(text[begin - 1]) ? begin - 1 : begin;
    if (has_word(text.substr(letter), word)) return word.size();
  }
  return 0;
}

bool is_end(std::string_view text, std::size_t at, std::string_view mark) {
  const auto digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  const bool within_number = at > 0 && digit(at - 1) && digit(at + mark.size());  // "4.50 m"
  const bool shortens = mark == "." && last_word_among(text.substr(0, at), abbreviations) > 0;
  return !within_number && !shortens;
}

// From one mark to the next around the span, without the marks.
IntRange stretch_around(std::string_view prompt, IntRange span, Words marks) {
  const auto first = static_cast<std::size_t>(span[0]), last = static_cast<std::size_t>(span[1]);
  std::size_t begin = 0, end = prompt.size();
  for (const std::string_view mark : marks) {
    for (std::size_t at = prompt.find(mark); at < end; at = prompt.find(mark, at + mark.size())) {
      if (!is_end(prompt, at, mark)) continue;
      if (at < first)
        begin = std::max(begin, at + mark.size());
      else if (at >= last)
        end = at;
    }
  }
  return {static_cast<int>(begin), static_cast<int>(end)};
}

IntRange sentence_of(std::string_view prompt, IntRange span) {
  return stretch_around(prompt, span, sentence_ends);
}

}  // namespace

bool has_word(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) { return lowered(a) == b; };
  for (auto at = text.begin();; ++at) {
    at = std::search(at, text.end(), word.begin(), word.end(), same);
    if (at == text.end()) return false;
    const auto past = at + static_cast<std::ptrdiff_t>(word.size());
    const bool begins = at == text.begin() || !is_latin(*(at - 1)) || !is_latin(word.front());
    const bool ends = past == text.end() || !is_latin(*past) || !is_latin(word.back());
    if (begins && ends) return true;
  }
}

bool has_any_word(std::string_view text, Words words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return has_word(text, word); });
}

std::string_view text_at(std::string_view prompt, IntRange span) {
  return prompt.substr(static_cast<std::size_t>(span[0]),
                       static_cast<std::size_t>(std::max(0, span[1] - span[0])));
}

IntRange clause_of(std::string_view prompt, IntRange span) {
  const IntRange clause = stretch_around(prompt, span, clause_ends);
  const auto first = static_cast<std::size_t>(span[0]), last = static_cast<std::size_t>(span[1]);
  const std::string_view blank = " \t\r";
  const std::size_t begin =
      std::min(prompt.find_first_not_of(blank, static_cast<std::size_t>(clause[0])), first);
  const std::size_t end =
      std::max(prompt.find_last_not_of(blank, static_cast<std::size_t>(clause[1]) - 1) + 1, last);
  return {static_cast<int>(begin), static_cast<int>(end)};
}

bool in_one_sentence(std::string_view prompt, IntRange a, IntRange b) {
  const IntRange sentence = sentence_of(prompt, a);
  return b[0] >= sentence[0] && b[1] <= sentence[1];
}

bool is_outdated(std::string_view prompt, IntRange span) {
  const IntRange clause = clause_of(prompt, span);
  return has_any_word(text_at(prompt, clause), outdated_with) ||
         has_any_word(text_at(prompt, {clause[0], span[1]}), outdated_after);
}

bool is_denied(std::string_view prompt, IntRange span) {
  std::string_view before = without_blanks(text_at(prompt, {clause_of(prompt, span)[0], span[0]}));
  before.remove_suffix(last_word_among(before, between_denial));
  return last_word_among(without_blanks(before), denying) > 0;
}

bool is_no_more(std::string_view prompt, IntRange span) {
  return has_any_word(text_at(prompt, clause_of(prompt, span)), no_more);
}

bool is_moved(std::string_view prompt, IntRange earlier, IntRange later) {
  constexpr std::array<std::string_view, 4> moving = {
      "moves from", "moved from", "move from", "从"};
  return earlier[0] == later[0] && has_any_word(text_at(prompt, earlier), moving);
}

bool takes_its_place(std::string_view prompt, IntRange earlier, IntRange later) {
  if (is_moved(prompt, earlier, later)) return true;
  const int from = earlier[1], to = clause_of(prompt, later)[1];
  const IntRange sentence = sentence_of(prompt, later);
  const IntRange before = sentence_of(prompt, {std::max(0, sentence[0] - 4), sentence[0]});
  return has_any_word(text_at(prompt, {std::max(from, sentence[0]), to}), replacing) ||
         has_any_word(text_at(prompt, {std::max(from, before[0]), to}), taken_back);
}

bool is_one_more(std::string_view prompt, IntRange span) {
  return has_any_word(text_at(prompt, clause_of(prompt, span)), one_more);
}

bool is_fallback(std::string_view prompt, IntRange span) {
  const int from = sentence_of(prompt, span)[0], to = clause_of(prompt, span)[1];
  return has_any_word(text_at(prompt, {from, to}), fallback);
}

}  // namespace marketgen::intake
