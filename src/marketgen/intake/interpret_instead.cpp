// What is not there, or stands in place of something else.
#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;
using language::Parts;

}  // namespace

// "No gondolas in the offers area", "no gates by the entrance", "no frozen food by the door": of
// furniture none in that zone, of equipment none at all, of goods not there.
bool interpret_absent_at(Reading& reading, const Meaning& statement) {
  const MeaningPtr& thing = statement.parts("things").front();
  const Meaning* zone = statement.has("zone") ? statement.parts("zone").front().get() : nullptr;
  const bool furniture = zone != nullptr && !zone->text("zone").empty() &&
                         are_furniture(reading, statement.parts("things"));
  if (furniture) {
    add_none(reading, noun_of(standing_in(*thing, zone->text("zone"))), statement.span);
    mention(reading, *zone);
    return true;
  }
  const catalog::FixtureKind* kind = fixture_kind_of(reading, *thing);
  const bool equipment = kind != nullptr && kind->role == catalog::FixtureRole::equipment;
  if (equipment || zone != nullptr) {
    add_none(reading, noun_of(*thing), statement.span);
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
    add_none(reading, noun_of(furniture && said ? standing_in(*thing, zone) : *thing), span);
  for (const MeaningPtr& thing : things)
    mention(reading, furniture && !zone.empty() ? standing_in(*thing, zone) : *thing);
  if (said != nullptr) mention(reading, *said);
  remember(reading, things);
  return true;
}

}  // namespace marketgen::intake
