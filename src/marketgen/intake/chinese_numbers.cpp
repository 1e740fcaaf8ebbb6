#include "intake/chinese_numbers.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace marketgen::intake {
namespace {

using Row = std::pair<std::string_view, double>;

constexpr std::array<Row, 15> digit_rows = {{{"〇", 0},
                                             {"零", 0},
                                             {"一", 1},
                                             {"二", 2},
                                             {"两", 2},
                                             {"俩", 2},
                                             {"三", 3},
                                             {"仨", 3},
                                             {"四", 4},
                                             {"五", 5},
                                             {"六", 6},
                                             {"七", 7},
                                             {"八", 8},
                                             {"九", 9},
                                             {"幺", 1}}};
constexpr std::array<Row, 4> scale_rows = {{{"十", 10}, {"百", 100}, {"千", 1000}, {"万", 10000}}};
constexpr double metre_mm = 1000;

template <std::size_t size>
std::optional<double> value_in(const std::array<Row, size>& rows, const Token& token) {
  if (!token.han) return std::nullopt;
  const auto row = std::ranges::find(rows, token.stem, &Row::first);
  return row == rows.end() ? std::nullopt : std::optional(row->second);
}

std::optional<double> digit_of(const Token& token) {
  return value_in(digit_rows, token);
}
std::optional<double> scale_of(const Token& token) {
  return value_in(scale_rows, token);
}

// A number and where it ends.
struct Numeral {
  double value = 0;
  std::size_t last = 0;
  std::optional<double> upper;
  bool plain = true;  // digits alone
};

class NumberReader {
 public:
  explicit NumberReader(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::optional<ChineseNumber> at(std::size_t first) const {
    if (const auto share = share_at(first)) return made("share", first, *share);
    const auto numeral = numeral_at(first);
    if (!numeral) return std::nullopt;
    if (const auto length = length_after(*numeral)) return made("length", first, *length);
    if (numeral->plain) return std::nullopt;
    return made(numeral->upper ? "quantity" : "number", first, *numeral);
  }

 private:
  static ChineseNumber made(std::string_view category, std::size_t first, const Numeral& numeral) {
    return {first, numeral.last, category, numeral.value, numeral.upper};
  }

  bool is(std::size_t at, std::string_view character) const {
    return at < tokens_.size() && tokens_[at].stem == character;
  }
  bool spells(std::size_t at, std::string_view a, std::string_view b) const {
    return is(at, a) && is(at + 1, b);
  }

  // Digits of either kind, or what they make with 十, 百, 千 and 万.
  std::optional<Numeral> numeral_at(std::size_t at) const {
    if (at >= tokens_.size()) return std::nullopt;
    if (tokens_[at].kind == TokenKind::number) return scaled(at);
    auto numeral = written_at(at);
    if (numeral && is(numeral->last, "点")) add_decimals(*numeral);
    return numeral;
  }

  // "3千", "1.5万"
  Numeral scaled(std::size_t at) const {
    Numeral numeral{tokens_[at].number, at + 1, std::nullopt, true};
    while (numeral.last < tokens_.size()) {
      const auto scale = scale_of(tokens_[numeral.last]);
      if (!scale || *scale < 100) break;
      numeral.value *= *scale;
      numeral.plain = false;
      ++numeral.last;
    }
    return numeral;
  }

  std::optional<Numeral> written_at(std::size_t at) const {
    std::size_t last = at;
    bool scales = false;
    while (last < tokens_.size() && (digit_of(tokens_[last]) || scale_of(tokens_[last]))) {
      scales = scales || scale_of(tokens_[last]).has_value();
      ++last;
    }
    if (last == at) return std::nullopt;
    return scales ? positional(at, last) : spelled(at, last);
  }

  // 三千五百, 一万二, 十五
  Numeral positional(std::size_t at, std::size_t end) const {
    constexpr double myriad = 10000;
    double sum = 0, section = 0, digit = 0, last_scale = 0;
    bool zero = false;
    for (std::size_t i = at; i < end; ++i) {
      if (const auto scale = scale_of(tokens_[i])) {
        if (*scale == myriad) {
          sum = (sum + section + digit) * myriad;
          section = 0;
        } else {
          section += (digit == 0 && section == 0 ? 1 : digit) * *scale;
        }
        last_scale = *scale;
        digit = 0;
        zero = false;
      } else {
        digit = digit_of(tokens_[i]).value_or(0);
        zero = zero || digit == 0;
      }
    }
    const bool shortened = digit > 0 && last_scale >= 100 && !zero;  // 一百二 is 120
    sum += section + (shortened ? digit * last_scale / 10 : digit);
    return {sum, end, std::nullopt, false};
  }

  // 五; 二〇 is 20; 三四 is three or four.
  Numeral spelled(std::size_t at, std::size_t end) const {
    const double first = digit_of(tokens_[at]).value_or(0);
    if (end - at == 2 && digit_of(tokens_[at + 1]) == first + 1 && first > 0)
      return {first, end, first + 1, false};
    double value = 0;
    for (std::size_t i = at; i < end; ++i)
      value = value * 10 + digit_of(tokens_[i]).value_or(0);
    return {value, end, std::nullopt, false};
  }

  // 三点五
  void add_decimals(Numeral& numeral) const {
    double place = 1;
    std::size_t at = numeral.last + 1;
    for (; at < tokens_.size() && digit_of(tokens_[at]); ++at)
      numeral.value += digit_of(tokens_[at]).value_or(0) * (place /= 10);
    if (at > numeral.last + 1) numeral.last = at;
  }

  // 八成五, 三分之一, 百分之八十, 一半
  std::optional<Numeral> share_at(std::size_t at) const {
    if (spells(at, "一", "半")) return Numeral{0.5, at + 2, std::nullopt, false};
    if (spells(at, "百", "分") && is(at + 2, "之")) return divided(numeral_at(at + 3), 100);
    const auto numeral = numeral_at(at);
    if (!numeral) return std::nullopt;
    if (spells(numeral->last, "分", "之")) {
      const auto above = numeral_at(numeral->last + 2);
      return numeral->value > 0 ? divided(above, numeral->value) : std::nullopt;
    }
    if (!is(numeral->last, "成") || numeral->value > 10) return std::nullopt;
    Numeral share{numeral->value / 10, numeral->last + 1, std::nullopt, false};
    if (is(share.last, "半")) {
      share.value += 0.05;
      ++share.last;
    } else if (const auto more =
                   share.last < tokens_.size() ? digit_of(tokens_[share.last]) : std::nullopt) {
      share.value += *more / 100;
      ++share.last;
    }
    return share;
  }

  static std::optional<Numeral> divided(std::optional<Numeral> numeral, double by) {
    if (numeral) numeral->value /= by;
    return numeral;
  }

  // 1米35, 三米半, 两米四: what follows the metres is a part of one.
  std::optional<Numeral> length_after(const Numeral& metres) const {
    const std::size_t unit = is(metres.last, "米") ? 1 : spells(metres.last, "公", "尺") ? 2 : 0;
    if (unit == 0) return std::nullopt;
    const std::size_t at = metres.last + unit;
    if (at >= tokens_.size()) return std::nullopt;
    if (is(at, "半")) return Numeral{(metres.value + 0.5) * metre_mm, at + 1, std::nullopt, false};
    double part = 0, place = 1;
    std::size_t last = at;
    if (tokens_[at].kind == TokenKind::number) {
      if (tokens_[at].text.size() > 2 || tokens_[at].text.find('.') != std::string::npos)
        return std::nullopt;
      part = tokens_[at].number * (tokens_[at].text.size() == 1 ? 0.1 : 0.01);
      last = at + 1;
    } else {
      for (; last < tokens_.size() && last < at + 2 && digit_of(tokens_[last]); ++last)
        part += digit_of(tokens_[last]).value_or(0) * (place /= 10);
    }
    if (last == at || is_counted(last)) return std::nullopt;
    return Numeral{(metres.value + part) * metre_mm, last, std::nullopt, false};
  }

  // Whether a number that ends there counts something: "2米5层" is no 2.5 m.
  bool is_counted(std::size_t at) const {
    constexpr std::array<std::string_view, 24> counters = {
        "层", "排", "条", "个", "台", "组", "张", "座", "处", "扇", "根", "米",
        "厘", "公", "平", "成", "分", "十", "百", "千", "列", "道", "套", "块"};
    return at < tokens_.size() &&
           (std::ranges::find(counters, tokens_[at].stem) != counters.end() ||
            digit_of(tokens_[at]) || tokens_[at].kind == TokenKind::number);
  }

  const std::vector<Token>& tokens_;
};

}  // namespace

std::vector<ChineseNumber> chinese_numbers(const std::vector<Token>& tokens,
                                           const std::vector<bool>& inside) {
  std::vector<ChineseNumber> numbers;
  const NumberReader reader(tokens);
  for (std::size_t at = 0; at < tokens.size();) {
    const auto number = inside[at] ? std::nullopt : reader.at(at);
    if (number) numbers.push_back(*number);
    at = number ? number->last : at + 1;
  }
  return numbers;
}

}  // namespace marketgen::intake
