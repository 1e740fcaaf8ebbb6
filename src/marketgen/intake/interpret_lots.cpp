// What was counted before, shared among zones: "ten runs: four of them hold dry goods, three
// snacks".
#include <algorithm>
#include <memory>

#include "intake/interpret.h"
#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;
using language::Parts;

// Lines have their number within them.
MeaningPtr number_of(const MeaningPtr& count) {
  return count->has("count") ? count->parts("count").front() : count;
}

}  // namespace

MeaningPtr last_fixture(const Reading& reading) {
  const std::vector<Parts>& recent = reading.memory->recent;
  for (std::size_t i = recent.size(); i-- > 0;) {
    const auto fixture = std::ranges::find_if(
        recent[i], [](const MeaningPtr& thing) { return thing->is("type", "fixture"); });
    if (fixture != recent[i].end()) return *fixture;
  }
  return nullptr;
}

bool interpret_lots(Reading& reading, const Meaning& statement) {
  const Parts& named = statement.parts("fixture");
  const MeaningPtr fixture = named.empty() ? last_fixture(reading) : named.front();
  const Parts &zones = statement.parts("zones"), &counts = statement.parts("counts");
  if (fixture == nullptr || zones.size() != counts.size()) return false;
  const char* slot = fixture->has("runs") ? "runs" : "count";
  for (std::size_t i = 0; i < zones.size(); ++i) {
    if (zones[i]->text("zone").empty()) return false;
    Meaning lot = standing_in(*fixture, zones[i]->text("zone"));
    for (const char* said : {"count", "runs", "each", "holds"})
      lot.slots.erase(said);
    lot.slots[slot] = Parts{number_of(counts[i])};
    lot.span = joined(zones[i]->span, lot.parts(slot).front()->span);
    mention(reading, lot);
    mention(reading, *zones[i]);
  }
  return true;
}

}  // namespace marketgen::intake
