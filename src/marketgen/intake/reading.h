// The readers of one sentence. Each looks for one kind of statement, adds what it says to the
// reading and marks the phrases that it used; they run in the order in which they stand here.
#pragma once
#include <string>
#include <string_view>

#include "intake/sentence.h"
#include "intake/understanding.h"

namespace marketgen::intake {

struct Reading {
  std::string_view prompt;
  const catalog::Catalog& catalog;
  Understanding& found;

  std::string words(IntRange span) const {
    return std::string(prompt.substr(static_cast<std::size_t>(span[0]),
                                     static_cast<std::size_t>(span[1] - span[0])));
  }
  plan::Requirement& add(plan::RequirementKind kind, IntRange span, plan::Strength strength) const {
    plan::Requirement& requirement = found.requirements.emplace_back();
    requirement.kind = kind;
    requirement.span = span;
    requirement.text = words(span);
    requirement.strength = strength;
    return requirement;
  }
};

// "24 x 15 m", "12 m wide and 9 m deep", "300 m2", "a 20 m2 bakery", "1.8 m wide aisles",
// "shelves 1.6 m high", "4 m ceiling".
void read_measures(Sentence& sentence, Reading& reading);
// "five checkouts", "at least six aisles", "5-tier shelves in snacks", "two entrances", "with
// endcaps".
void read_counts(Sentence& sentence, Reading& reading);
// "oak floor", "white walls and ceiling", "green accents", "warm light".
void read_look(Sentence& sentence, Reading& reading);
// "well stocked", "half empty", "tidy", "80 % full".
void read_stock(Sentence& sentence, Reading& reading);
// Zones, products, fixtures and openings, wanted or not, and how they stand to one another.
void read_places(Sentence& sentence, Reading& reading);
// "industrial style", "convenience store", "small".
void read_character(Sentence& sentence, Reading& reading);

// "at least" before or "or more" after a number. `shift` is what "more than" adds to a whole
// number.
struct Compared {
  plan::Comparison comparison = plan::Comparison::equal;
  int shift = 0;
  IntRange span{0, 0};  // of the comparison and the number
};
// The comparison around the number at `i`, up to the noun at `last`; its phrases are marked as
// used.
Compared comparison_around(Sentence& sentence, std::size_t i, std::size_t last);

}  // namespace marketgen::intake
