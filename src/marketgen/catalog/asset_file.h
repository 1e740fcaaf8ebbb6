// market-asset/1: one outside model taken into a user's library by `assets import`. The file lies
// beside the model; `--catalog` takes it like a file of rows.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/fields.h"
#include "catalog/own_mesh.h"
#include "catalog/product.h"

namespace marketgen::catalog {

// What the model was made from, and how sound it is.
struct AssetSource {
  std::string file;    // name of the file that was imported
  std::string sha256;  // of its bytes
  LengthUnit unit = LengthUnit::m;
  int triangles = 0;
  bool watertight = false;
  int open_edges = 0;              // edges that do not join two triangles, once each way
  std::vector<std::string> parts;  // names of its nodes, meshes and materials
  static constexpr auto fields =
      field_list(field("file", &AssetSource::file, "name of the imported file"),
                 field("sha256", &AssetSource::sha256, "of its bytes"),
                 field("unit", &AssetSource::unit, "unit it was made in"),
                 field("triangles", &AssetSource::triangles, "triangles"),
                 field("watertight", &AssetSource::watertight, "encloses a volume without holes"),
                 field("open_edges",
                       &AssetSource::open_edges,
                       "edges that do not join two triangles, once each way"),
                 field("parts", &AssetSource::parts, "names of nodes, meshes and materials"));
};

// One of the colours that a model mostly shows.
struct ColorShare {
  std::string color;  // #rrggbb
  double share = 0;   // of what is seen, 0..1
  static constexpr auto fields =
      field_list(field("color", &ColorShare::color, "#rrggbb"),
                 field("share", &ColorShare::share, "of what is seen", range(0, 1)));
};

// What an annotator says a model is. Empty texts: it cannot tell.
struct AssetAnnotation {
  std::string annotator;  // who says so: "offline", or a model's name
  std::string name, category, subcategory;
  std::string archetype;  // the shape of ours that it resembles
  std::string material;   // contact material
  Storage storage = Storage::ambient;
  Rigidity rigidity = Rigidity::rigid;
  std::vector<std::string> keywords;
  double confidence = 0;  // of the category, 0..1
  std::vector<std::string> reasons;
  static constexpr auto fields =
      field_list(field("annotator", &AssetAnnotation::annotator, "who says so"),
                 field("name", &AssetAnnotation::name, "what it is"),
                 field("category", &AssetAnnotation::category, "category id"),
                 field("subcategory", &AssetAnnotation::subcategory, "shelf group"),
                 field("archetype", &AssetAnnotation::archetype, "shape of ours that it resembles"),
                 field("material", &AssetAnnotation::material, "contact material"),
                 field("storage", &AssetAnnotation::storage, "temperature it is kept at"),
                 field("rigidity", &AssetAnnotation::rigidity, "how it takes a grip"),
                 field("keywords", &AssetAnnotation::keywords, "words to find it by"),
                 field("confidence", &AssetAnnotation::confidence, "of the category", range(0, 1)),
                 field("reasons", &AssetAnnotation::reasons, "what speaks for it"));
};

// What was seen in the model's materials.
struct AssetLook {
  std::vector<ColorShare> colors;                 // most seen first
  double roughness = 0, metallic = 0, clear = 0;  // means over the surface
  static constexpr auto fields =
      field_list(field("colors", &AssetLook::colors, "dominant colours, most seen first"),
                 field("roughness", &AssetLook::roughness, "mean, 0 mirror, 1 chalk"),
                 field("metallic", &AssetLook::metallic, "mean, 0 dielectric, 1 metal"),
                 field("clear", &AssetLook::clear, "share that is seen through"));
};

// Numbers that were worked out, each with where it comes from.
struct AssetEstimates {
  double volume_m3 = 0;
  std::string mass_from, friction_from;
  std::string contact_from;  // "coacd", "planes" (made when it is used) or "hull"
  int pieces = 0;
  double pieces_volume_m3 = 0;
  static constexpr auto fields = field_list(
      field("volume_m3", &AssetEstimates::volume_m3, "enclosed volume"),
      field("mass_from", &AssetEstimates::mass_from, "where the mass comes from"),
      field("friction_from", &AssetEstimates::friction_from, "where the friction comes from"),
      field("contact_from",
            &AssetEstimates::contact_from,
            "coacd, planes (made when it is used) or hull"),
      field("pieces", &AssetEstimates::pieces, "convex contact pieces in the model's file"),
      field("pieces_volume_m3", &AssetEstimates::pieces_volume_m3, "their volume together"));
};

struct AssetFile {
  std::string schema = "market-asset/1";
  Product product;
  AssetSource source;
  AssetLook look;
  AssetAnnotation annotation;
  AssetEstimates estimates;
  std::vector<std::string> notes;  // what a person should look at
  static constexpr auto fields =
      field_list(field("schema", &AssetFile::schema, "schema tag", constant("market-asset/1")),
                 field("product", &AssetFile::product, "the row that shops use", required()),
                 field("source", &AssetFile::source, "what it was made from"),
                 field("look", &AssetFile::look, "what was seen in its materials"),
                 field("annotation", &AssetFile::annotation, "what it is taken for"),
                 field("estimates", &AssetFile::estimates, "numbers that were worked out"),
                 field("notes", &AssetFile::notes, "what a person should look at"));
};

}  // namespace marketgen::catalog
