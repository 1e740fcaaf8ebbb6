// From what edit.grammar reads to changes and wishes.
#include <algorithm>
#include <utility>

#include "intake/interpret.h"
#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;

constexpr double usual_step = 0.25;  // "larger": by so much. Our own figure
constexpr double largest_step = 9, smallest_left = 0.05;

WordedChange change_of(const Reading& reading, ChangeAction action, IntRange span) {
  WordedChange change;
  change.action = action;
  change.span = span;
  change.text = reading.words(span);
  return change;
}

// What mentioning the thing asks for, apart from what was understood so far.
std::vector<plan::Requirement> wishes_of(const Reading& reading, const Meaning& thing) {
  Understanding apart;
  Reading only{reading.prompt, reading.catalog, apart};
  only.segments = reading.segments;
  only.memory = reading.memory;
  mention(only, thing);
  return std::move(apart.requirements);
}

bool is_till_kind(const Reading& reading, const std::string& kind) {
  const catalog::FixtureKind* row = reading.catalog.fixture_kind(kind);
  return row != nullptr && row->role == catalog::FixtureRole::checkout;
}

bool add_counted(Reading& reading, const Meaning& thing, ChangeAction action, IntRange span) {
  bool any = false;
  for (const plan::Requirement& wish : wishes_of(reading, thing)) {
    WordedChange change = change_of(reading, action, span);
    if (wish.kind == plan::RequirementKind::fixture_count && is_till_kind(reading, wish.subject)) {
      change.subject = wish.object;
      change.object = wish.subject;
      change.value = std::max(1.0, wish.value);
    } else if (wish.kind == plan::RequirementKind::zone_present ||
               wish.kind == plan::RequirementKind::zone_count) {
      change.subject = wish.subject;
    } else {
      continue;
    }
    reading.found.changes.push_back(std::move(change));
    any = true;
  }
  return any;
}

}  // namespace

bool interpret_swap(Reading& reading, const Meaning& said) {
  const language::Parts& things = said.parts("things");
  if (things.size() != 2) return false;
  WordedChange change = change_of(reading, ChangeAction::swap, said.span);
  change.subject = things[0]->text("zone");
  change.object = things[1]->text("zone");
  if (change.subject.empty() || change.object.empty()) return false;
  reading.found.changes.push_back(std::move(change));
  return true;
}

bool interpret_resize(Reading& reading, const Meaning& said) {
  WordedChange change = change_of(reading, ChangeAction::resize, said.span);
  change.subject = said.text("zone");
  if (change.subject.empty()) return false;
  if (said.has("area")) {
    change.value = said.number("area");
  } else {
    const double step = said.number("share", usual_step);
    change.relative = true;
    change.value = said.is("sign", "less") ? std::max(smallest_left, 1 - step)
                                           : 1 + std::min(step, largest_step);
  }
  reading.found.changes.push_back(std::move(change));
  return true;
}

bool interpret_more(Reading& reading, const Meaning& said) {
  bool any = false;
  for (const MeaningPtr& thing : said.parts("things"))
    any = add_counted(reading, *thing, ChangeAction::more, said.span) || any;
  if (!any) return interpret_mention(reading, said);
  if (!said.parts("at").empty()) {
    Meaning placed = said;
    placed.slots["kind"] = std::string("placed");
    interpret(reading, placed);
  }
  return true;
}

bool interpret_fewer(Reading& reading, const Meaning& said) {
  bool any = false;
  for (const MeaningPtr& thing : said.parts("things"))
    any = add_counted(reading, *thing, ChangeAction::fewer, said.span) || any;
  return any || interpret_absent(reading, said);
}

bool interpret_zone_value(Reading& reading, const Meaning& said) {
  WordedChange change = change_of(reading, ChangeAction::set, said.span);
  change.subject = said.text("zone");
  change.object = said.text("field");
  change.value = said.number("number");
  if (change.subject.empty() || change.object.empty()) return false;
  reading.found.changes.push_back(std::move(change));
  return true;
}

}  // namespace marketgen::intake
