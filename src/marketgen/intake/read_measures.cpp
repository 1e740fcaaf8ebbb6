#include <algorithm>
#include <array>
#include <optional>

#include "intake/floor_owner.h"
#include "intake/reading.h"

namespace marketgen::intake {
namespace {

constexpr double metre_mm = 1000;
// Two bare numbers are metres when a shop could have that size.
constexpr double min_store_m = 4;
constexpr double max_store_m = 200;

bool is_length(const Sentence& sentence, std::size_t i) {
  return sentence.is(i, Sense::number) && sentence.at(i).measured &&
         sentence.at(i).value == "length";
}
bool is_area(const Sentence& sentence, std::size_t i) {
  return sentence.is(i, Sense::number) && sentence.at(i).measured && sentence.at(i).value == "area";
}
bool is_bare(const Sentence& sentence, std::size_t i) {
  return sentence.is(i, Sense::number) && !sentence.at(i).measured && !sentence.at(i).used;
}

// Both sides of "24 x 15 m" in millimetres: a side without a unit takes that of the other.
std::optional<std::array<double, 2>> sides_mm(const Phrase& a, const Phrase& b) {
  const auto unit_of = [](const Phrase& phrase) { return phrase.number / phrase.written; };
  if (a.written <= 0 || b.written <= 0) return std::nullopt;
  if (a.measured && b.measured) return {{a.number, b.number}};
  if (b.measured) return {{a.written * unit_of(b), b.number}};
  if (a.measured) return {{a.number, b.written * unit_of(a)}};
  for (const double side : {a.written, b.written}) {
    if (side < min_store_m || side > max_store_m) return std::nullopt;
  }
  return {{a.written * metre_mm, b.written * metre_mm}};
}

void add_size(const Reading& reading,
              IntRange span,
              plan::Strength strength,
              double width_mm,
              double depth_mm) {
  plan::Requirement& size = reading.add(plan::RequirementKind::size, span, strength);
  size.value = width_mm;
  size.second_value = depth_mm;
}

bool shop_is_measured(const Reading& reading) {
  return reading.found.find(plan::RequirementKind::size) != nullptr ||
         reading.found.find(plan::RequirementKind::area, "") != nullptr;
}

// "24 x 15 m", "24m by 15m"; "a 5 x 4 m bakery" asks for a zone's floor.
void read_sizes(Sentence& sentence, const Reading& reading) {
  for (std::size_t i = 0; i + 2 < sentence.phrases.size(); ++i) {
    const bool numbers = (is_length(sentence, i) || is_bare(sentence, i)) &&
                         (is_length(sentence, i + 2) || is_bare(sentence, i + 2));
    if (!numbers || !sentence.is(i + 1, Sense::times)) continue;
    const Phrase& first = sentence.phrases[i];
    const Phrase& second = sentence.phrases[i + 2];
    const auto sides = sides_mm(first, second);
    if (!sides) continue;
    const IntRange span = joined(first.span, second.span);
    const std::string zone = zone_of_floor(sentence, i, i + 2, shop_is_measured(reading));
    if (zone.empty()) {
      add_size(reading, span, first.strength, (*sides)[0], (*sides)[1]);
    } else {
      plan::Requirement& area = reading.add(plan::RequirementKind::area, span, first.strength);
      area.subject = zone;
      area.value = 1e-6 * (*sides)[0] * (*sides)[1];
    }
    sentence.use(i, i + 2);
  }
}

// A length and the word that says along what: "9 m deep".
struct Dimension {
  std::size_t number, word;
  std::string_view value;  // width, depth or height
};

std::vector<Dimension> dimensions_of(const Sentence& sentence) {
  std::vector<Dimension> found;
  for (std::size_t i = 0; i < sentence.phrases.size(); ++i) {
    if (!is_length(sentence, i) || sentence.phrases[i].used) continue;
    const std::size_t next = sentence.skip_fillers(i + 1);
    if (sentence.is(next, Sense::dimension)) found.push_back({i, next, sentence.at(next).value});
  }
  return found;
}

// What a measure is about: the noun right after it, or right before it.
std::size_t noun_beside(const Sentence& sentence, std::size_t first, std::size_t last) {
  const auto noun = [&](std::size_t i) {
    return sentence.is(i, Sense::counted, "aisle") || sentence.is(i, Sense::part) ||
           sentence.is(i, Sense::fixture) || sentence.is(i, Sense::zone);
  };
  const std::size_t after = sentence.skip_fillers(last + 1);
  if (noun(after)) return after;
  std::size_t before = sentence.before(first);
  if (sentence.is(before, Sense::comparison)) before = sentence.before(before);
  if (sentence.is(before, Sense::dimension))
    before = sentence.before(before);  // "ceiling height of 4 m"
  return noun(before) ? before : sentence.phrases.size();
}

// "1.8 m wide aisles", "shelves 1.6 m high", "a 4 m ceiling". True when it was understood.
bool add_measure(Sentence& sentence,
                 const Reading& reading,
                 std::size_t number,
                 std::size_t last,
                 std::string_view dimension) {
  const std::size_t noun = noun_beside(sentence, number, last);
  if (noun >= sentence.phrases.size()) return false;
  Phrase& what = sentence.phrases[noun];
  const bool aisle = what.sense == Sense::counted && dimension != "height";
  const bool upright = what.sense != Sense::counted && what.sense != Sense::zone &&
                       (dimension == "height" || dimension.empty());
  if (!aisle && !upright) return false;
  const double value = sentence.phrases[number].number;
  const Compared compared = comparison_around(sentence, number, last);
  const IntRange span = joined(compared.span, what.span);
  plan::Requirement& measure =
      reading.add(aisle ? plan::RequirementKind::aisle_width : plan::RequirementKind::height,
                  span,
                  what.strength);
  measure.comparison = compared.comparison;
  measure.value = value;
  if (upright) measure.subject = what.value;
  sentence.use(number, last);
  what.used = what.counted = true;
  const std::size_t before = sentence.before(number);
  if (sentence.is(before, Sense::dimension)) sentence.use(before, before);
  return true;
}

bool names_shop(const Sentence& sentence, std::size_t i) {
  return sentence.is(i, Sense::shop) || sentence.is(i, Sense::profile);
}

// "a 10 m wide shop", "a shop 10 m wide", "shop, 10 m wide, …"; not "a 3 m wide entrance".
bool is_side_of_shop(const Sentence& sentence, const Dimension& one) {
  const double side = sentence.phrases[one.number].number;
  if (side < min_store_m * metre_mm || side > max_store_m * metre_mm) return false;
  std::size_t after = sentence.skip_fillers(one.word + 1);
  while (sentence.is(after, Sense::size) || sentence.is(after, Sense::style))
    after = sentence.skip_fillers(after + 1);
  const std::size_t before = sentence.before(one.number);
  const bool apart = after >= sentence.phrases.size() || sentence.is(after, Sense::separator);
  return names_shop(sentence, after) || names_shop(sentence, before) ||
         (apart && sentence.is(before, Sense::separator));
}

// "12 m wide and 9 m deep" with no noun is the store; so is "12 m wide", whose other side is open.
void read_dimensions(Sentence& sentence, const Reading& reading) {
  std::optional<Dimension> width, depth;
  for (const Dimension& one : dimensions_of(sentence)) {
    if (add_measure(sentence, reading, one.number, one.word, one.value)) continue;
    if (one.value == "width" && !width) width = one;
    if (one.value == "depth" && !depth) depth = one;
  }
  if ((!width && !depth) || shop_is_measured(reading)) return;
  if (!(width && depth) && !is_side_of_shop(sentence, width ? *width : *depth)) return;
  const auto span = [&](const Dimension& one) {
    return joined(sentence.phrases[one.number].span, sentence.phrases[one.word].span);
  };
  const auto number = [&](const std::optional<Dimension>& one) {
    return one ? sentence.phrases[one->number].number : 0;
  };
  const Dimension& one = width ? *width : *depth;
  const Dimension& other = depth ? *depth : *width;
  add_size(reading,
           joined(span(one), span(other)),
           sentence.phrases[one.number].strength,
           number(width),
           number(depth));
  sentence.use(one.number, one.word);
  sentence.use(other.number, other.word);
}

void read_bare_lengths(Sentence& sentence, const Reading& reading) {
  for (std::size_t i = 0; i < sentence.phrases.size(); ++i) {
    if (!is_length(sentence, i) || sentence.phrases[i].used) continue;
    const std::size_t before = sentence.before(i);
    const std::string_view dimension =
        sentence.is(before, Sense::dimension) ? std::string_view(sentence.at(before).value) : "";
    add_measure(sentence, reading, i, i, dimension);
  }
}

// Where the lower number of "200 to 300 m2" and "200-300 m2" stands, or the thousands of
// "1 200 m2"; size() when the area is one number.
std::size_t number_before(const Sentence& sentence, std::size_t area) {
  std::size_t at = sentence.before(area);
  if (sentence.is(at, Sense::separator, "and")) {
    at = sentence.before(at);
    if (!sentence.is(sentence.before(at), Sense::relation, "between"))
      return sentence.phrases.size();
  }
  const bool plain = is_bare(sentence, at) && !sentence.at(at).in_words;
  return plain && sentence.at(at).written > 0 ? at : sentence.phrases.size();
}

// Spaces part thousands in many languages. No shop is that large, so "200 300 m2" is two numbers.
bool is_thousands(const Reading& reading, const Phrase& high, const Phrase& low) {
  constexpr double largest_thousands = 99, three_digits = 999;
  const std::string between = reading.words({high.span[1], low.span[0]});
  const std::size_t digits = reading.words(low.span).find_first_not_of("0123456789");
  return between == " " && digits == 3 && high.written <= largest_thousands &&
         low.written <= three_digits;
}

void add_area(const Reading& reading,
              const Phrase& number,
              const std::string& zone,
              const Compared& compared) {
  plan::Requirement& area =
      reading.add(plan::RequirementKind::area, compared.span, number.strength);
  area.comparison = compared.comparison;
  area.value = number.number;
  area.subject = zone;
}

// "200 to 300 m2": at least the one and at most the other.
void add_area_range(const Reading& reading,
                    Phrase low,
                    const Phrase& high,
                    const std::string& zone) {
  const IntRange span = joined(low.span, high.span);
  low.number = low.written * high.number / high.written;
  add_area(reading, low, zone, {plan::Comparison::at_least, 0, span});
  add_area(reading, high, zone, {plan::Comparison::at_most, 0, span});
}

void read_areas(Sentence& sentence, const Reading& reading) {
  for (std::size_t i = 0; i < sentence.phrases.size(); ++i) {
    if (!is_area(sentence, i) || sentence.phrases[i].used) continue;
    const std::size_t low = number_before(sentence, i);
    const std::size_t first = std::min(low, i);
    const std::string zone = zone_of_floor(sentence, first, i, shop_is_measured(reading));
    sentence.use(i, i);
    const std::size_t adjective = sentence.before(first);  // "a large 30 m2 bakery": not the shop
    if (!zone.empty() && sentence.is(adjective, Sense::size)) sentence.use(adjective, adjective);
    if (low >= sentence.phrases.size()) {
      add_area(reading, sentence.phrases[i], zone, comparison_around(sentence, i, i));
      continue;
    }
    sentence.use(low, low);
    const std::size_t before = sentence.before(low);
    if (sentence.is(before, Sense::relation, "between")) sentence.use(before, before);
    Phrase number = sentence.phrases[i];
    if (is_thousands(reading, sentence.phrases[low], number)) {
      constexpr double thousand = 1000;
      number.number += sentence.phrases[low].written * thousand * number.number / number.written;
      number.span = joined(sentence.phrases[low].span, number.span);
      add_area(reading, number, zone, comparison_around(sentence, first, i));
    } else if (sentence.phrases[low].written < number.written) {
      add_area_range(reading, sentence.phrases[low], number, zone);
    } else {
      add_area(reading, number, zone, comparison_around(sentence, i, i));
    }
  }
}

}  // namespace

void read_measures(Sentence& sentence, Reading& reading) {
  read_sizes(sentence, reading);
  read_dimensions(sentence, reading);
  read_bare_lengths(sentence, reading);
  read_areas(sentence, reading);
}

}  // namespace marketgen::intake
