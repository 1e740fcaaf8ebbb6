// What was asked for, wish by wish: the one form that planner, store and audit share.
//
// A planner writes requirements (intake), the manifest of a store keeps them, and the audit judges
// them on the finished store without knowing the planner.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "plan/plan.h"

namespace marketgen::plan {

enum class RequirementKind {
  size,
  area,
  zone_present,
  zone_absent,
  zone_count,
  fixture_count,
  aisle_count,
  levels,
  relation,
  style,
  profile,
  material,
  color,
  product_present,
  product_absent,
  opening,
  endcaps,
  height,
  aisle_width,
  stock,
  light,
  shelf_pitch,
  run_count,
  time
};
constexpr std::array<std::string_view, 24> names_of(RequirementKind) {
  return {"size",           "area",
          "zone_present",   "zone_absent",
          "zone_count",     "fixture_count",
          "aisle_count",    "levels",
          "relation",       "style",
          "profile",        "material",
          "color",          "product_present",
          "product_absent", "opening",
          "endcaps",        "height",
          "aisle_width",    "stock",
          "light",          "shelf_pitch",
          "run_count",      "time"};
}

enum class Comparison { equal, at_least, at_most };
constexpr std::array<std::string_view, 3> names_of(Comparison) {
  return {"equal", "at_least", "at_most"};
}

// One atomic wish. What its fields mean, by kind:
//   size            value x second_value: width and depth in mm; 0 = that side was not said
//   area            subject: zone type, or "" for the whole floor; value: m2
//   zone_present, zone_absent, zone_count
//                   subject: zone type; value: how many zones of it
//   fixture_count   subject: fixture kind ("checkout_lane"); object: the zone type it implies;
//                   second_object: the zone type in which they are counted, or "" for the store;
//                   value: how many modules
//   run_count       subject, object, second_object as of fixture_count; value: how many straight
//                   lines; second_value: their stocked sides, 0 = any
//   aisle_count     value: aisles between gondolas, the outermost included
//   aisle_width     value: mm
//   levels          subject: zone type, or "" for all gondolas; value: stocked levels
//   shelf_pitch     subject: as of levels; value: mm from board to board
//   height          subject: "fixture" (gondolas), a fixture kind, or "ceiling"; value: mm;
//                   object: zone type, or "" for every zone
//   relation        relation, subject a, object b, second_object c: names of places
//                   (plan/floor_places.h)
//   style, profile  object: id
//   material        subject: floor wall ceiling fixture; object: material id
//   color           subject: fixture or accent; object: #rrggbb
//   product_present, product_absent
//                   subject: name or subcategory of products; object: the zone type that sells them
//   opening         subject: opening kind; object: its wall or ""; second_object: the end of that
//                   wall (a side, or center) or ""; value: how many, 0 = any
//   endcaps         value: 1 wanted, 0 not
//   stock           subject: fill, jitter, out_of_stock, misplaced, tags_missing, tags_wrong_price,
//                   tags_wrong_product or tags_doubled; object: zone type, or "" for every zone;
//                   value: share
//   light           subject: light_kelvin or light_lux; value
//   time            object: weekday and hour, as plans have them ("Sat 17:30")
// What is asked of every zone does not hold for those in `except`.
struct Requirement {
  std::string text;     // the words it came from
  IntRange span{0, 0};  // bytes of the prompt
  RequirementKind kind = RequirementKind::zone_present;
  std::string
      subject;  // zone type, fixture kind, material part, product word, opening kind, relation "a"
  std::string object;               // style, material, colour, profile, relation "b" …
  std::string second_object;        // relation `between`
  std::vector<std::string> except;  // zone types that it does not hold for
  RelationKind relation = RelationKind::near;
  Comparison comparison = Comparison::equal;
  double value = 0, second_value = 0;  // counts, mm, m2, levels; size: width and depth in mm
  Strength strength = Strength::must;

  static constexpr auto fields =
      field_list(field("text", &Requirement::text, "the words it came from"),
                 field("span", &Requirement::span, "bytes of the prompt"),
                 field("kind", &Requirement::kind, "what is asked"),
                 field("subject", &Requirement::subject, "of what"),
                 field("object", &Requirement::object, "what it should be or relate to"),
                 field("second_object", &Requirement::second_object, "second reference"),
                 field("except",
                       &Requirement::except,
                       "zone types that it does not hold for",
                       at_most_items(40)),
                 field("relation", &Requirement::relation, "for relations"),
                 field("comparison", &Requirement::comparison, "for numbers"),
                 field("value", &Requirement::value, "number asked for"),
                 field("second_value", &Requirement::second_value, "second number"),
                 field("strength", &Requirement::strength, "must or prefer"));
};

}  // namespace marketgen::plan
