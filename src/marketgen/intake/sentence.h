// A prompt cut into sentences of phrases: words that the lexicon knows, with what they mean, and
// the rest.
//
// Readers (read_*.h) go over the phrases of one sentence and mark what they used; what no reader
// used is reported as unparsed.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "intake/lexicon.h"
#include "intake/tokens.h"
#include "plan/plan.h"

namespace marketgen::intake {

struct Phrase {
  Sense sense = Sense::ordinary;
  std::string value;      // of the lexicon row; the folded words themselves when they are in no row
  double number = 0;      // of the row, or the number that was written
  std::string zone;       // of the row
  IntRange span{0, 0};    // bytes of the prompt
  bool used = false;      // some reader understood it
  bool in_words = false;  // of a lexicon row: a number was not written in digits
  bool measured =
      false;  // a number with a unit: `number` is in mm or m2, `value` is "length" or "area"
  double written = 0;    // the number as it was written
  bool counted = false;  // a noun whose number was understood: "five checkouts"
  plan::Strength strength =
      plan::Strength::must;  // what "ideally", "must" and the like around it say
};

struct Sentence {
  std::vector<Phrase> phrases;
  bool first = false;  // of the prompt: what it names first is what is asked for

  // Phrase i, or a filler beyond the ends.
  const Phrase& at(std::size_t i) const;
  bool is(std::size_t i, Sense sense) const { return at(i).sense == sense && i < phrases.size(); }
  bool is(std::size_t i, Sense sense, std::string_view value) const {
    return is(i, sense) && phrases[i].value == value;
  }
  // First phrase at or after `i` that is no filler; size() when there is none.
  std::size_t skip_fillers(std::size_t i) const;
  // Last phrase before `i` that is no filler; size() when there is none.
  std::size_t before(std::size_t i) const;
  void use(std::size_t first, std::size_t last);  // marks first..last, both included
};

// Bytes from the start of `a` to the end of `b`.
inline IntRange joined(IntRange a, IntRange b) {
  return {a[0] < b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
}

std::vector<Sentence> make_sentences(const std::vector<Token>& raw, const Lexicon& lexicon);

}  // namespace marketgen::intake
