// Doors and windows: how many, in which walls, at which end.
#include <array>
#include <optional>

#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;
using language::Parts;

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

// "Both doors in the east wall, the former to the south": an end of the wall that was said before.
bool is_end_of_known_wall(Reading& reading, const PlaceNoun& door, const Meaning& spot) {
  if (spot.number("wall") != 0 || !spot.is("type", "place")) return false;
  for (plan::Requirement& wish : reading.found.requirements) {
    const bool known = wish.kind == plan::RequirementKind::opening && wish.subject == door.name &&
                       !wish.object.empty() && wish.second_object.empty();
    if (!known || wish.object == spot.text("name")) continue;
    wish.second_object = spot.text("name");
    wish.span = joined(wish.span, door.span);
    wish.text = reading.words(wish.span);
    return true;
  }
  return false;
}

// "The entrance at the left end of the south wall": one wish. False when no place is one of a door.
bool add_door(Reading& reading, const PlaceNoun& door, const Parts& places) {
  std::vector<plan::Requirement>& wishes = reading.found.requirements;
  std::optional<std::size_t> first;
  for (const MeaningPtr& place : places) {
    for (const MeaningPtr& spot : resolved(reading, place->parts("objects"))) {
      if (!first || spot->number("wall") != 0) note_object(reading, spot);
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

// "Two emergency exits on the west wall": so many are there, where they are in one place.
bool add_doors(Reading& reading,
               const Meaning& door,
               const Parts& places,
               std::optional<double> count) {
  std::vector<plan::Requirement>& wishes = reading.found.requirements;
  const std::size_t made = wishes.size();
  const bool any = add_door(reading, noun_of(door), places);
  if (count && wishes.size() == made + 1) wishes.back().value = *count;
  return any;
}

std::optional<double> count_of(const Meaning& door) {
  if (!door.has("count")) return std::nullopt;
  return door.parts("count").front()->number("value");
}

}  // namespace

bool place_doors(Reading& reading, const Meaning& statement, const Parts& doors) {
  const Parts& at = statement.parts("at");
  const bool one_place = statement.parts("things").front()->is("type", "pronoun") &&
                         at.size() == 1 && at.front()->parts("objects").size() == 1;
  bool any = false;
  for (const MeaningPtr& door : doors) {
    const bool end =
        one_place &&
        is_end_of_known_wall(reading, noun_of(*door), *at.front()->parts("objects").front());
    any = end || add_doors(reading, *door, at, count_of(*door)) || any;
  }
  return any;
}

// "Two entrances": how many. "Two entrances, one west and one east": and so many in each place.
bool interpret_doors(Reading& reading, const Meaning& statement) {
  const MeaningPtr& door = statement.parts("things").front();
  if (door->has("count")) add_count(reading, *door);
  reading.memory->last_door = door;
  for (const MeaningPtr& part : statement.parts("parts"))
    add_doors(reading, *door, part->parts("at"), part->number("number"));
  return true;
}

// "Emergency exits in the short walls": one in each. A room of no said size is wider than deep.
bool interpret_doors_on(Reading& reading, const Meaning& statement) {
  const plan::Requirement* size = reading.found.find(plan::RequirementKind::size);
  const bool wide = size == nullptr || size->value >= size->second_value;
  const bool east_and_west = wide == statement.is("walls", "short");
  constexpr std::array sides = {std::array{"north", "south"}, std::array{"east", "west"}};
  for (const char* wall : sides[east_and_west ? 1 : 0]) {
    plan::Requirement& door = reading.add(plan::RequirementKind::opening, statement.span);
    door.subject = statement.parts("door").front()->text("name");
    door.object = wall;
    door.value = 1;
  }
  return true;
}

}  // namespace marketgen::intake
