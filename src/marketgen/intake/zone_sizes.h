// How much room a zone's fixtures take, before they are placed. The layout decides in the end;
// these are the sizes it works with: gondola depth from the profile, cabinets and counters from
// their rows.
#pragma once
#include "catalog/catalog.h"
#include "intake/store_program.h"

namespace marketgen::intake {

// One free-standing line of the zone's fixtures, both faces included.
int line_depth_mm(const ProgramZone& zone, const catalog::ProfileRow& profile);

// A band along a wall that holds the zone's wall fixtures.
int wall_depth_mm(const ProgramZone& zone, const catalog::Catalog& catalog);

// A band along a wall that holds tables on the wall and one line of them in front.
int hall_depth_mm(const ProgramZone& zone,
                  const catalog::ProfileRow& profile,
                  const catalog::Catalog& catalog);

// The floor along the front that a till, service or cafe zone needs.
int till_width_mm(const ProgramZone& zone, int front_depth_mm);

// From the exit's wall to the edge of the till zone: a lane, and the floor that must stay free
// inside the exit. Part of the floor before the lanes lies in the gap of `gap_mm` beyond.
int front_depth_mm(const StoreProgram& program, const catalog::Catalog& catalog, int gap_mm);

// The kind that lines the walls of a zone whose own fixtures stand free.
const catalog::FixtureKind* kind_on_walls(const catalog::FixtureKind& kind,
                                          const catalog::Catalog& catalog);

// Tables, bins and stacks stand free, with an aisle on all sides.
bool is_walked_round(const catalog::FixtureKind& kind);

constexpr int usual_front_mm = 6000;  // what tills are measured for before the floor is cut

// What the counted fixtures of a zone take: floor with its share of the aisles, and length in a
// band so deep. 0 when none is counted.
double counted_floor_m2(const ProgramZone& zone, const catalog::ProfileRow& profile);
int counted_length_mm(const ProgramZone& zone, const catalog::ProfileRow& profile, int depth_mm);
// How long the runs are that the words count; 0 when they leave it open.
int counted_run_mm(const ProgramZone& zone);
// What stands free beside the zone's own fixtures, in lines so long: its depth with an aisle to it.
int beside_depth_mm(const ProgramZone& zone, int length_mm);
// Lines of the zone's main fixtures side by side on a floor so deep; nothing when the words leave
// it open.
std::optional<int> counted_lines(const ProgramZone& zone, int depth_mm);

// From the wall at the staff's back to a desk's front.
int desk_room_mm(const catalog::FixtureKind& kind);

// Depth of one checkout lane: shorter lanes in small shops.
int lane_length_mm(const catalog::FixtureKind& lane, const StoreProgram& program);

}  // namespace marketgen::intake
