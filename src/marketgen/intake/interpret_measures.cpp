#include <algorithm>
#include <cmath>

#include "intake/interpret.h"
#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using Kind = plan::RequirementKind;

constexpr double metre_mm = 1000;
// Two bare numbers are metres when a shop could have that size.
constexpr double min_store_m = 4, max_store_m = 200;

bool floor_is_known(const Reading& reading) {
  const plan::Requirement* size = reading.found.find(Kind::size);
  return reading.found.find(Kind::area, "") != nullptr ||
         (size != nullptr && size->value > 0 && size->second_value > 0);
}

bool is_goods(const Segment& segment) {
  return segment.sense == Sense::zone || segment.sense == Sense::product;
}

// The segment that holds a token.
std::size_t segment_of(const Reading& reading, int token) {
  const auto& segments = *reading.segments;
  const auto at = std::ranges::find_if(segments, [&](const Segment& segment) {
    return static_cast<std::size_t>(token) < segment.last;
  });
  return static_cast<std::size_t>(at - segments.begin());
}

// "a kiosk with snacks and drinks of 40 m2": the kiosk has them all.
bool is_one_of_many(const Reading& reading, const Meaning& zone) {
  const auto& segments = *reading.segments;
  const std::size_t at = segment_of(reading, zone.words.front());
  const bool listed = at >= 2 && segments[at - 1].sense == Sense::separator &&
                      !segments[at - 1].content && is_goods(segments[at - 2]);
  return listed && !shop_is_measured(reading) &&
         std::any_of(
             segments.begin(), segments.begin() + static_cast<std::ptrdiff_t>(at), names_a_shop);
}

// The one thing that was asked for is "a bakery of 20 m2".
bool is_the_shop(const Reading& reading, const Meaning& zone) {
  if (!reading.first_sentence || shop_is_measured(reading) || zone.number("own_shop") != 1)
    return false;
  const auto& segments = *reading.segments;
  const std::size_t at = segment_of(reading, zone.words.front());
  return std::ranges::none_of(segments, names_a_shop) &&
         std::none_of(
             segments.begin(), segments.begin() + static_cast<std::ptrdiff_t>(at), is_goods);
}

// Of the zone, or of the shop.
std::string owner_of(const Reading& reading, const Meaning* zone, bool after) {
  if (zone == nullptr || is_the_shop(reading, *zone)) return "";
  if (!after && is_one_of_many(reading, *zone)) return "";
  return zone->text("zone");
}

bool add_sides(Reading& reading, const Meaning& sides, IntRange span, const std::string& zone) {
  const double width = sides.number("width"), depth = sides.number("depth");
  const auto possible = [](double side) {
    return side >= min_store_m * metre_mm && side <= max_store_m * metre_mm;
  };
  if (width <= 0 || depth <= 0) return false;
  if (sides.has("bare") && !(possible(width) && possible(depth))) return false;
  if (zone.empty()) {
    plan::Requirement& size = reading.add(Kind::size, span);
    size.value = width;
    size.second_value = depth;
    return true;
  }
  plan::Requirement& area = reading.add(Kind::area, span);
  area.subject = zone;
  area.value = 1e-6 * width * depth;
  return true;
}

// "No aisle narrower than 1.5 m" turns its comparison round.
Meaning measure_of(const Meaning& statement) {
  Meaning measure = *statement.parts("measure").front();
  if (statement.has("comparison")) measure.slots["comparison"] = statement.text("comparison");
  return measure;
}

void mention_parts(Reading& reading, const language::Parts& parts) {
  for (const language::MeaningPtr& part : parts) {
    if (part->has("type")) mention(reading, *part);
  }
}

bool stands_in_gondolas(const Reading& reading, const std::string& zone) {
  const catalog::ZoneTypeRow* row = reading.catalog.zone_type(zone);
  return row != nullptr && row->fixture == "gondola";
}

}  // namespace

bool shop_is_measured(const Reading& reading) {
  return reading.found.find(Kind::size) != nullptr || reading.found.find(Kind::area, "") != nullptr;
}

bool names_a_shop(const Segment& segment) {
  return segment.sense == Sense::shop || segment.sense == Sense::profile;
}

bool add_floor(Reading& reading, const Meaning& floor, const Meaning* zone, bool after) {
  const std::string owner = owner_of(reading, zone, after);
  for (const language::MeaningPtr& sides : floor.parts("sides"))
    if (!add_sides(reading, *sides, floor.span, owner)) return false;
  for (const language::MeaningPtr& extent : floor.parts("extent")) {
    plan::Requirement area = reading.wish(Kind::area, floor.span);
    area.subject = owner;
    add_number(reading, area, *extent, false);
  }
  return true;
}

bool interpret_floor(Reading& reading, const Meaning& statement) {
  const language::Parts& zones = statement.parts("zone");
  const Meaning* zone = zones.empty() ? nullptr : zones.front().get();
  // A second size is of something that the grammar did not see, unless the shop is named with it.
  if (zone == nullptr && !statement.has("shop") && floor_is_known(reading)) return false;
  if (!add_floor(reading, *statement.parts("floor").front(), zone, statement.has("after")))
    return false;
  mention_parts(reading, zones);
  interpret_also(reading, statement);
  return true;
}

// "And has 90 m2": the zone that was named last, once the shop's own floor is known; else the shop.
bool interpret_floor_of_last(Reading& reading, const Meaning& statement) {
  const std::vector<language::Parts>& recent = reading.memory->recent;
  const bool one = !recent.empty() && zones_of(recent.back()).size() == 1;
  // Two sides are nearly always those of the room.
  const bool sides = !statement.parts("floor").front()->parts("sides").empty();
  const bool of_shop = !one || (!statement.has("zone") && (reading.first_sentence || sides) &&
                                !shop_is_measured(reading));
  const Meaning* zone = of_shop ? nullptr : recent.back().front().get();
  if (zone == nullptr && floor_is_known(reading)) return false;
  if (zone != nullptr && zone->text("zone").empty()) return false;
  return add_floor(reading, *statement.parts("floor").front(), zone, false);
}

bool interpret_floor_each(Reading& reading, const Meaning& statement) {
  bool any = false;
  for (const language::MeaningPtr& zone : statement.parts("things")) {
    if (zone->text("zone").empty()) continue;
    any = add_floor(reading, *statement.parts("floor").front(), zone.get(), true) || any;
    mention(reading, *zone);
  }
  return any;
}

bool interpret_side(Reading& reading, const Meaning& statement) {
  const Meaning& side = *statement.parts("side").front();
  const double value = side.number("value");
  if (value < min_store_m * metre_mm || value > max_store_m * metre_mm || shop_is_measured(reading))
    return false;
  plan::Requirement& size = reading.add(Kind::size, side.span);
  (side.is("side", "width") ? size.value : size.second_value) = value;
  interpret_also(reading, statement);
  return true;
}

bool interpret_levels(Reading& reading, const Meaning& statement) {
  const Meaning& count = *statement.parts("count").front();
  if (!is_whole(count)) return false;  // "3.2 Every shelf": a heading's number
  plan::Requirement levels = reading.wish(Kind::levels, count.span);
  levels.subject = statement.text("zone");
  add_limit(reading, levels, &plan::Requirement::subject, count, true);
  mention_parts(reading, statement.parts("things"));
  for (const language::MeaningPtr& zone : statement.parts("mentions"))
    reading.add(Kind::zone_present, zone->span).subject = zone->text("value");
  return true;
}

bool interpret_rows(Reading& reading, const Meaning& statement) {
  // A number that an int holds; how many rows make sense is decided later (limits.h).
  constexpr double max_rows_read = 1e6;
  const Meaning& zone = *statement.parts("zone").front();
  const double rows = statement.parts("count").front()->number("value");
  if (rows < 1) return false;
  if (stands_in_gondolas(reading, zone.text("zone"))) {  // rows of shelves are runs
    plan::Requirement runs = reading.wish(Kind::run_count, statement.span);
    runs.subject = "gondola";
    runs.object = runs.second_object = zone.text("zone");
    add_number(reading, runs, *statement.parts("count").front(), true);
    mention(reading, zone);
    return true;
  }
  reading.found.rows.push_back(
      {zone.text("zone"), static_cast<int>(std::min(rows, max_rows_read)), statement.span});
  mention(reading, zone);
  return true;
}

bool interpret_aisles(Reading& reading, const Meaning& statement) {
  const Meaning& count = *statement.parts("count").front();
  if (count.number("value") < 1) return false;
  add_number(reading, reading.wish(Kind::aisle_count, statement.span), count, true);
  return true;
}

bool interpret_aisle_width(Reading& reading, const Meaning& statement) {
  if (!reading.about.empty()) return false;  // an aisle runs past many zones
  plan::Requirement width = reading.wish(Kind::aisle_width, statement.span);
  width.except = reading.except;
  add_number(reading, width, measure_of(statement), false);
  return true;
}

bool interpret_height(Reading& reading, const Meaning& statement) {
  plan::Requirement height = reading.wish(Kind::height, statement.span);
  height.subject = statement.text("of");
  if (height.subject == "ceiling")
    add_number(reading, height, measure_of(statement), false);
  else
    add_limit(reading, height, &plan::Requirement::object, measure_of(statement), false);
  return true;
}

// "1.1 m between them": shelves, or boards when people could not pass.
bool interpret_gap(Reading& reading, const Meaning& statement) {
  constexpr double narrowest_aisle_mm = 600;
  if (measure_of(statement).number("value") < narrowest_aisle_mm)
    return interpret_shelf_pitch(reading, statement);
  return interpret_aisle_width(reading, statement);
}

bool interpret_shelf_pitch(Reading& reading, const Meaning& statement) {
  constexpr double closest_mm = 80, widest_mm = 1500;  // limits of FixtureSpec::spacing_mm
  const Meaning measure = measure_of(statement);
  if (measure.number("value") < closest_mm || measure.number("value") > widest_mm) return false;
  plan::Requirement pitch = reading.wish(Kind::shelf_pitch, statement.span);
  add_limit(reading, pitch, &plan::Requirement::subject, measure, false);
  return true;
}

}  // namespace marketgen::intake
