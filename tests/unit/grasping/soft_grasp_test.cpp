// Bags in a gripper: their pieces cut where they bend, and slip counted on the part that is held.
#include <algorithm>
#include <numbers>

#include "grasping/grasp_trial.h"
#include "physics/soft/soft_pieces.h"
#include "unit/physics/soft_packs.h"

namespace marketgen {
namespace {

constexpr char peas[] = "snacks-wasabi-peas-125g";  // a pouch with its seam on top

struct Extremes {
  double low = 1e9, high = -1e9;
};

Extremes heights(const std::vector<physics::PieceCorners>& pieces) {
  Extremes found;
  for (const physics::PieceCorners& piece : pieces) {
    for (const Vec3& corner : piece)
      found.low = std::min(found.low, corner.z), found.high = std::max(found.high, corner.z);
  }
  return found;
}

TEST(SoftPieces, ABoxIsCutAtBothHinges) {
  assets::ProductBody body;
  body.pieces.push_back({.center = {0, 0, 0.15F}, .half_size = {0.1F, 0.05F, 0.15F}});
  const auto parts = physics::cut_at_hinges(body, physics::plain_soft_pack(), {0, 0, 0.15});
  const Extremes base = heights(parts[0]), top = heights(parts[1]), flap = heights(parts[2]);
  EXPECT_NEAR(base.low, -0.15, 1e-6);
  EXPECT_NEAR(base.high, -0.01, 1e-6);
  EXPECT_NEAR(top.low, -0.01, 1e-6);
  EXPECT_NEAR(top.high, 0.13, 1e-6);
  EXPECT_NEAR(flap.low, 0.13, 1e-6);
  EXPECT_NEAR(flap.high, 0.15, 1e-6);
}

TEST(SoftPieces, APieceInOnePartIsInNoOther) {
  assets::ProductBody body;
  body.pieces.push_back({.center = {0, 0, 0.05F}, .half_size = {0.1F, 0.05F, 0.05F}});
  const auto parts = physics::cut_at_hinges(body, physics::plain_soft_pack(), {0, 0, 0.15});
  EXPECT_EQ(parts[0].size(), 1U);
  EXPECT_TRUE(parts[1].empty());
  EXPECT_TRUE(parts[2].empty());
}

Extremes heights(const assets::ProductBody& body, double middle_z) {
  Extremes found;
  const auto take_in = [&](double z) {
    found.low = std::min(found.low, z - middle_z), found.high = std::max(found.high, z - middle_z);
  };
  for (const assets::ContactPiece& piece : body.pieces) {
    for (const Vec3f& point : piece.points)
      take_in(point.z);
    if (piece.shape != assets::PieceShape::box) continue;
    take_in(piece.center.z - piece.half_size.z), take_in(piece.center.z + piece.half_size.z);
  }
  return found;
}

// One in twenty.
TEST(SoftPieces, NoPackOfTheCatalogueLosesItsFootOrItsTop) {
  constexpr std::size_t one_in = 20;
  constexpr double left_out_m = 0.0011;
  for (std::size_t i = 0; i < soft_rows().size(); i += one_in) {
    const SoftRow& row = soft_rows()[i];
    const assets::ProductBody body = assets::make_product_body(*row.product).value();
    const Vec3 middle = to_double(assets::collision_of(*row.product).value().center);
    Extremes cut;
    for (const auto& pieces : physics::cut_at_hinges(body, row.pack, middle)) {
      const Extremes part = heights(pieces);
      cut = {std::min(cut.low, part.low), std::max(cut.high, part.high)};
    }
    const Extremes whole = heights(body, middle.z);
    EXPECT_NEAR(cut.low, whole.low, left_out_m) << row.product->sku;
    EXPECT_NEAR(cut.high, whole.high, left_out_m) << row.product->sku;
  }
}

TEST(SoftPieces, PartsAreWhereTheHingesPutThem) {
  const physics::SoftPack pack = physics::plain_soft_pack();
  EXPECT_EQ(physics::part_at(pack, {0, 0, -0.1}), 0);
  EXPECT_EQ(physics::part_at(pack, {0, 0, 0.1}), 1);
  EXPECT_EQ(physics::part_at(pack, {0, 0, 0.14}), 2);
  const double right = std::numbers::pi / 2;
  // 4 cm above the hinge at -1 cm: turned about X it lies 4 cm towards -Y of the hinge.
  const Vec3 bent = physics::bent_part(pack, 1, {right, 0}) * Vec3{0, 0, 0.03};
  EXPECT_NEAR(bent.y, -0.04, 1e-12);
  EXPECT_NEAR(bent.z, -0.01, 1e-12);
  const Vec3 back =
      physics::bent_part(pack, 2, {right, -right}) * Vec3{0, 0, 0.14};  // the flap upright
  EXPECT_NEAR(back.y, -0.14, 1e-12);
  EXPECT_NEAR(back.z, 0, 1e-12);
}

robots::GraspTool hand() {
  return robots::load_grasp_tool(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", "panda-hand")
      .value();
}

// From above, closing from front and back, with the pads' middle so far below the pack's top.
grasping::GraspOutcome pinched_from_above(double below_top_m, double friction) {
  const SoftRow& row = soft_row(peas);
  const robots::GraspTool tool = hand();
  const physics::SharedGoodsBody goods =
      physics::goods_body(*row.product, physics::GoodsUse::single).value();
  const Quaternion down = rotation_about({1, 0, 0}, std::numbers::pi);
  const Vec3 at = Vec3{0, 0, row.product->height_m() - below_top_m} - rotate(down, tool.pad_center);
  grasping::GraspTrial trial{*goods, tool, {{at, down}, tool.opening_m, 30}, friction};
  trial.soft = &row.pack;
  return grasping::try_grasp(trial).value();
}

TEST(SoftGrasps, APouchIsCarriedBelowItsSeamAndStandsAgain) {
  const grasping::GraspOutcome outcome = pinched_from_above(0.02, 0.6);
  EXPECT_EQ(name_of(outcome.end), "held") << outcome.slip_m;
  EXPECT_LT(outcome.slip_m, grasping::max_slip_m);
}

// The bag below swings by more than that.
TEST(SoftGrasps, HeldByItsFlapItsSlipIsTheFlaps) {
  const grasping::GraspOutcome outcome = pinched_from_above(0.006, 0.6);
  EXPECT_NE(name_of(outcome.end), "dropped");
  EXPECT_LT(outcome.slip_m, 0.002);
}

TEST(SoftGrasps, WithoutFrictionItComesOut) {
  EXPECT_EQ(name_of(pinched_from_above(0.006, 0.01).end), "dropped");
}

TEST(SoftGrasps, AboveItsFlapThereIsNothingToHold) {
  EXPECT_EQ(name_of(pinched_from_above(-0.03, 0.6).end), "missed");
}

TEST(SoftGrasps, ItStandsByItselfAndACupIsNotForIt) {
  const SoftRow& row = soft_row(peas);
  const physics::SharedGoodsBody goods =
      physics::goods_body(*row.product, physics::GoodsUse::single).value();
  EXPECT_TRUE(grasping::stands_alone(*goods, hand(), &row.pack).value());
  const robots::GraspTool cup =
      robots::load_grasp_tool(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", "suction-cup")
          .value();
  grasping::GraspTrial trial{*goods, cup, {{}, 0, cup.force_n}};
  trial.soft = &row.pack;
  EXPECT_EQ(grasping::try_grasp(trial).error().code, "motion.bad_configuration");
}

}  // namespace
}  // namespace marketgen
