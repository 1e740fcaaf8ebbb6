// Makes: which row of the catalogue a store has where several are of one kind. A store draws one
// make for each role, so that it looks of a piece: all its gondolas are of one make, all its lanes.
//
// Only with plan::Outfit::full. What the draw follows from is the seed and the kind of shop alone,
// so that an edit of one zone leaves the others' makes as they are.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/seed.h"
#include "catalog/catalog.h"
#include "plan/plan.h"

namespace marketgen::layout {

struct Fixture;
struct Layout;

struct MakeRow {
  std::string_view of;                     // the kind whose place it takes
  std::string_view kind;                   // fixture kind
  std::vector<std::string_view> profiles;  // kinds of shop that may have it; none: all
  std::vector<std::string_view> zones;     // zone types that have these and no others; none: all
  std::string_view source;                 // why so
};

const std::vector<MakeRow>& make_rows();

class Makes {
 public:
  // Each kind is its own make.
  Makes() = default;
  // One draw for each kind, and for each zone type that has makes of its own.
  Makes(const plan::Plan& plan, const catalog::Catalog& catalog, Seed seed);

  // What stands where `kind` was to stand, in zones of this type or at doors (no type).
  const catalog::FixtureKind& of(const catalog::FixtureKind& kind,
                                 std::string_view zone_type = "") const;

 private:
  std::map<std::pair<std::string, std::string>, const catalog::FixtureKind*> drawn_;
};

// Whether the plan's own words leave the zone's make open: the zone asks for no kind by name, or
// for one whose makes are built alike, and for no measure that the make cannot have.
bool may_have(const plan::Plan& plan,
              std::size_t zone,
              const catalog::FixtureKind& kind,
              const catalog::FixtureKind& make);

// Whether the fixture counts where `kind` is asked for: it is of the kind or, in a layout with full
// outfit, of one of its makes.
bool counts_as(const Layout& layout, const Fixture& fixture, std::string_view kind);

}  // namespace marketgen::layout
