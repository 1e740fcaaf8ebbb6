#include <algorithm>
#include <cmath>

#include "intake/reading.h"

namespace marketgen::intake {
namespace {

// A sentence's noun may follow its number after one adjective: "five modern checkouts".
bool countable(const Phrase& phrase) {
  switch (phrase.sense) {
    case Sense::zone:
    case Sense::fixture:
    case Sense::opening:
    case Sense::counted:
      return true;
    case Sense::part:
      return phrase.value == "fixture";  // "six shelves"
    default:
      return false;
  }
}

bool adjective(const Phrase& phrase) {
  return phrase.sense == Sense::ordinary || phrase.sense == Sense::size ||
         phrase.sense == Sense::color || phrase.sense == Sense::material;
}

std::size_t noun_after(const Sentence& sentence, std::size_t number) {
  std::size_t i = sentence.skip_fillers(number + 1);
  if (sentence.is(i, Sense::comparison)) i = sentence.skip_fillers(i + 1);  // "3 or more checkouts"
  if (i < sentence.phrases.size() && !countable(sentence.phrases[i]) &&
      adjective(sentence.phrases[i])) {
    i = sentence.skip_fillers(i + 1);
  }
  return i < sentence.phrases.size() && countable(sentence.phrases[i]) ? i
                                                                       : sentence.phrases.size();
}

bool is_shelving_noun(const Sentence& sentence, std::size_t i) {
  return sentence.is(i, Sense::part, "fixture") || sentence.is(i, Sense::fixture);
}

// "snacks with 6 tiers": a zone just before the number.
std::size_t zone_before(const Sentence& sentence, std::size_t i) {
  std::size_t at = sentence.before(i);
  if (is_shelving_noun(sentence, at))
    at = sentence.before(at);  // "snacks on gondolas with 6 tiers"
  return sentence.is(at, Sense::zone) ? at : sentence.phrases.size();
}

// "6 tiers in snacks", "6-tier shelves for snacks": a zone just after the noun.
std::size_t zone_after(const Sentence& sentence, std::size_t noun) {
  std::size_t at = sentence.skip_fillers(noun + 1);
  if (is_shelving_noun(sentence, at)) at = sentence.skip_fillers(at + 1);
  if (sentence.is(at, Sense::relation, "in")) at = sentence.skip_fillers(at + 1);
  return sentence.is(at, Sense::zone) ? at : sentence.phrases.size();
}

// "6-tier gondolas" asks for gondolas by the way: the noun belongs to the number.
void use_shelving_noun(Sentence& sentence, std::size_t noun) {
  const std::size_t next = sentence.skip_fillers(noun + 1);
  if (sentence.is(next, Sense::part, "fixture")) sentence.use(next, next);
}

void add_levels(Sentence& sentence,
                const Reading& reading,
                std::size_t noun,
                const Compared& compared,
                double value) {
  const plan::Strength strength = sentence.phrases[noun].strength;
  plan::Requirement& levels = reading.add(plan::RequirementKind::levels, compared.span, strength);
  levels.comparison = compared.comparison;
  levels.value = value + compared.shift;
  use_shelving_noun(sentence, noun);
  const std::size_t after = zone_after(sentence, noun);
  if (sentence.is(after, Sense::zone)) levels.subject = sentence.phrases[after].value;
}

// A number that an int holds; how many rows make sense is decided later (limits.h).
constexpr double max_rows_read = 1e6;

// "two rows of frozen food"
void add_rows(Sentence& sentence, const Reading& reading, std::size_t number, std::size_t noun) {
  const std::size_t zone = zone_after(sentence, noun);
  if (!sentence.is(zone, Sense::zone)) return;
  reading.found.rows.push_back(
      {sentence.phrases[zone].value,
       static_cast<int>(std::min(sentence.phrases[number].number, max_rows_read)),
       joined(sentence.phrases[number].span, sentence.phrases[zone].span)});
  sentence.use(number, noun);
}

plan::RequirementKind kind_of_count(const Phrase& noun) {
  if (noun.sense == Sense::counted) return plan::RequirementKind::aisle_count;
  if (noun.sense == Sense::opening) return plan::RequirementKind::opening;
  const bool tills = noun.value == "checkout" || noun.value == "self_checkout";
  return noun.sense == Sense::zone && !tills ? plan::RequirementKind::zone_count
                                             : plan::RequirementKind::fixture_count;
}

void add_count(Sentence& sentence, const Reading& reading, std::size_t number, std::size_t noun) {
  Phrase& what = sentence.phrases[noun];
  const double value = sentence.phrases[number].number;
  if (what.sense == Sense::counted && what.value == "row") {
    return add_rows(sentence, reading, number, noun);
  }
  const bool levels =
      (what.sense == Sense::counted && what.value == "level") || what.sense == Sense::part;
  const std::size_t owner = zone_before(sentence, number);
  const Compared compared = comparison_around(sentence, number, noun);
  sentence.use(number, number);
  what.used = what.counted = true;
  if (levels) {
    add_levels(sentence, reading, noun, compared, value);
    plan::Requirement& added = reading.found.requirements.back();
    if (added.subject.empty() && sentence.is(owner, Sense::zone)) {
      added.subject = sentence.phrases[owner].value;
    }
    return;
  }
  plan::Requirement& count = reading.add(kind_of_count(what), compared.span, what.strength);
  count.comparison = compared.comparison;
  count.value = value + compared.shift;
  if (what.sense != Sense::counted) count.subject = what.value;
  if (count.kind == plan::RequirementKind::fixture_count) {
    count.object = what.sense == Sense::zone ? what.value : what.zone;
  }
  if (what.value == "checkout") count.subject = "checkout_lane";
}

}  // namespace

Compared comparison_around(Sentence& sentence, std::size_t i, std::size_t last) {
  Compared result;
  result.span = joined(sentence.phrases[i].span, sentence.phrases[last].span);
  const auto take = [&](std::size_t at) {
    Phrase& word = sentence.phrases[at];
    result.comparison = value_named<plan::Comparison>(word.value).value_or(plan::Comparison::equal);
    result.shift = static_cast<int>(word.number);
    result.span = joined(result.span, word.span);
    word.used = true;
  };
  const std::size_t before = sentence.before(i);
  if (sentence.is(before, Sense::comparison)) take(before);
  for (std::size_t at = i + 1; at <= last; ++at) {
    if (sentence.is(at, Sense::comparison)) take(at);
  }
  const std::size_t after = sentence.skip_fillers(last + 1);
  const bool of_next_number = sentence.is(sentence.skip_fillers(after + 1), Sense::number);
  if (sentence.is(after, Sense::comparison) && !of_next_number) take(after);
  return result;
}

void read_counts(Sentence& sentence, Reading& reading) {
  for (std::size_t i = 0; i < sentence.phrases.size(); ++i) {
    const Phrase& number = sentence.phrases[i];
    if (number.sense != Sense::number || number.measured || number.used) continue;
    const bool whole = number.number >= 1 && number.number == std::floor(number.number);
    const std::size_t noun = noun_after(sentence, i);
    if (whole && noun < sentence.phrases.size()) add_count(sentence, reading, i, noun);
  }
}

}  // namespace marketgen::intake
