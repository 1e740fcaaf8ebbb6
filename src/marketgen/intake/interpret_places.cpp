#include <algorithm>
#include <optional>

#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;
using language::Parts;

// "it" is what was named last, "them" all that were named in one, "both" the last two, "the former"
// and "the latter" either of them.
Parts referred(const Reading& reading, const Meaning& pronoun) {
  const std::string& refers = pronoun.text("refers");
  if (reading.recent->empty()) return {};
  if (refers == "them") return reading.recent->back();
  Parts recent;
  for (const Parts& things : *reading.recent)
    recent.insert(recent.end(), things.begin(), things.end());
  if (refers == "last" || refers == "latter") return {recent.back()};
  if (recent.size() < 2) return {};
  const MeaningPtr& former = recent[recent.size() - 2];
  return refers == "former" ? Parts{former} : Parts{former, recent.back()};
}

bool is_thing(const Meaning& noun) {
  return !noun.is("type", "opening") && !noun.is("type", "place") && !noun.is("type", "pronoun");
}

// For the pronouns of what follows.
void remember(const Reading& reading, const Parts& things) {
  Parts named;
  std::ranges::copy_if(
      things, std::back_inserter(named), [](const MeaningPtr& thing) { return is_thing(*thing); });
  if (!named.empty()) reading.recent->push_back(std::move(named));
}

std::vector<PlaceNoun> nouns_of(const Parts& parts) {
  std::vector<PlaceNoun> nouns;
  for (const MeaningPtr& part : parts)
    nouns.push_back(noun_of(*part));
  return nouns;
}

// A wall and an end of it are one place. False when both say the same thing differently.
bool join_doors(const Reading& reading, plan::Requirement& door, const plan::Requirement& other) {
  const bool walls = !door.object.empty() && !other.object.empty() && door.object != other.object;
  const bool ends = !door.second_object.empty() && !other.second_object.empty();
  if (walls || ends) return false;
  if (door.object.empty()) door.object = other.object;
  if (door.second_object.empty()) door.second_object = other.second_object;
  door.span = joined(door.span, other.span);
  door.text = reading.words(door.span);
  return true;
}

// "The east end of the south wall": a direction beside a wall is that end of it.
void end_of_wall(const plan::Requirement& door, plan::Requirement& other, const Meaning& spot) {
  const bool end = spot.number("wall") == 0 && !door.object.empty() &&
                   other.object != door.object && other.second_object.empty();
  if (end) std::swap(other.object, other.second_object);
}

// "The entrance at the left end of the south wall": one wish. False when no place is one of a door.
bool add_door(Reading& reading, const PlaceNoun& door, const Parts& places) {
  std::vector<plan::Requirement>& wishes = reading.found.requirements;
  std::optional<std::size_t> first;
  for (const MeaningPtr& place : places) {
    for (const MeaningPtr& spot : place->parts("objects")) {
      const std::size_t made = wishes.size();
      add_relation(reading, {place->text("relation"), false, door, {noun_of(*spot)}});
      if (wishes.size() == made || wishes[made].kind != plan::RequirementKind::opening) continue;
      if (first) end_of_wall(wishes[*first], wishes[made], *spot);
      if (!first)
        first = made;
      else if (join_doors(reading, wishes[*first], wishes[made]))
        wishes.pop_back();
    }
  }
  return first.has_value();
}

// Each subject to each object; "between" takes its objects together.
bool add_relations(Reading& reading,
                   const std::string& relation,
                   bool denied,
                   const std::vector<PlaceNoun>& subjects,
                   const std::vector<PlaceNoun>& objects) {
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

bool sells(const catalog::Catalog& catalog, const catalog::ZoneTypeRow& row) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(row.fixture);
  if (kind != nullptr && kind->role == catalog::FixtureRole::checkout) return false;
  return !row.categories.empty() ||
         (kind != nullptr && kind->role == catalog::FixtureRole::shelving);
}

// Every zone type that sells something, and is none of theirs.
void forbid_others(Reading& reading, const Parts& things, IntRange span) {
  for (const catalog::ZoneTypeRow& row : reading.catalog.zone_types) {
    const bool asked = std::ranges::any_of(
        things, [&](const MeaningPtr& thing) { return thing->text("zone") == row.type; });
    if (!asked && sells(reading.catalog, row))
      reading.add(plan::RequirementKind::zone_absent, span).subject = row.type;
  }
}

}  // namespace

Parts resolved(const Reading& reading, const Parts& nouns) {
  Parts found;
  for (const MeaningPtr& noun : nouns) {
    const bool pronoun = noun->is("type", "pronoun");
    if (!pronoun) found.push_back(noun);
    for (const MeaningPtr& named : pronoun ? referred(reading, *noun) : Parts{}) {
      auto said = std::make_shared<Meaning>(*named);
      said->slots.erase("count");  // the number was said already
      said->span = noun->span;
      found.push_back(std::move(said));
    }
  }
  return found;
}

bool interpret_mention(Reading& reading, const Meaning& statement) {
  for (const MeaningPtr& thing : statement.parts("things"))
    mention(reading, *thing);
  remember(reading, statement.parts("things"));
  return true;
}

bool interpret_absent(Reading& reading, const Meaning& statement) {
  for (const MeaningPtr& thing : statement.parts("things")) {
    PlaceNoun noun = noun_of(*thing);
    noun.negated = true;
    noun.counted = false;
    if (thing == statement.parts("things").front()) noun.span = joined(statement.span, noun.span);
    noun.span[1] = thing->span[1];
    add_mention(reading, noun);
  }
  return true;
}

bool interpret_only(Reading& reading, const Meaning& statement) {
  interpret_mention(reading, statement);
  const Parts& things = statement.parts("things");
  const bool goods = std::ranges::any_of(things, [&](const MeaningPtr& thing) {
    const catalog::ZoneTypeRow* zone = reading.catalog.zone_type(thing->text("zone"));
    return !thing->is("type", "fixture") && zone != nullptr && sells(reading.catalog, *zone);
  });
  if (goods) forbid_others(reading, things, statement.span);  // "one till only" is but a number
  return true;
}

// "Wine in wine racks": the fixtures are those of the goods' zone. What is no fixture stands near.
bool interpret_held(Reading& reading, const Meaning& statement) {
  if (statement.has("only"))
    interpret_only(reading, statement);
  else
    interpret_mention(reading, statement);
  const Parts named = resolved(reading, statement.parts("things"));
  const Meaning& goods = named.empty() ? *statement.parts("things").front() : *named.front();
  for (const MeaningPtr& by : statement.parts("by")) {
    if (!by->is("type", "fixture")) {
      mention(reading, *by);
      add_relation(reading, {"near", false, noun_of(goods), {noun_of(*by)}});
      continue;
    }
    Meaning fixture = *by;
    if (!goods.text("zone").empty()) fixture.slots["zone"] = goods.text("zone");
    mention(reading, fixture);
  }
  return true;
}

bool interpret_doors(Reading& reading, const Meaning& statement) {
  for (const MeaningPtr& door : statement.parts("things"))
    if (door->has("count")) add_count(reading, *door);
  return true;
}

namespace {

// What the things are, before where they are. True when there are any.
bool mention_placed(Reading& reading, const Meaning& statement) {
  bool any = false;
  for (const MeaningPtr& thing : statement.parts("things")) {
    const bool wanted = is_thing(*thing) && !statement.has("unwanted");
    if (wanted) mention(reading, *thing);
    if (!is_thing(*thing) && thing->has("count")) add_count(reading, *thing);
    any = any || wanted || thing->has("count");
  }
  return any;
}

bool add_place(Reading& reading, const Meaning& place, const Parts& things, bool denied) {
  const std::string& relation = place.text("relation");
  if (!names_far(relation, denied)) {
    for (const MeaningPtr& object : place.parts("objects"))
      if (is_thing(*object)) mention(reading, *object);
  }
  const Parts objects = resolved(reading, place.parts("objects"));
  if (objects.empty()) return false;
  return add_relations(reading, relation, denied, nouns_of(things), nouns_of(objects));
}

}  // namespace

bool interpret_placed(Reading& reading, const Meaning& statement) {
  const bool denied = statement.has("denied");
  const Parts things = resolved(reading, statement.parts("things"));
  if (things.empty()) return false;
  bool any = mention_placed(reading, statement);
  if (things.front()->is("type", "opening") && !denied) {
    for (const MeaningPtr& door : things)
      any = add_door(reading, noun_of(*door), statement.parts("at")) || any;
    return any;
  }
  for (const MeaningPtr& place : statement.parts("at")) {
    if (add_place(reading, *place, things, denied))
      any = true;
    else
      reading.senseless.insert(reading.senseless.end(), place->words.begin(), place->words.end());
  }
  remember(reading, statement.parts("things"));
  return any;
}

}  // namespace marketgen::intake
