#include "audit/straight_runs.h"

#include <algorithm>
#include <tuple>

#include "layout/side.h"

namespace marketgen::audit {
namespace {

constexpr int touching_mm = 60;        // what modules that stand end to end may be apart
constexpr int back_gap_mm = 150;       // between two runs with their backs together
constexpr double shared_length = 0.5;  // of the shorter of the two

// Modules of a double-sided line look the same from behind.
int direction_of(const layout::Fixture& fixture) {
  return fixture.sides == 2 ? fixture.yaw_deg % 180 : fixture.yaw_deg;
}

auto line_of(const layout::Fixture& fixture) {
  const layout::Side front = layout::facing_of(fixture.yaw_deg);
  const RectMm rect = layout::footprint_of(fixture);
  return std::tuple{fixture.kind,
                    fixture.zone,
                    fixture.sides,
                    direction_of(fixture),
                    layout::across(rect, front).middle(),
                    layout::along(rect, front).from};
}

// The next module goes on with the run. Precondition: of one kind, zone and direction.
bool goes_on(const StraightRun& run, const layout::Fixture& next) {
  const layout::Side front = layout::facing_of(run.yaw_deg);
  const RectMm rect = layout::footprint_of(next);
  const int aside = layout::across(rect, front).middle() - layout::across(run.rect, front).middle();
  const int gap = layout::along(rect, front).from - layout::along(run.rect, front).to;
  return std::abs(aside) <= touching_mm && std::abs(gap) <= touching_mm;
}

bool same_make(const layout::Fixture& a, const layout::Fixture& b) {
  return a.kind == b.kind && a.zone == b.zone && a.sides == b.sides &&
         direction_of(a) == direction_of(b);
}

struct NamedRun {
  StraightRun run;
  const layout::Fixture* first;
};

bool stands_behind(const NamedRun& other, const NamedRun& mine) {
  if (other.run.sides != 1 || other.first->kind != mine.first->kind) return false;
  if ((other.run.yaw_deg + 180) % 360 != mine.run.yaw_deg) return false;
  const layout::Side back = layout::opposite(layout::facing_of(mine.run.yaw_deg));
  const int gap = layout::distance_beyond(mine.run.rect, back, other.run.rect);
  const layout::Span a = layout::along(mine.run.rect, back);
  const layout::Span b = layout::along(other.run.rect, back);
  const double shared = layout::intersection(a, b).length();
  return std::abs(gap) <= back_gap_mm && shared >= shared_length * std::min(a.length(), b.length());
}

}  // namespace

std::vector<StraightRun> straight_runs(const std::vector<layout::Fixture>& fixtures) {
  std::vector<const layout::Fixture*> sorted;
  for (const layout::Fixture& fixture : fixtures)
    sorted.push_back(&fixture);
  std::ranges::stable_sort(sorted, {}, [](const layout::Fixture* f) { return line_of(*f); });
  std::vector<NamedRun> named;
  for (const layout::Fixture* fixture : sorted) {
    const RectMm rect = layout::footprint_of(*fixture);
    if (!named.empty() && same_make(*named.back().first, *fixture) &&
        goes_on(named.back().run, *fixture)) {
      named.back().run.rect = bounds_of(named.back().run.rect, rect);
      ++named.back().run.modules;
      continue;
    }
    named.push_back({{rect, fixture->yaw_deg, fixture->sides, 1, false}, fixture});
  }
  std::vector<StraightRun> runs;
  for (const NamedRun& mine : named) {
    runs.push_back(mine.run);
    runs.back().back_to_back =
        mine.run.sides == 1 && std::ranges::any_of(named, [&](const NamedRun& other) {
          return &other != &mine && stands_behind(other, mine);
        });
  }
  return runs;
}

}  // namespace marketgen::audit
