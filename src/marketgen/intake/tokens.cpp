#include "intake/tokens.h"

#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <memory>

#include "base/words.h"
#include "intake/han.h"

namespace marketgen::intake {
namespace {

enum class Glyph { space, newline, letter, han, digit, superscript, symbol };

struct Character {
  int code = 0;
  int first = 0, last = 0;  // bytes
  Glyph glyph = Glyph::space;
  bool upper = false;
};

Glyph glyph_of(int code) {
  if (code == '\n' || code == 0x2028 || code == 0x2029) return Glyph::newline;
  if (is_han(code)) return Glyph::han;
  switch (utf8proc_category(code)) {
    case UTF8PROC_CATEGORY_LU:
    case UTF8PROC_CATEGORY_LL:
    case UTF8PROC_CATEGORY_LT:
    case UTF8PROC_CATEGORY_LM:
    case UTF8PROC_CATEGORY_LO:
    case UTF8PROC_CATEGORY_MN:
    case UTF8PROC_CATEGORY_MC:
    case UTF8PROC_CATEGORY_ME:
      return Glyph::letter;
    case UTF8PROC_CATEGORY_ND:
      return Glyph::digit;
    case UTF8PROC_CATEGORY_NO:
      return Glyph::superscript;
    case UTF8PROC_CATEGORY_ZS:
    case UTF8PROC_CATEGORY_CC:
    case UTF8PROC_CATEGORY_CF:
      return Glyph::space;
    default:
      return Glyph::symbol;
  }
}

std::vector<Character> characters_of(std::string_view prompt) {
  std::vector<Character> characters;
  int at = 0;
  const int size = static_cast<int>(prompt.size());
  while (at < size) {
    utf8proc_int32_t code = 0;
    const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(prompt.data()) + at;
    const auto length = static_cast<int>(utf8proc_iterate(bytes, size - at, &code));
    if (length <= 0) break;  // not UTF-8: the caller has checked
    characters.push_back(
        {code, at, at + length, glyph_of(code), utf8proc_category(code) == UTF8PROC_CATEGORY_LU});
    at += length;
  }
  return characters;
}

bool is_apostrophe(int code) {
  return code == '\'' || code == 0x2019 || code == 0x02BC;
}
bool is_dash(int code) {
  return code == '-' || (code >= 0x2010 && code <= 0x2015);
}
bool is_double_quote(int code) {
  const bool corner = code >= 0x300C && code <= 0x300F;  // 「」『』
  const bool title = code == 0x300A || code == 0x300B;   // 《》
  return code == '"' || (code >= 0x201C && code <= 0x201F) || code == 0xAB || code == 0xBB ||
         corner || title;
}
bool is_bullet(int code) {
  return is_dash(code) || code == '*' || code == 0x2022;
}

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view prompt)
      : prompt_(prompt), characters_(characters_of(prompt)) {}

  std::vector<Token> run() {
    at_ = numbering();
    while (at_ < characters_.size())
      take_next();
    return std::move(tokens_);
  }

 private:
  const Character& here(std::size_t ahead = 0) const {
    static constexpr Character nothing{};
    return at_ + ahead < characters_.size() ? characters_[at_ + ahead] : nothing;
  }

  Token token_of(std::size_t first, std::size_t last, TokenKind kind) const {
    Token token;
    token.kind = kind;
    token.span = {characters_[first].first, characters_[last - 1].last};
    token.text = fold(prompt_.substr(static_cast<std::size_t>(token.span[0]),
                                     static_cast<std::size_t>(token.span[1] - token.span[0])));
    token.stem = token.text;
    token.capital = characters_[first].upper;
    return token;
  }

  void take_next() {
    switch (here().glyph) {
      case Glyph::space:
        ++at_;
        break;
      case Glyph::newline:
        take_newline();
        break;
      case Glyph::letter:
        take_word();
        break;
      case Glyph::han:
        take_character();
        break;
      case Glyph::digit:
        take_number();
        break;
      default:
        take_symbol();
    }
  }

  // A line break ends the sentence when the next line is blank or starts with a bullet or a
  // number, and in Chinese; otherwise text was only wrapped.
  void take_newline() {
    const std::size_t start = at_++;
    while (here().glyph == Glyph::space && at_ < characters_.size())
      ++at_;
    const bool bullet = is_bullet(here().code) && here(1).glyph == Glyph::space;
    const std::size_t number = numbering();
    const bool chinese =
        here().glyph == Glyph::han || (!tokens_.empty() && tokens_.back().han && number == 0);
    if (here().glyph != Glyph::newline && !bullet && number == 0 && !chinese) return;
    tokens_.push_back(token_of(start, start + 1, TokenKind::sentence_end));
    at_ += bullet ? 1 : number;
  }

  std::size_t digits_at(std::size_t ahead) const {
    std::size_t digits = 0;
    while (here(ahead + digits).glyph == Glyph::digit)
      ++digits;
    return digits;
  }

  // Characters of "3.", "3、" or "3.1" that begin a line; 0 when none do. "3.5 m" does not.
  std::size_t numbering() {
    const std::size_t digits = digits_at(0);
    if (digits == 0 || digits > 2 || at_ + digits >= characters_.size()) return 0;
    const int code = here(digits).code;
    const bool mark =
        code == '.' || code == ')' || code == 0x3001 || code == 0xFF09 || code == 0xFF0E;
    const std::size_t further = digits_at(digits + 1);
    if (mark && further == 0) return at_ + digits + 1 < characters_.size() ? digits + 1 : 0;
    const bool section = code == '.' && further <= 2 && is_section(digits, further);
    return section ? digits + 1 + further : 0;
  }

  int value_at(std::size_t ahead, std::size_t digits) const {
    int value = 0;
    for (std::size_t i = 0; i < digits; ++i)
      value = 10 * value + here(ahead + i).code - '0';
    return value;
  }

  // "2.3 Windows" is a section when 2.2 began a line before, and "2.1 Floor" begins one.
  bool is_section(std::size_t digits, std::size_t further) {
    const bool spaced = here(digits + 1 + further).glyph == Glyph::space &&
                        here(digits + 2 + further).glyph == Glyph::letter;
    const std::array number = {value_at(0, digits), value_at(digits + 1, further)};
    const bool first = number[1] == 1 && here(digits + 2 + further).upper;
    const bool next = number[0] == section_[0] && number[1] == section_[1] + 1;
    if (!spaced || (!first && !next)) return false;
    section_ = number;
    return true;
  }

  void take_character() {
    Token token = token_of(at_, at_ + 1, TokenKind::word);
    token.stem = simplified(token.text);
    token.han = true;
    tokens_.push_back(std::move(token));
    ++at_;
  }

  void take_word() {
    const std::size_t start = at_;
    const auto apostrophe_inside = [&] {
      return is_apostrophe(here().code) && here(1).glyph == Glyph::letter;
    };
    while (here().glyph == Glyph::letter || apostrophe_inside())
      ++at_;
    take_exponent(start);
    Token token = token_of(start, at_, TokenKind::word);
    if (token.text.ends_with("'s")) token.text.resize(token.text.size() - 2);
    token.stem = singular(token.text);
    tokens_.push_back(std::move(token));
  }

  // "m²" and "m2" are one unit; "aisle2" is not.
  void take_exponent(std::size_t start) {
    if (here().glyph == Glyph::superscript) {
      ++at_;
      return;
    }
    const bool short_unit = at_ - start <= 2 && characters_[start].code != 'x';  // not "12x2"
    if (short_unit && here().code == '2' && here(1).glyph != Glyph::digit) ++at_;
  }

  // Digits with thousands separators ("4,000", "4 000" is two numbers) and a decimal point or
  // comma.
  void take_number() {
    const std::size_t start = at_;
    std::string digits;
    const auto take_digits = [&] {
      int count = 0;
      for (; here().glyph == Glyph::digit; ++at_, ++count) {
        digits += fold(prompt_.substr(static_cast<std::size_t>(here().first),
                                      static_cast<std::size_t>(here().last - here().first)));
      }
      return count;
    };
    const auto digits_after = [&] {
      std::size_t count = 0;
      while (here(1 + count).glyph == Glyph::digit)
        ++count;
      return count;
    };
    take_digits();
    while (here().code == ',' && digits_after() == 3) {
      ++at_;
      take_digits();
    }
    const bool point = here().code == '.' || here().code == ',' || here().code == 0xFF0E;
    if (point && digits_after() > 0) {
      ++at_;
      digits += '.';
      take_digits();
    }
    Token token = token_of(start, at_, TokenKind::number);
    token.text = token.stem = digits;
    std::from_chars(digits.data(), digits.data() + digits.size(), token.number);
    tokens_.push_back(std::move(token));
  }

  void take_symbol() {
    const std::size_t start = at_++;
    const int code = characters_[start].code;
    Token token = token_of(start, at_, TokenKind::symbol);
    if (is_dash(code)) {
      if (joins_words(start)) return;
      // A dash between digits spans a range, one between spaces parts clauses.
      token.text = between_digits(start) ? "-" : ",";
    }
    if (code == 0xD7) token.text = "x";  // multiplication sign
    if (is_double_quote(code)) token.text = "\"";
    if (is_apostrophe(code)) token.text = "'";
    if (follows_number(start) && is_apostrophe(code)) return add_unit(token, "foot");
    if (follows_number(start) && is_double_quote(code) && !quote_is_open_)
      return add_unit(token, "inch");
    if (is_double_quote(code)) quote_is_open_ = !quote_is_open_;
    if (code == '.' && ends_inches()) return;
    if (ends_sentence(code)) token.kind = TokenKind::sentence_end;
    token.stem = token.text;
    tokens_.push_back(std::move(token));
  }

  bool follows_number(std::size_t mark) const {
    return mark > 0 && characters_[mark - 1].glyph == Glyph::digit &&
           here().glyph != Glyph::letter && !tokens_.empty() &&
           tokens_.back().kind == TokenKind::number;
  }

  // 4'6" is a length.
  void add_unit(Token mark, const char* unit) {
    mark.kind = TokenKind::word;
    mark.text = mark.stem = unit;
    tokens_.push_back(std::move(mark));
  }

  bool joins_words(std::size_t dash) const {
    const auto part = [&](std::size_t i) {
      const Glyph glyph = characters_[i].glyph;
      return glyph == Glyph::letter || glyph == Glyph::digit;
    };
    return dash > 0 && dash + 1 < characters_.size() && part(dash - 1) && part(dash + 1) &&
           !between_digits(dash);
  }

  bool between_digits(std::size_t dash) const {
    const auto digit = [&](std::size_t i) { return characters_[i].glyph == Glyph::digit; };
    return dash > 0 && dash + 1 < characters_.size() && digit(dash - 1) && digit(dash + 1);
  }

  // "14 in.": the word before is a unit and the dot belongs to it.
  bool ends_inches() {
    const std::size_t count = tokens_.size();
    const bool unit = count >= 2 && tokens_[count - 1].text == "in" &&
                      tokens_[count - 2].kind == TokenKind::number;
    if (unit) tokens_[count - 1].text = tokens_[count - 1].stem = "inch";
    return unit;
  }

  bool ends_sentence(int code) const {
    constexpr std::array<std::string_view, 8> abbreviations = {
        "sq", "approx", "max", "min", "ca", "incl", "excl", "dept"};
    constexpr std::array<int, 7> ends = {'!', '?', ';', 0x3002, 0xFF01, 0xFF1F, 0xFF1B};
    if (std::ranges::find(ends, code) != ends.end()) return true;
    if (code != '.' || is_initial()) return false;
    for (const std::string_view word : abbreviations) {
      if (!tokens_.empty() && tokens_.back().text == word) return false;
    }
    return true;
  }

  // "5 p.m.": its second dot ends a sentence only before a capital letter.
  bool is_half_of_day() const {
    const std::size_t count = tokens_.size();
    if (count < 3 || tokens_[count - 1].text != "m" || tokens_[count - 2].text != ".") return false;
    const std::string& letter = tokens_[count - 3].text;
    return (letter == "a" || letter == "p") && !(here().glyph == Glyph::space && here(1).upper);
  }

  // The dots of "i.e." and "e.g.": after one letter that follows such a dot or is followed by one.
  bool is_initial() const {
    if (is_half_of_day()) return true;
    const bool letter = !tokens_.empty() && tokens_.back().kind == TokenKind::word &&
                        tokens_.back().text.size() == 1 && tokens_.back().text != "m";
    if (!letter) return false;
    const bool more = here().glyph == Glyph::letter && here(1).code == '.';
    const std::size_t count = tokens_.size();
    return more || (count >= 2 && tokens_[count - 2].text == ".");
  }

  std::string_view prompt_;
  std::vector<Character> characters_;
  std::size_t at_ = 0;
  std::array<int, 2> section_ = {0, 0};  // the last one that began a line
  bool quote_is_open_ = false;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokenize(std::string_view prompt) {
  return Tokenizer(prompt).run();
}

std::string fold(std::string_view text) {
  utf8proc_uint8_t* folded = nullptr;
  const utf8proc_ssize_t length =
      utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                   static_cast<utf8proc_ssize_t>(text.size()),
                   &folded,
                   static_cast<utf8proc_option_t>(UTF8PROC_COMPAT | UTF8PROC_COMPOSE |
                                                  UTF8PROC_STABLE | UTF8PROC_CASEFOLD));
  const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(folded, &std::free);
  if (length < 0) return std::string(text);
  std::string result(reinterpret_cast<const char*>(folded), static_cast<std::size_t>(length));
  constexpr std::string_view curly_apostrophe = "\xE2\x80\x99";
  for (std::size_t at = result.find(curly_apostrophe); at != std::string::npos;
       at = result.find(curly_apostrophe, at)) {
    result.replace(at, curly_apostrophe.size(), "'");
  }
  return result;
}

}  // namespace marketgen::intake
