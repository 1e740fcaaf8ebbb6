// market-plan/1: what a store should be, in whole millimetres and stable ids; readable and writable
// by a person or a model.
//
// A plan says which zones there are and how the floor is divided among them (a BSP tree); layout
// turns it into fixtures.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "geometry/rectangle.h"
#include "plan/planogram.h"
#include "plan/vary.h"

namespace marketgen::plan {

enum class Wall { north, south, east, west };
constexpr std::array<std::string_view, 4> names_of(Wall) {
  return {"north", "south", "east", "west"};
}

enum class OpeningKind { entrance, exit, service, emergency, window };
constexpr std::array<std::string_view, 5> names_of(OpeningKind) {
  return {"entrance", "exit", "service", "emergency", "window"};
}

struct Opening {
  std::string id;
  OpeningKind kind = OpeningKind::entrance;
  Wall wall = Wall::south;
  double center = 0.5;  // fraction from the wall's west or south end
  int width_mm = 2000;

  static constexpr auto fields =
      field_list(field("id", &Opening::id, "id, unique in the plan", identifier()),
                 field("kind", &Opening::kind, "what passes through", required()),
                 field("wall", &Opening::wall, "wall it is in", required()),
                 field("center",
                       &Opening::center,
                       "its middle, as a fraction from the wall's west or south end",
                       range(0, 1)),
                 field("width_mm", &Opening::width_mm, "clear width", range(600, 12000)));
};

struct Column {
  int x_mm = 0, y_mm = 0, size_mm = 400;

  static constexpr auto fields =
      field_list(field("x_mm",
                       &Column::x_mm,
                       "centre, east of the south-west corner",
                       range(0, 500000),
                       required()),
                 field("y_mm",
                       &Column::y_mm,
                       "centre, north of the south-west corner",
                       range(0, 500000),
                       required()),
                 field("size_mm", &Column::size_mm, "side of the square column", range(50, 2000)));
};

struct Shell {
  int width_mm = 24000;  // east-west
  int depth_mm = 15000;  // north-south
  int ceiling_mm = 3660;
  std::optional<PolygonMm> outline_mm;  // for shells that are not rectangles
  std::vector<Opening> openings;
  std::vector<Column> columns;

  static constexpr auto fields = field_list(
      field("width_mm", &Shell::width_mm, "inner size east-west", range(4000, 200000), required()),
      field(
          "depth_mm", &Shell::depth_mm, "inner size north-south", range(4000, 200000), required()),
      field("ceiling_mm", &Shell::ceiling_mm, "clear height", range(2300, 12000)),
      field("outline_mm",
            &Shell::outline_mm,
            "floor polygon, counter-clockwise, for shells that are not rectangles",
            range(0, 200000),
            at_most_items(200)),
      field("openings", &Shell::openings, "doors and windows", at_most_items(40)),
      field("columns", &Shell::columns, "free-standing columns", at_most_items(400)));
};

struct Look {
  std::string floor = "terrazzo-white";
  std::string wall = "plaster-white";
  std::string ceiling = "ceiling-grid-white";
  std::string fixture = "metal-white";
  std::string accent = "#2e7d32";
  int light_kelvin = 4000;
  int light_lux = 800;
  std::optional<catalog::LampFitting> lamps;  // none said: panel
  std::optional<double> daylight;             // none said: 1
  std::optional<bool> neon;                   // none said: no

  static constexpr auto fields = field_list(
      field("floor", &Look::floor, "floor material", reference()),
      field("wall", &Look::wall, "wall material", reference()),
      field("ceiling", &Look::ceiling, "ceiling material", reference()),
      field("fixture", &Look::fixture, "fixture material", reference()),
      field("accent", &Look::accent, "signs and bands, #rrggbb", at_most_bytes(7)),
      field("light_kelvin", &Look::light_kelvin, "colour temperature", range(1500, 10000)),
      field("light_lux", &Look::light_lux, "illuminance on the floor", range(50, 3000)),
      field("lamps", &Look::lamps, "how lamps are fitted; left out: panel"),
      field("daylight",
            &Look::daylight,
            "outside, share of an overcast day, 0 is night; left out: 1",
            range(0, 1)),
      field("neon", &Look::neon, "a glowing line below the bands on the walls"));
};

enum class Axis { x, y };
constexpr std::array<std::string_view, 2> names_of(Axis) {
  return {"x", "y"};
}

// Inner node: split, ratio, gap_mm and two children. Leaf: zone. An inner node that says no ratio
// is cut in halves, and one that says no gap_mm has no aisle between its children (plan/bsp.h:
// default_split_ratio, default_gap_mm).
struct Node {
  std::string id;
  std::optional<Axis>
      split;  // y cuts across Y, the first child is south; x: the first child is west
  std::optional<double> ratio;        // first child's share of what is left after the gap
  std::optional<int> gap_mm;          // aisle between the children
  std::vector<std::string> children;  // exactly two ids in an inner node
  std::optional<std::string> zone;    // a zone's id in a leaf

  static constexpr auto fields = field_list(
      field("id", &Node::id, "id, unique in the plan", identifier()),
      field(
          "split", &Node::split, "cut across this axis; y: first child south, x: first child west"),
      field("ratio",
            &Node::ratio,
            "first child's share after the gap is taken off",
            range(0.08, 0.92)),
      field("gap_mm", &Node::gap_mm, "aisle between the children", range(0, 8000)),
      field("children", &Node::children, "the two halves, by id", at_most_items(2), reference()),
      field("zone", &Node::zone, "the zone that fills a leaf, by id", reference()));
};

struct AreaRange {
  std::optional<double> min, target, max;

  static constexpr auto fields =
      field_list(field("min", &AreaRange::min, "least floor area", range(0.5, 40000)),
                 field("target", &AreaRange::target, "wanted floor area", range(0.5, 40000)),
                 field("max", &AreaRange::max, "most floor area", range(0.5, 40000)));
};

enum class Endcaps { none, front, back, both };
constexpr std::array<std::string_view, 4> names_of(Endcaps) {
  return {"none", "front", "back", "both"};
}

enum class RunAxis { automatic, x, y };
constexpr std::array<std::string_view, 3> names_of(RunAxis) {
  return {"auto", "x", "y"};
}

// Fixtures of a zone. What is absent comes from the fixture kind's row and the profile.
//
// `count` is kept both ways: never more of this kind in the zone, and COUNT_SHORT says what found
// no room. 0 of a zone's main fixtures leaves it those along its walls and those of `Zone::also`.
// `runs` are straight lines, each as long as the others; with `double_sided` false they stand
// apart, without it two of one-sided kinds may stand back to back.
struct FixtureSpec {
  std::string kind = "gondola";
  std::optional<bool> double_sided;
  Endcaps endcaps = Endcaps::none;
  RunAxis axis = RunAxis::automatic;
  std::optional<int> module_mm, depth_mm, height_mm, levels, spacing_mm;
  int run_max_mm = 12000;
  std::optional<int> aisle_mm;
  std::optional<int> count;  // lanes, cabinets, tables wanted; absent = as many as fit
  std::optional<int> runs;   // straight lines wanted; absent = as many as fit
  std::optional<std::string> color;
  std::optional<std::string> material;

  static constexpr auto fields = field_list(
      field("kind", &FixtureSpec::kind, "fixture kind", reference()),
      field("double_sided", &FixtureSpec::double_sided, "stocked from both sides"),
      field("endcaps",
            &FixtureSpec::endcaps,
            "endcaps on the runs; front is the end nearer the checkouts"),
      field("axis", &FixtureSpec::axis, "direction of the runs"),
      field("module_mm", &FixtureSpec::module_mm, "width of one section", range(200, 4500)),
      field("depth_mm", &FixtureSpec::depth_mm, "overall depth", range(200, 4500)),
      field("height_mm", &FixtureSpec::height_mm, "overall height", range(300, 3000)),
      field("levels", &FixtureSpec::levels, "stocked levels, base included", range(1, 10)),
      field("spacing_mm", &FixtureSpec::spacing_mm, "distance between levels", range(80, 1500)),
      field("run_max_mm",
            &FixtureSpec::run_max_mm,
            "longest run without a cross aisle",
            range(1000, 60000)),
      field("aisle_mm", &FixtureSpec::aisle_mm, "aisle between runs", range(600, 8000)),
      field(
          "count", &FixtureSpec::count, "fixtures wanted; absent = as many as fit", range(0, 200)),
      field("runs",
            &FixtureSpec::runs,
            "straight lines of fixtures wanted; absent = as many as fit",
            range(1, 60)),
      field("color", &FixtureSpec::color, "colour, #rrggbb", at_most_bytes(7)),
      field("material", &FixtureSpec::material, "material", reference()));
};

// brand_vertical: brands from left to right, in the same order on every board of a bay;
// brand_horizontal and brand_columns: scene/brand_blocks.h; mixed: by demand, whatever the brand.
enum class BlockPattern { brand_vertical, brand_horizontal, mixed, brand_columns };
constexpr std::array<std::string_view, 4> names_of(BlockPattern) {
  return {"brand-vertical", "brand-horizontal", "mixed", "brand-columns"};
}

// Faults of the price tags on shelf edges: shares of the tags that would be there, each on its own.
struct PriceTagSpec {
  double missing = 0, wrong_price = 0, wrong_product = 0, doubled = 0;

  static constexpr auto fields =
      field_list(field("missing", &PriceTagSpec::missing, "are not there", range(0.0, 1.0)),
                 field("wrong_price",
                       &PriceTagSpec::wrong_price,
                       "say a price that does not hold any more",
                       range(0.0, 1.0)),
                 field("wrong_product",
                       &PriceTagSpec::wrong_product,
                       "are those of another product on the shelf",
                       range(0.0, 1.0)),
                 field("doubled",
                       &PriceTagSpec::doubled,
                       "have an outdated one beside them where the block is wide enough for two",
                       range(0.0, 1.0)));
};

struct StockSpec {
  std::vector<std::string> categories;
  std::vector<std::string> exclude;                    // words of products that must not be here
  std::optional<std::vector<std::string>> must_stock;  // words, each of a product that must be here
  double fill = 0.95;
  IntRange facings{2, 4};
  BlockPattern block = BlockPattern::brand_vertical;
  double depth_fill = 1.0;
  double jitter = 0.2;
  double out_of_stock = 0.03;
  double misplaced = 0.0;
  std::optional<PriceTagSpec> price_tags;  // none: every tag is there and right

  static constexpr auto fields = field_list(
      field("categories",
            &StockSpec::categories,
            "what may stand here; empty = whatever the zone sells",
            at_most_items(40)),
      field("exclude",
            &StockSpec::exclude,
            "names or keywords of products that must not be here",
            at_most_items(40)),
      field("must_stock",
            &StockSpec::must_stock,
            "names or keywords, of each of which one product must be here",
            at_most_items(40)),
      field("fill", &StockSpec::fill, "occupied share of the shelf front", range(0.0, 1.0)),
      field("facings", &StockSpec::facings, "fewest and most facings of one SKU", range(1, 40)),
      field("block",
            &StockSpec::block,
            "how brands stand in a bay: brand-vertical: from left to right, in the same order on "
            "every board; brand-columns: each above itself on all boards, what is asked for most "
            "at eye level and in the most facings; brand-horizontal: each on boards of its own; "
            "mixed: by demand, whatever the brand"),
      field("depth_fill",
            &StockSpec::depth_fill,
            "share of the shelf depth that is filled",
            range(0.0, 1.0)),
      field("jitter",
            &StockSpec::jitter,
            "disorder of single items: 0 ruler-straight, 1 untidy",
            range(0.0, 1.0)),
      field("out_of_stock",
            &StockSpec::out_of_stock,
            "share of facing blocks that are empty",
            range(0.0, 1.0)),
      field("misplaced",
            &StockSpec::misplaced,
            "share of the items in front rows that stand in the wrong place",
            range(0.0, 0.5)),
      field("price_tags", &StockSpec::price_tags, "faults of the price tags on the shelf edges"));
};

struct Zone {
  std::string id;
  std::string type;  // one of data/zone_types.json
  std::string label;
  AreaRange area_m2;
  std::string anchor = "any";
  catalog::Storage temperature = catalog::Storage::ambient;
  FixtureSpec fixture;
  std::optional<std::vector<FixtureSpec>> also;  // kinds beside `fixture`, each with a count
  StockSpec stock;

  static constexpr auto fields =
      field_list(field("id", &Zone::id, "id, unique in the plan", identifier()),
                 field("type", &Zone::type, "zone type", required(), reference()),
                 field("label", &Zone::label, "sign over the zone", at_most_bytes(80)),
                 field("area_m2", &Zone::area_m2, "floor area"),
                 field("anchor",
                       &Zone::anchor,
                       "side of the store: any north south east west center entrance",
                       reference()),
                 field("temperature", &Zone::temperature, "temperature of its fixtures"),
                 field("fixture", &Zone::fixture, "its fixtures"),
                 field("also",
                       &Zone::also,
                       "fixtures of other kinds that stand there too, each with its count",
                       at_most_items(8)),
                 field("stock", &Zone::stock, "its goods"));
};

enum class RelationKind {
  near,
  far,
  along,
  at,
  left_of,
  right_of,
  behind,
  facing,
  between,
  not_adjacent
};
constexpr std::array<std::string_view, 10> names_of(RelationKind) {
  return {"near",
          "far",
          "along",
          "at",
          "left_of",
          "right_of",
          "behind",
          "facing",
          "between",
          "not_adjacent"};
}
enum class Strength { prefer, must };
constexpr std::array<std::string_view, 2> names_of(Strength) {
  return {"prefer", "must"};
}

// a and b name zones (id or type), openings (id or kind), walls, or "checkout"; c only for
// `between`.
struct Relation {
  RelationKind kind = RelationKind::near;
  std::string a, b;
  std::optional<std::string> c;
  Strength strength = Strength::prefer;

  static constexpr auto fields =
      field_list(field("kind", &Relation::kind, "the relation", required()),
                 field("a", &Relation::a, "what is placed", required(), reference()),
                 field("b", &Relation::b, "what it relates to", required(), reference()),
                 field("c", &Relation::c, "second reference, for `between`", reference()),
                 field("strength", &Relation::strength, "how binding it is"));
};

enum class Source { unset, llm, photo, drawing, text, flag, repair };
constexpr std::array<std::string_view, 7> names_of(Source) {
  return {"default", "llm", "photo", "drawing", "text", "flag", "repair"};
}

// Where a value of the plan came from.
struct Provenance {
  std::string path;  // JSON pointer into the plan
  Source source = Source::unset;
  std::optional<IntRange> span;  // bytes of the prompt, [first, past the last]
  double confidence = 1;

  static constexpr auto fields = field_list(
      field("path", &Provenance::path, "JSON pointer into the plan", required()),
      field("source", &Provenance::source, "who said so", required()),
      field("span", &Provenance::span, "bytes of the prompt: first, past the last", range(0, 1e6)),
      field("confidence", &Provenance::confidence, "0 guess, 1 said", range(0, 1)));
};

// What stands at the doors: baskets, trolleys, gates and other equipment. A kind that no wish names
// stands as usual.
struct EquipmentSpec {
  std::string kind;
  int count = 1;                  // in the whole store; 0 = none
  std::optional<std::string> at;  // opening, by id or kind; absent: the entrances in turn

  static constexpr auto fields = field_list(
      field("kind", &EquipmentSpec::kind, "fixture kind", required(), reference()),
      field("count", &EquipmentSpec::count, "how many; 0 = none", range(0, 20), required()),
      field("at",
            &EquipmentSpec::at,
            "door that it stands at, by id or kind; absent: the entrances in turn",
            reference()));
};

// Pins one value of one fixture. A fixture whose x_mm or y_mm is pinned takes along what stands in
// a line with it: its run, the run back to back with that, and their endcaps.
struct Override {
  std::string fixture, field_name, value;

  static constexpr auto fields = field_list(
      field("fixture", &Override::fixture, "fixture id in the layout", required(), reference()),
      field("field",
            &Override::field_name,
            "levels, height_mm, color, material or kind; x_mm or y_mm: its middle, with its run",
            required()),
      field("value", &Override::value, "the value as text", required()));
};

// Pins one exact product.
struct Placement {
  std::string sku;
  std::array<double, 3> position_m{};
  double yaw_deg = 0;

  static constexpr auto fields =
      field_list(field("sku", &Placement::sku, "product", required(), reference()),
                 field("position_m",
                       &Placement::position_m,
                       "bottom centre in the store frame",
                       range(-1, 200),
                       required()),
                 field("yaw_deg", &Placement::yaw_deg, "0 = front faces south", range(-360, 360)));
};

// How far boards are apart and how goods share them.
enum class ShelfPitch {
  even,   // as far from one another all over a fixture; goods come in the assortment's order
  fitted  // as high as what stands on them; goods have the room that shops give their kind
};
constexpr std::array<std::string_view, 2> names_of(ShelfPitch) {
  return {"even", "fitted"};
}

// What the catalogue has for the store besides the plain rows.
enum class Outfit {
  plain,  // the kinds that the plan names, and those that its zones usually have
  full    // one make for each role, special units in line with others, more accessories
};
constexpr std::array<std::string_view, 2> names_of(Outfit) {
  return {"plain", "full"};
}

struct Plan {
  std::string schema = "market-plan/1";
  std::string name = "Market";
  std::string profile = "supermarket-eu";
  std::optional<std::string> country;
  std::optional<std::string> time;  // plan/store_time.h
  std::optional<Vary> vary;
  std::optional<ShelfPitch> shelves;  // none: even
  std::optional<Outfit> outfit;       // none: plain
  Shell shell;
  Look look;
  std::vector<Node> nodes;
  std::vector<Zone> zones;
  std::optional<std::vector<EquipmentSpec>> equipment;
  std::vector<Relation> relations;
  std::vector<Override> overrides;
  std::vector<Placement> placements;
  std::optional<std::vector<StockedShelf>> planogram;
  std::vector<Provenance> provenance;

  static constexpr auto fields = field_list(
      field("schema", &Plan::schema, "schema tag", constant("market-plan/1")),
      field("name", &Plan::name, "the store's name", at_most_bytes(120)),
      field("profile", &Plan::profile, "limits and habits of this kind of shop", reference()),
      field("country",
            &Plan::country,
            "whose money and units price tags have; absent: euro and metric units",
            reference()),
      field("time",
            &Plan::time,
            "weekday and hour of the day, \"Sat 17:30\": what shoppers took since the last "
            "restocking is gone; absent: no time",
            at_most_bytes(16)),
      field("vary", &Plan::vary, "seeds of single axes in the place of the store's own"),
      field(
          "shelves",
          &Plan::shelves,
          "how far boards are apart. fitted: as high as the goods on them, and each kind of goods "
          "has the room that shops give it; even: all over a fixture alike, and goods come in the "
          "order of the assortment; absent: even"),
      field(
          "outfit",
          &Plan::outfit,
          "what the catalogue has besides the plain rows. full: one make of each kind of fixture, "
          "drawn for the store, special units in line with others, more accessories, numbers over "
          "lanes and boards over exits; plain: none of that; absent: plain"),
      field("shell", &Plan::shell, "the room", required()),
      field("look", &Plan::look, "materials and light"),
      field("nodes",
            &Plan::nodes,
            "BSP tree; the root is the node that is nobody's child",
            required(),
            at_most_items(64)),
      field("zones", &Plan::zones, "what is where", required(), at_most_items(24)),
      field("equipment",
            &Plan::equipment,
            "what stands at the doors, where it is not as usual",
            at_most_items(16)),
      field("relations", &Plan::relations, "wishes about places", at_most_items(200)),
      field("overrides", &Plan::overrides, "single values of single fixtures", at_most_items(2000)),
      field("placements", &Plan::placements, "exact products", at_most_items(100000)),
      field("planogram",
            &Plan::planogram,
            "shelves whose goods are said one by one",
            at_most_items(max_planogram_shelves)),
      field("provenance", &Plan::provenance, "where values came from", at_most_items(2000)));
};

constexpr int max_bsp_depth = 6;
constexpr int max_bsp_leaves = 24;

// Reads and validates. `source` names the text in errors.
Result<Plan> read_plan(std::string_view text,
                       const std::string& source,
                       const catalog::Catalog& catalog);

// Everything the schema cannot say: unique ids, one binary tree that holds each zone once, openings
// within their walls and apart from one another, known kinds, materials and categories, an outline
// without self-crossings. First fault wins.
Result<void> validate_plan(const Plan& plan,
                           const std::string& source,
                           const catalog::Catalog& catalog);

// The shell's floor: its outline, or the rectangle.
PolygonMm floor_of(const Shell& shell);
RectMm footprint_of(const Column& column);

// Index of the root node. Precondition: valid plan.
std::size_t root_of(const Plan& plan);
const Node* find_node(const Plan& plan, std::string_view id);
const Zone* find_zone(const Plan& plan, std::string_view id);

}  // namespace marketgen::plan
