// Do the relations that were asked for hold among the rectangles of a candidate?
//
// The definitions are those by which the audit judges the finished store (docs/metrics.md): near is
// a gap of at most 20 % of the store's diagonal (3 m at least), far of at least 35 %; along and at
// a wall means within 1.5 m of it; left, right and behind are seen by someone who comes in.
#pragma once
#include <map>
#include <string_view>
#include <vector>

#include "intake/candidate.h"

namespace marketgen {

// Rectangles of everything that goes by the name: zones of that type, openings of that kind, walls,
// "center", "checkout".
std::vector<RectMm> places_named(const Candidate& candidate,
                                 const StoreProgram& program,
                                 std::string_view name);

// places_named of one candidate, each name looked up once.
class Places {
 public:
  Places(const Candidate& candidate, const StoreProgram& program)
      : candidate_(candidate), program_(program) {}
  const std::vector<RectMm>& named(std::string_view name);
  const Candidate& candidate() const { return candidate_; }

 private:
  const Candidate& candidate_;
  const StoreProgram& program_;
  std::map<std::string_view, std::vector<RectMm>> known_;
};

// How badly the wish is missed: 0 when it holds, otherwise 1 and more with the distance in store
// diagonals added. Precondition: a relation. What it names but the store lacks counts as missed,
// except by `far` and `not_adjacent`.
double miss_of(const Requirement& wish, Places& places);

// Free floor between two rectangles; 0 when they touch or overlap.
double distance_mm(const RectMm& a, const RectMm& b);

}  // namespace marketgen
