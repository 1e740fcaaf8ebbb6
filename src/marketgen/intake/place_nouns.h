// Nouns that stand somewhere in a store, and what a sentence about them asks for.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "intake/interpret.h"

namespace marketgen::intake {

enum class NounKind { zone, product, fixture, opening, place };
constexpr std::array<std::string_view, 5> names_of(NounKind) {
  return {"zone", "product", "fixture", "opening", "place"};
}

struct PlaceNoun {
  NounKind kind = NounKind::zone;
  std::string name;  // zone type, product word, fixture kind, opening kind or place
  std::string zone;  // zone type that stands for it in relations; empty for openings and places
  std::string scope = {};  // of a fixture: the zone type in which it is counted
  IntRange span{0, 0};
  bool wall = false;     // of a place: "the back wall", not "the back"
  bool negated = false;  // not wanted
  bool counted = false;  // its number is a wish of its own
  double factor = 1;     // of its usual size
};

// Whether a number has no fraction; "4.1 Dairy" counts nothing.
bool is_whole(const language::Meaning& number);

// What a noun of the grammar says (slots type, name, zone, wall, factor, count, runs, scope).
PlaceNoun noun_of(const language::Meaning& said);

// The noun is wanted, or not: zone_present, product_absent, fixture_count, endcaps; with a number,
// how many.
void add_mention(Reading& reading, const PlaceNoun& noun);
// There is to be none of it: said at `span`.
void add_none(Reading& reading, PlaceNoun noun, IntRange span);
void mention(Reading& reading, const language::Meaning& said);
void add_count(Reading& reading, const language::Meaning& said);
// "two rows of six chest freezers": how many lines, and how many in all.
void add_runs(Reading& reading, const language::Meaning& said);

// The fixtures stand in that zone: they are counted there, not in the one that their name implies.
language::Meaning standing_in(const language::Meaning& fixture, const std::string& zone);

// Null for what is no fixture.
const catalog::FixtureKind* fixture_kind_of(const Reading& reading, const language::Meaning& thing);

// Fixtures that goods lie or stand on, and none besides.
bool are_furniture(const Reading& reading, const language::Parts& things);

// The fixtures that were named last; null when none were.
language::MeaningPtr last_fixture(const Reading& reading);

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
