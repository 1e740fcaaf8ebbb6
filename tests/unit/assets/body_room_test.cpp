// Every committed row against the shape that is drawn of it: a pack of a liquid holds its contents,
// the free space over them and its own wall, and is not much larger; whatever is sold by weight or
// piece is as dense over its body as such goods are. Bounds and their sources: body_room.json.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "assets/product_model.h"
#include "base/parallel.h"
#include "geometry/solid.h"
#include "io/file.h"
#include "io/json.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

struct Wall {
  std::string material;
  double thickness_mm = 0;
  std::string source;
  static constexpr auto fields =
      field_list(field("material", &Wall::material, "contact material", required()),
                 field("thickness_mm", &Wall::thickness_mm, "of a pack's wall", required()),
                 field("source", &Wall::source, "where it comes from", required()));
};

struct LiquidRoom {
  std::vector<std::string> archetypes;
  double headspace = 0, most = 1.3;
  std::string source;
  static constexpr auto fields = field_list(
      field("archetypes", &LiquidRoom::archetypes, "container shapes", required()),
      field("headspace", &LiquidRoom::headspace, "least free share of the inside", required()),
      field("most", &LiquidRoom::most, "inside over contents at most", required()),
      field("source", &LiquidRoom::source, "where they come from", required()));
};

struct BodyDensity {
  std::vector<std::string> archetypes;
  std::array<int, 2> density_kg_m3{};
  std::string source;
  static constexpr auto fields =
      field_list(field("archetypes", &BodyDensity::archetypes, "container shapes", required()),
                 field("density_kg_m3", &BodyDensity::density_kg_m3, "least, most", required()),
                 field("source", &BodyDensity::source, "where they come from", required()));
};

struct PouredGoods {
  std::string subcategory, word;
  int max_kg_m3 = 0;
  std::string source;
  static constexpr auto fields =
      field_list(field("subcategory", &PouredGoods::subcategory, "of the rows", required()),
                 field("word", &PouredGoods::word, "in name or variant", required()),
                 field("max_kg_m3", &PouredGoods::max_kg_m3, "with its bag", required()),
                 field("source", &PouredGoods::source, "where it comes from", required()));
};

struct BodyRoom {
  std::string schema;
  std::vector<Wall> walls;
  std::vector<LiquidRoom> liquids;
  std::vector<BodyDensity> solids;
  std::vector<PouredGoods> poured;
  static constexpr auto fields =
      field_list(field("schema", &BodyRoom::schema, "tag", constant("body-room")),
                 field("walls", &BodyRoom::walls, "by material", required()),
                 field("liquids", &BodyRoom::liquids, "by container shape", required()),
                 field("solids", &BodyRoom::solids, "by container shape", required()),
                 field("poured", &BodyRoom::poured, "narrower bounds", required()));
};

const BodyRoom& body_room() {
  static const BodyRoom room = [] {
    const std::string file = MARKETGEN_SOURCE_DIR "/tests/unit/assets/body_room.json";
    const auto text = io::read_file(file);
    if (!text.ok()) fatal(to_string(text.error()).c_str());
    auto read = io::read_json<BodyRoom>(*text, file);
    if (!read.ok()) fatal(to_string(read.error()).c_str());
    return std::move(read).value();
  }();
  return room;
}

// The row of `rows` that names the shape.
template <class Row>
const Row* row_of(const std::vector<Row>& rows, const std::string& archetype) {
  for (const Row& row : rows)
    for (const std::string& name : row.archetypes)
      if (name == archetype) return &row;
  return nullptr;
}

// What is drawn.
struct DrawnBody {
  double volume_m3 = 0, area_m2 = 0;
};

DrawnBody drawn_body(const catalog::Product& product) {
  constexpr int columns = 160;
  const Mesh mesh = assets::make_product_model(product).value().mesh;
  DrawnBody body{Solid(mesh, columns).volume(), 0};
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 at = to_double(mesh.positions[a]);
    const Vec3 normal = cross(to_double(mesh.positions[b]) - at, to_double(mesh.positions[c]) - at);
    body.area_m2 += length(normal) / 2;
  }
  return body;
}

bool is_liquid(const catalog::Product& product) {
  return product.unit_of_measure == "l";
}

// Of liquids or of all others, by row of the catalogue; the rest is empty.
std::vector<DrawnBody> drawn_bodies(bool liquids) {
  const std::vector<catalog::Product>& products = committed_catalog().products;
  return parallel_map(products.size(), [&](std::size_t i) {
    return is_liquid(products[i]) == liquids ? drawn_body(products[i]) : DrawnBody{};
  });
}

double wall_of(const catalog::Product& product) {
  for (const Wall& wall : body_room().walls)
    if (wall.material == product.material) return wall.thickness_mm * 1e-3;
  ADD_FAILURE() << product.sku << ": no wall of " << product.material;
  return 0;
}

TEST(BodyRoom, ALiquidsPackHoldsItAndLittleElse) {
  const catalog::Catalog& catalog = committed_catalog();
  const std::vector<DrawnBody> bodies = drawn_bodies(/*liquids=*/true);
  int looked_at = 0;
  for (std::size_t i = 0; i < catalog.products.size(); ++i) {
    const catalog::Product& product = catalog.products[i];
    if (!is_liquid(product)) continue;
    const LiquidRoom* bounds = row_of(body_room().liquids, product.archetype);
    ASSERT_NE(bounds, nullptr) << product.sku << ": no bounds for " << product.archetype;
    const DrawnBody& drawn = bodies[i];
    const double inside = (drawn.volume_m3 - wall_of(product) * drawn.area_m2) * 1e3;
    EXPECT_GE(inside * (1 - bounds->headspace), product.unit_amount)
        << product.sku << ": litres inside its wall, without the head space";
    EXPECT_LE(inside, bounds->most * product.unit_amount) << product.sku << ": litres inside";
    ++looked_at;
  }
  EXPECT_GT(looked_at, 500);
}

std::array<int, 2> density_bounds(const catalog::Product& product) {
  const BodyDensity* row = row_of(body_room().solids, product.archetype);
  if (row == nullptr) {
    ADD_FAILURE() << product.sku << ": no bounds for " << product.archetype;
    return {0, 100000};
  }
  std::array<int, 2> bounds = row->density_kg_m3;
  const std::string words = product.name + " " + product.variant;
  for (const PouredGoods& poured : body_room().poured) {
    if (poured.subcategory == product.subcategory && words.find(poured.word) != std::string::npos)
      bounds[1] = std::min(bounds[1], poured.max_kg_m3);
  }
  return bounds;
}

TEST(BodyRoom, GoodsAreAsDenseAsTheirKind) {
  const catalog::Catalog& catalog = committed_catalog();
  const std::vector<DrawnBody> bodies = drawn_bodies(/*liquids=*/false);
  for (std::size_t i = 0; i < catalog.products.size(); ++i) {
    const catalog::Product& product = catalog.products[i];
    if (is_liquid(product)) continue;
    const auto [least, most] = density_bounds(product);
    const double density = product.mass_kg / bodies[i].volume_m3;
    EXPECT_GE(density, least) << product.sku << ": kg/m3 of its drawn body";
    EXPECT_LE(density, most) << product.sku << ": kg/m3 of its drawn body";
  }
}

// Contents weigh at least what the lightest such liquid does: whipped ice 0.45, foam and gas 0.6.
TEST(BodyRoom, APackWeighsMoreThanItsContents) {
  constexpr double lightest_kg_l = 0.45, heaviest_kg_l = 2.6;  // a small glass jar
  for (const catalog::Product& product : committed_catalog().products) {
    if (is_liquid(product)) {
      EXPECT_GT(product.mass_kg, lightest_kg_l * product.unit_amount) << product.sku;
      EXPECT_LT(product.mass_kg, heaviest_kg_l * product.unit_amount + 0.2) << product.sku;
    } else if (product.unit_of_measure == "kg") {
      EXPECT_GE(product.mass_kg, product.unit_amount) << product.sku;
    }
  }
}

TEST(BodyRoom, EveryBoundHasASource) {
  for (const Wall& row : body_room().walls)
    EXPECT_GE(row.source.size(), 20U) << row.material;
  for (const LiquidRoom& row : body_room().liquids)
    EXPECT_GE(row.source.size(), 10U) << row.archetypes.front();
  for (const BodyDensity& row : body_room().solids)
    EXPECT_GE(row.source.size(), 20U) << row.archetypes.front();
  for (const PouredGoods& row : body_room().poured)
    EXPECT_GE(row.source.size(), 20U) << row.word;
}

}  // namespace
}  // namespace marketgen
