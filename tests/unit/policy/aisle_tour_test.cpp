// Where a collecting robot looks next, on a map made by hand.
#include "policy/aisle_tour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace marketgen {
namespace {

// An open floor in front of boards that face south.
class PlainMap : public agent::AisleMap {
 public:
  explicit PlainMap(const std::vector<Vec3>& edges) {
    for (const Vec3& edge : edges)
      boards_.push_back({{edge, {}}, 1.0, 0.4, 0.3, assets::ShelfUse::stand, false});
  }
  agent::ShelfBoard& board(std::size_t i) { return boards_[i]; }
  const std::vector<agent::ShelfBoard>& boards() const override { return boards_; }
  bool has_room(const robots::BasePlace& place) const override { return place.y_m > 0; }
  Result<motion::BaseFollower> way(const robots::BasePlace&,
                                   const robots::BasePlace&) const override {
    return Error{"motion.unreachable", "map", "nobody drives here"};
  }
  Result<motion::WayRound> way_round(const robots::BasePlace&,
                                     const robots::BasePlace&,
                                     std::span<const motion::MovingDisc>,
                                     bool) const override {
    return Error{"motion.unreachable", "base path", "nobody is about"};
  }
  std::optional<double> way_m(const robots::BasePlace& from,
                              const robots::BasePlace& to) const override {
    if (to.x_m > 8) return std::nullopt;  // behind a wall
    return std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  }
  motion::Obstacles fixtures(Vec3, double) const override { return {}; }

 private:
  std::vector<agent::ShelfBoard> boards_;
};

TEST(AisleTour, OneStopLooksStraightAtAllBoardsOfAFront) {
  const PlainMap map({{1, 3, 0.5}, {1, 3, 0.9}, {1, 2.95, 0.15}, {2, 3, 0.5}, {3, 0.3, 0.5}});
  const auto stops = policy::view_stops(map);
  ASSERT_EQ(stops.size(), 2U) << "nobody can stand before the last one";
  EXPECT_NEAR(stops[0].place.x_m, 1, 1e-9);
  EXPECT_LT(stops[0].place.y_m, 3 - 0.6);
  EXPECT_NEAR(stops[0].place.heading, std::numbers::pi / 2, 1e-9);
}

// It opens no doors and takes nothing out of heaps: it does not look there.
TEST(AisleTour, ItStopsWhereItCanFetchFrom) {
  PlainMap map({{1, 3, 0.5}, {3, 3, 0.5}, {5, 3, 0.1}});
  map.board(0).has_door = true;
  map.board(1).use = assets::ShelfUse::heap;
  const auto stops = policy::view_stops(map);
  ASSERT_EQ(stops.size(), 1U);
  EXPECT_NEAR(stops[0].place.x_m, 5, 1e-9) << "a low board is looked at like any other";
}

TEST(AisleTour, GoesToTheCategoryFirstAndNeverTwice) {
  const PlainMap map({{1, 3, 0.5}, {3, 3, 0.5}, {5, 3, 0.5}, {9, 3, 0.5}});
  const auto stops = policy::view_stops(map);
  ASSERT_EQ(stops.size(), 4U);
  std::vector<bool> seen(stops.size(), false);
  const robots::BasePlace from{3, 1, 0};
  EXPECT_EQ(policy::next_stop(map, stops, seen, from, {5, 3}, 3), 2U);
  seen[2] = true;
  EXPECT_EQ(policy::next_stop(map, stops, seen, from, {5, 3}, 3), 1U);
  seen[1] = true;
  EXPECT_EQ(policy::next_stop(map, stops, seen, from, {5, 3}, 3), std::nullopt);
  EXPECT_EQ(policy::next_stop(map, stops, seen, from, {5, 3}, 5), 0U)
      << "the fourth cannot be reached";
}

}  // namespace
}  // namespace marketgen
