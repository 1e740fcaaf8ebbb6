// The steps that furnish the zones, in the order in which make_layout takes them. Each adds to the
// site what still fits.
#pragma once
#include <array>
#include <deque>
#include <string>
#include <vector>

#include "base/seed.h"
#include "layout/site.h"
#include "layout/zone_ground.h"

namespace marketgen::layout {

// What has been built so far of one zone's main fixtures, or of one group that stands beside them.
struct ZoneBuild {
  const plan::Zone* zone = nullptr;  // of a group: the zone with the group's fixtures as its own
  ZoneKinds kinds;
  std::string prefix;  // of its runs' ids: the zone's id, or "<zone>/<kind>" of a group
  int next_run = 1;
  int main_modules = 0;
  int other_modules = 0;
  bool stands = false;  // as it is: its fixtures were there before (layout/kept_layout.h)
  int main_runs = 0;

  std::string run_id() const { return prefix + "/run-" + std::to_string(next_run); }
  std::string take_run_id();
  // How many more modules and runs of the kind the plan wants; only its main kind is counted.
  int modules_left(const catalog::FixtureKind* kind) const;
  int runs_left(const catalog::FixtureKind* kind) const;
  // The most that the next run may have, so that all runs that are wanted are as long.
  int max_in_run(const catalog::FixtureKind* kind) const;
  // The fewest for it to be one of the runs that are wanted.
  int min_in_run(const catalog::FixtureKind* kind) const;
  void count(const catalog::FixtureKind* kind, const std::vector<PlacedRun>& runs);
};

// Straight lines that the fixtures are to be: nothing when the plan does not say. Both sides of a
// double-sided run of a kind that is stocked from one side are lines.
std::optional<int> lines_wanted(const plan::FixtureSpec& spec, const catalog::FixtureKind& kind);

// One piece of floor under construction.
struct GroundBuild {
  Ground ground;
  std::size_t zone = 0;           // index into the zone builds
  std::array<int, 4> lined_mm{};  // by side: how far a wall run reaches into it
  bool finished = false;          // nothing more will stand here
};

// Fixtures of `Zone::also`.
struct GroupBuild {
  std::size_t zone = 0;  // index into the zone builds
  ZoneBuild build;
};

struct Build {
  const Design& design;
  Site site;
  std::vector<ZoneBuild> zones;  // in plan order
  std::vector<GroundBuild> grounds;
  Seed seed;
  std::deque<plan::Zone> group_zones = {};  // what the groups' builds point to
  std::vector<GroupBuild> groups = {};      // in plan order
};

// What is left of a stretch of wall without the windows that a unit of this height would cover.
std::vector<Span> without_windows(const Build& build, Side side, Span span, int height_mm);

// Checkout lanes, self-checkouts, service desks: before anything else, because the flow depends on
// them.
void place_checkouts(Build& build);
// Gates, baskets and trolleys beside the doors, and what other equipment the plan wants there.
void place_entrance(Build& build);
// Groups that stand along walls, or whose zone has no floor before its wall runs.
void line_walls_with_groups(Build& build);
// Runs along the store's walls.
void line_walls(Build& build);
// Groups that stand free: tables, bins, islands.
void stand_groups(Build& build);
// Free-standing runs and islands.
void fill_floor(Build& build);
// The same with the least lawful aisles, for zones that got nothing.
void fill_empty_zones(Build& build);
// The furnished zones' fixtures and, last of all, their accessories (layout/accessories.h). Zones
// that stand have theirs.
std::vector<Fixture> with_accessories(const Build& furnished, std::vector<Fixture> fixtures);

}  // namespace marketgen::layout
