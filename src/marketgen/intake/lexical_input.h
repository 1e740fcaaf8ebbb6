// A sentence as the chart parser takes it: every meaning that the lexicon has for its words.
#pragma once
#include <vector>

#include "intake/lexicon.h"
#include "intake/tokens.h"
#include "language/chart.h"

namespace marketgen::intake {

// What the words of a sentence are when each is taken for the longest phrase it begins.
struct Segment {
  std::size_t first = 0, last = 0;  // tokens, past the last
  Sense sense = Sense::ordinary;    // of words in no row, too
  std::string value;                // of the row
  bool content = false;             // the row has a number: of sense word, it says something
};
std::vector<Segment> segments_of(const std::vector<Token>& sentence, const Lexicon& lexicon);

// Of every row whose words stand in the sentence, wherever they begin and however long: category is
// the sense ("unknown" for words in no row, "has" for fillers of that value, the value itself for
// sense word), slots are value, number and zone where the row has them. A number's value is a
// number, of digits and of words: "two hundred and fifty" is one, as is "1 200". In Chinese what
// stands within a longer phrase is no word (chinese_words.h).
language::Input lexical_input(const std::vector<Token>& sentence,
                              const std::vector<Segment>& segments,
                              const Lexicon& lexicon);

}  // namespace marketgen::intake
