// The program of a store, in the architect's sense: what kind, how large, which zones with how much
// floor. No places yet.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "intake/brief.h"
#include "intake/fixture_wishes.h"
#include "intake/understanding.h"

namespace marketgen::intake {

// How a zone likes to stand.
enum class Stance {
  central,  // long double-sided runs in the middle
  wall,     // cabinets and racks with their backs to a wall
  hall,     // tables, stacks and counters that are walked round
  front     // tills and service: between entrance and exit
};

// `kind`: of the zone's main fixtures; null: it has none.
Stance stance_of(const catalog::ZoneTypeRow& type, const catalog::FixtureKind* kind);

struct ProgramZone {
  std::string id;
  const catalog::ZoneTypeRow* type = nullptr;
  const catalog::FixtureKind* kind = nullptr;  // null: no fixtures
  Stance stance = Stance::central;
  bool cold = false;
  bool stressed = false;            // the words ask for more of it than usual
  double target_m2 = 0;             // floor with its share of the aisles
  std::optional<double> wanted_m2;  // floor that was asked for
  plan::Comparison wanted_how = plan::Comparison::equal;
  std::optional<int> count;      // fixtures asked for
  std::optional<int> rows;       // "two rows of frozen food"
  KindWish main;                 // what is said of its main fixtures
  std::vector<KindWish> beside;  // what else stands there, each with a count or with runs
  std::optional<drawing::DrawnRuns> drawn_runs;  // shelves on a drawing (intake/drawn_runs.h)
};

struct StoreProgram {
  const catalog::ProfileRow* profile = nullptr;
  int width_mm = 0, depth_mm = 0;  // as built: east-west, north-south
  std::vector<ProgramZone> zones;
  std::optional<int> aisles;    // aisles asked for
  std::optional<int> aisle_mm;  // aisle width asked for
  plan::Comparison aisle_how = plan::Comparison::equal;
  bool across = false;  // runs of gondolas lie along the front, where a zone is wide enough
  std::optional<double>
      entrance_at;  // asked for: from the west end of the front, as drafts have it
  std::vector<plan::EquipmentSpec> equipment;  // at the doors, where it is not as usual
  bool till_counter = false;                   // no room for lanes
  bool open = false;                           // nobody said how large the floor is
  bool columns_at_walls = false;               // a floor with columns all over it did not do
  double counted_share = 1;  // of the room that counted fixtures need: less where it is not there
  bool plain = false;        // no room for more than a till and ordinary shelves
  std::optional<plan::Shell> shell;  // drawn
  std::optional<DrawnZones> drawn;   // zones stand where a drawing has them
  std::vector<RectMm> outside;       // what is no floor within its bounds
  double area_m2() const {
    if (shell) return marketgen::area_m2(plan::floor_of(*shell));
    return 1e-6 * width_mm * depth_mm;
  }
};

// The kind of shop: by a flag, by the words, by photos, or the usual one.
const catalog::ProfileRow& profile_of(const Brief& brief,
                                      const Understanding& found,
                                      const catalog::Catalog& catalog);

// The zone types that the wishes name, in the order in which they name them.
std::vector<std::string> named_zone_types(const Understanding& found,
                                          const catalog::Catalog& catalog);

// "bakery", "bakery-2": of the zones of one type, counted from 0.
std::string zone_id(const std::string& type, int index);

// Decides what the understanding leaves open from the profile. Conflicts between flags and text are
// settled already. Error: brief.bad_size when the words ask for a store that cannot be built.
Result<StoreProgram> make_program(const Brief& brief,
                                  const Understanding& found,
                                  const catalog::Catalog& catalog,
                                  const Concessions& concessions,
                                  std::vector<std::string>& trace);

// A larger floor, by a fifth, for what found no room on it. False when that is the largest.
bool enlarge(StoreProgram& program);

}  // namespace marketgen::intake
