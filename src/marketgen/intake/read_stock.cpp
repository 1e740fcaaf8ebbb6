#include "intake/reading.h"

namespace marketgen::intake {
namespace {

constexpr double percent = 0.01;

// "80 % full"
void read_percentages(Sentence& sentence, const Reading& reading) {
  for (std::size_t i = 0; i + 1 < sentence.phrases.size(); ++i) {
    const Phrase& number = sentence.phrases[i];
    const bool share = number.sense == Sense::number && !number.used && !number.measured &&
                       number.number >= 0 && number.number <= 100;
    if (!share || !sentence.is(i + 1, Sense::unit, "percent")) continue;
    const std::size_t word = sentence.skip_fillers(i + 2);
    if (!sentence.is(word, Sense::stock)) continue;
    const IntRange span = joined(number.span, sentence.phrases[word].span);
    plan::Requirement& stock = reading.add(plan::RequirementKind::stock, span, number.strength);
    stock.subject = sentence.phrases[word].value;
    stock.value = number.number * percent;
    sentence.use(i, word);
  }
}

}  // namespace

void read_stock(Sentence& sentence, Reading& reading) {
  read_percentages(sentence, reading);
  for (Phrase& phrase : sentence.phrases) {
    if (phrase.sense != Sense::stock || phrase.used) continue;
    plan::Requirement& stock =
        reading.add(plan::RequirementKind::stock, phrase.span, phrase.strength);
    stock.subject = phrase.value;
    stock.value = phrase.number;
    // Full shelves and gaps are floors, order is a ceiling; the row says which side its number is
    // on.
    stock.comparison = value_named<plan::Comparison>(phrase.zone).value_or(plan::Comparison::equal);
    phrase.used = true;
  }
}

}  // namespace marketgen::intake
