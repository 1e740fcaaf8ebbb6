#include "intake/place_nouns.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace marketgen::intake {
namespace {

// What a relation means when it is said, and when it is denied.
struct RelationMeaning {
  std::string_view value;
  plan::RelationKind said, denied;
};
constexpr RelationMeaning meanings[] = {
    {"near", plan::RelationKind::near, plan::RelationKind::far},
    {"next_to", plan::RelationKind::near, plan::RelationKind::not_adjacent},
    {"at", plan::RelationKind::at, plan::RelationKind::far},
    {"in", plan::RelationKind::at, plan::RelationKind::far},
    {"along", plan::RelationKind::along, plan::RelationKind::far},
    {"far", plan::RelationKind::far, plan::RelationKind::near},
    {"between", plan::RelationKind::between, plan::RelationKind::not_adjacent},
    {"behind", plan::RelationKind::behind, plan::RelationKind::not_adjacent},
    {"in_front_of", plan::RelationKind::facing, plan::RelationKind::not_adjacent},
    {"facing", plan::RelationKind::facing, plan::RelationKind::not_adjacent},
    {"left_of", plan::RelationKind::left_of, plan::RelationKind::right_of},
    {"right_of", plan::RelationKind::right_of, plan::RelationKind::left_of},
};

std::optional<plan::RelationKind> kind_of(std::string_view value, bool negated) {
  for (const RelationMeaning& meaning : meanings) {
    if (meaning.value == value) return negated ? meaning.denied : meaning.said;
  }
  return std::nullopt;
}

// The goods or fixtures that were named; empty where the zone itself was.
std::string named_in(const PlaceNoun& noun) {
  const bool of_zone = noun.kind == NounKind::fixture || noun.kind == NounKind::product;
  return of_zone && noun.name != noun.zone ? noun.name : "";
}

std::string_view name_in_relations(const PlaceNoun& noun) {
  const bool itself = noun.kind == NounKind::opening || noun.kind == NounKind::place;
  return itself ? noun.name : noun.zone;
}

void add_wish(Reading& reading,
              plan::RelationKind kind,
              const PlaceNoun& subject,
              const PlaceNoun& object,
              std::string_view object_name) {
  plan::Requirement& wish =
      reading.add(plan::RequirementKind::relation, joined(subject.span, object.span));
  wish.relation = kind;
  wish.subject = name_in_relations(subject);
  wish.object = object_name;
  reading.found.named.push_back(
      {wish.span, named_in(subject), named_in(object), subject.kind == NounKind::fixture});
}

// "the entrance on the east wall", "an exit on the right"
bool add_opening_place(Reading& reading, const PlaceNoun& opening, const PlaceNoun& place) {
  plan::Requirement& wish =
      reading.add(plan::RequirementKind::opening, joined(opening.span, place.span));
  wish.subject = opening.name;
  const std::vector<std::string> sides = split(place.name, '+');  // a corner has two
  const bool front_or_back = sides[0] != "left" && sides[0] != "right" && sides[0] != "center";
  if (place.wall || front_or_back) wish.object = sides[0];
  if (!place.wall && !front_or_back) wish.second_object = sides[0];
  if (sides.size() > 1) wish.second_object = sides[1];
  return true;
}

// A place as object: walls are lined, sides are stood at.
bool add_at_place(Reading& reading, const SaidRelation& said, plan::RelationKind kind) {
  const PlaceNoun& place = said.objects[0];
  const bool sideways = kind != plan::RelationKind::along && kind != plan::RelationKind::at &&
                        kind != plan::RelationKind::near && kind != plan::RelationKind::far;
  if (sideways) return false;
  if (said.subject.kind == NounKind::opening) {
    return kind != plan::RelationKind::far && add_opening_place(reading, said.subject, place);
  }
  const bool stands = kind == plan::RelationKind::at || kind == plan::RelationKind::along;
  if (stands)
    kind =
        place.wall && place.name != "center" ? plan::RelationKind::along : plan::RelationKind::at;
  for (const std::string& side : split(place.name, '+')) {
    add_wish(reading, kind, said.subject, place, side);
  }
  return true;
}

void add_zone_mention(Reading& reading, const PlaceNoun& noun) {
  if (!noun.counted) {
    const plan::RequirementKind kind =
        noun.negated ? plan::RequirementKind::zone_absent : plan::RequirementKind::zone_present;
    reading.add(kind, noun.span).subject = noun.name;
  }
  if (noun.factor != 1 && !noun.negated) {
    reading.found.emphases.push_back(
        {noun.name, noun.factor, reading.words(noun.span), noun.span, noun.name});
  }
}

void add_product_mention(Reading& reading, const PlaceNoun& noun) {
  const plan::RequirementKind kind =
      noun.negated ? plan::RequirementKind::product_absent : plan::RequirementKind::product_present;
  plan::Requirement& wish = reading.add(kind, noun.span);
  wish.subject = noun.name;
  wish.object = noun.zone;
  if (noun.factor != 1 && !noun.negated && !noun.zone.empty()) {
    reading.found.emphases.push_back(
        {noun.zone, noun.factor, reading.words(noun.span), noun.span, noun.name});
  }
}

void add_fixture_mention(Reading& reading, const PlaceNoun& noun) {
  if (noun.counted) return;
  if (noun.name == "endcap") {
    plan::Requirement& endcaps = reading.add(plan::RequirementKind::endcaps, noun.span);
    endcaps.value = noun.negated ? 0 : 1;
    endcaps.comparison = noun.negated ? plan::Comparison::at_most : plan::Comparison::at_least;
    return;
  }
  plan::Requirement& wish = reading.add(plan::RequirementKind::fixture_count, noun.span);
  wish.subject = noun.name;
  wish.object = noun.zone;
  wish.second_object = noun.scope;
  wish.comparison = noun.negated ? plan::Comparison::at_most : plan::Comparison::at_least;
  wish.value = noun.negated ? 0 : 1;
}

// Every shop has doors; where they are is said by relations.
void add_opening_mention(Reading& reading, const PlaceNoun& noun) {
  if (!noun.negated) return;
  plan::Requirement& none = reading.add(plan::RequirementKind::opening, noun.span);
  none.subject = noun.name;
  none.comparison = plan::Comparison::at_most;
}

}  // namespace

bool is_whole(const language::Meaning& number) {
  return number.number("value") == std::floor(number.number("value"));
}

PlaceNoun noun_of(const language::Meaning& said) {
  PlaceNoun noun;
  noun.kind = value_named<NounKind>(said.text("type")).value_or(NounKind::zone);
  noun.name = said.text("name");
  noun.zone = said.text("zone");
  noun.span = said.span;
  noun.wall = noun.kind == NounKind::place && said.number("wall") != 0;
  noun.counted = said.has("count") || said.has("runs");
  noun.scope = said.text("scope");
  noun.factor = said.number("factor", 1);
  return noun;
}

void mention(Reading& reading, const language::Meaning& said) {
  if (said.is("type", "pronoun")) return;
  if (said.has("floor")) add_floor(reading, *said.parts("floor").front(), &said, false);
  if (said.has("count") && !is_whole(*said.parts("count").front())) {
    language::Meaning uncounted = said;  // "4.1 Dairy": a heading's number
    uncounted.slots.erase("count");
    return mention(reading, uncounted);
  }
  if (said.has("count")) add_count(reading, said);
  if (said.has("runs")) add_runs(reading, said);
  for (const language::MeaningPtr& goods : said.parts("holds"))
    mention(reading, *goods);
  add_mention(reading, noun_of(said));
}

language::Meaning standing_in(const language::Meaning& fixture, const std::string& zone) {
  language::Meaning standing = fixture;
  // Baskets among goods are those that goods lie in.
  if (fixture.is("name", "basket_stack")) standing.slots["name"] = std::string("bin");
  standing.slots["zone"] = zone;
  standing.slots["scope"] = zone;
  return standing;
}

const catalog::FixtureKind* fixture_kind_of(const Reading& reading,
                                            const language::Meaning& thing) {
  return thing.is("type", "fixture") ? reading.catalog.fixture_kind(thing.text("name")) : nullptr;
}

bool are_furniture(const Reading& reading, const language::Parts& things) {
  return std::ranges::all_of(things, [&](const language::MeaningPtr& thing) {
    const catalog::FixtureKind* kind = fixture_kind_of(reading, *thing);
    const bool baskets = kind != nullptr && kind->kind == "basket_stack";
    return kind != nullptr && (kind->role == catalog::FixtureRole::shelving || baskets);
  });
}

void add_runs(Reading& reading, const language::Meaning& said) {
  const language::Meaning& lines = *said.parts("runs").front();
  const language::Parts& numbers = lines.parts("count");
  plan::Requirement runs = reading.wish(plan::RequirementKind::run_count, said.span);
  runs.subject = said.text("name");
  runs.object = said.text("zone");
  runs.second_object = said.text("scope");
  runs.second_value = said.number("sides", lines.number("sides"));
  const language::Meaning* number =
      !numbers.empty() ? numbers.front().get() : (lines.number("value") > 0 ? &lines : nullptr);
  runs.value = 1;
  if (number != nullptr)
    add_number(reading, runs, *number, true);
  else
    reading.found.requirements.push_back(runs);
  if (!said.has("each")) return;
  plan::Requirement count = runs;
  count.kind = plan::RequirementKind::fixture_count;
  count.second_value = 0;
  const double times = number != nullptr ? number->number("value") : 1;
  language::Meaning each = *said.parts("each").front();
  for (const std::string slot : {"value", "upper"}) {
    if (each.has(slot)) each.slots[slot] = times * each.number(slot);
  }
  add_number(reading, count, each, true);
}

// "five checkouts", "two promotion areas", "two entrances"
void add_count(Reading& reading, const language::Meaning& said) {
  language::Meaning number = *said.parts("count").front();
  if (said.parts("count").size() > 1)  // "two rows of six each"
    number.slots["value"] = number.number("value") * said.parts("count").back()->number("value");
  if (said.has("comparison")) number.slots["comparison"] = said.text("comparison");
  const std::string& name = said.text("name");
  const bool tills = name == "checkout" || name == "self_checkout";
  plan::Requirement count =
      reading.wish(said.is("type", "opening")          ? plan::RequirementKind::opening
                   : said.is("type", "zone") && !tills ? plan::RequirementKind::zone_count
                                                       : plan::RequirementKind::fixture_count,
                   said.span);
  count.subject = name == "checkout" ? "checkout_lane" : name;
  if (count.kind == plan::RequirementKind::fixture_count) {
    count.object = said.text("zone");
    count.second_object = said.text("scope");
  }
  add_number(reading, count, number, true);
}

void add_mention(Reading& reading, const PlaceNoun& noun) {
  switch (noun.kind) {
    case NounKind::zone:
      return add_zone_mention(reading, noun);
    case NounKind::product:
      return add_product_mention(reading, noun);
    case NounKind::fixture:
      return add_fixture_mention(reading, noun);
    case NounKind::opening:
      return add_opening_mention(reading, noun);
    case NounKind::place:
      return;  // every shop has walls; where things are is said by relations
  }
}

void add_none(Reading& reading, PlaceNoun noun, IntRange span) {
  noun.negated = true;
  noun.counted = false;
  noun.span = span;
  add_mention(reading, noun);
}

bool names_far(std::string_view relation, bool negated) {
  const std::optional<plan::RelationKind> kind = kind_of(relation, negated);
  return kind == plan::RelationKind::far || kind == plan::RelationKind::not_adjacent;
}

bool add_relation(Reading& reading, const SaidRelation& said) {
  std::optional<plan::RelationKind> kind = kind_of(said.value, said.negated);
  if (!kind || name_in_relations(said.subject).empty()) return false;
  const PlaceNoun& object = said.objects[0];
  if (object.kind == NounKind::place) return add_at_place(reading, said, *kind);
  if (*kind == plan::RelationKind::at || *kind == plan::RelationKind::along)
    kind = plan::RelationKind::near;
  const std::string_view subject_name = name_in_relations(said.subject);
  if (name_in_relations(object).empty()) return false;  // goods or fixtures of no zone of their own
  if (subject_name == name_in_relations(object)) return true;  // one zone holds both
  if (*kind == plan::RelationKind::between && said.objects.size() < 2) return false;
  add_wish(reading, *kind, said.subject, object, name_in_relations(object));
  if (*kind != plan::RelationKind::between) return true;
  plan::Requirement& wish = reading.found.requirements.back();
  wish.second_object = name_in_relations(said.objects[1]);
  wish.span = joined(wish.span, said.objects[1].span);
  wish.text = reading.words(wish.span);
  return true;
}

}  // namespace marketgen::intake
