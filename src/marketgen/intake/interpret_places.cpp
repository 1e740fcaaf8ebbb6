#include <algorithm>

#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;

std::vector<PlaceNoun> nouns_of(const language::Parts& parts) {
  std::vector<PlaceNoun> nouns;
  for (const language::MeaningPtr& part : parts)
    nouns.push_back(noun_of(*part));
  return nouns;
}

// Each subject to each object; "between" takes its objects together.
bool add_relations(Reading& reading,
                   const Meaning& place,
                   bool denied,
                   const std::vector<PlaceNoun>& subjects) {
  const std::string& relation = place.text("relation");
  const std::vector<PlaceNoun> objects = nouns_of(place.parts("objects"));
  bool any = false;
  for (const PlaceNoun& subject : subjects) {
    if (relation == "between") {
      any = add_relation(reading, {relation, denied, subject, objects}) || any;
      continue;
    }
    for (const PlaceNoun& object : objects)
      any = add_relation(reading, {relation, denied, subject, {object}}) || any;
  }
  return any;
}

bool is_thing(const Meaning& noun) {
  return !noun.is("type", "opening") && !noun.is("type", "place");
}

}  // namespace

bool interpret_mention(Reading& reading, const Meaning& statement) {
  for (const language::MeaningPtr& thing : statement.parts("things"))
    mention(reading, *thing);
  return true;
}

bool interpret_absent(Reading& reading, const Meaning& statement) {
  for (const language::MeaningPtr& thing : statement.parts("things")) {
    PlaceNoun noun = noun_of(*thing);
    noun.negated = true;
    noun.counted = false;
    if (thing == statement.parts("things").front()) noun.span = joined(statement.span, noun.span);
    noun.span[1] = thing->span[1];
    add_mention(reading, noun);
  }
  return true;
}

bool interpret_doors(Reading& reading, const Meaning& statement) {
  for (const language::MeaningPtr& door : statement.parts("things"))
    if (door->has("count")) add_count(reading, *door);
  return true;
}

bool interpret_placed(Reading& reading, const Meaning& statement) {
  const bool denied = statement.has("denied");
  const language::Parts& things = statement.parts("things");
  for (const language::MeaningPtr& thing : things) {
    if (is_thing(*thing) && !statement.has("unwanted")) mention(reading, *thing);
    if (!is_thing(*thing) && thing->has("count")) add_count(reading, *thing);
  }
  bool any = false;
  for (const language::MeaningPtr& place : statement.parts("at")) {
    if (!names_far(place->text("relation"), denied)) {
      for (const language::MeaningPtr& object : place->parts("objects"))
        if (is_thing(*object)) mention(reading, *object);
    }
    any = add_relations(reading, *place, denied, nouns_of(things)) || any;
  }
  return any;
}

}  // namespace marketgen::intake
