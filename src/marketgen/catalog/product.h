// A product row: everything the rest of the program knows about one SKU.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"

namespace marketgen::catalog {

enum class Storage { ambient, chilled, frozen };
constexpr std::array<std::string_view, 3> names_of(Storage) {
  return {"ambient", "chilled", "frozen"};
}

enum class Rigidity { rigid, crushable, soft };
constexpr std::array<std::string_view, 3> names_of(Rigidity) {
  return {"rigid", "crushable", "soft"};
}

// Which ways a pack may be put down: on its base only, on a flat side too, or any way (loose
// fruit).
enum class Orientation { upright, flat, any };
constexpr std::array<std::string_view, 3> names_of(Orientation) {
  return {"upright", "flat", "any"};
}

// How the printed face looks; drawn by assets/label.
struct LabelStyle {
  std::string primary = "#336699";    // ground colour of the pack
  std::string secondary = "#ffffff";  // bands, panel behind the name
  std::string accent = "#ffcc00";     // burst, cap, small marks
  std::string text = "#ffffff";       // colour of the name
  std::string motif =
      "none";  // picture drawn on the front: one of the motifs in assets/print/label_motifs.inc

  static constexpr auto fields =
      field_list(field("primary", &LabelStyle::primary, "ground colour of the pack, #rrggbb"),
                 field("secondary", &LabelStyle::secondary, "bands and panels, #rrggbb"),
                 field("accent", &LabelStyle::accent, "burst, cap and small marks, #rrggbb"),
                 field("text", &LabelStyle::text, "colour of the name, #rrggbb"),
                 field("motif", &LabelStyle::motif, "picture on the front, by name"));
};

enum class Opacity { opaque, clear };
constexpr std::array<std::string_view, 2> names_of(Opacity) {
  return {"opaque", "clear"};
}

// What one sees of the goods through a clear wall.
struct Contents {
  std::string color;  // #rrggbb
  Opacity opacity =
      Opacity::opaque;       // clear: a liquid one sees through, `color` over the pack's depth
  double refraction = 1.33;  // index of a clear liquid
  double fill = 0.9;         // of the clear wall's height
  int particle_mm = 0;       // pieces against the wall; 0: none
  std::string particle_color = {};  // #rrggbb

  static constexpr auto fields =
      field_list(field("color",
                       &Contents::color,
                       "colour behind the wall, #rrggbb",
                       required(),
                       at_most_bytes(7)),
                 field("opacity", &Contents::opacity, "whether light passes"),
                 field("refraction",
                       &Contents::refraction,
                       "index of refraction of a clear liquid",
                       range(1, 1.7)),
                 field("fill",
                       &Contents::fill,
                       "share of the clear wall's height that is filled",
                       range(0.2, 1)),
                 field("particle_mm",
                       &Contents::particle_mm,
                       "size of pieces against the wall; 0 = none",
                       range(0, 60)),
                 field("particle_color",
                       &Contents::particle_color,
                       "colour of the pieces, #rrggbb",
                       at_most_bytes(7)));
};

// Pictures of a pack's sides that its label shows instead of a drawn one: files beside the row's
// own while a row is read, from then on names of kept pictures (catalog/own_faces.h). Empty: none.
struct PackFaces {
  std::string front, back, left, right, top, bottom;  // the whole pack as it is seen from there
  std::string wrap;                                   // the label of a round pack, unrolled

  static constexpr auto fields = field_list(
      field("front", &PackFaces::front, "PNG or JPEG of the front", at_most_bytes(400)),
      field("back", &PackFaces::back, "of the back", at_most_bytes(400)),
      field("left",
            &PackFaces::left,
            "of the side at the left hand of who looks at the front",
            at_most_bytes(400)),
      field("right", &PackFaces::right, "of the side at the right hand", at_most_bytes(400)),
      field("top", &PackFaces::top, "of the top, its lower edge at the front", at_most_bytes(400)),
      field("bottom",
            &PackFaces::bottom,
            "of the bottom, its upper edge at the front",
            at_most_bytes(400)),
      field("wrap",
            &PackFaces::wrap,
            "the unrolled label of a can, bottle or jar, the front in its middle",
            at_most_bytes(400)));
};

struct Product {
  std::string sku;      // "beverages-cola-can-330"
  std::string ean;      // EAN-13 from a GS1 restricted-circulation prefix; empty for loose produce
  std::string plu;      // price look-up code of loose produce; otherwise empty
  std::string name;     // "Cola"
  std::string name_zh;  // "可乐"
  std::string variant;  // "Zero Sugar"; may be empty
  std::string brand;    // invented
  std::string description;            // one sentence
  std::string category;               // one of data/categories.json
  std::string subcategory;            // "soft drinks"
  std::vector<std::string> keywords;  // for search
  std::string archetype;  // container shape: one of assets/shapes/archetypes.inc, or "mesh"
  std::string mesh;       // of archetype "mesh" only: see catalog/own_mesh.h
  std::array<int, 3> size_mm{
      60, 60, 100};  // width, depth, height as it stands with its front to the shopper
  double mass_kg = 0.1;
  double friction = 0.4;  // sliding friction on a painted steel shelf
  std::string material =
      "cardboard";  // contact material: tin glass pet hdpe cardboard film paper foil skin
  Rigidity rigidity = Rigidity::rigid;
  Storage storage = Storage::ambient;
  Orientation orientation = Orientation::upright;
  int stack_max = 1;       // how many may stand on one another on a shelf, this one included
  std::string net;         // "330 ml", "6 x 1.5 l", "500 g", "each"
  double unit_amount = 1;  // amount in unit_of_measure: 0.33
  std::string unit_of_measure = "kg";  // l, kg, or piece: the unit price is price / unit_amount
  double price = 1.0;                  // in the money of `country`
  std::optional<std::string> country = {};  // catalog/countries.inc; absent: euro, metric units
  int shelf_life_days = 365;                // from delivery to the date printed on the pack
  std::string family;  // look-alikes share it: same brand, other variant or size
  LabelStyle label;
  std::optional<Contents> contents;     // absent: nothing is seen
  std::optional<PackFaces> faces = {};  // absent: the label is drawn

  double width_m() const { return size_mm[0] * 1e-3; }
  double depth_m() const { return size_mm[1] * 1e-3; }
  double height_m() const { return size_mm[2] * 1e-3; }

  static constexpr auto fields = field_list(
      field("sku", &Product::sku, "stock keeping unit, unique", identifier()),
      field("ean", &Product::ean, "EAN-13, unique; empty for loose produce", at_most_bytes(13)),
      field("plu", &Product::plu, "price look-up code of loose produce", at_most_bytes(5)),
      field("name", &Product::name, "product name", required(), at_most_bytes(80)),
      field("name_zh", &Product::name_zh, "product name in Chinese", at_most_bytes(80)),
      field("variant", &Product::variant, "flavour, strength or cut", at_most_bytes(80)),
      field("brand", &Product::brand, "invented brand", at_most_bytes(40)),
      field("description", &Product::description, "one sentence", at_most_bytes(400)),
      field("category", &Product::category, "category id, see data/categories.json", required()),
      field("subcategory", &Product::subcategory, "shelf group within the category", required()),
      field("keywords", &Product::keywords, "words to find it by", at_most_items(40)),
      field("archetype", &Product::archetype, "container shape", required()),
      field("mesh",
            &Product::mesh,
            "GLB or OBJ file of a product of archetype mesh, relative to this file",
            at_most_bytes(400)),
      field("size_mm",
            &Product::size_mm,
            "width, depth, height as it stands on a shelf",
            range(5, 1500),
            required()),
      field("mass_kg", &Product::mass_kg, "gross mass", range(0.001, 50), required()),
      field("friction",
            &Product::friction,
            "sliding friction on a painted steel shelf",
            range(0.05, 1.5)),
      field("material", &Product::material, "contact material of the outside"),
      field("rigidity", &Product::rigidity, "how it takes a grip"),
      field("storage", &Product::storage, "temperature it is kept at"),
      field("orientation", &Product::orientation, "ways it may be put down"),
      field("stack_max", &Product::stack_max, "most items on one another on a shelf", range(1, 12)),
      field("net", &Product::net, "net quantity as printed", at_most_bytes(24)),
      field("unit_amount",
            &Product::unit_amount,
            "net quantity in unit_of_measure",
            range(0.0001, 1000)),
      field("unit_of_measure", &Product::unit_of_measure, "l, kg or piece", at_most_bytes(8)),
      field("price",
            &Product::price,
            "shelf price, in euro where no country is named",
            range(0.01, 200000)),
      field("shelf_life_days",
            &Product::shelf_life_days,
            "days from delivery to the date printed on the pack",
            range(1, 4000)),
      field("family", &Product::family, "shared by look-alikes", at_most_bytes(80)),
      field("label", &Product::label, "how the pack is printed"),
      field("contents", &Product::contents, "what is seen through a clear wall"),
      field("country",
            &Product::country,
            "country whose money the price is in and whose units the tag has: eu, us, gb, cn, jp, "
            "ch, se, pl, ca or au; absent: eu",
            reference()),
      field("faces",
            &Product::faces,
            "pictures of the pack's sides, relative to this file; absent: the label is drawn"));
};

}  // namespace marketgen::catalog
