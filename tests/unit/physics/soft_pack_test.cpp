// What a soft pack is made of, for every bag and pouch of the catalogue.
#include "physics/soft/soft_pack.h"

#include "physics/soft/soft_body.h"
#include "support/committed_catalog.h"
#include "unit/physics/soft_packs.h"

namespace marketgen {
namespace {

// Extent of the parts along each axis, and their middle of mass.
struct Whole {
  Vec3 low{1, 1, 1}, high{-1, -1, -1}, middle;
  double mass_kg = 0;
};

Whole whole_of(const physics::SoftPack& pack) {
  Whole whole;
  for (const physics::SoftPart& part : pack.parts) {
    const Vec3 low = part.center - part.half_size, high = part.center + part.half_size;
    whole.low = {
        std::min(whole.low.x, low.x), std::min(whole.low.y, low.y), std::min(whole.low.z, low.z)};
    whole.high = {std::max(whole.high.x, high.x),
                  std::max(whole.high.y, high.y),
                  std::max(whole.high.z, high.z)};
    whole.middle = whole.middle + part.center * part.mass_kg;
    whole.mass_kg += part.mass_kg;
  }
  whole.middle = whole.middle * (1 / whole.mass_kg);
  return whole;
}

// About the middle of mass, along the pack's axes: each part is a box of one density.
Vec3 inertia_of_parts(const physics::SoftPack& pack) {
  Vec3 sum;
  const Vec3 middle = whole_of(pack).middle;
  for (const physics::SoftPart& part : pack.parts) {
    const Vec3 c = part.center - middle, &h = part.half_size;
    const double x = c.x * c.x + h.x * h.x / 3, y = c.y * c.y + h.y * h.y / 3;
    const double z = c.z * c.z + h.z * h.z / 3;
    sum = sum + Vec3{y + z, x + z, x + y} * part.mass_kg;
  }
  return sum;
}

TEST(SoftPack, HasTheMassSizeAndInertiaOfItsRow) {
  for (const SoftRow& row : soft_rows()) {
    const catalog::Product& product = *row.product;
    const Whole whole = whole_of(row.pack);
    EXPECT_DOUBLE_EQ(whole.mass_kg, product.mass_kg) << product.sku;
    const Vec3 half{product.width_m() / 2, product.depth_m() / 2, product.height_m() / 2};
    EXPECT_LT(length(whole.high - half), 1e-3) << product.sku;
    EXPECT_LT(length(whole.low + half), 1e-3) << product.sku;
    const Vec3 is = inertia_of_parts(row.pack);
    const double sx = half.x * half.x, sy = half.y * half.y, sz = half.z * half.z;
    const Vec3 box = Vec3{sy + sz, sx + sz, sx + sy} * (product.mass_kg / 3);
    for (const double share : {is.x / box.x, is.y / box.y, is.z / box.z}) {
      EXPECT_GT(share, 0.6) << product.sku;  // the box's end is as heavy as its middle
      EXPECT_LT(share, 1.02) << product.sku;
    }
    for (const physics::SoftPart& part : row.pack.parts)
      EXPECT_GT(part.mass_kg, 0) << product.sku;
  }
}

// The judge is the body of grasp trials, filled and with its mesh cut sixteen times as fine. Of the
// whole catalogue 95 % are within 3 mm; flat packs that hang or are full to one side are farther
// off.
TEST(SoftPack, HasItsMiddleOfMassWhereTheFilledPackHas) {
  const std::vector<SoftRow>& rows = soft_rows();
  std::size_t low = 0, far = 0;
  for (std::size_t i = 0; i < rows.size(); i += 20) {
    const catalog::Product& product = *rows[i].product;
    const Result<assets::ProductBody> body = assets::make_product_body(product);
    ASSERT_TRUE(body.ok());
    const Vec3 expected = to_double(body->center_of_mass) - Vec3{0, 0, product.height_m() / 2};
    const Vec3 off = whole_of(rows[i].pack).middle - expected;
    EXPECT_LT(length(off), 0.008) << product.sku;
    if (length(off) >= 0.003) ++far;
    if (expected.z < -0.02) ++low;
  }
  EXPECT_LE(far, rows.size() / 20 / 10);
  EXPECT_GT(low, 5U);  // pouches
}

TEST(SoftPack, AreTheBagsAndPouchesWithASeam) {
  std::map<std::string, int> of_archetype;
  for (const SoftRow& row : soft_rows())
    ++of_archetype[row.product->archetype];
  const std::map<std::string, int> expected{{"flow_pack", 4},
                                            {"loaf", 46},
                                            {"net_bag", 21},
                                            {"pillow_bag", 298},
                                            {"pouch", 161},
                                            {"sachet", 48},
                                            {"vacuum_pack", 32}};
  EXPECT_EQ(of_archetype, expected);
  EXPECT_FALSE(physics::may_be_soft_pack(hand_made_product("can", "can", {66, 66, 115}, 0.35)));
}

// The flap is where the seal is, and no thicker than it, or 3 mm.
TEST(SoftPack, PutsTheFlapOnTheSeam) {
  const SoftRow& pouch = soft_row("snacks-almonds-natural-500g");  // 150 x 65 x 215 mm
  const physics::SoftPart& flap = pouch.pack.parts[2];
  EXPECT_NEAR(flap.center.z + flap.half_size.z, 0.1075, 1e-6);
  EXPECT_NEAR(flap.half_size.z, 0.010, 1e-6);
  EXPECT_NEAR(flap.half_size.y, 0.0015, 1e-6);
  EXPECT_NEAR(flap.half_size.x, 0.074, 1e-6);
  EXPECT_NEAR(pouch.pack.hinges[1].at.z, 0.1075 - 0.020, 1e-6);
  EXPECT_EQ(pouch.pack.hinges[1].axis.x, 1);
}

// The known answer of the spring: a quarter of a radian with the heavier half level in the air.
TEST(SoftPack, SagsByFourteenDegrees) {
  for (const SoftRow& row : soft_rows()) {
    const physics::SoftHinge& hinge = row.pack.hinges[0];
    double moment = 0;
    for (int half = 0; half < 2; ++half) {
      const physics::SoftPart& part = row.pack.parts[static_cast<std::size_t>(half)];
      moment = std::max(moment, part.mass_kg * 9.81 * length(part.center - hinge.at));
    }
    EXPECT_NEAR(moment / hinge.stiffness_n_m, 0.25, 1e-9) << row.product->sku;
  }
}

TEST(SoftPack, RefusesARowWithoutMassOrSize) {
  catalog::Product pouch = *soft_row("snacks-almonds-natural-500g").product;
  catalog::Product light = pouch, flat = pouch, odd = pouch;
  light.mass_kg = 0;
  flat.size_mm[1] = 0;
  odd.label.primary = "no colour";
  EXPECT_EQ(physics::soft_pack_of(light).error().code, "catalog.bad_row");
  EXPECT_EQ(physics::soft_pack_of(light).error().where, pouch.sku);
  EXPECT_EQ(physics::soft_pack_of(flat).error().code, "catalog.bad_row");
  EXPECT_FALSE(physics::soft_pack_of(odd).ok());
  pouch.rigidity = catalog::Rigidity::rigid;
  ASSERT_TRUE(physics::soft_pack_of(pouch).ok());
  EXPECT_FALSE(physics::soft_pack_of(pouch)->has_value());
}

}  // namespace
}  // namespace marketgen
