// Numbers that are said of some zones and not of others.
#include <algorithm>
#include <utility>

#include "intake/interpret.h"
#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;
using language::Parts;
using Kind = plan::RequirementKind;

void mention_zones(Reading& reading, const Parts& things) {
  for (const MeaningPtr& thing : things)
    if (!thing->text("zone").empty()) mention(reading, *thing);
}

// Interprets statements as said of those zones only.
bool interpret_about(Reading& reading, const Parts& limits, std::vector<std::string> zones) {
  bool any = false;
  std::swap(reading.about, zones);
  for (const MeaningPtr& limit : limits)
    any = interpret(reading, *limit) || any;
  std::swap(reading.about, zones);
  return any;
}

bool interpret_states(Reading& reading, const Parts& states, std::vector<std::string> zones) {
  std::swap(reading.about, zones);
  for (const MeaningPtr& state : states)
    interpret_stock(reading, *state);
  std::swap(reading.about, zones);
  return !states.empty();
}

// The field that holds a requirement's zone, of the kinds that a zone can have for itself.
std::string plan::Requirement::*zone_field(Kind kind) {
  if (kind == Kind::levels || kind == Kind::shelf_pitch) return &plan::Requirement::subject;
  if (kind == Kind::height || kind == Kind::stock) return &plan::Requirement::object;
  return nullptr;
}

std::vector<std::string> zones_with_stock(const Understanding& found) {
  std::vector<std::string> zones;
  for (const plan::Requirement& wish : found.requirements)
    if (wish.kind == Kind::stock && !wish.object.empty()) zones.push_back(wish.object);
  return zones;
}

plan::Comparison comparison_of(const Meaning& said) {
  return value_named<plan::Comparison>(said.text("comparison")).value_or(plan::Comparison::equal);
}

// Full shelves and gaps are floors, order is a ceiling; the row says which side its number is on. A
// share that was said is the number itself, "nothing missing" is none.
void fill_stock(plan::Requirement& stock, const Meaning& said) {
  stock.subject = said.text("value");
  stock.value = said.number("number");
  stock.comparison = comparison_of(said);
  if (said.has("share")) {
    stock.value = said.number("share");
    stock.comparison = plan::Comparison::equal;
  }
  if (said.has("empty")) stock.value = 1 - said.number("empty");
  if (!said.has("none")) return;
  stock.value = 0;
  stock.comparison = plan::Comparison::at_most;
}

}  // namespace

// "Canned goods: shelf pitch 9 inches, six boards high."
bool interpret_limited(Reading& reading, const Meaning& statement) {
  const Parts things = resolved(reading, statement.parts("things"));
  const std::vector<std::string> zones = zones_of(things);
  if (zones.empty() || !interpret_about(reading, statement.parts("also"), zones)) return false;
  mention_zones(reading, things);
  return true;
}

// "Five levels everywhere but in the baby aisle, three there."
bool interpret_excepting(Reading& reading, const Meaning& statement) {
  const Parts& things = statement.parts("except");
  const std::vector<std::string> zones = zones_of(things);
  if (zones.empty()) return false;
  std::vector<std::string> except = zones;
  std::swap(reading.except, except);
  const bool understood = interpret_about(reading, statement.parts("also"), {}) ||
                          interpret_states(reading, statement.parts("states"), {});
  std::swap(reading.except, except);
  if (!understood) return false;
  for (const MeaningPtr& limit : statement.parts("also")) {
    Meaning there = *limit;  // the same, of another number
    for (const char* slot : {"count", "measure"})
      if (statement.has(slot)) there.slots[slot] = statement.parts(slot);
    there.span = joined(things.front()->span, statement.span);
    if (statement.has("count") || statement.has("measure"))
      interpret_about(reading, {std::make_shared<Meaning>(std::move(there))}, zones);
  }
  interpret_states(reading, statement.parts("there"), zones);
  mention_zones(reading, things);
  return true;
}

// "Produce and dairy take up 120 and 80 m2 respectively": the first the first, and so on.
bool interpret_respectively(Reading& reading, const Meaning& statement) {
  const Parts& things = statement.parts("things");
  const Parts& numbers = statement.parts("numbers");
  if (things.size() != numbers.size()) return false;
  for (std::size_t i = 0; i < things.size(); ++i) {
    const std::string& type = things[i]->text("zone");
    if (type.empty()) return false;
    plan::Requirement wish =
        reading.wish(statement.is("of", "area") ? Kind::area : Kind::levels, statement.span);
    wish.subject = type;
    Meaning number = *numbers[i];
    if (statement.has("per"))
      number.slots["value"] = number.number("value") * statement.number("per");
    add_number(reading, wish, number, true);
  }
  Meaning named = statement;
  Parts ones = things;
  auto last = std::make_shared<Meaning>(*things.back());
  const auto count = static_cast<double>(things.size());  // "all three": not of the last one
  if (last->has("count") && last->parts("count").front()->number("value") == count)
    last->slots.erase("count");
  ones.back() = std::move(last);
  named.slots["things"] = std::move(ones);
  return interpret_mention(reading, named);
}

// "Detergents exactly as the dry goods": whatever the other zone has for itself.
bool interpret_same_as(Reading& reading, const Meaning& statement) {
  const std::vector<std::string> zones = zones_of(statement.parts("things"));
  const std::vector<std::string> models = zones_of(resolved(reading, statement.parts("as")));
  if (zones.empty() || models.size() != 1) return false;
  std::vector<plan::Requirement> copies;
  for (const plan::Requirement& wish : reading.found.requirements) {
    std::string plan::Requirement::*const field = zone_field(wish.kind);
    const bool asked = !statement.has("of") || name_of(wish.kind) == statement.text("of");
    if (field == nullptr || wish.*field != models.front() || !asked) continue;
    for (const std::string& zone : zones) {
      plan::Requirement copy = wish;
      copy.*field = zone;
      copy.span = statement.span;
      copy.text = reading.words(statement.span);
      copies.push_back(std::move(copy));
    }
  }
  if (copies.empty()) return false;
  std::ranges::move(copies, std::back_inserter(reading.found.requirements));
  mention_zones(reading, statement.parts("things"));
  return true;
}

// "Twice as much floor for fruit as for dairy", "half as much again as": settled when the prompt is
// read, for the other area may stand after it.
bool interpret_ratio(Reading& reading, const Meaning& statement) {
  const std::vector<std::string> zones = zones_of(statement.parts("things"));
  const std::vector<std::string> models = zones_of(statement.parts("as"));
  const double factor =
      statement.number("factor", 1) + statement.number("more") - statement.number("less");
  if (zones.size() != 1 || models.size() != 1 || zones == models || factor <= 0) return false;
  reading.found.ratios.push_back({zones.front(),
                                  models.front(),
                                  factor,
                                  reading.strength,
                                  reading.words(statement.span),
                                  statement.span});
  mention_zones(reading, statement.parts("things"));
  mention_zones(reading, statement.parts("as"));
  return true;
}

// Each state of the same goods: "tidy and well stocked".
bool interpret_stocks(Reading& reading, const Meaning& statement) {
  bool any = false;
  for (const MeaningPtr& state : statement.parts("states")) {
    Meaning one = *state;
    for (const char* slot : {"things", "rest"})
      if (const auto said = statement.slots.find(slot); said != statement.slots.end())
        one.slots.insert(*said);
    one.span = statement.span;
    any = interpret_stock(reading, one) || any;
  }
  return any;
}

// Of the zones that are named, of all, or ("everything else") of those of which nothing was said.
bool interpret_stock(Reading& reading, const Meaning& statement) {
  plan::Requirement stock = reading.wish(Kind::stock, statement.span);
  fill_stock(stock, statement);
  const Parts things = resolved(reading, statement.parts("things"));
  std::vector<std::string> zones = zones_of(things);
  if (!things.empty() && zones.empty()) return false;
  if (zones.empty()) zones = reading.about;
  if (zones.empty()) {
    stock.except = statement.has("rest") ? zones_with_stock(reading.found) : reading.except;
    reading.found.requirements.push_back(std::move(stock));
    return true;
  }
  for (const std::string& zone : zones) {
    stock.object = zone;
    reading.found.requirements.push_back(stock);
  }
  mention_zones(reading, things);
  remember(reading, things);
  return true;
}

}  // namespace marketgen::intake
