// Grasp candidates, judged by what did not make them: known shapes, and rays against the packs' own
// meshes.
#include "motion/grasp_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/rotation_axes.h"
#include "motion/grasp_seeds.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

robots::GraspTool tool_called(const std::string& id) {
  auto tool = robots::load_grasp_tool(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", id);
  if (!tool.ok()) fatal(to_string(tool.error()).c_str());
  return std::move(tool).value();
}

// One primitive of one density.
struct Pack {
  catalog::Product product;
  assets::ProductBody body;
};
Pack pack_of(assets::PieceShape shape, Vec3f half, double mass_kg) {
  Pack pack;
  pack.product.sku = "test-pack";
  pack.product.mass_kg = mass_kg;
  pack.body.center_of_mass = {0, 0, half.z};
  pack.body.pieces.push_back({.shape = shape, .center = {0, 0, half.z}, .half_size = half});
  return pack;
}
Pack can_of(float radius_m, float height_m, double mass_kg = 0.35) {
  return pack_of(assets::PieceShape::cylinder, {radius_m, radius_m, height_m / 2}, mass_kg);
}

motion::GraspCandidates found(const Pack& pack,
                              const robots::GraspTool& tool,
                              const motion::GraspQuery& query = {}) {
  auto answer = motion::grasp_candidates(pack.product, pack.body, tool, query);
  if (!answer.ok()) fatal(to_string(answer.error()).c_str());
  return std::move(answer).value();
}

Vec3 pad_middle(const robots::GraspTool& tool, const motion::GraspCandidate& candidate) {
  return candidate.grasp.product_from_tool * tool.pad_center;
}
Vec3 axis_of(const motion::GraspCandidate& candidate, Vec3 axis) {
  return rotate(candidate.grasp.product_from_tool.rotation, axis);
}

// Whoever grips a can from the side has its diameter between the pads, and its axis in the middle.
TEST(GraspCandidates, ACanIsPinchedAcrossItsDiameter) {
  const robots::GraspTool hand = tool_called("panda-hand");
  const motion::GraspCandidates answer = found(can_of(0.033F, 0.115F), hand);
  ASSERT_FALSE(answer.found.empty());
  for (const motion::GraspCandidate& candidate : answer.found) {
    EXPECT_NEAR(candidate.width_m, 0.066, 1e-4);
    EXPECT_NEAR(candidate.grasp.opening_m, 0.076, 1e-4);
    const Vec3 middle = pad_middle(hand, candidate), closing = axis_of(candidate, {0, 1, 0});
    EXPECT_NEAR(dot(middle, closing), 0, 1e-4);
    EXPECT_NEAR(closing.z, 0, 1e-9);
    EXPECT_EQ(candidate.grasp.force_n, 70);
    EXPECT_GE(candidate.clearance_m, 0.002);
  }
}

TEST(GraspCandidates, WhatIsTooWideSaysSo) {
  const motion::GraspCandidates answer = found(can_of(0.045F, 0.115F), tool_called("panda-hand"));
  EXPECT_TRUE(answer.found.empty());
  EXPECT_EQ(answer.refusal, motion::GraspRefusal::too_wide);
  EXPECT_NE(answer.reason.find("90 mm"), std::string::npos) << answer.reason;
  EXPECT_FALSE(found(can_of(0.039F, 0.115F), tool_called("parallel-gripper")).found.empty());
}

TEST(GraspCandidates, WhatIsTooHeavySaysSo) {
  const robots::GraspTool gripper = tool_called("parallel-gripper");
  EXPECT_EQ(found(can_of(0.033F, 0.115F, 1.5), gripper).refusal, motion::GraspRefusal::too_heavy);
  motion::GraspQuery greasy;
  greasy.friction = 0.05;  // 60 N hold 0.23 kg, moved and with a margin
  EXPECT_EQ(found(can_of(0.033F, 0.115F, 0.35), gripper, greasy).refusal,
            motion::GraspRefusal::too_heavy);
}

TEST(GraspCandidates, NoMassIsAnError) {
  const Pack pack = can_of(0.033F, 0.115F, 0);
  const auto answer =
      motion::grasp_candidates(pack.product, pack.body, tool_called("panda-hand"), {});
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.error().code, "catalog.bad_row");
}

TEST(GraspCandidates, APackNowhereIsAnError) {
  const Pack pack = can_of(0.033F, 0.115F);
  const auto code = [&](const motion::GraspQuery& query) {
    const auto answer =
        motion::grasp_candidates(pack.product, pack.body, tool_called("panda-hand"), query);
    return answer.ok() ? std::string() : answer.error().code;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  motion::GraspQuery lying, near, walled;
  lying.world_from_product.rotation.w = nan;
  near.likes = {{{nan, 0, 0}, {}}};
  walled.walls = {{{}, {0.1, nan, 0.1}}};
  EXPECT_EQ(code(lying), "motion.bad_configuration");
  EXPECT_EQ(code(near), "motion.bad_configuration");
  EXPECT_EQ(code(walled), "motion.bad_configuration");
}

// Walls that lean by 40 degrees squeeze out of pads at friction 0.5 (27 degrees).
TEST(GraspCandidates, ASteepWedgeIsNotHeld) {
  Pack pack = can_of(0.03F, 0.06F);
  assets::ContactPiece& wedge = pack.body.pieces[0];
  wedge.shape = assets::PieceShape::hull;
  wedge.points.clear();
  for (const float side : {-1.0F, 1.0F}) {
    for (const float x : {-0.09F, 0.09F})
      wedge.points.push_back({x, side * 0.035F, 0});
    for (const float x : {-0.04F, 0.04F})
      wedge.points.push_back({x * 0.9F, side * 0.001F, 0.04F});
  }
  EXPECT_TRUE(found(pack, tool_called("panda-hand")).found.empty());
}

// A flat front takes the 35 mm cup; a 66 mm can is 5 mm deep under it; a can lid is flat.
TEST(GraspCandidates, CupsWantEvenFaces) {
  const robots::GraspTool cup = tool_called("suction-cup");
  const auto box = found(pack_of(assets::PieceShape::box, {0.09F, 0.03F, 0.12F}, 0.4), cup);
  ASSERT_FALSE(box.found.empty());
  const bool front = std::ranges::any_of(box.found, [](const motion::GraspCandidate& c) {
    return c.strategy == motion::GraspStrategy::suction_front;
  });
  EXPECT_TRUE(front);
  const auto can = found(can_of(0.033F, 0.115F), cup);
  ASSERT_FALSE(can.found.empty());
  for (const motion::GraspCandidate& candidate : can.found)
    EXPECT_EQ(candidate.strategy, motion::GraspStrategy::suction_top);
  motion::GraspQuery shelf;
  shelf.from_front = true;
  EXPECT_EQ(found(can_of(0.033F, 0.115F), cup, shelf).refusal, motion::GraspRefusal::no_seal);
}

// Against loads from all sides: three places of the lip hold a third of the pull each.
TEST(GraspCandidates, ACupsSwingIsThePullThatItNeedsWhicheverWayUp) {
  const robots::GraspTool cup = tool_called("suction-cup");
  const Pack box = pack_of(assets::PieceShape::box, {0.05F, 0.02F, 0.08F}, 0.15);
  const motion::GraspCandidates answer = found(box, cup);
  ASSERT_GT(answer.found.size(), 1U);
  for (const motion::GraspCandidate& candidate : answer.found) {
    const Vec3 at = candidate.grasp.product_from_tool.position,
               ahead = axis_of(candidate, {0, 0, 1});
    const double load_n = motion::turn_safety * 0.15 * (9.81 + motion::carry_acceleration_m_s2);
    double most = 0;
    for (int turn = 0; turn < 72; ++turn) {
      for (int lean = 0; lean <= 36; ++lean) {
        const double a = turn * std::numbers::pi / 36, b = lean * std::numbers::pi / 36;
        const Vec3 load =
            Vec3{std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)} * load_n;
        const Vec3 moment = cross(to_double(box.body.center_of_mass) - at, load);
        const double peel = length(moment - ahead * dot(moment, ahead));
        most = std::max(most, dot(load, ahead) + 2 * peel / cup.cup_radius_m);
      }
    }
    EXPECT_LE(most, candidate.swing_n * 1.001);
    EXPECT_GE(most, candidate.swing_n * 0.98);
  }
}

TEST(GraspCandidates, NoCupSealsOverARingPull) {
  Pack can = can_of(0.033F, 0.115F);
  can.body.features.push_back(
      {assets::FeatureKind::tab, {0, -0.004F, 0.114F}, {0.006F, 0.01F, 0.001F}});
  EXPECT_EQ(found(can, tool_called("suction-cup")).refusal, motion::GraspRefusal::no_seal);
}

TEST(GraspCandidates, WhatHangsTooHeavyOnACupSaysSo) {  // 25 N do not lift 1.4 kg by a box's front
  const auto box = found(pack_of(assets::PieceShape::box, {0.09F, 0.06F, 0.12F}, 1.4),
                         tool_called("suction-cup"));
  EXPECT_TRUE(box.found.empty());
  EXPECT_EQ(box.refusal, motion::GraspRefusal::too_heavy);
  EXPECT_FALSE(box.reason.empty());
}

TEST(GraspCandidates, TheFrontIsWhereTheShopperStands) {
  motion::GraspQuery shelf;
  shelf.from_front = true;
  shelf.ceiling_m = 0.145;
  const auto answer = found(can_of(0.033F, 0.115F), tool_called("panda-hand"), shelf);
  ASSERT_FALSE(answer.found.empty());
  for (const motion::GraspCandidate& candidate : answer.found)
    EXPECT_GE(axis_of(candidate, {0, 0, 1}).y, 0.5);
}

// A can on its side in the middle of the floor, its axis along the world's X; `aside_m` to a wall
// along it on either side.
motion::GraspQuery lying_between_walls(double aside_m) {
  motion::GraspQuery query;
  query.from_above = true;
  query.world_from_product = {{-0.0575, 0, 0.033}, rotation_about({0, 1, 0}, 1.5707963267948966)};
  for (const double side : {1.0, -1.0})
    query.walls.push_back(
        {{{0, side * (0.033 + aside_m + 0.005), 0.075}, {}}, {0.3, 0.005, 0.075}});
  return query;
}

// By corners and middles of the tool's solids, which the search does not look at.
double min_distance_to_walls(const robots::GraspTool& tool,
                             const robots::Grasp& grasp,
                             const motion::GraspQuery& query) {
  std::vector<robots::ToolSolid> solids = robots::opened(tool, grasp.opening_m);
  solids.insert(solids.end(), tool.body.begin(), tool.body.end());
  double least = 1;
  for (const robots::ToolSolid& solid : solids) {
    const Pose at = query.world_from_product * grasp.product_from_tool * solid.tool_from_solid;
    for (int i = 0; i < 27; ++i) {
      const Vec3 share{i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0};
      const Vec3 point = at * (share * solid.half_size);
      least = std::min(least, point.z);
      for (const motion::GraspObstacle& wall : query.walls) {
        const Vec3 p = inverse(wall.world_from_box) * point;
        const auto out = [](double x, double half) { return std::max(0.0, std::abs(x) - half); };
        least = std::min(least,
                         length(Vec3{out(p.x, wall.half_size.x),
                                     out(p.y, wall.half_size.y),
                                     out(p.z, wall.half_size.z)}));
      }
    }
  }
  return least;
}

TEST(GraspCandidates, ALyingCanIsTakenFromAboveClearOfWalls) {
  const Pack can = can_of(0.033F, 0.115F);
  for (const char* id : {"panda-hand", "parallel-gripper"}) {
    const robots::GraspTool tool = tool_called(id);
    for (const double aside : {0.15, 0.08}) {
      const motion::GraspQuery query = lying_between_walls(aside);
      const motion::GraspCandidates answer = found(can, tool, query);
      ASSERT_FALSE(answer.found.empty()) << id << aside << answer.reason;
      for (const motion::GraspCandidate& candidate : answer.found) {
        const Vec3 approach =
            rotate(query.world_from_product.rotation, axis_of(candidate, {0, 0, 1}));
        EXPECT_LE(approach.z, -0.4226);
        EXPECT_GE(min_distance_to_walls(tool, candidate.grasp, query), 0.002 - 1e-6);
      }
    }
  }
}

TEST(GraspCandidates, BetweenNearWallsThereIsNoRoom) {
  const Pack can = can_of(0.033F, 0.115F);
  motion::GraspQuery query = lying_between_walls(0.004);  // a finger is thicker
  for (const double side : {1.0, -1.0})
    query.walls.push_back({{{side * 0.0665, 0, 0.075}, {}}, {0.005, 0.3, 0.075}});
  const motion::GraspCandidates answer = found(can, tool_called("panda-hand"), query);
  EXPECT_TRUE(answer.found.empty());
  EXPECT_EQ(answer.refusal, motion::GraspRefusal::no_room);
  EXPECT_NE(answer.reason.find("walls"), std::string::npos);
}

// Likes give way by 8 mm: fingers fit beside one that lies a finger's width off, not beside one
// that touches.
TEST(GraspCandidates, LikesThatLieCloseLeaveNoRoom) {
  const Pack can = can_of(0.033F, 0.115F);
  const robots::GraspTool tool = tool_called("parallel-gripper");
  motion::GraspQuery query = lying_between_walls(0.3);
  const auto add_likes = [&](double gap) {
    query.likes.clear();
    for (const double side : {1.0, -1.0}) {
      Pose like = query.world_from_product;
      like.position.y = side * (0.066 + gap);
      query.likes.push_back(like);
      like.position.y = 0;
      like.position.x += side * (0.115 + gap);
      query.likes.push_back(like);
    }
  };
  add_likes(0.06);
  EXPECT_FALSE(found(can, tool, query).found.empty());
  add_likes(0.001);
  EXPECT_EQ(found(can, tool, query).refusal, motion::GraspRefusal::no_room);
}

TEST(GraspCandidates, AxesMakeTheirRotation) {
  for (const Vec3 z :
       {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0.6, 0, -0.8}}) {
    const Vec3 y = normalized(cross(z, std::abs(z.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}));
    const Quaternion q = rotation_with_axes(y, z);
    EXPECT_NEAR(length(rotate(q, {0, 0, 1}) - z), 0, 1e-12);
    EXPECT_NEAR(length(rotate(q, {0, 1, 0}) - y), 0, 1e-12);
  }
}

// ---- Against the meshes that are drawn ----

// First triangle that the ray meets (Moeller and Trumbore 1997).
struct MeshHit {
  double distance = 1e9;
  Vec3 normal;
};
MeshHit first_of_mesh(const Mesh& mesh, Vec3 origin, Vec3 direction) {
  MeshHit first;
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Vec3 a = to_double(mesh.positions[ia]);
    const Vec3 ab = to_double(mesh.positions[ib]) - a, ac = to_double(mesh.positions[ic]) - a;
    const Vec3 p = cross(direction, ac);
    const double det = dot(ab, p);
    if (std::abs(det) < 1e-15) continue;
    const Vec3 t = origin - a;
    const double u = dot(t, p) / det, v = dot(direction, cross(t, ab)) / det;
    if (u < 0 || v < 0 || u + v > 1) continue;
    const double at = dot(ac, cross(t, ab)) / det;
    if (at > 0 && at < first.distance) first = {at, normalized(cross(ab, ac))};
  }
  return first;
}

// Where a pad that comes along `way` onto the mesh would stop, and the normal there that faces it
// best.
struct MeshPad {
  double stop = 1e9, cosine = -1;
};
MeshPad pad_on_mesh(const Mesh& mesh,
                    const robots::GraspTool& tool,
                    const motion::GraspCandidate& c,
                    double side) {
  const Vec3 way = axis_of(c, {0, -side, 0});
  MeshPad pad;
  std::vector<MeshHit> hits;
  for (int i = -3; i <= 3; ++i) {
    for (int k = -3; k <= 3; ++k) {
      const Vec3 on_pad{
          tool.pad_x_m * i / 3, side * 0.04, tool.pad_center.z + tool.pad_z_m * k / 3};
      hits.push_back(first_of_mesh(mesh, c.grasp.product_from_tool * on_pad, way));
      pad.stop = std::min(pad.stop, hits.back().distance);
    }
  }
  for (const MeshHit& hit : hits) {
    if (hit.distance < pad.stop + 0.003) pad.cosine = std::max(pad.cosine, -dot(hit.normal, way));
  }
  pad.stop = 0.04 - pad.stop;
  return pad;
}

// Rigid goods of each of ten shapes: on the drawn mesh the pads stop as far apart as the candidate
// says, up to the tolerance of the contact pieces, on faces that look at them within the friction
// cone.
TEST(GraspCandidates, PadsMeetTheDrawnPackFaceToFace) {
  const robots::GraspTool hand = tool_called("panda-hand");
  constexpr double pieces_m = 0.005, friction = 0.5;
  const double cone = 1 / std::sqrt(1 + friction * friction);
  int judged = 0;
  for (const char* shape : {"can",
                            "food_tin",
                            "box",
                            "jar",
                            "water_bottle",
                            "wine_bottle",
                            "aerosol",
                            "yogurt_cup",
                            "apple",
                            "tube"}) {
    int packs = 0;
    for (const catalog::Product& product : committed_catalog().products) {
      if (product.archetype != shape || packs == 2) continue;
      ++packs;
      const auto model = assets::make_product_model(product);
      const auto body = assets::make_product_body(product);
      ASSERT_TRUE(model.ok() && body.ok()) << product.sku;
      motion::GraspQuery best;
      best.most = 3;
      const auto answer = motion::grasp_candidates(product, *body, hand, best);
      ASSERT_TRUE(answer.ok()) << to_string(answer.error());
      for (const motion::GraspCandidate& candidate : answer->found) {
        const MeshPad left = pad_on_mesh(model->mesh, hand, candidate, 1);
        const MeshPad right = pad_on_mesh(model->mesh, hand, candidate, -1);
        ++judged;
        EXPECT_NEAR(left.stop + right.stop, candidate.width_m, pieces_m) << product.sku;
        EXPECT_GE(std::min(left.cosine, right.cosine), cone - 0.05) << product.sku;
        EXPECT_LE(candidate.width_m, hand.opening_m) << product.sku;
        EXPECT_LE(candidate.grasp.opening_m, hand.opening_m) << product.sku;
      }
    }
  }
  EXPECT_GE(judged, 30);
}

}  // namespace
}  // namespace marketgen
