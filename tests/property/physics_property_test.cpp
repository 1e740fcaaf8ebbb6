// Goods of random rows in physics: bodies that can exist, packs that stand where they are put,
// falls that win no energy, walls and boards that nothing passes; and the grid of what is near,
// against looking at every box.
//
// What a World repeats bit for bit, tests/unit/physics/world_repeat_test.cpp has.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/gravity.h"
#include "base/seed.h"
#include "geometry/box_extents.h"
#include "physics/goods/goods_body.h"
#include "physics/goods/product_bodies.h"
#include "physics/goods/spec_geoms.h"
#include "physics/settle/bulk_model.h"
#include "physics/world/product_grid.h"
#include "physics/world/world.h"
#include "scene/placements.h"
#include "scene/shelf_fill.h"
#include "support/committed_catalog.h"
#include "support/hand_made_scene.h"
#include "support/number_of_cases.h"

namespace marketgen {
namespace {

Stream physics_stream(const char* name, std::size_t number) {
  return Seed(23).child(name, number).stream();
}

Quaternion random_turn(Stream& draw) {
  Quaternion turn;
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    turn = turn * rotation_about(axis, draw.uniform(-std::numbers::pi, std::numbers::pi));
  return turn;
}

const catalog::Product& random_row(Stream& draw) {
  const std::vector<catalog::Product>& rows = committed_catalog().products;
  return rows[static_cast<std::size_t>(draw.integer(0, static_cast<int>(rows.size()) - 1))];
}

// ---- Bodies ----

// The least of the main moments, and how far the greatest falls short of the two others' sum; of a
// body that can exist neither is negative. By the roots of the characteristic cubic.
struct MainMoments {
  double least = 0, spare = 0;
};
MainMoments main_moments(const std::array<float, 6>& inertia) {
  mjtNum full[9], roots[3], axes[9], turn[4];
  const std::array<int, 9> entry{0, 3, 4, 3, 1, 5, 4, 5, 2};
  for (std::size_t i = 0; i < entry.size(); ++i)
    full[i] = static_cast<mjtNum>(inertia[static_cast<std::size_t>(entry[i])]);
  mju_eig3(roots, axes, turn, full);
  std::sort(roots, roots + 3);
  return {roots[0], roots[0] + roots[1] - roots[2]};
}

physics::Box3 extent_of(const assets::ProductBody& body) {
  physics::Box3 extent{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  const auto add = [&](Vec3f p) {
    const auto& [x, y, z] = to_double(p);
    extent.low = {std::min(extent.low.x, x), std::min(extent.low.y, y), std::min(extent.low.z, z)};
    extent.high = {
        std::max(extent.high.x, x), std::max(extent.high.y, y), std::max(extent.high.z, z)};
  };
  for (const assets::ContactPiece& piece : body.pieces) {
    for (const Vec3f& point : piece.points)
      add(point);
    if (piece.shape == assets::PieceShape::hull) continue;
    const auto& [x, y, z] = piece.half_size;
    const Vec3f half = piece.lying ? Vec3f{z, y, x} : piece.half_size;
    add(piece.center - half);
    add(piece.center + half);
  }
  return extent;
}

void expect_within(double low, double high, double outer_low, double outer_high, double margin) {
  EXPECT_GE(low, outer_low - margin);
  EXPECT_LE(high, outer_high + margin);
}

void expect_can_exist(const catalog::Product& product, physics::GoodsUse use) {
  const auto goods = physics::goods_body(product, use);
  ASSERT_TRUE(goods.ok()) << to_string(goods.error());
  const assets::ProductBody& body = (*goods)->body;
  const MainMoments moments = main_moments(body.inertia_kg_m2);
  EXPECT_GT(moments.least, 0);
  EXPECT_GE(moments.spare, -1e-5 * moments.least);
  // Pieces in the box of the row: 3 % for those of one's own that bulge between cuts.
  const double w = product.width_m() / 2, d = product.depth_m() / 2, h = product.height_m();
  const double margin = 1e-3 + 0.03 * std::max({w, d, h / 2});
  const physics::Box3 extent = extent_of(body);
  expect_within(extent.low.x, extent.high.x, -w, w, margin);
  expect_within(extent.low.y, extent.high.y, -d, d, margin);
  expect_within(extent.low.z, extent.high.z, 0, h, margin);
  // The middle of mass among the pieces.
  const Vec3 middle = to_double(body.center_of_mass);
  expect_within(middle.x, middle.x, extent.low.x, extent.high.x, 0);
  expect_within(middle.y, middle.y, extent.low.y, extent.high.y, 0);
  expect_within(middle.z, middle.z, extent.low.z, extent.high.z, 0);
}

// All 2,995 rows: MARKETGEN_PROPERTY_GOODS=3000.
TEST(PhysicsProperty, BodiesOfRowsCanExist) {
  const std::vector<catalog::Product>& rows = committed_catalog().products;
  const std::size_t wanted =
      std::min(rows.size(), number_of_cases("MARKETGEN_PROPERTY_GOODS", 150));
  for (std::size_t i = 0; i < wanted; ++i) {
    const catalog::Product& product = rows[i * rows.size() / wanted];
    for (const physics::GoodsUse use : {physics::GoodsUse::stocked, physics::GoodsUse::bulk}) {
      SCOPED_TRACE(product.sku);
      expect_can_exist(product, use);
    }
  }
}

// ---- Goods by themselves on a board of a World ----
//
// Not on its floor: a plane of MuJoCo 4.0.1 finds a cylinder that leans by 1e-15 rad as much as 17
// mm deep in it, and throws it over.

constexpr double pitch_m = 0.65;  // apart: none meets another, standing or fallen

struct Placed {
  scene::Scene scene;
  std::vector<Pose> start;  // of each product
};

constexpr float board_top_m = 0.52F;

// Over most of the room, as a part of the shop's only fixture.
void add_board(scene::Scene& scene) {
  scene::ScenePart board;
  board.position_m = {0, -1.9F, board_top_m - 0.02F};
  board.half_size_m = {2.6F, 1.4F, 0.02F};
  scene.parts.push_back(board);
  ++scene.fixtures[0].part_count;
}

// Goods of random rows, as they stand on a shelf or any way round with their lowest corner in the
// air.
Placed on_board(Stream& draw, bool standing) {
  HandMadeScene shop;
  add_board(shop.scene);
  Placed placed;
  for (double x = 0.9; x < 5.2; x += pitch_m) {
    for (double y = 0.8; y < 2.9; y += pitch_m) {
      const catalog::Product& row = random_row(draw);
      if (std::max({row.size_mm[0], row.size_mm[1], row.size_mm[2]}) > 450) continue;
      const auto sku = static_cast<std::uint32_t>(shop.scene.catalog.size());
      shop.scene.catalog.push_back(row);
      Pose pose{{x, y, board_top_m}, rotation_about({0, 0, 1}, draw.uniform(-3, 3))};
      if (!standing) {
        pose.rotation = random_turn(draw);
        const Vec3 half{row.width_m() / 2, row.depth_m() / 2, row.height_m() / 2};
        const double drop_m = draw.uniform(0.02, 0.3);
        const Vec3 middle{x, y, board_top_m + box_half_extents(pose.rotation, half).z + drop_m};
        pose.position = middle - rotate(pose.rotation, {0, 0, half.z});
      }
      const std::uint32_t product = shop.add(sku, {0, 0, 0});
      shop.scene.products[product].facing = scene::no_facing;
      scene::place(shop.scene.products[product], pose);
      placed.start.push_back(scene::world_from_product(shop.scene.products[product]));
    }
  }
  placed.scene = std::move(shop.scene);
  return placed;
}

physics::World world_of(const scene::Scene& scene) {
  physics::WorldOptions options;
  options.soft_pool = 0;  // rigid, as goods_body() says
  auto world = physics::World::create(scene, std::move(options));
  if (!world.ok()) fatal(to_string(world.error()).c_str());
  return std::move(world).value();
}

double apart(const Pose& a, const Pose& b) {
  return length(a.position - b.position);
}

TEST(PhysicsProperty, WhatStandsOnABoardStaysThere) {
  std::size_t woken = 0;
  const std::size_t boards = number_of_cases("MARKETGEN_PROPERTY_BOARDS", 4);
  for (std::size_t i = 0; i < boards; ++i) {
    Stream draw = physics_stream("standing", i);
    const Placed placed = on_board(draw, true);
    physics::World world = world_of(placed.scene);
    for (std::uint32_t p = 0; p < placed.start.size(); ++p)
      ASSERT_TRUE(world.wake(p).ok());
    ASSERT_TRUE(world.step(1500).ok());
    for (std::uint32_t p = 0; p < placed.start.size(); ++p) {
      ++woken;
      EXPECT_LT(apart(world.product_pose(p), placed.start[p]), 0.005)
          << i << ": " << placed.scene.catalog[placed.scene.products[p].sku].sku;
    }
  }
  EXPECT_GT(woken, 12 * boards);
}

// Of height and motion; J. A body at its pose and motion, alone in the air or on the board.
double energy_of(const assets::ProductBody& body,
                 double mass_kg,
                 const physics::ProductMotion& motion) {
  const Vec3 spin = rotate(inverse(motion.pose.rotation), motion.angular_rad_s);
  const auto& [xx, yy, zz, xy, xz, yz] = body.inertia_kg_m2;
  const Vec3 momentum{xx * spin.x + xy * spin.y + xz * spin.z,
                      xy * spin.x + yy * spin.y + yz * spin.z,
                      xz * spin.x + yz * spin.y + zz * spin.z};
  const double height = (motion.pose * to_double(body.center_of_mass)).z;
  return mass_kg * standard_gravity * height +
         0.5 * mass_kg * dot(motion.velocity_m_s, motion.velocity_m_s) + 0.5 * dot(spin, momentum);
}

// Energy of one product over time, as the height to which it would lift its mass.
struct Fall {
  double start_m = -1, min_m = 0, over_start_m = 0;
  double given_back = 0;  // by a contact, as a share of what was lost until then

  void add(double energy_m) {
    if (start_m < 0) start_m = min_m = energy_m;
    over_start_m = std::max(over_start_m, energy_m - start_m);
    min_m = std::min(min_m, energy_m);
    const double lost_m = start_m - min_m;
    if (lost_m > 0.005) given_back = std::max(given_back, (energy_m - min_m) / lost_m);
  }
};

// A contact is a spring with a damper: it gives a little back of what it took, 3.2 % were measured,
// and never more than there was.
TEST(SlowPhysicsProperty, NoFallWinsEnergy) {
  constexpr double given_back_share = 0.06;
  std::size_t fallen = 0;
  const std::size_t boards = number_of_cases("MARKETGEN_PROPERTY_BOARDS", 4);
  for (std::size_t i = 0; i < boards; ++i) {
    Stream draw = physics_stream("falling", i);
    const Placed placed = on_board(draw, false);
    physics::World world = world_of(placed.scene);
    std::vector<Fall> falls(placed.start.size());
    for (std::uint32_t p = 0; p < placed.start.size(); ++p)
      ASSERT_TRUE(world.wake(p).ok());
    for (int step = 0; step < 750; ++step) {
      ASSERT_TRUE(world.step().ok());
      for (std::uint32_t p = 0; p < placed.start.size(); ++p) {
        const catalog::Product& row = placed.scene.catalog[placed.scene.products[p].sku];
        const assets::ProductBody& body =
            (*physics::goods_body(row, physics::GoodsUse::stocked))->body;
        falls[p].add(energy_of(body, row.mass_kg, world.product_motion(p)) /
                     (row.mass_kg * standard_gravity));
      }
    }
    for (std::uint32_t p = 0; p < placed.start.size(); ++p) {
      ++fallen;
      SCOPED_TRACE(placed.scene.catalog[placed.scene.products[p].sku].sku);
      EXPECT_LE(falls[p].over_start_m, 1e-5) << i;
      EXPECT_LT(falls[p].given_back, given_back_share) << i;
    }
  }
  EXPECT_GT(fallen, 12 * boards);
}

// ---- Goods in a basket ----

constexpr double to_clear_rim_m = 0.02;

// Let go one after another over a basket, at up to 3 m/s down: as if from half a metre.
struct Basket {
  physics::MujocoModel model{nullptr, mj_deleteModel};
  physics::MujocoData data{nullptr, mj_deleteData};
};
Basket basket_with(const std::vector<physics::SharedGoodsBody>& items, Stream& draw) {
  const physics::MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
  physics::set_contact_options(*spec, 0);
  spec->option.enableflags &= ~mjENBL_SLEEP;
  spec->compiler.balanceinertia = 1;
  physics::add_container(mjs_findBody(spec.get(), "world"), physics::checkout_basket);
  physics::ProductBodies bodies(*spec);
  double over = physics::checkout_basket.height_m + to_clear_rim_m;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Quaternion turn = random_turn(draw);
    const Vec3 half = physics::turned_half_extents(items[i]->product, turn);
    const Vec3 middle{draw.uniform(-0.05, 0.05), draw.uniform(-0.1, 0.1), over + half.z};
    over += 2 * half.z + to_clear_rim_m;
    const Vec3 up = rotate(turn, {0, 0, items[i]->product.height_m() / 2});
    bodies.add("item" + std::to_string(i), *items[i], {middle - up, turn});
  }
  Basket basket;
  basket.model = std::move(physics::compile(*spec, "test")).value();
  basket.data = std::move(physics::make_data(*basket.model, "test")).value();
  for (int joint = 0; joint < basket.model->njnt; ++joint)
    basket.data->qvel[basket.model->jnt_dofadr[joint] + 2] = -draw.uniform(0, 3);
  return basket;
}

// Where a middle of mass is under the floor or in a wall; "" where it may be.
std::string passed(Vec3 p) {
  if (p.z < 0) return "under the floor";
  if (p.z > physics::checkout_basket.height_m) return "";
  const double x = std::abs(p.x) - physics::checkout_basket.top_x_m / 2;
  const double y = std::abs(p.y) - physics::checkout_basket.top_y_m / 2;
  const double through = std::max(x, y);
  return through > 0 && through < physics::checkout_basket.wall_m ? "in a wall" : "";
}

TEST(PhysicsProperty, NothingPassesTheFloorOrTheWallsOfABasket) {
  const std::size_t baskets = number_of_cases("MARKETGEN_PROPERTY_BASKETS", 8);
  std::size_t inside = 0, dropped = 0;
  for (std::size_t i = 0; i < baskets; ++i) {
    Stream draw = physics_stream("basket", i);
    std::vector<physics::SharedGoodsBody> items;
    while (items.size() < 6) {
      const catalog::Product& row = random_row(draw);
      // What weighs less may be pressed into the floor by what falls on it (a toothbrush by 6 mm):
      // not mended yet.
      constexpr double min_kg = 0.03;
      if (row.mass_kg >= min_kg && physics::fits_in(physics::checkout_basket, row))
        items.push_back(physics::goods_body(row, physics::GoodsUse::bulk).value());
    }
    const Basket basket = basket_with(items, draw);
    for (int step = 0; step < 1000; ++step) {
      mj_step(basket.model.get(), basket.data.get());
      for (std::size_t k = 0; k < items.size(); ++k) {
        const mjtNum* at = basket.data->xipos + 3 * (k + 1);
        ASSERT_EQ(passed({at[0], at[1], at[2]}), "")
            << i << ": " << items[k]->product.sku << " at step " << step << ": " << at[0] << " "
            << at[1] << " " << at[2];
      }
    }
    for (std::size_t k = 0; k < items.size(); ++k) {
      const mjtNum* at = basket.data->xipos + 3 * (k + 1);
      ++dropped;
      inside += std::abs(at[0]) < physics::checkout_basket.top_x_m / 2 &&
                        std::abs(at[1]) < physics::checkout_basket.top_y_m / 2
                    ? 1
                    : 0;
    }
  }
  EXPECT_GT(2 * inside, dropped) << "the others fell over the rim";
}

// ---- What is near ----

physics::Box3 random_box(Stream& draw) {
  const Vec3 low{draw.uniform(-3, 3), draw.uniform(-3, 3), draw.uniform(0, 2)};
  const double size = std::exp(draw.uniform(-6, 0.5));
  return {low, low + Vec3{draw.uniform(0, size), draw.uniform(0, size), draw.uniform(0, size)}};
}

TEST(PhysicsProperty, TheGridFindsWhatLookingAtEveryBoxFinds) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    Stream draw = physics_stream("grid", i);
    constexpr std::uint32_t products = 300;
    physics::ProductGrid grid(products);
    std::vector<std::optional<physics::Box3>> boxes(products);
    for (int turn = 0; turn < 1500; ++turn) {
      const auto product = static_cast<std::uint32_t>(draw.integer(0, products - 1));
      boxes[product].reset();
      if (draw.chance(0.8)) {
        boxes[product] = random_box(draw);
        grid.put(product, *boxes[product]);
      } else {
        grid.remove(product);
      }
      if (turn % 10 != 0) continue;
      const physics::Box3 asked = random_box(draw);
      const double within = draw.chance(0.3) ? 0 : draw.uniform(0, 0.5);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t p = 0; p < products; ++p)
        if (boxes[p] && boxes[p]->meets(asked, within)) expected.push_back(p);
      found += expected.size();
      EXPECT_EQ(grid.near(asked, within), expected);
    }
  }
  EXPECT_GT(found, 3000U);
}

}  // namespace
}  // namespace marketgen
