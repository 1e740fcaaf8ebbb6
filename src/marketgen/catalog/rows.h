// The smaller rows of the catalogue: categories, zone types, materials, profiles and styles.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "catalog/product.h"

namespace marketgen::catalog {

struct CategoryRow {
  std::string id;
  std::string name;
  std::string color = "#888888";  // in drawings

  static constexpr auto fields =
      field_list(field("id", &CategoryRow::id, "category id", identifier()),
                 field("name", &CategoryRow::name, "what people call it", required()),
                 field("color", &CategoryRow::color, "colour in drawings, #rrggbb"));
};

// A kind of zone: what it sells, on what, and where it likes to be.
struct ZoneTypeRow {
  std::string type;               // "dairy"
  std::string label;              // "Dairy & eggs"
  std::string color = "#888888";  // in layout.png
  std::string fixture;            // default fixture kind; empty: no fixtures (a lobby)
  std::string anchor = "any";     // any north south east west center entrance
  Storage temperature = Storage::ambient;
  std::vector<std::string> categories;     // sold here
  std::vector<std::string> subcategories;  // narrows the categories; empty = all
  double share = 0.05;                     // of the selling area in an ordinary supermarket
  bool food = true;
  std::vector<std::string> keywords;  // English words that name it

  static constexpr auto fields = field_list(
      field("type", &ZoneTypeRow::type, "zone type used in plans", identifier()),
      field("label", &ZoneTypeRow::label, "sign over the zone", required()),
      field("color", &ZoneTypeRow::color, "colour in the layout picture, #rrggbb"),
      field("fixture", &ZoneTypeRow::fixture, "default fixture kind"),
      field("anchor",
            &ZoneTypeRow::anchor,
            "side of the store it likes: any north south east west center entrance"),
      field("temperature", &ZoneTypeRow::temperature, "temperature of its fixtures"),
      field("categories", &ZoneTypeRow::categories, "categories sold here"),
      field("subcategories", &ZoneTypeRow::subcategories, "only these subcategories; empty = all"),
      field("share", &ZoneTypeRow::share, "share of the selling area", range(0, 1)),
      field("food", &ZoneTypeRow::food, "sells food"),
      field("keywords", &ZoneTypeRow::keywords, "words that name it"));
};

// What a material's surface is made of; catalog/material_patterns.inc lists them.
enum class MaterialPattern {
#define MATERIAL_PATTERN(name, periods, description) name,
#include "catalog/material_patterns.inc"
#undef MATERIAL_PATTERN
};
constexpr auto names_of(MaterialPattern) {
#define MATERIAL_PATTERN(name, periods, description) std::string_view(#name),
  return std::array{
#include "catalog/material_patterns.inc"
  };
#undef MATERIAL_PATTERN
}

struct MaterialRow {
  std::string id;  // "terrazzo-white"
  std::string name;
  MaterialPattern pattern = MaterialPattern::plain;
  std::string color = "#cccccc";         // ground colour
  std::string second_color = "#999999";  // grout, chips, mortar, dark grain
  int period_mm = 600;                   // width of one tile, plank or brick
  double roughness = 0.5;
  double metallic = 0.0;
  std::vector<std::string> uses;  // floor wall ceiling fixture
  std::string third_color;        // chips or veins of another kind, what shows below; empty = none
  double joint_mm = 0;            // width of joints and gaps; 0 = usual for the pattern
  double aspect = 0;              // length of a piece over its width; 0 = usual for the pattern
  double relief = 1;              // factor on the pattern's own depth
  double variation = 1;           // factor on the differences between pieces
  double transmission = 0;        // share of light let through: 0 opaque, 0.9 clear glass

  static constexpr auto fields = field_list(
      field("id", &MaterialRow::id, "material id used in plans", identifier()),
      field("name", &MaterialRow::name, "what people call it", required()),
      field("pattern", &MaterialRow::pattern, "procedural pattern"),
      field("color", &MaterialRow::color, "ground colour, #rrggbb"),
      field("second_color", &MaterialRow::second_color, "grout, chips, mortar or grain, #rrggbb"),
      field("period_mm", &MaterialRow::period_mm, "size of one repeat", range(10, 4000)),
      field("roughness", &MaterialRow::roughness, "0 mirror, 1 chalk", range(0, 1)),
      field("metallic", &MaterialRow::metallic, "0 dielectric, 1 metal", range(0, 1)),
      field("uses", &MaterialRow::uses, "where it may be used: floor wall ceiling fixture"),
      field("third_color",
            &MaterialRow::third_color,
            "chips or veins of another kind, #rrggbb; empty = none",
            at_most_bytes(7)),
      field("joint_mm",
            &MaterialRow::joint_mm,
            "width of joints and gaps; 0 = usual for the pattern",
            range(0, 100)),
      field("aspect",
            &MaterialRow::aspect,
            "length of a piece over its width; 0 = usual for the pattern",
            range(0, 40)),
      field("relief", &MaterialRow::relief, "factor on the pattern's own depth", range(0, 10)),
      field("variation",
            &MaterialRow::variation,
            "factor on the differences between pieces",
            range(0, 10)),
      field("transmission",
            &MaterialRow::transmission,
            "share of light let through: 0 opaque, 0.9 clear glass",
            range(0, 1)));
};

// Limits and habits of one kind of shop in one part of the world. Sources are named in the rows'
// `source`.
struct ProfileRow {
  std::string id;  // "supermarket-eu"
  std::string name;
  std::string source;  // where the numbers come from
  int main_aisle_mm = 2200;
  int secondary_aisle_mm = 1800;
  int cold_aisle_mm = 2800;  // before deli, fresh and frozen
  int cross_aisle_mm = 2400;
  int checkout_clear_mm = 2200;  // each side of the checkout line
  int minimum_aisle_mm = 1000;   // narrower is a violation
  int wheelchair_mm = 915;       // ADA 2010, 403.5.1
  int ceiling_mm = 3660;
  int gondola_height_mm = 1800;
  int gondola_shelf_mm = 470;  // depth of one side
  int module_mm = 1250;
  double checkouts_per_100_m2 = 0.7;
  std::array<int, 2> default_size_mm{24000, 15000};
  double stock_fill = 0.95;
  std::vector<std::string>
      zones;  // zone types of a complete shop of this kind, most important first

  static constexpr auto fields = field_list(
      field("id", &ProfileRow::id, "profile id", identifier()),
      field("name", &ProfileRow::name, "what people call it", required()),
      field("source", &ProfileRow::source, "where the numbers come from", required()),
      field("main_aisle_mm", &ProfileRow::main_aisle_mm, "main aisle", range(800, 6000)),
      field("secondary_aisle_mm",
            &ProfileRow::secondary_aisle_mm,
            "aisle between gondolas",
            range(800, 6000)),
      field("cold_aisle_mm",
            &ProfileRow::cold_aisle_mm,
            "aisle before deli, fresh and frozen",
            range(800, 6000)),
      field(
          "cross_aisle_mm", &ProfileRow::cross_aisle_mm, "aisle across the runs", range(800, 6000)),
      field("checkout_clear_mm",
            &ProfileRow::checkout_clear_mm,
            "free floor each side of the checkout line",
            range(800, 6000)),
      field("minimum_aisle_mm",
            &ProfileRow::minimum_aisle_mm,
            "narrowest lawful aisle",
            range(600, 3000)),
      field("wheelchair_mm",
            &ProfileRow::wheelchair_mm,
            "narrowest wheelchair route",
            range(600, 2000)),
      field("ceiling_mm", &ProfileRow::ceiling_mm, "ceiling height", range(2300, 12000)),
      field("gondola_height_mm",
            &ProfileRow::gondola_height_mm,
            "usual gondola height",
            range(900, 2400)),
      field("gondola_shelf_mm",
            &ProfileRow::gondola_shelf_mm,
            "shelf depth of one side",
            range(200, 800)),
      field("module_mm", &ProfileRow::module_mm, "usual module width", range(400, 2000)),
      field("checkouts_per_100_m2",
            &ProfileRow::checkouts_per_100_m2,
            "lanes per 100 m2 of store",
            range(0, 10)),
      field("default_size_mm",
            &ProfileRow::default_size_mm,
            "store size when none is given",
            range(4000, 200000)),
      field("stock_fill",
            &ProfileRow::stock_fill,
            "share of the shelf front that is stocked",
            range(0, 1)),
      field("zones", &ProfileRow::zones, "zone types of a complete shop, most important first"));
};

// How lamps are fitted: square into the ceiling, as bright lines below it, or as single shades on
// cords.
enum class LampFitting { panel, line, pendant };
constexpr std::array<std::string_view, 3> names_of(LampFitting) {
  return {"panel", "line", "pendant"};
}

// A look: materials, colours and light.
struct StyleRow {
  std::string id;  // "scandinavian"
  std::string name;
  std::string floor = "terrazzo-white";
  std::string wall = "plaster-white";
  std::string ceiling = "ceiling-grid-white";
  std::string fixture = "metal-white";
  std::string fixture_color = "#f2f2f0";
  std::string accent = "#2e7d32";
  int light_kelvin = 4000;
  int light_lux = 800;
  std::optional<LampFitting> lamps;
  std::optional<double> daylight;
  std::optional<bool> neon;
  std::vector<std::string> keywords;

  static constexpr auto fields = field_list(
      field("id", &StyleRow::id, "style id", identifier()),
      field("name", &StyleRow::name, "what people call it", required()),
      field("floor", &StyleRow::floor, "floor material"),
      field("wall", &StyleRow::wall, "wall material"),
      field("ceiling", &StyleRow::ceiling, "ceiling material"),
      field("fixture", &StyleRow::fixture, "fixture material"),
      field("fixture_color", &StyleRow::fixture_color, "fixture colour, #rrggbb"),
      field("accent", &StyleRow::accent, "signs and bands, #rrggbb"),
      field("light_kelvin",
            &StyleRow::light_kelvin,
            "colour temperature of the light",
            range(1500, 10000)),
      field("light_lux", &StyleRow::light_lux, "illuminance on the floor", range(50, 3000)),
      field("lamps", &StyleRow::lamps, "how lamps are fitted; left out: panel"),
      field("daylight",
            &StyleRow::daylight,
            "outside, share of an overcast day, 0 is night; left out: 1",
            range(0, 1)),
      field("neon", &StyleRow::neon, "a glowing line below the bands on the walls"),
      field("keywords", &StyleRow::keywords, "words that name it"));
};

// Friction of one pair of contact materials.
struct FrictionRow {
  std::string a, b;
  double sliding = 0.4;
  std::string source;                // key of a FrictionSource
  std::string detail;                // which of its entries
  std::array<double, 2> possible{};  // of an estimate: least and most that is thought possible

  static constexpr auto fields = field_list(
      field("a", &FrictionRow::a, "contact material", required()),
      field("b", &FrictionRow::b, "contact material", required()),
      field("sliding",
            &FrictionRow::sliding,
            "coefficient of sliding friction",
            range(0.01, 2),
            required()),
      field("source",
            &FrictionRow::source,
            "where the number comes from: a key of friction_sources.json",
            required()),
      field("detail", &FrictionRow::detail, "which of the source's entries"),
      field("range", &FrictionRow::possible, "of an estimate: least and most, else absent"));
};

// Where frictions come from, as a reader can find it. The key of an estimate begins with
// "estimate".
struct FrictionSource {
  std::string key, text;

  bool is_estimate() const { return key.starts_with("estimate"); }

  static constexpr auto fields =
      field_list(field("key", &FrictionSource::key, "unique", identifier(), required()),
                 field("text", &FrictionSource::text, "title, edition, place in it", required()));
};

}  // namespace marketgen::catalog
