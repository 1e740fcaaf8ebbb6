// Does one thing stand near, behind, between … others, and by how much? One signed measure for
// planners, layout rules and the audit.
//
// A relation is measured between rectangles of floor (plan/floor_places.h). It holds when its slack
// is at least 0 m; whoever still changes the floor asks for more than that, by a margin of their
// own, and the audit asks for none. Left, right and behind are seen by someone who comes in at the
// first entrance, and go by the rectangles' centres; every other distance is between edges.
//
//   near          gap at most 20 % of the floor's diagonal, or 3 m
//   far           gap at least 35 % of the diagonal
//   along, at     of a wall or the middle: reaches into it, with at least half of its own length;
//                 of a zone or a door: a gap of at most 1.5 m
//   left_of, right_of, behind
//                 centres at least 0.1 m apart that way
//   facing        side by side along 0.1 m at least, at most 6 m apart, not in one another
//   between       its centre lies between the two others', and the way over it from one to the
//   other
//                 is at most 15 % of the diagonal longer than straight on
//   not_adjacent  gap at least 1 m, an aisle
//
// Where several places go by a name, far and not_adjacent are to hold for every pair, the others
// for one. A relation to something that the floor does not have cannot be judged: it neither holds
// nor is broken.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "plan/floor_places.h"
#include "plan/requirement.h"

namespace marketgen::plan {

// Limits. No standard says how near "near" is: these are our own definitions (docs/metrics.md),
// scaled with the shop, except where an aisle is the measure.
constexpr double near_share = 0.20, far_share = 0.35, detour_share = 0.15;  // of the diagonal
constexpr double min_near_m = 3;
constexpr double beside_m = 1e-3 * wall_strip_mm;  // "at" a zone or a door, as at a wall
constexpr double in_line_m = 0.1;                  // centres nearer than this are in one line
constexpr double facing_m = 6;                     // across the widest aisle
constexpr double not_adjacent_m = 1;  // an aisle between: minimum_aisle_mm of every profile

// The words of a relation, whoever said it. `c` is empty except for `between`.
struct RelationTerms {
  RelationKind kind = RelationKind::near;
  std::string_view a, b;
  std::string_view c = {};
};
RelationTerms terms_of(const Relation& relation);
RelationTerms terms_of(const Requirement& wish);  // of kind `relation`

// What decides a relation: the condition of it that is missed most, or kept most narrowly.
struct RelationMeasure {
  std::string_view what;  // "gap", "offset", "length shared"
  double measured_m = 0, limit_m = 0;
  bool at_least = false;  // the limit is a lower one
  PointMm at_mm{0, 0};    // the middle of the place `a` that decides

  double slack_m() const { return at_least ? measured_m - limit_m : limit_m - measured_m; }
  bool holds() const { return slack_m() >= 0; }
};

// Nothing when a name stands for nothing on this floor, or both for the same thing.
std::optional<RelationMeasure> measure_relation(const NamedFloor& floor,
                                                const RelationTerms& relation);

// The first name of the relation that stands for nothing on this floor; empty when there is none.
std::string_view missing_place(const NamedFloor& floor, const RelationTerms& relation);

// "dairy near entrance: gap 7.6 m, at most 4.5 m holds", or why it cannot be judged.
std::string words_of(const NamedFloor& floor,
                     const RelationTerms& relation,
                     const std::optional<RelationMeasure>& measure);

double diagonal_m(const RectMm& floor);

}  // namespace marketgen::plan
