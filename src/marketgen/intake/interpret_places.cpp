#include <algorithm>
#include <array>
#include <optional>

#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;
using language::Parts;

bool is_thing(const Meaning& noun) {
  return !noun.is("type", "opening") && !noun.is("type", "place") && !noun.is("type", "pronoun");
}

// The n-th of the last list that has so many, counted from 1.
Parts nth_of_list(const std::vector<Parts>& recent, std::size_t n) {
  for (std::size_t i = recent.size(); i-- > 0;)
    if (recent[i].size() >= std::max<std::size_t>(n, 2)) return {recent[i][n - 1]};
  return {};
}

// The last list of three and more.
Parts last_list(const std::vector<Parts>& recent) {
  for (std::size_t i = recent.size(); i-- > 0;)
    if (recent[i].size() > 2) return recent[i];
  return {};
}

Parts first_two_of(const Parts& list) {
  return list.empty() ? list : Parts(list.begin(), list.begin() + 2);
}

// Both doors for customers, as one word names them.
Parts both_doors(const Meaning& pronoun) {
  Parts doors;
  for (const char* name : {"entrance", "exit"}) {
    auto door = std::make_shared<Meaning>(pronoun);
    door->slots.erase("refers");
    door->slots["type"] = "opening";
    door->slots["name"] = name;
    doors.push_back(std::move(door));
  }
  return doors;
}

// "it" is what was named last, "them" all that were named in one, "both" the last two, "the former"
// and "the latter" either of them, "the second" one of a list, "which" the last thing of all.
Parts referred(const Reading& reading, const Meaning& pronoun) {
  const std::string& refers = pronoun.text("refers");
  const Memory& memory = *reading.memory;
  if (refers == "doors") return both_doors(pronoun);
  if (refers == "which") return memory.last_object ? Parts{memory.last_object} : Parts{};
  if (refers == "wall") return memory.last_place ? Parts{memory.last_place} : Parts{};
  if (refers == "last" && memory.last_door) return {memory.last_door};
  if (memory.recent.empty()) return {};
  if (refers == "them") return memory.recent.back();
  if (refers == "first_two") return first_two_of(last_list(memory.recent));
  if (const Parts list = last_list(memory.recent); refers == "last_one" && !list.empty())
    return {list.back()};
  if (refers == "nth")
    return nth_of_list(memory.recent, static_cast<std::size_t>(pronoun.number("number", 1)));
  Parts recent;
  for (const Parts& things : memory.recent)
    recent.insert(recent.end(), things.begin(), things.end());
  if (refers == "last" || refers == "latter" || refers == "last_one") return {recent.back()};
  if (recent.size() < 2) return {};
  const MeaningPtr& former = recent[recent.size() - 2];
  return refers == "former" ? Parts{former} : Parts{former, recent.back()};
}

std::vector<PlaceNoun> nouns_of(const Parts& parts) {
  std::vector<PlaceNoun> nouns;
  for (const MeaningPtr& part : parts)
    nouns.push_back(noun_of(*part));
  return nouns;
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

// Sweets at the till do not make it a department.
bool sells(const catalog::Catalog& catalog, const catalog::ZoneTypeRow& row) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(row.fixture);
  if (kind != nullptr && kind->role == catalog::FixtureRole::checkout) return false;
  return !row.categories.empty() ||
         (kind != nullptr && kind->role == catalog::FixtureRole::shelving);
}

// Every zone type that sells something, and is none of theirs; a shop that sells one thing only has
// tills.
void forbid_others(Reading& reading, const std::vector<std::string>& zones, IntRange span) {
  for (const catalog::ZoneTypeRow& row : reading.catalog.zone_types) {
    const bool asked = std::ranges::find(zones, row.type) != zones.end();
    if (!asked && sells(reading.catalog, row))
      reading.add(plan::RequirementKind::zone_absent, span).subject = row.type;
  }
}

}  // namespace

void note_object(const Reading& reading, const MeaningPtr& object) {
  if (is_thing(*object)) reading.memory->last_object = object;
  if (object->is("type", "place")) reading.memory->last_place = object;
}

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

void remember(const Reading& reading, const Parts& things) {
  Parts named;
  std::ranges::copy_if(
      things, std::back_inserter(named), [](const MeaningPtr& thing) { return is_thing(*thing); });
  if (named.empty()) return;
  reading.memory->last_door = nullptr;
  reading.memory->last_object = named.back();
  reading.memory->recent.push_back(std::move(named));
}

bool interpret_mention(Reading& reading, const Meaning& statement) {
  for (const MeaningPtr& thing : statement.parts("things"))
    mention(reading, *thing);
  remember(reading, statement.parts("things"));
  return true;
}

namespace {

// What the answer denies was only asked about.
void forget_mentions(Reading& reading, const Meaning& thing) {
  std::erase_if(reading.found.requirements, [&](const plan::Requirement& wish) {
    const bool some = wish.comparison == plan::Comparison::at_least && wish.value <= 1;
    switch (wish.kind) {
      case plan::RequirementKind::zone_present:
        return wish.subject == thing.text("zone");
      case plan::RequirementKind::product_present:
        return wish.subject == thing.text("name");
      case plan::RequirementKind::fixture_count:
        return some && wish.subject == thing.text("name");
      default:
        return false;
    }
  });
}

}  // namespace

bool interpret_absent(Reading& reading, const Meaning& statement) {
  const Parts& said = statement.parts("things");
  const bool answer = said.front()->is("type", "pronoun");  // "and the café? There is none"
  const Parts things = answer ? resolved(reading, said) : said;
  if (things.empty()) return false;
  for (const MeaningPtr& thing : things) {
    if (answer) forget_mentions(reading, *thing);
    const int begin =
        thing == things.front() ? std::min(statement.span[0], thing->span[0]) : thing->span[0];
    add_none(reading, noun_of(*thing), answer ? statement.span : IntRange{begin, thing->span[1]});
  }
  return true;
}

bool interpret_only(Reading& reading, const Meaning& statement) {
  interpret_mention(reading, statement);
  const Parts& things = statement.parts("things");
  const std::vector<std::string> zones = zones_of(things);
  if (zones.size() == 1 && zones.front() == "self_checkout")
    reading.add(plan::RequirementKind::zone_absent, statement.span).subject = "checkout";
  const bool goods = std::ranges::any_of(things, [&](const MeaningPtr& thing) {
    const catalog::ZoneTypeRow* zone = reading.catalog.zone_type(thing->text("zone"));
    return !thing->is("type", "fixture") && zone != nullptr && sells(reading.catalog, *zone);
  });
  if (goods) forbid_others(reading, zones, statement.span);  // "one till only" is but a number
  return true;
}

// "No other category": none but those that were named before.
bool interpret_only_named(Reading& reading, const Meaning& statement) {
  std::vector<std::string> named;
  for (const plan::Requirement& wish : reading.found.requirements) {
    if (wish.kind == plan::RequirementKind::zone_present ||
        wish.kind == plan::RequirementKind::zone_count)
      named.push_back(wish.subject);
    if (wish.kind == plan::RequirementKind::product_present) named.push_back(wish.object);
  }
  if (named.empty()) return false;
  forbid_others(reading, named, statement.span);
  return true;
}

// "Three tables and a fridge in the bakery": they are the bakery's.
bool mention_in_zone(Reading& reading, const Parts& things, const Parts& places) {
  const bool one_zone = places.size() == 1 && !places.front()->is("type", "fixture") &&
                        !places.front()->text("zone").empty();
  if (!one_zone || !are_furniture(reading, things)) return false;
  const std::string& zone = places.front()->text("zone");
  for (const MeaningPtr& thing : things)
    mention(reading, standing_in(*thing, zone));
  mention(reading, *places.front());
  remember(reading, things);
  return true;
}

// "Wine in wine racks": the fixtures are those of the goods' zone. What is no fixture stands near.
bool interpret_held(Reading& reading, const Meaning& statement) {
  const bool furniture = !statement.has("only") &&
                         mention_in_zone(reading, statement.parts("things"), statement.parts("by"));
  if (furniture) return true;
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
    const std::string& zone = goods.text("zone");
    mention(reading, zone.empty() ? *by : standing_in(*by, zone));
  }
  if (statement.has("at")) interpret_placed(reading, statement);
  return true;
}

// "A bakery with two tables and a bread rack": what stands in the zone. Where something else is
// among them, the sentence only lists what there is.
bool interpret_equipped(Reading& reading, const Meaning& statement) {
  const Meaning& zone = *statement.parts("zone").front();
  const Parts& things = statement.parts("things");
  if (statement.has("at")) {
    Meaning placed = statement;
    placed.slots["things"] = statement.parts("zone");
    interpret_placed(reading, placed);
  } else {
    mention(reading, zone);
  }
  const bool furniture =
      !zone.is("type", "fixture") && !zone.text("zone").empty() && are_furniture(reading, things);
  for (const MeaningPtr& thing : things)
    mention(reading, furniture ? standing_in(*thing, zone.text("zone")) : *thing);
  Parts named{statement.parts("zone").front()};
  named.insert(named.end(), things.begin(), things.end());
  remember(reading, named);
  return true;
}

namespace {

// "Trolleys by the exit": equipment that is no zone's stands at that door.
bool stand_at_door(Reading& reading, const Parts& things, const Meaning& place) {
  const Parts& doors = place.parts("objects");
  const bool by = place.is("relation", "near") || place.is("relation", "next_to") ||
                  place.is("relation", "at") || place.is("relation", "in");
  const bool one_door = by && doors.size() == 1 && doors.front()->is("type", "opening");
  const bool equipment = std::ranges::all_of(things, [&](const MeaningPtr& thing) {
    const catalog::FixtureKind* kind = fixture_kind_of(reading, *thing);
    return kind != nullptr && kind->role == catalog::FixtureRole::equipment &&
           thing->text("zone").empty() && kind->generator != "pillar";
  });
  if (!one_door || !equipment) return false;
  for (const MeaningPtr& thing : things) {
    Meaning standing = *thing;
    standing.slots["scope"] = doors.front()->text("name");
    mention(reading, standing);
  }
  remember(reading, things);
  return true;
}

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

// What pronouns mean where nothing is beside itself: "ice cream and frozen food opposite them".
Parts resolved_beside(Reading& reading, const Parts& nouns, const Parts& things) {
  std::vector<Parts>& recent = reading.memory->recent;
  const std::vector<Parts> all = recent;
  const std::vector<std::string> own = zones_of(things);
  const auto is_own = [&](const MeaningPtr& thing) {
    return std::ranges::find(own, thing->text("zone")) != own.end();
  };
  while (recent.size() > 1 && !own.empty() && std::ranges::all_of(recent.back(), is_own))
    recent.pop_back();
  Parts objects = resolved(reading, nouns);
  recent = all;
  return objects;
}

bool add_place(Reading& reading, const Meaning& place, const Parts& things, bool denied) {
  const std::string& relation = place.text("relation");
  if (!names_far(relation, denied)) {
    for (const MeaningPtr& object : place.parts("objects"))
      if (is_thing(*object)) mention(reading, *object);
  }
  const Parts objects = resolved_beside(reading, place.parts("objects"), things);
  if (objects.empty()) return false;
  for (const MeaningPtr& object : objects)
    note_object(reading, object);
  return add_relations(reading, relation, denied, nouns_of(things), nouns_of(objects));
}

// What stood where counts before what it stood by, for "it"; a pronoun names nothing new.
void remember_subjects(const Reading& reading, const Parts& things) {
  const MeaningPtr object = reading.memory->last_object;
  remember(reading, things);
  if (object) reading.memory->last_object = object;
}

// The one thing that was counted, with the number that is meant.
bool recount(Meaning& again, const Meaning& correction) {
  const Parts& things = again.parts("things");
  const bool of_things =
      std::ranges::any_of(things, [](const MeaningPtr& thing) { return thing->has("count"); });
  if (again.has("count") && !of_things) {  // "four levels", also of shelves
    again.slots["count"] = correction.parts("count");
    return true;
  }
  if (things.size() != 1 || !things.front()->has("count")) return false;
  auto thing = std::make_shared<Meaning>(*things.front());
  thing->slots["count"] = correction.parts("count");
  again.slots["things"] = Parts{std::move(thing)};
  return true;
}

}  // namespace

bool interpret_placed(Reading& reading, const Meaning& statement) {
  const bool denied = statement.has("denied");
  const Parts things = resolved(reading, statement.parts("things"));
  if (things.empty()) return false;
  reading.memory->last_object = nullptr;
  if (!denied && statement.parts("at").size() == 1) {
    const Meaning& place = *statement.parts("at").front();
    const bool within =
        place.is("relation", "in") && mention_in_zone(reading, things, place.parts("objects"));
    if (within || stand_at_door(reading, things, place)) return true;
  }
  bool any = mention_placed(reading, statement);
  if (things.front()->is("type", "opening") && !denied) {
    if (things.size() > 1) reading.memory->recent.push_back(things);
    reading.memory->last_door = things.front();
    return place_doors(reading, statement, things) || any;
  }
  for (const MeaningPtr& place : statement.parts("at")) {
    if (add_place(reading, *place, things, denied))
      any = true;
    else
      reading.senseless.insert(reading.senseless.end(), place->words.begin(), place->words.end());
  }
  remember_subjects(reading, statement.parts("things"));
  return any;
}

// "Dairy and bakery opposite each other."
bool interpret_mutual(Reading& reading, const Meaning& statement) {
  const Parts things = resolved(reading, statement.parts("things"));
  if (things.size() < 2) return false;
  reading.memory->recent.push_back(things);
  if (!statement.parts("things").front()->is("type", "pronoun"))
    interpret_mention(reading, statement);
  std::vector<PlaceNoun> others = nouns_of(things);
  bool any = false;
  for (std::size_t i = 0; i + 1 < others.size(); ++i)
    any = add_relation(
              reading,
              {statement.text("relation"), statement.has("denied"), others[i], {others[i + 1]}}) ||
          any;
  return any;
}

// "No, along the right": the last statement again, with another place or number; what it asked for
// before is no wish. "Scrap that": it is not said again.
bool interpret_correction(Reading& reading, const Meaning& statement) {
  Memory& memory = *reading.memory;
  std::vector<plan::Requirement>& wishes = reading.found.requirements;
  if (!memory.last || memory.past_wish != wishes.size()) return false;
  const MeaningPtr last = memory.last;
  Meaning again = *last;
  const bool places = statement.has("at");
  if (places && !last->has("at")) return false;
  if (places) again.slots["at"] = statement.parts("at");
  if (statement.has("count") && !recount(again, statement)) return false;
  wishes.erase(wishes.begin() + static_cast<std::ptrdiff_t>(memory.first_wish), wishes.end());
  if (!places && !statement.has("count")) return true;
  again.span = joined(last->span, statement.span);
  return interpret(reading, again);
}

}  // namespace marketgen::intake
