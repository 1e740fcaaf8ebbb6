#include "layout/standing_site.h"

#include <algorithm>
#include <map>
#include <string>

#include "layout/staff_floor.h"

namespace marketgen::layout {
namespace {

// What a fixture that stays keeps free, as when it was placed.
int kept_clear_mm(const Design& design, const plan::Zone& zone, const catalog::FixtureKind& kind) {
  if (kind.generator == "checkout_lane") return 0;  // lanes keep their line clear: keep_line_clear
  if (kind.role != catalog::FixtureRole::shelving) return design.min_aisle_mm();
  return module_spec(design, zone, kind).clear_mm(design);
}

// Room to queue and to pack before and behind lanes that stay, and between them.
void keep_line_clear(Site& site,
                     const Design& design,
                     const std::vector<Fixture>& lanes,
                     double share) {
  const Doorway* exit = exit_of(design.floor, design.plan.shell);
  const Side out = exit != nullptr ? exit->wall : Side::south;
  RectMm line = footprint_of(lanes.front());
  for (const Fixture& lane : lanes) {
    const RectMm rect = footprint_of(lane);
    line = bounds_of(line, rect);
  }
  const int clear = static_cast<int>(share * design.profile.checkout_clear_mm);
  site.keep_clear(line);
  site.keep_clear(strip_beyond(line, out, clear));
  site.keep_clear(strip_beyond(line, opposite(out), clear));
}

}  // namespace

void stand_again(Site& site,
                 const Design& design,
                 const std::vector<Fixture>& fixtures,
                 double line_share) {
  std::map<std::string, std::vector<Fixture>> lanes;  // by run
  for (const Fixture& fixture : fixtures) {
    const catalog::FixtureKind* kind = design.catalog.fixture_kind(fixture.kind);
    const plan::Zone* zone = plan::find_zone(design.plan, fixture.zone);
    const bool at_entrance = fixture.run.starts_with(fixture.zone + "/entrance/");
    if (at_entrance) site.keep_clear(footprint_of(fixture).grown(design.min_aisle_mm()));
    if (kind != nullptr && kind->generator == "checkout_lane")
      lanes[fixture.run].push_back(fixture);
    if (kind != nullptr && staff_depth_mm(*kind) > 0) {
      const Side back = opposite(facing_of(fixture.yaw_deg));
      site.keep_clear(strip_beyond(footprint_of(fixture), back, staff_depth_mm(*kind)));
    }
    const bool known = kind != nullptr && zone != nullptr;
    site.keep(fixture, known ? kept_clear_mm(design, *zone, *kind) : 0);
  }
  for (const auto& [run, line] : lanes)
    keep_line_clear(site, design, line, line_share);
}

}  // namespace marketgen::layout
