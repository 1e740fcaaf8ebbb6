// The steps that furnish the zones, in the order in which make_layout takes them. Each adds to the
// site what still fits.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/seed.h"
#include "layout/site.h"
#include "layout/zone_ground.h"

namespace marketgen::layout {

// What has been built in one zone so far.
struct ZoneBuild {
  const plan::Zone* zone = nullptr;
  ZoneKinds kinds;
  int next_run = 1;
  int main_modules = 0;
  int other_modules = 0;
  bool stands = false;  // as it is: its fixtures were there before (layout/kept_layout.h)

  std::string take_run_id() { return zone->id + "/run-" + std::to_string(next_run++); }
  // How many more modules of the kind the plan wants; only its main kind is counted.
  int modules_left(const catalog::FixtureKind* kind) const;
  void count(const catalog::FixtureKind* kind, const std::vector<PlacedRun>& runs);
};

// One piece of floor under construction.
struct GroundBuild {
  Ground ground;
  std::size_t zone = 0;           // index into the zone builds
  std::array<int, 4> lined_mm{};  // by side: how far a wall run reaches into it
  bool finished = false;          // nothing more will stand here
};

struct Build {
  const Design& design;
  Site site;
  std::vector<ZoneBuild> zones;  // in plan order
  std::vector<GroundBuild> grounds;
  Seed seed;
};

// Checkout lanes, self-checkouts, service desks: before anything else, because the flow depends on
// them.
void place_checkouts(Build& build);
// Gates, baskets and trolleys beside the entrance.
void place_entrance(Build& build);
// Runs along the store's walls.
void line_walls(Build& build);
// Free-standing runs and islands.
void fill_floor(Build& build);
// The same with the least lawful aisles, for zones that got nothing.
void fill_empty_zones(Build& build);

}  // namespace marketgen::layout
