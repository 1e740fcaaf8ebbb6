// Which fixtures a zone gets, and the size of one module.
#pragma once
#include <string>
#include <vector>

#include "assets/fixtures/fixture_model.h"
#include "layout/design.h"
#include "layout/layout.h"

namespace marketgen::layout {

// The top shelf must hold something below the top of its fixture.
inline constexpr int min_top_gap_mm = 150;
constexpr int max_spacing_mm = 2000;  // of Fixture::fields; a single level has no next one

// One module as it will be repeated along a run.
struct ModuleSpec {
  const catalog::FixtureKind* kind = nullptr;
  std::vector<int> widths_mm;  // preferred first
  int depth_mm = 0;
  int height_mm = 0;
  int levels = 0;
  int base_mm = 0;
  int spacing_mm = 0;
  int sides = 1;
  int wished_aisle_mm = 0;  // before its fronts; 0: as the rules and the kind want it
  std::string material, color;

  int narrowest_mm() const;
  int door_swing_mm() const;
  // Free floor demanded before its front: a lawful aisle beside the open doors, or what the kind's
  // row asks for.
  int clear_mm(const Design& design) const;
};

// The kinds of a zone; null where it has none.
struct ZoneKinds {
  const catalog::FixtureKind* main = nullptr;  // what the plan or the zone's type asks for
  const catalog::FixtureKind* wall = nullptr;  // what lines its walls
};
ZoneKinds kinds_of(const plan::Zone& zone, const catalog::Catalog& catalog);
// The zone as if the fixtures of `also` were its own: what is said of a zone's main fixtures then
// holds for them.
plan::Zone with_fixtures(plan::Zone zone, const plan::FixtureSpec& also);
// The kinds of such a zone: what it says, and along walls where the kind stands there.
ZoneKinds kinds_beside(const plan::FixtureSpec& also, const catalog::Catalog& catalog);

// Whether the look's material is for it: shelving takes it; cabinets, counters and wooden furniture
// keep their own.
bool takes_look(const catalog::FixtureKind& kind);

// The zone's wishes count when `kind` is the kind they are about; the rest comes from the kind's
// row and the profile.
ModuleSpec module_spec(const Design& design,
                       const plan::Zone& zone,
                       const catalog::FixtureKind& kind);
// The same module stocked from one side only, for standing against a wall or back to back.
ModuleSpec one_sided(ModuleSpec spec);

// Widths of modules, left to right, that fill `length_mm` as well as they can: what is left over is
// shorter than the narrowest module. Preferred widths first. Empty when not one fits.
std::vector<int> fill_widths(const ModuleSpec& spec, int length_mm);

// One module of the kind with its row's own measures, by itself in a run; place, zone and ids are
// the caller's.
Fixture lone_module(const catalog::FixtureKind& kind);
// A fixture of this module with everything but its place and ids.
Fixture make_module(const ModuleSpec& spec, const plan::Zone& zone);

// What its generator builds the fixture from.
assets::FixtureShape fixture_shape(const Fixture& fixture,
                                   const catalog::FixtureKind& kind,
                                   const plan::Look& look);

// Whether each zone's module can be built with the measures that it is to have; the kind's
// generator knows. Error: plan.bad_value at the first that cannot.
Result<void> check_modules(const Design& design);

}  // namespace marketgen::layout
