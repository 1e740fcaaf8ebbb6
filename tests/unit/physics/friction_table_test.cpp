#include "physics/goods/friction_table.h"

#include <gtest/gtest.h>

#include <set>

#include "support/committed_catalog.h"

namespace marketgen {
namespace {

const std::vector<catalog::FrictionRow> few = {{"tin", "steel", 0.25, "", "", {}},
                                               {"glass", "steel", 0.36, "", "", {}},
                                               {"glass", "rubber", 0.6, "", "", {}},
                                               {"foam", "rubber", 0.9, "", "", {}}};

TEST(FrictionTable, ARowDecidesInEitherOrder) {
  const physics::FrictionTable table(few);
  EXPECT_EQ(table.sliding(table.material("rubber"), table.material("glass")), 0.6);
  EXPECT_EQ(table.sliding(table.material("glass"), table.material("rubber")), 0.6);
}

TEST(FrictionTable, OtherPairsTakeTheMeanOfBothOnSteel) {
  const physics::FrictionTable table(few);
  EXPECT_DOUBLE_EQ(table.sliding(table.material("tin"), table.material("glass")), 0.3);
  EXPECT_DOUBLE_EQ(table.sliding(table.material("tin"), table.material("tin")), 0.25);
}

TEST(FrictionTable, KnowsNothingOfMaterialsWithoutRows) {
  const physics::FrictionTable table(few);
  EXPECT_EQ(table.material("velvet"), physics::FrictionTable::unknown);
  EXPECT_EQ(table.sliding(table.material("velvet"), table.material("steel")), 0);
  EXPECT_EQ(table.sliding(table.material("foam"), table.material("tin")), 0) << "no foam on steel";
  EXPECT_EQ(physics::FrictionTable({}).sliding(0, 0), 0);
}

// Goods meet shelves, belts, the floor, grippers and one another.
TEST(FrictionTable, TheCommittedRowsGiveEveryPairOfMaterials) {
  const catalog::Catalog& catalog = committed_catalog();
  const physics::FrictionTable table(catalog.frictions);
  std::set<std::string, std::less<>> materials{std::string(physics::reference_material),
                                               std::string(physics::belt_material),
                                               std::string(physics::room_material)};
  for (const catalog::Product& product : catalog.products)
    materials.insert(product.material);
  EXPECT_GE(materials.size(), 13U);
  for (const std::string& a : materials) {
    ASSERT_NE(table.material(a), physics::FrictionTable::unknown) << a;
    for (const std::string& b : materials) {
      const double sliding = table.sliding(table.material(a), table.material(b));
      EXPECT_GE(sliding, 0.1) << a << " on " << b;
      EXPECT_LE(sliding, 1.0) << a << " on " << b;
    }
  }
}

TEST(FrictionTable, EveryCommittedRowIsTheOnlyOneOfItsPair) {
  std::set<std::pair<std::string, std::string>> pairs;
  for (const catalog::FrictionRow& row : committed_catalog().frictions) {
    EXPECT_TRUE(pairs.insert(std::minmax(row.a, row.b)).second) << row.a << " on " << row.b;
  }
}

}  // namespace
}  // namespace marketgen
