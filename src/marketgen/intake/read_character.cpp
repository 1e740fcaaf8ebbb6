#include "intake/reading.h"

namespace marketgen::intake {
namespace {

// Of two words for the kind of shop the more specific one counts: "discount supermarket" is a
// discounter.
void read_profile(const Reading& reading, Phrase& phrase, double& specificity) {
  phrase.used = true;
  if (phrase.number < specificity) return;
  for (plan::Requirement& known : reading.found.requirements) {
    if (known.kind != plan::RequirementKind::profile || phrase.number <= specificity) continue;
    known.text = reading.words(phrase.span);
    known.span = phrase.span;
    known.object = phrase.value;
    specificity = phrase.number;
    return;
  }
  specificity = phrase.number;
  reading.add(plan::RequirementKind::profile, phrase.span, phrase.strength).object = phrase.value;
}

}  // namespace

void read_character(Sentence& sentence, Reading& reading) {
  double specificity = 0;
  for (Phrase& phrase : sentence.phrases) {
    if (phrase.used) continue;
    // "well stocked shelves": every shop has shelves, so they ask for nothing.
    const bool any_shelves = phrase.sense == Sense::part && phrase.value == "fixture";
    if (phrase.sense == Sense::style) {
      reading.add(plan::RequirementKind::style, phrase.span, phrase.strength).object = phrase.value;
      phrase.used = true;
    } else if (phrase.sense == Sense::profile) {
      read_profile(reading, phrase, specificity);
    } else if (phrase.sense == Sense::size) {
      reading.found.size_factor *= phrase.number;
      phrase.used = true;
    } else if (phrase.sense == Sense::shop || any_shelves) {
      phrase.used = true;
    }
  }
}

}  // namespace marketgen::intake
