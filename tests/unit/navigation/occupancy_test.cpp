#include "navigation/occupancy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/seed.h"

namespace marketgen {
namespace {

const PolygonMm room_4x3{{0, 0}, {4000, 0}, {4000, 3000}, {0, 3000}};

std::size_t free_cells(const navigation::OccupancyGrid& grid) {
  std::size_t count = 0;
  for (const std::uint8_t cell : grid.blocked)
    count += cell == 0 ? 1 : 0;
  return count;
}

// Random rectangles in a 6 x 5 m room.
navigation::OccupancyGrid cluttered_grid(std::uint64_t seed, int clearance_mm) {
  Stream draw = Seed(seed).child("clutter").stream();
  std::vector<RectMm> obstacles;
  for (int i = 0; i < 9; ++i) {
    const int x = draw.integer(0, 5500), y = draw.integer(0, 4500);
    obstacles.push_back({x, y, x + draw.integer(100, 1500), y + draw.integer(100, 1500)});
  }
  return navigation::make_occupancy(
      {{0, 0}, {6000, 0}, {6000, 5000}, {0, 5000}}, obstacles, clearance_mm, 100);
}

TEST(Occupancy, PolygonsBlockTheCellsWhoseMiddlesLieInThem) {
  const navigation::OccupancyGrid empty = navigation::make_occupancy(room_4x3, {}, 0, 100);
  // A square on its corner around (2, 1.5), 5 cells each way, of whose 50 cells the middles of 10
  // lie on an edge; and one that sticks out of the room.
  const navigation::OccupancyGrid grid =
      with_blocked(empty,
                   {{{1500, 1500}, {2000, 1000}, {2500, 1500}, {2000, 2000}},
                    {{3800, 2800}, {5000, 2800}, {5000, 4000}, {3800, 4000}}});
  EXPECT_EQ(free_cells(grid), 1200U - 40 - 4);
  EXPECT_FALSE(grid.free(20, 15));
  EXPECT_TRUE(grid.free(15, 10));
  EXPECT_FALSE(grid.free(39, 29));
}

TEST(Occupancy, EmptyRoomWithoutClearanceIsAllFree) {
  const navigation::OccupancyGrid grid = navigation::make_occupancy(room_4x3, {}, 0, 100);
  EXPECT_EQ(grid.columns, 40);
  EXPECT_EQ(grid.rows, 30);
  EXPECT_EQ(free_cells(grid), 1200U);
}

TEST(Occupancy, ClearanceShrinksTheFloor) {  // 500 mm off each wall: 30 x 20 cells of 100 mm remain
  EXPECT_EQ(free_cells(navigation::make_occupancy(room_4x3, {}, 500, 100)), 600U);
}

TEST(Occupancy, CornersOfObstaclesAreRound) {
  const navigation::OccupancyGrid grid =
      navigation::make_occupancy(room_4x3, {{1500, 1000, 2500, 2000}}, 300, 50);
  EXPECT_FALSE(grid.free(28, 30));  // 75 mm west of the obstacle's side
  EXPECT_TRUE(grid.free(22, 30));   // 375 mm west
  // (1275, 775) is 225 mm off in x and y, 318 mm from the corner: free, though inside the grown
  // square.
  EXPECT_TRUE(grid.free(25, 15));
  EXPECT_FALSE(grid.free(26, 16));  // (1325, 825) is 247 mm from the corner
}

// Squared distance in mm; 0 on the rectangle.
std::int64_t squared_distance(PointMm p, const RectMm& r) {
  const std::int64_t dx = std::max({r.x0 - p[0], 0, p[0] - r.x1});
  const std::int64_t dy = std::max({r.y0 - p[1], 0, p[1] - r.y1});
  return dx * dx + dy * dy;
}

TEST(Occupancy, BlocksExactlyTheCentresNearerThanTheClearance) {
  Stream draw = Seed(4).child("rectangles").stream();
  for (const int clearance : {0, 1, 30, 420, 999}) {
    for (int i = 0; i < 40; ++i) {
      const int x = draw.integer(-300, 4200), y = draw.integer(-300, 3200);
      const RectMm obstacle{x, y, x + draw.integer(0, 1500), y + draw.integer(0, 1500)};
      const navigation::OccupancyGrid bare =
          navigation::make_occupancy(room_4x3, {}, clearance, 50);
      const navigation::OccupancyGrid grid =
          navigation::make_occupancy(room_4x3, {obstacle}, clearance, 50);
      for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
          const PointMm p = grid.center(column, row);
          const bool inside =
              p[0] > obstacle.x0 && p[0] < obstacle.x1 && p[1] > obstacle.y0 && p[1] < obstacle.y1;
          const bool near = squared_distance(p, obstacle) < std::int64_t{clearance} * clearance;
          ASSERT_EQ(grid.free(column, row), bare.free(column, row) && !inside && !near)
              << clearance << " mm, obstacle " << i << ", cell " << column << ", " << row;
        }
      }
    }
  }
}

TEST(Occupancy, OutlineCutsTheFloor) {  // an L: the north-east quarter of 4 x 4 m is missing
  const PolygonMm outline{{0, 0}, {4000, 0}, {4000, 2000}, {2000, 2000}, {2000, 4000}, {0, 4000}};
  const navigation::OccupancyGrid grid = navigation::make_occupancy(outline, {}, 0, 100);
  EXPECT_EQ(free_cells(grid), 1200U);
  EXPECT_FALSE(grid.free(30, 30));
  EXPECT_TRUE(grid.free(10, 30));
}

TEST(Occupancy, NearestFreeStaysWithinReach) {
  const navigation::OccupancyGrid grid =
      navigation::make_occupancy(room_4x3, {{0, 0, 2000, 3000}}, 0, 100);
  EXPECT_FALSE(navigation::nearest_free(grid, {1000, 1550}, 900).has_value());
  const auto found = navigation::nearest_free(grid, {1500, 1550}, 900);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(*found, grid.index(20, 15));
}

TEST(Components, AWallMakesTwoRooms) {
  const navigation::OccupancyGrid grid =
      navigation::make_occupancy(room_4x3, {{1000, 0, 1100, 3000}}, 0, 100);
  const navigation::Components found = navigation::find_components(grid);
  ASSERT_EQ(found.cells.size(), 3U);
  EXPECT_EQ(found.cells[1], 300);
  EXPECT_EQ(found.cells[2], 870);
  EXPECT_EQ(found.largest(), 2);
}

// Every cell with its label's first cell, found by walking: what `find_components` promises.
void expect_components(const navigation::OccupancyGrid& grid) {
  const navigation::Components found = navigation::find_components(grid);
  std::vector<int> label(grid.blocked.size(), 0);
  int labels = 0;
  for (std::size_t start = 0; start < label.size(); ++start) {
    if (grid.blocked[start] != 0 || label[start] != 0) continue;
    std::vector<std::size_t> pending{start};
    label[start] = ++labels;
    int cells = 0;
    for (; !pending.empty(); ++cells) {
      const auto column = static_cast<int>(pending.back()) % grid.columns;
      const auto row = static_cast<int>(pending.back()) / grid.columns;
      pending.pop_back();
      for (const PointMm step : {PointMm{1, 0}, PointMm{-1, 0}, PointMm{0, 1}, PointMm{0, -1}}) {
        if (!grid.free(column + step[0], row + step[1])) continue;
        const std::size_t next = grid.index(column + step[0], row + step[1]);
        if (label[next] != 0) continue;
        label[next] = labels;
        pending.push_back(next);
      }
    }
    ASSERT_LT(static_cast<std::size_t>(labels), found.cells.size());
    EXPECT_EQ(found.cells[static_cast<std::size_t>(labels)], cells);
  }
  EXPECT_EQ(found.cells.size(), static_cast<std::size_t>(labels) + 1);
  EXPECT_EQ(found.label, label);
}

TEST(Components, AreThoseThatWalkingFinds) {
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    expect_components(cluttered_grid(seed, 150));
  Stream draw = Seed(9).child("speckles").stream();  // mazes: parts that join late
  for (int i = 0; i < 40; ++i) {
    navigation::OccupancyGrid grid = navigation::make_occupancy(room_4x3, {}, 0, 100);
    for (std::uint8_t& cell : grid.blocked)
      cell = draw.chance(0.42) ? 1 : 0;
    expect_components(grid);
  }
}

TEST(Components, ADoorMustBeWideEnough) {  // an 800 mm door lets 390 mm radius through, not 450
  const std::vector<RectMm> wall{{2000, 0, 2100, 1000}, {2000, 1800, 2100, 3000}};
  EXPECT_EQ(
      navigation::find_components(navigation::make_occupancy(room_4x3, wall, 350, 50)).cells.size(),
      2U);
  EXPECT_EQ(
      navigation::find_components(navigation::make_occupancy(room_4x3, wall, 450, 50)).cells.size(),
      3U);
}

TEST(Path, StraightLineIsTwoPoints) {
  const auto path = navigation::shortest_path(
      navigation::make_occupancy(room_4x3, {}, 0, 100), {550, 1550}, {3550, 1550});
  ASSERT_TRUE(path.has_value());
  EXPECT_EQ(path->points, (std::vector<PointMm>{{550, 1550}, {3550, 1550}}));
  EXPECT_DOUBLE_EQ(path->length_m, 3.0);
}

TEST(Path, GoesRoundAnObstacle) {
  // A wall from the south leaves only the north 1 m open: the way bends round its tip.
  const navigation::OccupancyGrid grid =
      navigation::make_occupancy(room_4x3, {{1900, 0, 2100, 2000}}, 0, 100);
  const auto path = navigation::shortest_path(grid, {1050, 550}, {2950, 550});
  ASSERT_TRUE(path.has_value());
  // By hand: two legs round the tip, sqrt(0.85^2 + 1.5^2) each at least, plus 0.2 m across.
  EXPECT_GT(path->length_m, 3.6);
  EXPECT_LT(path->length_m, 4.0);
}

TEST(Path, NothingThroughAClosedWall) {
  const navigation::OccupancyGrid grid =
      navigation::make_occupancy(room_4x3, {{1900, 0, 2100, 3000}}, 0, 100);
  EXPECT_FALSE(navigation::shortest_path(grid, {550, 550}, {3550, 550}).has_value());
}

TEST(Path, DistancesAreThoseToTheNearestStart) {
  const navigation::OccupancyGrid grid =
      navigation::make_occupancy(room_4x3, {{1900, 0, 2100, 3000}}, 0, 100);
  const auto west = grid.index(0, 0), east = grid.index(39, 29);
  const std::vector<float> both = navigation::distances_from(grid, {west, east});
  EXPECT_EQ(both[west], 0);
  EXPECT_NEAR(both[grid.index(3, 4)], 3 * 141.4 + 100, 0.1);
  EXPECT_NEAR(both[grid.index(39, 9)], 2000, 0.1) << "the eastern one is the nearest";
  const std::vector<float> one = navigation::distances_from(grid, {west});
  EXPECT_FALSE(std::isfinite(one[east])) << "behind the wall";
  EXPECT_FALSE(std::isfinite(one[grid.index(20, 3)])) << "in the wall";
}

TEST(Path, LegsCrossOnlyFreeCells) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const navigation::OccupancyGrid grid = cluttered_grid(seed, 200);
    const auto path = navigation::shortest_path(grid, {500, 500}, {5500, 4500});
    if (!path) continue;
    for (std::size_t i = 0; i + 1 < path->points.size(); ++i) {
      const PointMm a = path->points[i], b = path->points[i + 1];
      for (int k = 0; k <= 400; ++k) {
        const int x = a[0] + (b[0] - a[0]) * k / 400, y = a[1] + (b[1] - a[1]) * k / 400;
        EXPECT_TRUE(grid.free(x / 100, y / 100)) << "seed " << seed << " at " << x << "," << y;
      }
    }
  }
}

TEST(Clearance, EqualsTheBruteForceDistance) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const navigation::OccupancyGrid grid = cluttered_grid(seed, 0);
    const std::vector<float> field = navigation::clearance_field(grid);
    for (int row = 0; row < grid.rows; row += 3) {
      for (int column = 0; column < grid.columns; column += 3) {
        double best = std::numeric_limits<double>::max();
        for (int r = -1; r <= grid.rows; ++r) {
          for (int c = -1; c <= grid.columns; ++c) {
            if (grid.free(c, r)) continue;
            best = std::min(best, std::hypot(c - column, r - row));
          }
        }
        EXPECT_NEAR(field[grid.index(column, row)], best * grid.cell_mm, 1e-2);
      }
    }
  }
}

double distance_to(PointMm p, PointMm a, PointMm b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double share = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
  const double t = std::min(1.0, std::max(0.0, share));
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

// Every cell of a room with slanted walls against its distance from each of them.
TEST(Occupancy, SlantedWallsAreMeasuredCellByCell) {
  const PolygonMm floor{
      {1000, 0}, {9000, 700}, {8300, 6000}, {6000, 2500}, {3500, 7000}, {0, 4000}};
  for (const int clearance : {0, 300, 850}) {
    const navigation::OccupancyGrid grid = navigation::make_occupancy(floor, {}, clearance, 50);
    std::size_t free = 0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const PointMm p = grid.center(column, row);
        double nearest = 1e9;
        for (std::size_t i = 0; i < floor.size(); ++i)
          nearest = std::min(nearest, distance_to(p, floor[i], floor[(i + 1) % floor.size()]));
        if (std::abs(nearest - clearance) < 0.01) continue;  // rounding decides
        EXPECT_EQ(grid.free(column, row), contains(floor, p) && nearest > clearance)
            << p[0] << " " << p[1] << " " << clearance;
        free += grid.free(column, row) ? 1 : 0;
      }
    }
    EXPECT_GT(free, 1000U);
  }
}

// Comb-shaped, as large as a plan may have it: what went over every cell for each of its teeth took
// ten seconds for one grid.
TEST(Occupancy, ALargeRoomWithManyCorners) {
  PolygonMm comb{{0, 0}, {200'000, 0}};
  for (int x = 200'000; x > 8000; x -= 4000) {
    comb.push_back({x, 200'000});
    comb.push_back({x - 2000, 200'000});
    comb.push_back({x - 2000, 60'000});
    comb.push_back({x - 4000, 60'000});
  }
  comb.push_back({8000, 200'000});
  comb.push_back({0, 200'000});
  const auto start = std::chrono::steady_clock::now();
  const navigation::OccupancyGrid grid = navigation::make_occupancy(comb, {}, 400);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_TRUE(grid.free(100, 3000));
}

TEST(Occupancy, AnObstacleThatLeavesAWayRoundItCutsNothingOff) {
  // A corridor of 4 x 3 m for a base of 0.8 m: its centre moves in the middle 2.2 m.
  const navigation::OccupancyGrid grid = navigation::make_occupancy(room_4x3, {}, 400, 50);
  EXPECT_TRUE(navigation::stays_joined(grid, {1800, 0, 2200, 1200}, 400, 1500));
  EXPECT_FALSE(navigation::stays_joined(grid, {1800, 0, 2200, 2800}, 400, 1500));  // 0.2 m left
  const navigation::OccupancyGrid after =
      navigation::with_obstacle(grid, {1800, 0, 2200, 2800}, 400);
  EXPECT_EQ(navigation::find_components(after).cells.size(), 3U);  // two, and the blocked
}

}  // namespace
}  // namespace marketgen
