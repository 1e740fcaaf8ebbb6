// What is not there, or stands in place of something else.
#include <algorithm>

#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;
using language::Parts;

void add_none(Reading& reading, const Meaning& thing, IntRange span) {
  PlaceNoun noun = noun_of(thing);
  noun.negated = true;
  noun.counted = false;
  noun.span = span;
  add_mention(reading, noun);
}

bool is_equipment(const Reading& reading, const Meaning& thing) {
  const catalog::FixtureKind* kind =
      thing.is("type", "fixture") ? reading.catalog.fixture_kind(thing.text("name")) : nullptr;
  return kind != nullptr && kind->role == catalog::FixtureRole::equipment;
}

}  // namespace

// "No gondolas in the offers area", "no gates by the entrance", "no frozen food by the door": of
// furniture none in that zone, of equipment none at all, of goods not there.
bool interpret_absent_at(Reading& reading, const Meaning& statement) {
  const MeaningPtr& thing = statement.parts("things").front();
  const Meaning* zone = statement.has("zone") ? statement.parts("zone").front().get() : nullptr;
  const bool furniture = zone != nullptr && !zone->text("zone").empty() &&
                         are_furniture(reading, statement.parts("things"));
  if (furniture) {
    add_none(reading, standing_in(*thing, zone->text("zone")), statement.span);
    mention(reading, *zone);
    return true;
  }
  if (is_equipment(reading, *thing) || zone != nullptr) {
    add_none(reading, *thing, statement.span);
    if (zone != nullptr) mention(reading, *zone);
    return true;
  }
  Meaning denied = statement;
  denied.slots["denied"] = std::string("yes");
  denied.slots["unwanted"] = std::string("yes");
  return interpret_placed(reading, denied);
}

// "Swap the multidecks in dairy for glass-door coolers": the new stand where the old stood.
bool interpret_replaced(Reading& reading, const Meaning& statement) {
  const Parts& old = statement.parts("old");
  const Parts& things = statement.parts("things");
  const bool furniture = are_furniture(reading, old) && are_furniture(reading, things);
  const Meaning* said = statement.has("zone") ? statement.parts("zone").front().get() : nullptr;
  const std::string zone = said != nullptr ? said->text("zone")
                           : furniture     ? old.front()->text("zone")
                                           : std::string();
  const IntRange span = {statement.span[0], things.front()->span[0]};
  for (const MeaningPtr& thing : old)
    add_none(reading, furniture && said ? standing_in(*thing, zone) : *thing, span);
  for (const MeaningPtr& thing : things)
    mention(reading, furniture && !zone.empty() ? standing_in(*thing, zone) : *thing);
  if (said != nullptr) mention(reading, *said);
  remember(reading, things);
  return true;
}

// "Forty pallets in the drinks section and fifteen in dry goods", "and another for fish": of the
// fixture that was named last, or that the statement names.
bool interpret_so_many_in(Reading& reading, const Meaning& statement) {
  const MeaningPtr fixture =
      statement.has("fixture") ? statement.parts("fixture").front() : last_fixture(reading);
  const Meaning& zone = *statement.parts("zone").front();
  if (!fixture || zone.text("zone").empty()) return false;
  Meaning standing = standing_in(*fixture, zone.text("zone"));
  standing.span = statement.span;
  standing.slots.erase("runs");
  standing.slots.erase("count");
  plan::Requirement count = reading.wish(plan::RequirementKind::fixture_count, statement.span);
  count.subject = standing.text("name");
  count.object = count.second_object = zone.text("zone");
  Meaning one;
  one.slots["value"] = 1.0;
  add_number(
      reading, count, statement.has("count") ? *statement.parts("count").front() : one, true);
  mention(reading, zone);
  return true;
}

}  // namespace marketgen::intake
