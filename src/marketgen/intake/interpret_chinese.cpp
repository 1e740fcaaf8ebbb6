// What Chinese says by leaving it out: whose floor it is, what lacks the fixtures.
#include <algorithm>

#include "intake/interpret.h"
#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;
using language::Parts;
using Kind = plan::RequirementKind;

// The zone that was named last.
std::string zone_spoken_of(const Reading& reading) {
  if (reading.memory->recent.empty()) return "";
  return reading.memory->recent.back().back()->text("zone");
}

// The number that is said of it is a least or most one.
void compare(Meaning& thing, const std::string& comparison) {
  Meaning number = *thing.parts("count").front();
  number.slots["comparison"] = comparison;
  thing.slots["count"] = Parts{std::make_shared<Meaning>(std::move(number))};
}

}  // namespace

// "面宽20米，进深15米": always the shop's, so that a second one contradicts the first.
bool interpret_floor_of_shop(Reading& reading, const Meaning& statement) {
  return add_floor(reading, statement, nullptr, false);
}

// "果蔬沿西墙，不少于100平方米": a size with no owner is that of the zone that was spoken of,
// unless the sentence names a shop whose floor is not known yet.
bool interpret_floor_of_it(Reading& reading, const Meaning& statement) {
  const Meaning& extent = *statement.parts("extent").front();
  const std::string zone = zone_spoken_of(reading);
  const bool shop_is_named = std::ranges::any_of(*reading.segments, names_a_shop);
  const bool of_shop = !shop_is_measured(reading) && (zone.empty() || shop_is_named);
  if (!of_shop && zone.empty()) return false;
  plan::Requirement area = reading.wish(Kind::area, extent.span);
  if (!of_shop) area.subject = zone;
  add_number(reading, area, extent, false);
  return true;
}

// "冷藏柜沿左墙，一共八台", "put freezers there, nine of them": so many of what was named last.
bool interpret_count_of_it(Reading& reading, const Meaning& statement) {
  if (reading.memory->recent.empty()) return false;
  Meaning thing = *reading.memory->recent.back().back();
  const bool counted = thing.is("type", "fixture") || thing.text("name").ends_with("checkout");
  const char* slot = statement.has("runs") ? "runs" : "count";
  if (thing.has(slot) || !counted) return false;
  if (statement.has("runs") && !thing.is("type", "fixture")) return false;
  thing.slots[slot] = statement.parts(slot);
  thing.span = statement.span;
  if (!statement.has("runs")) {
    if (statement.has("comparison")) compare(thing, statement.text("comparison"));
    add_count(reading, thing);
    return true;
  }
  thing.slots.erase("each");
  add_runs(reading, thing);
  return true;
}

// "冷冻区不要岛柜": none of those fixtures there.
bool interpret_lacking(Reading& reading, const Meaning& statement) {
  const Parts things = resolved(reading, statement.parts("things"));
  if (things.empty()) return false;
  interpret_mention(reading, statement);
  const std::string zone = things.back()->text("zone");
  for (const MeaningPtr& thing : statement.parts("without")) {
    PlaceNoun noun = noun_of(*thing);
    if (noun.kind == NounKind::fixture && !zone.empty()) noun.zone = zone;
    add_none(reading, noun, joined(statement.span, noun.span));
  }
  return true;
}

// "粮油、罐头、零食一律五层货架": of each.
bool interpret_levels_of(Reading& reading, const Meaning& statement) {
  interpret_mention(reading, statement);
  const Meaning& count = *statement.parts("count").front();
  for (const MeaningPtr& thing : statement.parts("things")) {
    if (thing->text("zone").empty()) continue;
    plan::Requirement levels = reading.wish(Kind::levels, statement.span);
    levels.subject = thing->text("zone");
    add_number(reading, levels, count, true);
  }
  return true;
}

// "窗：南墙4扇": so many at a place.
bool interpret_doors_at(Reading& reading, const Meaning& statement) {
  auto door = std::make_shared<Meaning>(*statement.parts("door").front());
  door->slots.erase("count");
  Meaning placed = statement;
  placed.slots["things"] = Parts{std::move(door)};
  const std::size_t first = reading.found.requirements.size();
  if (!interpret_placed(reading, placed) || reading.found.requirements.size() == first)
    return false;
  plan::Requirement& wish = reading.found.requirements[first];
  wish.value = statement.parts("count").front()->number("value");
  wish.span = joined(wish.span, statement.span);
  wish.text = reading.words(wish.span);
  return true;
}

// "紧急出口两个，北墙一个，东墙一个", "两个入口，分别在东墙和西墙": each place has its own.
bool interpret_doors_shared(Reading& reading, const Meaning& statement) {
  bool any = false;
  for (const MeaningPtr& part : statement.parts("parts")) {
    Meaning place;
    place.slots["relation"] = "at";
    place.slots["objects"] = part->parts("at");
    place.span = part->span;
    const bool spots = part->parts("at").front()->is("type", "place");
    Meaning lot = statement;
    lot.span = part->span;
    lot.slots["door"] = statement.parts("things");
    lot.slots["at"] =
        spots ? Parts{std::make_shared<Meaning>(std::move(place))} : part->parts("at");
    if (part->has("count")) lot.slots["count"] = part->parts("count");
    if (!part->has("count")) {
      Meaning one;
      one.slots["value"] = 1.0;
      lot.slots["count"] = Parts{std::make_shared<Meaning>(std::move(one))};
    }
    any = interpret_doors_at(reading, lot) || any;
  }
  return any;
}

// "货架黑色、钢制": each word for itself.
bool interpret_surfaces(Reading& reading, const Meaning& statement) {
  bool any = false;
  for (const MeaningPtr& word : statement.parts("surface")) {
    Meaning surface;
    surface.slots["words"] = Parts{word};
    surface.span = word->span;
    Meaning one = statement;
    one.slots["surface"] = Parts{std::make_shared<Meaning>(std::move(surface))};
    any = interpret_surface(reading, one) || any;
  }
  return any;
}

// "Frozen food, deli and wine at the left, back and right wall respectively": of the last list when
// none is named.
bool interpret_placed_each(Reading& reading, const Meaning& statement) {
  const std::vector<Parts>& recent = reading.memory->recent;
  const bool named = statement.has("things");
  Parts things = named ? statement.parts("things") : Parts{};
  const Parts& places = statement.parts("places");
  for (std::size_t i = recent.size(); !named && i-- > 0 && things.size() < places.size();)
    things.insert(things.begin(), recent[i].begin(), recent[i].end());
  if (things.size() != places.size()) return false;
  if (named) interpret_mention(reading, statement);
  bool any = false;
  for (std::size_t i = 0; i < things.size(); ++i)
    any = add_relation(reading, {"at", false, noun_of(*things[i]), {noun_of(*places[i])}}) || any;
  return any;
}

// "粮油、罐头各两排双面货架": so many in each.
bool interpret_runs_each(Reading& reading, const Meaning& statement) {
  bool any = false;
  for (const MeaningPtr& thing : statement.parts("things")) {
    const std::string& zone = thing->text("zone");
    if (zone.empty()) continue;
    Meaning runs = standing_in(*statement.parts("fixture").front(), zone);
    runs.slots["runs"] = statement.parts("runs");
    runs.span = joined(thing->span, statement.span);
    mention(reading, runs);
    any = true;
  }
  return any && interpret_mention(reading, statement);
}

// "没有缺货"
bool interpret_none_of_stock(Reading& reading, const Meaning& statement) {
  plan::Requirement& stock = reading.add(Kind::stock, statement.span);
  stock.subject = statement.text("value");
  stock.comparison = plan::Comparison::at_most;
  return true;
}

}  // namespace marketgen::intake
