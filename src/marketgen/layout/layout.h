// market-layout/1: the plan made concrete. Zones as polygons, every fixture module in its place,
// aisles, openings, violations.
//
// Store frame: x east, y north, origin at the south-west floor corner, whole millimetres. Yaw 0
// means that the front of a fixture faces south (-Y); 90 faces east, 180 north, 270 west. Modules
// that stand in one line share `run`.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "base/seed.h"
#include "catalog/catalog.h"
#include "geometry/rectangle.h"
#include "plan/plan.h"

namespace marketgen::layout {

struct LayoutZone {
  std::string id;
  std::string type;
  std::string label;
  PolygonMm polygon_mm;
  double area_m2 = 0;

  static constexpr auto fields = field_list(
      field("id", &LayoutZone::id, "the plan's zone id", identifier()),
      field("type", &LayoutZone::type, "zone type", required()),
      field("label", &LayoutZone::label, "sign over the zone"),
      field(
          "polygon_mm", &LayoutZone::polygon_mm, "floor it covers, counter-clockwise", required()),
      field("area_m2", &LayoutZone::area_m2, "floor area"));
};

// One module: a shelf section, a cabinet, a checkout lane.
struct Fixture {
  std::string id;          // "dairy/run-2/module-3"
  std::string run;         // "dairy/run-2"
  std::string kind;        // catalogue fixture kind
  std::string zone;        // zone id
  int x_mm = 0, y_mm = 0;  // centre of its footprint
  int yaw_deg = 0;         // 0, 90, 180, 270
  int width_mm = 1250;     // along its front
  int depth_mm = 500;      // front to back
  int height_mm = 1800;
  int levels = 5;        // stocked levels, base included
  int base_mm = 150;     // top of the lowest level
  int spacing_mm = 350;  // between levels
  // Of boards that are fitted to their goods: from each to the next and over the last, lowest
  // first. Those of the back, where it has others.
  std::optional<std::vector<int>> spacings_mm, back_spacings_mm;
  int sides = 1;           // 1, or 2 for double-sided
  std::string endcap_of;   // the run whose end it closes; empty otherwise
  bool run_start = false;  // has no neighbour on its left (seen from its front)
  bool run_end = false;    // has none on its right
  std::string material = "metal-white";
  std::string color = "#f2f2f0";

  static constexpr auto fields = field_list(
      field("id", &Fixture::id, "id", identifier()),
      field("run", &Fixture::run, "the line it stands in", required()),
      field("kind", &Fixture::kind, "fixture kind", required()),
      field("zone", &Fixture::zone, "zone id", required()),
      field("x_mm", &Fixture::x_mm, "centre, east"),
      field("y_mm", &Fixture::y_mm, "centre, north"),
      field("yaw_deg", &Fixture::yaw_deg, "0 = front faces south, 90 = east", range(0, 270)),
      field("width_mm", &Fixture::width_mm, "along its front", range(100, 6000)),
      field("depth_mm", &Fixture::depth_mm, "front to back", range(40, 6000)),
      field("height_mm", &Fixture::height_mm, "overall height", range(100, 4000)),
      field("levels", &Fixture::levels, "stocked levels, base included", range(0, 12)),
      field("base_mm", &Fixture::base_mm, "top of the lowest level", range(0, 2000)),
      field("spacing_mm", &Fixture::spacing_mm, "between levels", range(0, 2000)),
      field("sides", &Fixture::sides, "1, or 2 when stocked from both sides", range(1, 2)),
      field("endcap_of", &Fixture::endcap_of, "run whose end it closes"),
      field("run_start", &Fixture::run_start, "no neighbour on its left"),
      field("run_end", &Fixture::run_end, "no neighbour on its right"),
      field("material", &Fixture::material, "material of its body"),
      field("color", &Fixture::color, "colour of its body, #rrggbb"),
      // Last: scene files of before have fields by number.
      field("spacings_mm",
            &Fixture::spacings_mm,
            "from each board to the next and over the last, lowest first; absent: spacing_mm",
            range(80, 2000),
            at_most_items(12)),
      field("back_spacings_mm",
            &Fixture::back_spacings_mm,
            "those of its back; absent: as in front",
            range(80, 2000),
            at_most_items(12)));
};

// Footprint in store coordinates: width and depth swapped for yaw 90 and 270.
RectMm footprint_of(const Fixture& fixture);

enum class AisleKind { main, secondary, cross, checkout };
constexpr std::array<std::string_view, 4> names_of(AisleKind) {
  return {"main", "secondary", "cross", "checkout"};
}

struct Aisle {
  std::string id;
  AisleKind kind = AisleKind::secondary;
  PolygonMm polygon_mm;
  int width_mm = 0;  // narrowest free width, open cooler doors counted

  static constexpr auto fields =
      field_list(field("id", &Aisle::id, "id", identifier()),
                 field("kind", &Aisle::kind, "its place in the traffic"),
                 field("polygon_mm", &Aisle::polygon_mm, "free floor it covers", required()),
                 field("width_mm", &Aisle::width_mm, "narrowest free width", range(0, 100000)));
};

enum class Severity { hard, soft };
constexpr std::array<std::string_view, 2> names_of(Severity) {
  return {"hard", "soft"};
}

// One broken rule (also used by the scene's rules).
struct Violation {
  std::string code;  // "AISLE_TOO_NARROW"
  Severity severity = Severity::soft;
  std::string where;  // id of the aisle, fixture, zone or opening
  double value = 0, limit = 0;
  std::string message;
  std::optional<PointMm> at_mm;  // for the picture

  static constexpr auto fields =
      field_list(field("code", &Violation::code, "rule", required()),
                 field("severity", &Violation::severity, "hard or soft"),
                 field("where", &Violation::where, "what broke it"),
                 field("value", &Violation::value, "measured"),
                 field("limit", &Violation::limit, "allowed"),
                 field("message", &Violation::message, "for a person"),
                 field("at_mm", &Violation::at_mm, "place, for the picture", range(-1000, 500000)));
};

struct Layout {
  std::string schema = "market-layout/1";
  std::string name;
  std::string profile;
  plan::Shell shell;  // with outline_mm always set
  plan::Look look;
  std::optional<std::string> time;  // of the plan: when its shelves are seen
  std::vector<LayoutZone> zones;
  std::vector<Fixture> fixtures;  // sorted by id
  std::vector<Aisle> aisles;      // sorted by id
  std::vector<Violation> violations;
  std::optional<plan::Outfit> outfit;  // of the plan
  std::optional<std::string> country;  // of the plan, where the outfit is full: of its signs

  static constexpr auto fields = field_list(
      field("schema", &Layout::schema, "schema tag", constant("market-layout/1")),
      field("name", &Layout::name, "the store's name"),
      field("profile", &Layout::profile, "kind of shop"),
      field("shell", &Layout::shell, "the room", required()),
      field("look", &Layout::look, "materials and light"),
      field("zones", &Layout::zones, "zones", required()),
      field("fixtures", &Layout::fixtures, "one row per module", required(), at_most_items(100000)),
      field("aisles", &Layout::aisles, "free strips between fixtures"),
      field("violations", &Layout::violations, "broken rules"),
      field("time",  // it and what follows: scenes of before have no such columns
            &Layout::time,
            "weekday and hour at which its shelves are seen; absent: as staff filled them",
            at_most_bytes(16)),
      field("outfit", &Layout::outfit, "whether it has more than the plain rows; absent: plain"),
      field("country",
            &Layout::country,
            "whose words its signs have, where the outfit is full; absent: English",
            at_most_bytes(16)));
};

// Every module, aisle and violation of the plan. Deterministic. Errors: layout.impossible when not
// one fixture fits.
Result<Layout> make_layout(const plan::Plan& plan, const catalog::Catalog& catalog, Seed seed);

// A plan with its mendable faults mended (too narrow gaps, zones too small, checkout missing or far
// from the exit…), and what was done. The result is a new plan whose changes carry provenance
// `repair`.
struct Repaired {
  plan::Plan plan;
  std::vector<std::string> changes;  // one sentence each
  std::optional<Layout> layout;      // of the plan; nothing when it has none
  std::int64_t work = 0;             // of all layouts that were made for it
};
// What a layout costs, whatever machine makes it: one for each module (about 25 microseconds) and
// one for ten square metres of floor. A layout of a hall costs a hundred times that of a shop, so
// that fewer of them are tried: none is begun once a repair has done so much work.
constexpr std::int64_t max_repair_work = 6'000;
Result<Repaired> repair_plan(const plan::Plan& plan,
                             const catalog::Catalog& catalog,
                             Seed seed,
                             std::int64_t max_work = max_repair_work);

// Evaluates every rule of layout_rules.inc. make_layout has already put the result into
// `violations`.
std::vector<Violation> check_layout(const Layout& layout,
                                    const plan::Plan& plan,
                                    const catalog::Catalog& catalog);

const Fixture* find_fixture(const Layout& layout, std::string_view id);
const LayoutZone* find_zone(const Layout& layout, std::string_view id);

}  // namespace marketgen::layout
