#include <array>
#include <optional>

#include "intake/reading.h"

namespace marketgen {
namespace {

constexpr double metre_mm = 1000;
// Two bare numbers are metres when a shop could have that size.
constexpr double least_store_m = 4;
constexpr double most_store_m = 200;

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
    if (side < least_store_m || side > most_store_m) return std::nullopt;
  }
  return {{a.written * metre_mm, b.written * metre_mm}};
}

void add_size(
    const Reading& reading, IntRange span, Strength strength, double width_mm, double depth_mm) {
  Requirement& size = reading.add(RequirementKind::size, span, strength);
  size.value = width_mm;
  size.second_value = depth_mm;
}

// "24 x 15 m", "24m by 15m"
void read_sizes(Sentence& sentence, const Reading& reading) {
  for (std::size_t i = 0; i + 2 < sentence.phrases.size(); ++i) {
    const bool numbers = (is_length(sentence, i) || is_bare(sentence, i)) &&
                         (is_length(sentence, i + 2) || is_bare(sentence, i + 2));
    if (!numbers || !sentence.is(i + 1, Sense::times)) continue;
    const Phrase& first = sentence.phrases[i];
    const Phrase& second = sentence.phrases[i + 2];
    const auto sides = sides_mm(first, second);
    if (!sides) continue;
    add_size(reading, joined(first.span, second.span), first.strength, (*sides)[0], (*sides)[1]);
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
  Requirement& measure = reading.add(
      aisle ? RequirementKind::aisle_width : RequirementKind::height, span, what.strength);
  measure.comparison = compared.comparison;
  measure.value = value;
  if (upright) measure.subject = what.value;
  sentence.use(number, last);
  what.used = what.counted = true;
  const std::size_t before = sentence.before(number);
  if (sentence.is(before, Sense::dimension)) sentence.use(before, before);
  return true;
}

// "12 m wide and 9 m deep" with no noun is the store.
void read_dimensions(Sentence& sentence, const Reading& reading) {
  std::optional<Dimension> width, depth;
  for (const Dimension& one : dimensions_of(sentence)) {
    if (add_measure(sentence, reading, one.number, one.word, one.value)) continue;
    if (one.value == "width" && !width) width = one;
    if (one.value == "depth" && !depth) depth = one;
  }
  if (!width || !depth) return;
  const auto span = [&](const Dimension& one) {
    return joined(sentence.phrases[one.number].span, sentence.phrases[one.word].span);
  };
  add_size(reading,
           joined(span(*width), span(*depth)),
           sentence.phrases[width->number].strength,
           sentence.phrases[width->number].number,
           sentence.phrases[depth->number].number);
  sentence.use(width->number, width->word);
  sentence.use(depth->number, depth->word);
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

// The zone of "a 20 m2 bakery", "a bakery of 20 m2"; size() when the area is the store's.
std::size_t zone_of_area(const Sentence& sentence, std::size_t number) {
  const std::size_t after = sentence.skip_fillers(number + 1);
  bool sold = false;  // "a kiosk of 30 m2 selling snacks" is 30 m2 large
  for (std::size_t i = number + 1; i < after; ++i)
    sold = sold || sentence.is(i, Sense::filler, "selling");
  if (sentence.is(after, Sense::zone) && !sold) return after;
  std::size_t before = sentence.before(number);
  if (sentence.is(before, Sense::comparison)) before = sentence.before(before);
  return sentence.is(before, Sense::zone) ? before : sentence.phrases.size();
}

void read_areas(Sentence& sentence, const Reading& reading) {
  for (std::size_t i = 0; i < sentence.phrases.size(); ++i) {
    if (!is_area(sentence, i) || sentence.phrases[i].used) continue;
    const std::size_t zone = zone_of_area(sentence, i);
    const Compared compared = comparison_around(sentence, i, i);
    Requirement& area =
        reading.add(RequirementKind::area, compared.span, sentence.phrases[i].strength);
    area.comparison = compared.comparison;
    area.value = sentence.phrases[i].number;
    if (zone < sentence.phrases.size()) area.subject = sentence.phrases[zone].value;
    sentence.use(i, i);
  }
}

}  // namespace

void read_measures(Sentence& sentence, Reading& reading) {
  read_sizes(sentence, reading);
  read_dimensions(sentence, reading);
  read_bare_lengths(sentence, reading);
  read_areas(sentence, reading);
}

}  // namespace marketgen
