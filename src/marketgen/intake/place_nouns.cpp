#include "intake/place_nouns.h"

#include <algorithm>

#include "base/text.h"

namespace marketgen {
namespace {

std::optional<NounKind> noun_kind(Sense sense) {
  switch (sense) {
    case Sense::zone:
      return NounKind::zone;
    case Sense::product:
      return NounKind::product;
    case Sense::fixture:
      return NounKind::fixture;
    case Sense::opening:
      return NounKind::opening;
    case Sense::place:
      return NounKind::place;
    default:
      return std::nullopt;
  }
}

// What a relation means when it is said, and when it is denied.
struct Meaning {
  std::string_view value;
  RelationKind said, denied;
};
constexpr Meaning meanings[] = {
    {"near", RelationKind::near, RelationKind::far},
    {"next_to", RelationKind::near, RelationKind::not_adjacent},
    {"at", RelationKind::at, RelationKind::far},
    {"in", RelationKind::at, RelationKind::far},
    {"along", RelationKind::along, RelationKind::far},
    {"far", RelationKind::far, RelationKind::near},
    {"between", RelationKind::between, RelationKind::not_adjacent},
    {"behind", RelationKind::behind, RelationKind::not_adjacent},
    {"in_front_of", RelationKind::facing, RelationKind::not_adjacent},
    {"facing", RelationKind::facing, RelationKind::not_adjacent},
    {"left_of", RelationKind::left_of, RelationKind::right_of},
    {"right_of", RelationKind::right_of, RelationKind::left_of},
};

std::optional<RelationKind> kind_of(std::string_view value, bool negated) {
  for (const Meaning& meaning : meanings) {
    if (meaning.value == value) return negated ? meaning.denied : meaning.said;
  }
  return std::nullopt;
}

std::string_view name_in_relations(const PlaceNoun& noun) {
  const bool itself = noun.kind == NounKind::opening || noun.kind == NounKind::place;
  return itself ? noun.name : noun.zone;
}

void add_wish(Reading& reading,
              RelationKind kind,
              const PlaceNoun& subject,
              const PlaceNoun& object,
              std::string_view object_name) {
  Requirement& wish =
      reading.add(RequirementKind::relation, joined(subject.span, object.span), subject.strength);
  wish.relation = kind;
  wish.subject = name_in_relations(subject);
  wish.object = object_name;
}

// "the entrance on the east wall", "an exit on the right"
bool add_opening_place(Reading& reading, const PlaceNoun& opening, const PlaceNoun& place) {
  Requirement& wish =
      reading.add(RequirementKind::opening, joined(opening.span, place.span), opening.strength);
  wish.subject = opening.name;
  const std::vector<std::string> sides = split(place.name, '+');  // a corner has two
  const bool front_or_back = sides[0] != "left" && sides[0] != "right" && sides[0] != "center";
  if (place.wall || front_or_back) wish.object = sides[0];
  if (!place.wall && !front_or_back) wish.second_object = sides[0];
  if (sides.size() > 1) wish.second_object = sides[1];
  return true;
}

// A place as object: walls are lined, sides are stood at.
bool add_at_place(Reading& reading, const SaidRelation& said, RelationKind kind) {
  const PlaceNoun& place = said.objects[0];
  const bool sideways = kind != RelationKind::along && kind != RelationKind::at &&
                        kind != RelationKind::near && kind != RelationKind::far;
  if (sideways) return false;
  if (said.subject.kind == NounKind::opening) {
    return kind != RelationKind::far && add_opening_place(reading, said.subject, place);
  }
  const bool stands = kind == RelationKind::at || kind == RelationKind::along;
  if (stands) kind = place.wall && place.name != "center" ? RelationKind::along : RelationKind::at;
  for (const std::string& side : split(place.name, '+')) {
    add_wish(reading, kind, said.subject, place, side);
  }
  return true;
}

void add_zone_mention(Reading& reading, const PlaceNoun& noun) {
  if (!noun.counted) {
    const RequirementKind kind =
        noun.negated ? RequirementKind::zone_absent : RequirementKind::zone_present;
    reading.add(kind, noun.span, noun.strength).subject = noun.name;
  }
  if (noun.factor != 1 && !noun.negated) {
    reading.found.emphases.push_back({noun.name, noun.factor, reading.words(noun.span), noun.span});
  }
}

void add_product_mention(Reading& reading, const PlaceNoun& noun) {
  const RequirementKind kind =
      noun.negated ? RequirementKind::product_absent : RequirementKind::product_present;
  Requirement& wish = reading.add(kind, noun.span, noun.strength);
  wish.subject = noun.name;
  wish.object = noun.zone;
  if (noun.factor != 1 && !noun.negated && !noun.zone.empty()) {
    reading.found.emphases.push_back({noun.zone, noun.factor, reading.words(noun.span), noun.span});
  }
}

void add_fixture_mention(Reading& reading, const PlaceNoun& noun) {
  if (noun.counted) return;
  if (noun.name == "endcap") {
    Requirement& endcaps = reading.add(RequirementKind::endcaps, noun.span, noun.strength);
    endcaps.value = noun.negated ? 0 : 1;
    endcaps.comparison = noun.negated ? Comparison::at_most : Comparison::at_least;
    return;
  }
  Requirement& wish = reading.add(RequirementKind::fixture_count, noun.span, noun.strength);
  wish.subject = noun.name;
  wish.object = noun.zone;
  wish.comparison = noun.negated ? Comparison::at_most : Comparison::at_least;
  wish.value = noun.negated ? 0 : 1;
}

}  // namespace

bool names_a_place(const Phrase& phrase) {
  const std::optional<NounKind> kind = noun_kind(phrase.sense);
  return kind && *kind != NounKind::place;
}

PlaceNoun noun_at(const Sentence& sentence, std::size_t i) {
  const Phrase& phrase = sentence.phrases[i];
  PlaceNoun noun;
  noun.kind = noun_kind(phrase.sense).value_or(NounKind::zone);
  noun.name = phrase.value;
  noun.zone = noun.kind == NounKind::zone ? phrase.value : phrase.zone;
  noun.phrase = i;
  noun.span = phrase.span;
  noun.wall = noun.kind == NounKind::place && phrase.number != 0;
  noun.counted = phrase.counted;
  noun.strength = phrase.strength;
  return noun;
}

void use_suffixes(Sentence& sentence, std::size_t noun) {
  for (std::size_t i = noun + 1; i < sentence.phrases.size(); ++i) {
    const bool belongs = sentence.is(i, Sense::suffix) || sentence.is(i, Sense::counted, "aisle") ||
                         sentence.is(i, Sense::part, "fixture");
    if (!belongs || sentence.at(i).used) return;
    sentence.use(i, i);
  }
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
    case NounKind::place:
      return;  // every shop has doors and walls; where they are is said by relations
  }
}

bool names_far(std::string_view relation, bool negated) {
  const std::optional<RelationKind> kind = kind_of(relation, negated);
  return kind == RelationKind::far || kind == RelationKind::not_adjacent;
}

bool add_relation(Reading& reading, const SaidRelation& said) {
  std::optional<RelationKind> kind = kind_of(said.value, said.negated);
  if (!kind) return false;
  const PlaceNoun& object = said.objects[0];
  if (object.kind == NounKind::place) return add_at_place(reading, said, *kind);
  if (*kind == RelationKind::at || *kind == RelationKind::along) kind = RelationKind::near;
  const std::string_view subject_name = name_in_relations(said.subject);
  if (subject_name.empty() || subject_name == name_in_relations(object))
    return true;  // one zone holds both
  if (*kind == RelationKind::between && said.objects.size() < 2) return false;
  add_wish(reading, *kind, said.subject, object, name_in_relations(object));
  if (*kind != RelationKind::between) return true;
  Requirement& wish = reading.found.requirements.back();
  wish.second_object = name_in_relations(said.objects[1]);
  wish.span = joined(wish.span, said.objects[1].span);
  wish.text = reading.words(wish.span);
  return true;
}

}  // namespace marketgen
