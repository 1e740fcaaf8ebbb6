// The map that an agent is given: fixtures stand elsewhere on it, and the store stays as it is.
#include "episodes/aisle/mapped_store.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "episodes/aisle/aisle_senses.h"
#include "support/realistic_worlds.h"

namespace marketgen {
namespace {

episodes::Realism with_map(double place_m) {
  episodes::Realism realism;
  realism.map.place_m = place_m;
  return realism;
}

// The same shelf again, `east_m` of the first.
void add_again(scene::Scene& scene, float east_m, const layout::Fixture& called) {
  scene::SceneFixture fixture = scene.fixtures[0];
  layout::Fixture row = scene.layout.fixtures[0];
  row.id = called.id, row.run = called.run, row.endcap_of = called.endcap_of;
  row.x_mm += static_cast<int>(1e3F * east_m);
  fixture.position_m[0] += east_m;
  const auto number = static_cast<std::uint32_t>(scene.fixtures.size());
  const std::uint32_t first = fixture.first_part;
  fixture.first_part = static_cast<std::uint32_t>(scene.parts.size());
  fixture.first_shelf = static_cast<std::uint32_t>(scene.shelves.size());
  fixture.shelf_count = 0;
  for (std::uint32_t part = first; part < first + fixture.part_count; ++part) {
    scene.parts.push_back(scene.parts[part]);
    scene.parts.back().fixture = number;
  }
  scene.fixtures.push_back(fixture);
  scene.layout.fixtures.push_back(row);
}

// Two modules of a run and what closes its end, and three runs beside it.
std::shared_ptr<const episodes::AisleStore> store_of_runs() {
  HandMadeScene shop;
  scene::Scene& scene = shop.scene;
  scene.layout.shell.width_mm = 14000;
  scene.layout.shell.outline_mm = PolygonMm{{0, 0}, {14000, 0}, {14000, 4000}, {0, 4000}};
  layout::Fixture called;
  called.id = "dry/run-1/module-2", called.run = "dry/run-1";
  add_again(scene, 1.25F, called);
  called.id = "dry/end-1/module-1", called.run = "dry/end-1", called.endcap_of = "dry/run-1";
  add_again(scene, 2.5F, called);
  for (int run = 2; run < 5; ++run) {
    called = {};
    called.run = "dry/run-" + std::to_string(run);
    called.id = called.run + "/module-1";
    add_again(scene, 2.0F + 2.0F * static_cast<float>(run), called);
  }
  return or_die(episodes::open_aisle_store(data_rows(), scene));
}

constexpr PointMm start{3000, 1600};

TEST(MappedStore, RunsStandElsewhereAsAWhole) {
  const auto store = store_of_runs();
  const auto mapped = or_die(mapped_store(store, {0.03}, Seed(5), start));
  ASSERT_NE(mapped, store);
  std::map<std::string, std::pair<int, int>> shifts;
  int farthest = 0;
  for (std::size_t f = 0; f < store->scene.fixtures.size(); ++f) {
    const layout::Fixture &there = store->scene.layout.fixtures[f],
                          &said = mapped->scene.layout.fixtures[f];
    const std::pair shift{said.x_mm - there.x_mm, said.y_mm - there.y_mm};
    EXPECT_LE(std::abs(shift.first), 30);
    EXPECT_LE(std::abs(shift.second), 30);
    farthest = std::max({farthest, std::abs(shift.first), std::abs(shift.second)});
    const std::string run = there.endcap_of.empty() ? there.run : there.endcap_of;
    EXPECT_EQ(shifts.try_emplace(run, shift).first->second, shift) << there.id;
    for (const std::size_t axis : {0U, 1U})
      EXPECT_NEAR(1e3 * (mapped->scene.fixtures[f].position_m[axis] -
                         store->scene.fixtures[f].position_m[axis]),
                  axis == 0 ? shift.first : shift.second,
                  0.01);
  }
  EXPECT_EQ(shifts.size(), 4U);
  EXPECT_GT(farthest, 15);
  EXPECT_TRUE(mapped->ways.space().free(start));
}

TEST(MappedStore, TheSameSeedDrawsTheSameAndNoDialIsTheStoreItself) {
  const auto store = store_of_runs();
  const auto at = [&](std::uint64_t seed) {
    return or_die(mapped_store(store, {0.03}, Seed(seed), start))->scene.layout.fixtures[0].x_mm;
  };
  EXPECT_EQ(at(5), at(5));
  EXPECT_FALSE(at(5) == at(6) && at(6) == at(7));
  EXPECT_EQ(or_die(mapped_store(store, {}, Seed(5), start)), store);
}

// Where the robot begins is free floor on its map, too: what was drawn is less then.
TEST(MappedStore, TheMapLeavesTheRobotRoomToBegin) {
  const auto store = store_of_runs();
  PointMm near{3000, 1600};
  while (store->ways.space().free({near[0], near[1] + 1}))
    ++near[1];  // as near to the shelf as it may stand
  int nearer = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto mapped = or_die(mapped_store(store, {0.05}, Seed(seed), near));
    EXPECT_TRUE(mapped->ways.space().free(near)) << seed;
    nearer += mapped == store ? 1 : 0;
  }
  EXPECT_GT(nearer, 0) << "no run was drawn to stand nearer";
  EXPECT_LT(nearer, 12);
}

// Boards, obstacles and free floor are those of the map; what physics has is as it was.
TEST(MappedStore, TheAgentIsToldTheMapAndTheWorldStaysAsItIs) {
  const auto ideal = can_world_at({}), erring = can_world_at(with_map(0.1));
  EXPECT_EQ(&*or_die(ideal->mapped()), &ideal->store());
  const auto mapped = or_die(erring->mapped());
  const episodes::StoreMap truth(ideal->store()), told(*mapped);
  ASSERT_EQ(told.boards().size(), truth.boards().size());
  const Vec3 off =
      told.boards()[0].store_from_board.position - truth.boards()[0].store_from_board.position;
  EXPECT_GT(length(off), 0.005);
  EXPECT_LE(std::max(std::abs(off.x), std::abs(off.y)), 0.1 + 1e-6);
  EXPECT_EQ(erring->state_hash(), ideal->state_hash());
  EXPECT_EQ(&erring->store().scene, &ideal->store().scene);
  const Vec3 middle{3, 3.5, 0.5};
  const auto boxes = [&](const episodes::StoreMap& map) {
    std::vector<double> places;
    for (const auto& box : map.fixtures(middle, 1).boxes)
      places.push_back(box.pose.position.y);
    return places;
  };
  EXPECT_NE(boxes(told), boxes(truth));
  EXPECT_NE(mapped->ways.space().grown(), ideal->store().ways.space().grown());
}

}  // namespace
}  // namespace marketgen
