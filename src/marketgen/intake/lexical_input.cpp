#include "intake/lexical_input.h"

#include <cmath>
#include <map>
#include <optional>

#include "intake/chinese_words.h"

namespace marketgen::intake {
namespace {

constexpr double filler_cost = 0.1, suffix_cost = 1, unknown_cost = 2;  // of passing over one
constexpr double next_unknown_cost = 0.5;  // of a further character of the same unknown Chinese
constexpr char has[] = "has";

// A word of the grammar's own that says nothing when no construction takes it.
bool is_small_word(const Segment& segment) {
  return segment.sense == Sense::word && !segment.content;
}

bool is_word_number(const LexiconRow& row) {
  return row.sense == Sense::number;
}

// What number words in a row make: 2 and 100 "two hundred", 20 and 5 "twenty-five", 300 and 20
// "three hundred and twenty"; nothing when they are two numbers.
std::optional<double> composed(double so_far, double next) {
  if ((next == 100 && so_far < 100) || (next == 1000 && so_far < 1000)) return so_far * next;
  const auto ends_in = [&](double unit) { return so_far >= unit && std::fmod(so_far, unit) == 0; };
  const bool digit_after_tens = ends_in(10) && !ends_in(100) && so_far >= 20 && next < 10;
  if (digit_after_tens || (ends_in(100) && next < 100) || (ends_in(1000) && next < 1000))
    return so_far + next;
  return std::nullopt;
}

class InputMaker {
 public:
  InputMaker(const std::vector<Token>& sentence,
             const std::vector<Segment>& segments,
             const Lexicon& lexicon)
      : tokens_(sentence), segments_(segments), lexicon_(lexicon), chinese_(sentence, lexicon) {}

  language::Input run() {
    find_shared_heads();
    for (const Segment& segment : segments_)
      add_tokens(segment);
    for (std::size_t at = 0; at < tokens_.size(); ++at) {
      add_rows(at);
      add_number(at);
    }
    return std::move(input_);
  }

 private:
  void add_tokens(const Segment& segment) {
    for (std::size_t at = segment.first; at < segment.last; ++at) {
      language::InputToken token{tokens_[at].stem, tokens_[at].span};
      const bool mark = tokens_[at].kind == TokenKind::symbol && segment.sense == Sense::ordinary;
      const bool filler = segment.sense == Sense::filler || segment.sense == Sense::strength ||
                          is_small_word(segment) || mark;
      const bool passed = filler && segment.value != has;
      const bool unknown = segment.sense == Sense::ordinary && tokens_[at].kind == TokenKind::word;
      const bool suffix = segment.sense == Sense::suffix;
      const bool goes_on = tokens_[at].han && !input_.tokens.empty() && tokens_[at - 1].han &&
                           input_.tokens.back().skip_cost >= next_unknown_cost;
      token.skip_cost = passed               ? filler_cost
                        : suffix             ? suffix_cost
                        : goes_on && unknown ? next_unknown_cost
                        : unknown            ? unknown_cost
                                             : -1;
      token.counts = !filler && segment.sense != Sense::separator;
      input_.tokens.push_back(std::move(token));
    }
  }

  void add(std::size_t first, std::size_t last, std::string_view category, language::Meaning what) {
    input_.entries.push_back(
        {static_cast<int>(first), static_cast<int>(last), std::string(category), std::move(what)});
  }

  // "Oat, soy and almond milk": one word each, and what it is with the last word of the list.
  void find_shared_heads() {
    for (std::size_t at = 2; at < tokens_.size(); ++at) {
      for (const Lexicon::Match& match : lexicon_.matches(tokens_, at)) {
        if (match.row->sense == Sense::product && match.tokens >= 2)
          share_head(at, tokens_[at + match.tokens - 1]);
      }
    }
  }

  void share_head(std::size_t first, const Token& head) {
    while (first >= 2 && is_list_mark(first - 1)) {
      const bool two = first >= 3 && is_list_mark(first - 2);  // ", and"
      const std::size_t at = first - (two ? 3 : 2);
      const LexiconRow* row = product_of(tokens_[at], head);
      if (row == nullptr) return;
      shared_heads_[at] = row;
      first = at;
    }
  }

  bool is_list_mark(std::size_t at) const {
    const auto match = lexicon_.longest_match(tokens_, at);
    return match && match->tokens == 1 && match->row->sense == Sense::separator &&
           (match->row->value == "," || match->row->value == "and" || match->row->value == "or");
  }

  // What both words are together; nothing where the first says something by itself: a plural, or
  // a zone.
  const LexiconRow* product_of(const Token& word, const Token& head) const {
    if (word.kind != TokenKind::word || (!word.han && word.text != word.stem)) return nullptr;
    for (const Lexicon::Match& alone : lexicon_.matches({word}, 0))
      if (alone.row->sense == Sense::zone) return nullptr;
    const auto both = lexicon_.longest_match({word, head}, 0);
    const bool goods = both && both->tokens == 2 && both->row->sense == Sense::product;
    return goods ? both->row : nullptr;
  }

  static language::Meaning meaning_of(const LexiconRow& row) {
    language::Meaning what;
    if (!row.value.empty()) what.slots["value"] = row.value;
    if (row.number != 0) what.slots["number"] = row.number;
    if (!row.zone.empty()) what.slots["zone"] = row.zone;
    return what;
  }

  void add_rows(std::size_t at) {
    const auto shared = shared_heads_.find(at);
    if (shared != shared_heads_.end())
      add(at, at + 1, name_of(Sense::product), meaning_of(*shared->second));
    const std::vector<Lexicon::Match> matches = lexicon_.matches(tokens_, at);
    for (const Lexicon::Match& match : matches) {
      const LexiconRow& row = *match.row;
      if (is_word_number(row) || chinese_.hides(at, at + match.tokens)) continue;
      const bool other_goods = row.sense == Sense::product && match.tokens == 1;
      if (shared != shared_heads_.end() && other_goods) continue;
      language::Meaning what = meaning_of(row);
      const bool is_has = row.sense == Sense::filler && row.value == has;
      const bool unknown = row.sense == Sense::ordinary;
      add(at,
          at + match.tokens,
          is_has                     ? std::string_view(has)
          : row.sense == Sense::word ? std::string_view(row.value)
          : unknown                  ? "unknown"
                                     : name_of(row.sense),
          std::move(what));
    }
    const bool known =
        !matches.empty() || shared != shared_heads_.end() || chinese_.hides(at, at + 1);
    if (!known && tokens_[at].kind == TokenKind::word) add(at, at + 1, "unknown", {});
  }

  void add_chinese_number(const ChineseNumber& number) {
    language::Meaning what;
    what.slots["value"] = number.value;
    if (number.upper) what.slots["upper"] = *number.upper;
    add(number.first, number.last, number.category, std::move(what));
  }

  struct Numeral {
    double value = 0;
    std::size_t last = 0;  // past it
  };

  std::optional<Numeral> word_at(std::size_t at) const {
    if (at >= tokens_.size()) return std::nullopt;
    if (const auto match = lexicon_.longest_match(tokens_, at);
        match && is_word_number(*match->row))
      return Numeral{match->row->number, at + match->tokens};
    return std::nullopt;
  }

  bool continues_number(std::size_t at) const {
    return at > 0 && tokens_[at - 1].kind == TokenKind::number && is_thousands(at - 1);
  }

  // Spaces part thousands in many languages. No shop is that large, so "200 300" is two numbers.
  bool is_thousands(std::size_t at) const {
    constexpr double max_thousands = 99;
    return at + 1 < tokens_.size() && tokens_[at].number <= max_thousands &&
           tokens_[at + 1].kind == TokenKind::number && tokens_[at + 1].text.size() == 3 &&
           tokens_[at + 1].text.find('.') == std::string::npos &&
           tokens_[at + 1].span[0] == tokens_[at].span[1] + 1;
  }

  void add_number(std::size_t at) {
    if (const ChineseNumber* written = chinese_.number_at(at)) return add_chinese_number(*written);
    if (chinese_.hides(at, at + 1)) return;
    std::optional<Numeral> number;
    if (tokens_[at].kind == TokenKind::number) {
      if (continues_number(at)) return;
      number = Numeral{tokens_[at].number, at + 1};
      if (is_thousands(at)) {
        number->value = number->value * 1000 + tokens_[at + 1].number;
        ++number->last;
      }
      const auto scale = word_at(number->last);  // "2 hundred"
      if (scale && scale->value >= 100) number = {number->value * scale->value, scale->last};
    } else {
      number = word_at(at);
      if (!number) return;
      *number = composed_from(*number);
    }
    language::Meaning what;
    what.slots["value"] = number->value;
    add(at, number->last, "number", std::move(what));
  }

  Numeral composed_from(Numeral number) const {
    while (true) {
      const bool joined = number.last < tokens_.size() && tokens_[number.last].stem == "and";
      const auto next = word_at(number.last + (joined ? 1 : 0));
      if (!next || (joined && number.value < 100)) return number;
      const auto sum = composed(number.value, next->value);
      if (!sum) return number;
      number = {*sum, next->last};
    }
  }

  const std::vector<Token>& tokens_;
  const std::vector<Segment>& segments_;
  const Lexicon& lexicon_;
  ChineseWords chinese_;
  std::map<std::size_t, const LexiconRow*> shared_heads_;  // by the token of the first word
  language::Input input_;
};

}  // namespace

std::vector<Segment> segments_of(const std::vector<Token>& sentence, const Lexicon& lexicon) {
  const ChineseWords chinese(sentence, lexicon);
  std::vector<Segment> segments;
  for (std::size_t at = 0; at < sentence.size();) {
    const auto match = lexicon.longest_match(sentence, at);
    const ChineseNumber* number = chinese.number_at(at);
    Segment segment;
    segment.first = at;
    segment.last = number ? number->last : at + (match ? match->tokens : 1);
    const bool digits = !match && sentence[at].kind == TokenKind::number;
    if (number != nullptr || digits) {
      segment.sense = Sense::number;
    } else if (match) {
      segment.sense = match->row->sense;
      segment.value = match->row->value;
      segment.content = match->row->number != 0;
    }
    at = segment.last;
    segments.push_back(std::move(segment));
  }
  return segments;
}

language::Input lexical_input(const std::vector<Token>& sentence,
                              const std::vector<Segment>& segments,
                              const Lexicon& lexicon) {
  return InputMaker(sentence, segments, lexicon).run();
}

}  // namespace marketgen::intake
