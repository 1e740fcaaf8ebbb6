#include "intake/relation_geometry.h"

#include <algorithm>

namespace marketgen::intake {
namespace {

constexpr double margin_share = 0.1, min_margin_m = 0.1;
constexpr double not_judged = 2;  // as bad as missed by the whole diagonal

}  // namespace

plan::NamedFloor named_floor(const Candidate& candidate, const StoreProgram& program) {
  plan::NamedFloor floor{candidate.floor, candidate.openings, {}};
  floor.zones.reserve(program.zones.size());
  for (std::size_t i = 0; i < program.zones.size(); ++i)
    floor.zones.push_back({program.zones[i].id, program.zones[i].type->type, candidate.rects[i]});
  return floor;
}

double planner_margin_m(const plan::RelationMeasure& measure) {
  return std::max(min_margin_m, margin_share * measure.limit_m);
}

double miss_of(const plan::Requirement& wish, const plan::NamedFloor& floor) {
  const std::optional<plan::RelationMeasure> measure =
      plan::measure_relation(floor, plan::terms_of(wish));
  if (!measure) return not_judged;
  const double miss_m = planner_margin_m(*measure) - measure->slack_m();
  return miss_m <= 0 ? 0 : 1 + miss_m / plan::diagonal_m(floor.bounds);
}

}  // namespace marketgen::intake
