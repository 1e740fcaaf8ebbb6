// Sizes and densities of the committed rows against bounds by pack type, each with its source:
// pack_bounds.json. The bounds come from standards and makers' sheets, or from geometry and the
// density of contents ("derived"), not from the rows.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "catalog/catalog.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen {
namespace {

struct PackBounds {
  std::string archetype;
  std::array<int, 2> density_kg_m3{};  // mass over the volume of the bounding box
  std::array<int, 2> width_mm{}, depth_mm{}, height_mm{};
  std::string source;
  static constexpr auto fields =
      field_list(field("archetype", &PackBounds::archetype, "pack type", required()),
                 field("density_kg_m3", &PackBounds::density_kg_m3, "least, most", required()),
                 field("width_mm", &PackBounds::width_mm, "least, most", required()),
                 field("depth_mm", &PackBounds::depth_mm, "least, most", required()),
                 field("height_mm", &PackBounds::height_mm, "least, most", required()),
                 field("source", &PackBounds::source, "where they come from", required()));
};

struct BoundsFile {
  std::string schema;
  std::vector<PackBounds> rows;
  static constexpr auto fields =
      field_list(field("schema", &BoundsFile::schema, "tag", constant("pack-bounds")),
                 field("rows", &BoundsFile::rows, "one a pack type", required()));
};

std::map<std::string, PackBounds> bounds_by_archetype() {
  const std::string file = MARKETGEN_SOURCE_DIR "/tests/unit/catalog/pack_bounds.json";
  const auto text = io::read_file(file);
  if (!text.ok()) fatal(to_string(text.error()).c_str());
  const auto read = io::read_json<BoundsFile>(*text, file);
  if (!read.ok()) fatal(to_string(read.error()).c_str());
  std::map<std::string, PackBounds> bounds;
  for (const PackBounds& row : read->rows)
    bounds[row.archetype] = row;
  return bounds;
}

void expect_within(double value, const std::array<int, 2>& range, const std::string& what) {
  EXPECT_GE(value, range[0]) << what;
  EXPECT_LE(value, range[1]) << what;
}

TEST(PackBounds, EveryOneHasASource) {
  for (const auto& [archetype, row] : bounds_by_archetype()) {
    EXPECT_GE(row.source.size(), 20U) << archetype;
    for (const auto* range : {&row.density_kg_m3, &row.width_mm, &row.depth_mm, &row.height_mm})
      EXPECT_LT((*range)[0], (*range)[1]) << archetype;
  }
}

TEST(PackBounds, HoldForEveryRow) {
  const auto catalog = catalog::load_catalog(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data");
  ASSERT_TRUE(catalog.ok()) << to_string(catalog.error());
  const auto bounds = bounds_by_archetype();
  for (const catalog::Product& p : catalog->products) {
    const auto row = bounds.find(p.archetype);
    ASSERT_NE(row, bounds.end()) << p.sku << ": no bounds for " << p.archetype;
    const double density = p.mass_kg / (p.width_m() * p.depth_m() * p.height_m());
    expect_within(density, row->second.density_kg_m3, p.sku + " density");
    expect_within(p.size_mm[0], row->second.width_mm, p.sku + " width");
    expect_within(p.size_mm[1], row->second.depth_mm, p.sku + " depth");
    expect_within(p.size_mm[2], row->second.height_mm, p.sku + " height");
  }
}

}  // namespace
}  // namespace marketgen
