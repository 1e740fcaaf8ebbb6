// From what the grammar reads in a sentence to requirements.
//
// Each statement of data/grammar has a kind, and each kind one function here.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "intake/lexical_input.h"
#include "intake/understanding.h"
#include "language/meaning.h"

namespace marketgen::intake {

// What pronouns and corrections look back to.
struct Memory {
  std::vector<language::Parts> recent;  // things, statement by statement
  language::MeaningPtr last_object;     // the thing that was named last, wherever it stood
  language::MeaningPtr last_place;      // wall or side
  language::MeaningPtr last_door;       // where no thing was named after it
  // The last statement, as far as a correction may change it, and the wishes that it made.
  language::MeaningPtr last;
  std::size_t first_wish = 0, past_wish = 0;
};

// The sentence that is read, and what is understood so far.
struct Reading {
  std::string_view prompt;
  const catalog::Catalog& catalog;
  Understanding& found;
  const std::vector<Segment>* segments = nullptr;  // of the sentence
  bool first_sentence = false;                     // what a prompt names first is what is asked for
  plan::Strength strength = plan::Strength::must;  // of the clause
  Memory* memory = nullptr;                        // of the statements before
  std::vector<int> senseless = {};                 // words of a statement, part of which made sense
  double profile_weight = 0;             // how specific the sentence's word for the kind of shop is
  std::vector<std::string> about = {};   // zone types that a limit is said of; none: of all
  std::vector<std::string> except = {};  // but of these

  std::string words(IntRange span) const {
    return std::string(prompt.substr(static_cast<std::size_t>(span[0]),
                                     static_cast<std::size_t>(span[1] - span[0])));
  }
  // Of the clause's strength; what is asked is still to be filled in.
  plan::Requirement wish(plan::RequirementKind kind, IntRange span) const {
    plan::Requirement requirement;
    requirement.kind = kind;
    requirement.span = span;
    requirement.text = words(span);
    requirement.strength = strength;
    return requirement;
  }
  plan::Requirement& add(plan::RequirementKind kind, IntRange span) const {
    return found.requirements.emplace_back(wish(kind, span));
  }
};

// Bytes from the start of `a` to the end of `b`.
inline IntRange joined(IntRange a, IntRange b) {
  return {a[0] < b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
}

// A number with its comparison, as the slots value, upper, comparison and shift say it. "four to
// six" is two requirements: each gets the same span and one bound.
void add_number(Reading& reading,
                const plan::Requirement& wish,
                const language::Meaning& number,
                bool whole);

// False when it makes no sense ("left of the back"): then its words count as not understood. Where
// only a part makes none, the words of that part are in Reading::senseless.
bool interpret(Reading& reading, const language::Meaning& statement);
// What a statement says besides: nouns are mentioned, statements interpreted (slot also).
void interpret_also(Reading& reading, const language::Meaning& statement);

// Whether a size or an area of the shop's floor was said before.
bool shop_is_measured(const Reading& reading);
bool names_a_shop(const Segment& segment);

// What "20 m2" or "5 x 4 m" is said of: `zone`, or the shop (null, or a zone that is what was asked
// for or one of many that it has). `after`: the zone stands after the number.
bool add_floor(Reading& reading,
               const language::Meaning& floor,
               const language::Meaning* zone,
               bool after);

// Adds a number that is said of some zones: of its own (field `zone`), else of those that
// Reading::about has, else of all but Reading::except.
void add_limit(Reading& reading,
               const plan::Requirement& wish,
               std::string plan::Requirement::*zone,
               const language::Meaning& number,
               bool whole);

// Zone types of things, each once.
std::vector<std::string> zones_of(const language::Parts& things);

// With what pronouns stand for in their place.
language::Parts resolved(const Reading& reading, const language::Parts& nouns);
// What a thing or wall was named as, for "which" and "the same wall".
void note_object(const Reading& reading, const language::MeaningPtr& object);
// Where doors are (slot at), each of them. False when no place is one of a door.
bool place_doors(Reading& reading,
                 const language::Meaning& statement,
                 const language::Parts& doors);
// For the pronouns of what follows.
void remember(const Reading& reading, const language::Parts& things);

// By kind; each adds what it says.
bool interpret_floor(Reading& reading, const language::Meaning& statement);
bool interpret_floor_of_last(Reading& reading, const language::Meaning& statement);
bool interpret_floor_each(Reading& reading, const language::Meaning& statement);
bool interpret_side(Reading& reading, const language::Meaning& statement);
bool interpret_levels(Reading& reading, const language::Meaning& statement);
bool interpret_shelf_pitch(Reading& reading, const language::Meaning& statement);
bool interpret_gap(Reading& reading, const language::Meaning& statement);
bool interpret_limited(Reading& reading, const language::Meaning& statement);
bool interpret_excepting(Reading& reading, const language::Meaning& statement);
bool interpret_respectively(Reading& reading, const language::Meaning& statement);
bool interpret_same_as(Reading& reading, const language::Meaning& statement);
bool interpret_ratio(Reading& reading, const language::Meaning& statement);
bool interpret_lots(Reading& reading, const language::Meaning& statement);
bool interpret_stock(Reading& reading, const language::Meaning& statement);
bool interpret_stocks(Reading& reading, const language::Meaning& statement);
bool interpret_rows(Reading& reading, const language::Meaning& statement);
bool interpret_aisles(Reading& reading, const language::Meaning& statement);
bool interpret_aisle_width(Reading& reading, const language::Meaning& statement);
bool interpret_height(Reading& reading, const language::Meaning& statement);
bool interpret_mention(Reading& reading, const language::Meaning& statement);
bool interpret_absent(Reading& reading, const language::Meaning& statement);
bool interpret_absent_at(Reading& reading, const language::Meaning& statement);
bool interpret_replaced(Reading& reading, const language::Meaning& statement);
bool interpret_absent_but(Reading& reading, const language::Meaning& statement);
bool interpret_only(Reading& reading, const language::Meaning& statement);
bool interpret_only_named(Reading& reading, const language::Meaning& statement);
bool interpret_doors(Reading& reading, const language::Meaning& statement);
bool interpret_held(Reading& reading, const language::Meaning& statement);
bool interpret_equipped(Reading& reading, const language::Meaning& statement);
bool interpret_placed(Reading& reading, const language::Meaning& statement);
bool interpret_mutual(Reading& reading, const language::Meaning& statement);
bool interpret_correction(Reading& reading, const language::Meaning& statement);
bool interpret_surface(Reading& reading, const language::Meaning& statement);
// When the shelves are seen (interpret_time.cpp).
bool interpret_time(Reading& reading, const language::Meaning& statement);
// Of edits (data/grammar/edit.grammar).
bool interpret_swap(Reading& reading, const language::Meaning& said);
bool interpret_resize(Reading& reading, const language::Meaning& said);
bool interpret_more(Reading& reading, const language::Meaning& said);
bool interpret_fewer(Reading& reading, const language::Meaning& said);
bool interpret_zone_value(Reading& reading, const language::Meaning& said);

// Of Chinese alone (interpret_chinese.cpp).
bool interpret_floor_of_shop(Reading& reading, const language::Meaning& statement);
bool interpret_floor_of_it(Reading& reading, const language::Meaning& statement);
bool interpret_count_of_it(Reading& reading, const language::Meaning& statement);
bool interpret_lacking(Reading& reading, const language::Meaning& statement);
bool interpret_levels_of(Reading& reading, const language::Meaning& statement);
bool interpret_doors_on(Reading& reading, const language::Meaning& statement);
bool interpret_doors_at(Reading& reading, const language::Meaning& statement);
bool interpret_doors_shared(Reading& reading, const language::Meaning& statement);
bool interpret_placed_each(Reading& reading, const language::Meaning& statement);
bool interpret_runs_each(Reading& reading, const language::Meaning& statement);
bool interpret_surfaces(Reading& reading, const language::Meaning& statement);
bool interpret_none_of_stock(Reading& reading, const language::Meaning& statement);

}  // namespace marketgen::intake
