// Nouns that stand somewhere in a store, and what a sentence about them asks for.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "intake/reading.h"
#include "intake/sentence.h"

namespace marketgen::intake {

enum class NounKind { zone, product, fixture, opening, place };

struct PlaceNoun {
  NounKind kind = NounKind::zone;
  std::string name;  // zone type, product word, fixture kind, opening kind or place
  std::string zone;  // zone type that stands for it in relations; empty for openings and places
  std::size_t phrase = 0;
  IntRange span{0, 0};
  bool wall = false;     // of a place: "the back wall", not "the back"
  bool negated = false;  // not wanted
  bool counted = false;  // its number was understood already
  bool article = false;  // starts a noun phrase of its own
  double factor = 1;     // of its usual size
  plan::Strength strength = plan::Strength::must;
};

// Zones, products, fixtures and openings.
bool names_a_place(const Phrase& phrase);
// Precondition: the phrase names a place or is one.
PlaceNoun noun_at(const Sentence& sentence, std::size_t i);

// "zone", "section", "aisle", "shelves" right after the noun belong to it.
void use_suffixes(Sentence& sentence, std::size_t noun);

// The noun is wanted, or not: zone_present, product_absent, fixture_count, endcaps, opening.
void add_mention(Reading& reading, const PlaceNoun& noun);

// The relation asks for distance, so what it names need not exist.
bool names_far(std::string_view relation, bool negated);

struct SaidRelation {
  std::string
      value;  // of the lexicon row: near next_to along at in far between behind facing left_of …
  bool negated = false;
  const PlaceNoun& subject;
  const std::vector<PlaceNoun>& objects;
};
// Adds the relation, or what an opening's place asks for. False when it makes no sense ("left of
// the back").
bool add_relation(Reading& reading, const SaidRelation& said);

}  // namespace marketgen::intake
