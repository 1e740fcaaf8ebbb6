#include "navigation/visibility_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/progress.h"
#include "base/seed.h"
#include "navigation/occupancy.h"

namespace marketgen {
namespace {

constexpr int radius_mm = 420;
const PolygonMm hall{{0, 0}, {12000, 0}, {12000, 9000}, {0, 9000}};

double distance_mm(PointMm a, PointMm b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

std::string code_of(const Result<navigation::FloorPath>& result) {
  return result.ok() ? "ok" : result.error().code;
}

// Distance of a point to a rectangle, by formula and not by the code under test.
double distance_mm(double x, double y, const RectMm& r) {
  return std::hypot(std::max({r.x0 - x, 0.0, x - r.x1}), std::max({r.y0 - y, 0.0, y - r.y1}));
}

std::vector<RectMm> clutter(std::uint64_t seed, int count) {
  Stream draw = Seed(seed).child("clutter").stream();
  std::vector<RectMm> rects;
  for (int i = 0; i < count; ++i) {
    const int x = draw.integer(0, 10500), y = draw.integer(0, 8000);
    rects.push_back({x, y, x + draw.integer(200, 2500), y + draw.integer(200, 2500)});
  }
  return rects;
}

PointMm free_place(const navigation::FreeSpace& space, Stream& draw) {
  for (int i = 0; i < 10000; ++i) {
    const PointMm p{draw.integer(0, 12000), draw.integer(0, 9000)};
    if (space.free(p)) return p;
  }
  return {-1, -1};
}

// A 60 x 40 m store: back-to-back gondolas of 1 m modules, coolers along the walls, promotion
// pallets in the cross aisles.
std::vector<RectMm> big_store() {
  std::vector<RectMm> rects;
  for (int run = 0; run < 14; ++run) {
    for (int block = 0; block < 3; ++block) {
      for (int module = 0; module < 9; ++module) {
        const int x = 3000 + 4000 * run, y = 6000 + 11000 * block + 1000 * module;
        rects.push_back({x, y, x + 600, y + 1000});
        rects.push_back({x + 600, y, x + 1200, y + 1000});
      }
    }
  }
  for (int i = 0; i < 46; ++i)
    rects.push_back({1250 * i, 39000, 1250 * i + 1250, 40000});
  for (int i = 0; i < 24; ++i)
    rects.push_back({3300 + 2300 * i, 2000, 4500 + 2300 * i, 2800});
  return rects;
}

TEST(VisibilityGraph, AFreeLineIsThePath) {
  const auto graph = navigation::VisibilityGraph::make(hall, {}, radius_mm);
  ASSERT_TRUE(graph.ok());
  const auto path = graph->shortest_path({1000, 1000}, {4000, 5000});
  ASSERT_TRUE(path.ok());
  EXPECT_EQ(path->points.size(), 2U);
  EXPECT_DOUBLE_EQ(path->length_m, 5.0);
}

TEST(VisibilityGraph, GoesRoundAWallByTheGrownCorners) {
  // A thin wall x 5000..5200 from y 0 to 5000; r 400, so the octagon cuts at 400 and 166.
  const auto graph = navigation::VisibilityGraph::make(hall, {{5000, 0, 5200, 5000}}, 400);
  ASSERT_TRUE(graph.ok());
  const auto path = graph->shortest_path({3000, 1000}, {7200, 1000});
  ASSERT_TRUE(path.ok());
  const std::vector<PointMm> corners{
      {3000, 1000}, {4600, 5166}, {4834, 5400}, {5366, 5400}, {5600, 5166}, {7200, 1000}};
  EXPECT_EQ(path->points, corners);
  EXPECT_NEAR(
      path->length_m, 1e-3 * (2 * std::hypot(1600, 4166) + 2 * std::hypot(234, 234) + 532), 1e-9);
}

TEST(VisibilityGraph, APassageOfExactlyTheBaseIsOpenAndOneMillimetreLessIsNot) {
  const auto with_gap = [](int gap) {
    return navigation::VisibilityGraph::make(
        hall, {{5000, 0, 5200, 4000}, {5000, 4000 + gap, 5200, 9000}}, radius_mm);
  };
  const auto open = with_gap(2 * radius_mm), shut = with_gap(2 * radius_mm - 1);
  ASSERT_TRUE(open.ok() && shut.ok());
  EXPECT_TRUE(open->shortest_path({2000, 2000}, {9000, 2000}).ok());
  EXPECT_EQ(code_of(shut->shortest_path({2000, 2000}, {9000, 2000})), "motion.unreachable");
}

TEST(VisibilityGraph, SlantedWallsAndConvexObstaclesCount) {
  const PolygonMm cut{{0, 0}, {12000, 0}, {12000, 5000}, {8000, 9000}, {0, 9000}};
  const auto graph = navigation::VisibilityGraph::make(
      cut, {}, radius_mm, {{{5000, 4000}, {6500, 5500}, {5000, 7000}}});
  ASSERT_TRUE(graph.ok());
  EXPECT_FALSE(graph->space().free({10300, 6300}));  // 283 mm from the slanted wall
  EXPECT_TRUE(graph->space().free({10000, 6300}));   // 495 mm
  EXPECT_FALSE(graph->space().free({6200, 6200}));   // 283 mm from the triangle's side
  const auto path = graph->shortest_path({3000, 5500}, {8000, 5500});
  ASSERT_TRUE(path.ok());
  EXPECT_GT(path->length_m, 5.2);
}

TEST(VisibilityGraph, EndsThatCannotBeAreErrors) {
  const auto graph = navigation::VisibilityGraph::make(hall, {{5000, 4000, 6000, 5000}}, radius_mm);
  ASSERT_TRUE(graph.ok());
  EXPECT_EQ(code_of(graph->shortest_path({-1, 500}, {2000, 2000})), "motion.outside_floor");
  EXPECT_EQ(code_of(graph->shortest_path({2000, 2000}, {2'000'000'000, 2000})),
            "motion.outside_floor");
  EXPECT_EQ(code_of(graph->shortest_path({2000, 2000}, {5500, 4500})), "motion.base_blocked");
  EXPECT_EQ(code_of(graph->shortest_path({419, 2000}, {2000, 2000})), "motion.base_blocked");
  EXPECT_EQ(code_of(graph->shortest_path({420, 2000}, {2000, 2000})), "ok");
}

TEST(VisibilityGraph, BadFloorsAreErrors) {
  const auto code = [](const PolygonMm& floor, const std::vector<RectMm>& rects, int clearance) {
    const auto graph = navigation::VisibilityGraph::make(floor, rects, clearance);
    return graph.ok() ? "ok" : graph.error().code;
  };
  EXPECT_EQ(code({{0, 0}, {1000, 0}}, {}, 300), "motion.bad_floor");
  EXPECT_EQ(code(hall, {}, 0), "motion.bad_floor");
  EXPECT_EQ(code(hall, {{500, 500, 400, 600}}, 300), "motion.bad_floor");
  EXPECT_EQ(code(hall, {{0, 0, 2'000'000, 100}}, 300), "motion.bad_floor");
}

TEST(FreeSpace, NeighboursMergeIntoRuns) {
  EXPECT_EQ(navigation::merged({{0, 0, 10, 10}, {20, 0, 30, 10}, {10, 0, 20, 10}, {5, 2, 8, 4}}),
            (std::vector<RectMm>{{0, 0, 30, 10}}));
  EXPECT_EQ(navigation::merged({{0, 0, 10, 10}, {10, 0, 20, 11}}).size(), 2U);
}

// ---- Properties over random halls ----

TEST(VisibilityGraph, PathsKeepTheirDistanceAndAreNoLongerThanAStar) {
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::vector<RectMm> rects = clutter(seed, 10);
    const auto graph = navigation::VisibilityGraph::make(hall, rects, radius_mm);
    ASSERT_TRUE(graph.ok());
    // Whole cells of this grid are free for the octagon too, so its paths are paths of ours.
    constexpr int cell_mm = 25;
    const auto grown = static_cast<int>(std::ceil(radius_mm / std::cos(M_PI / 8) + cell_mm));
    const navigation::OccupancyGrid grid = navigation::make_occupancy(hall, rects, grown, cell_mm);
    Stream draw = Seed(seed).child("ends").stream();
    for (int query = 0; query < 6; ++query) {
      const PointMm from = free_place(graph->space(), draw), to = free_place(graph->space(), draw);
      const auto path = graph->shortest_path(from, to);
      const auto rough = navigation::shortest_path(grid, from, to);
      const bool same_ends = rough && distance_mm(rough->points.front(), from) <= cell_mm &&
                             distance_mm(rough->points.back(), to) <= cell_mm;
      if (!path.ok()) {
        EXPECT_EQ(path.error().code, "motion.unreachable");
        EXPECT_FALSE(same_ends) << "A* found a way that the graph lacks, seed " << seed;
        continue;
      }
      double length_mm = 0;
      for (std::size_t i = 0; i + 1 < path->points.size(); ++i) {
        const PointMm a = path->points[i], b = path->points[i + 1];
        length_mm += distance_mm(a, b);
        const int steps = 1 + static_cast<int>(distance_mm(a, b) / 5);
        for (int k = 0; k <= steps; ++k) {
          const double x = a[0] + double(b[0] - a[0]) * k / steps;
          const double y = a[1] + double(b[1] - a[1]) * k / steps;
          EXPECT_GE(std::min({x, y, 12000 - x, 9000 - y}), radius_mm - 1e-6);
          for (const RectMm& r : rects)
            ASSERT_GE(distance_mm(x, y, r), radius_mm - 1e-6) << "seed " << seed;
        }
      }
      EXPECT_NEAR(path->length_m, 1e-3 * length_mm, 1e-9);
      if (!same_ends) continue;
      ++solved;
      EXPECT_LE(path->length_m, rough->length_m + 2e-3 * cell_mm) << "seed " << seed;
    }
  }
  EXPECT_GT(solved, 100);
}

// The full graph: every pair of grown corners, tangent or not, and Dijkstra without a heap.
double brute_force_m(const navigation::FreeSpace& space, PointMm from, PointMm to) {
  std::vector<PointMm> nodes{from, to};
  for (const PolygonMm& polygon : space.grown()) {
    for (const PointMm& p : polygon) {
      if (space.free(p)) nodes.push_back(p);
    }
  }
  std::vector<double> cost(nodes.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> done(nodes.size(), false);
  cost[0] = 0;
  for (std::size_t round = 0; round < nodes.size(); ++round) {
    std::size_t best = nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!done[i] && (best == nodes.size() || cost[i] < cost[best])) best = i;
    }
    done[best] = true;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double through = cost[best] + distance_mm(nodes[best], nodes[i]);
      if (through < cost[i] && space.sees(nodes[best], nodes[i])) cost[i] = through;
    }
  }
  return 1e-3 * cost[1];
}

TEST(VisibilityGraph, BitangentsAloneLoseNoShortestPath) {
  for (std::uint64_t seed = 100; seed < 130; ++seed) {
    const auto graph = navigation::VisibilityGraph::make(hall, clutter(seed, 9), radius_mm);
    ASSERT_TRUE(graph.ok());
    Stream draw = Seed(seed).child("ends").stream();
    const PointMm from = free_place(graph->space(), draw), to = free_place(graph->space(), draw);
    const auto path = graph->shortest_path(from, to);
    const double expected = brute_force_m(graph->space(), from, to);
    if (path.ok()) {
      EXPECT_NEAR(path->length_m, expected, 1e-9) << "seed " << seed;
    } else {
      EXPECT_EQ(expected, std::numeric_limits<double>::infinity()) << "seed " << seed;
    }
  }
}

// A line of sight agrees with a walk along it in steps of a millimetre.
TEST(FreeSpace, SightAgreesWithAWalkAlongTheLine) {
  const auto space = navigation::FreeSpace::make(hall, clutter(7, 12), radius_mm);
  ASSERT_TRUE(space.ok());
  Stream draw = Seed(7).child("lines").stream();
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    const PointMm a = free_place(*space, draw), b = free_place(*space, draw);
    const int steps = static_cast<int>(distance_mm(a, b));
    double deepest = 0;  // how far inside a grown obstacle the line runs
    for (int k = 0; k <= steps; ++k) {
      const double x = a[0] + double(b[0] - a[0]) * k / steps;
      const double y = a[1] + double(b[1] - a[1]) * k / steps;
      for (const PolygonMm& p : space->grown()) {
        double depth = 1e9;
        for (std::size_t e = 0, d = p.size() - 1; e < p.size(); d = e++) {
          const double ex = p[e][0] - p[d][0], ey = p[e][1] - p[d][1];
          depth = std::min(depth, (ex * (y - p[d][1]) - ey * (x - p[d][0])) / std::hypot(ex, ey));
        }
        deepest = std::max(deepest, depth);
      }
    }
    const bool sees = space->sees(a, b);
    seen += sees ? 1 : 0;
    if (sees) {
      EXPECT_LE(deepest, 1e-6);
    } else {
      EXPECT_GT(deepest, -1.0);  // what blocks it lies within the walk's step
    }
  }
  EXPECT_GT(seen, 20);
}

TEST(VisibilityGraph, SameForAnyNumberOfThreads) {
  const auto lengths = [](int threads) {
    const ThreadLimit limit(threads);
    const auto graph = navigation::VisibilityGraph::make(hall, clutter(3, 14), radius_mm);
    std::vector<std::vector<PointMm>> paths;
    Stream draw = Seed(3).child("ends").stream();
    for (int i = 0; i < 20; ++i) {
      const PointMm from = free_place(graph->space(), draw), to = free_place(graph->space(), draw);
      const auto path = graph->shortest_path(from, to);
      paths.push_back(path.ok() ? path->points : std::vector<PointMm>{});
    }
    return std::make_pair(graph->edges(), paths);
  };
  const auto one = lengths(1);
  EXPECT_EQ(one, lengths(2));
  EXPECT_EQ(one, lengths(4));
}

// Prints its figures; the limits leave room for a loaded machine (goals: 200 ms and 5 ms).
TEST(VisibilityGraph, ABigStoreIsPreparedAndAskedQuickly) {
  const PolygonMm floor{{0, 0}, {60000, 0}, {60000, 40000}, {0, 40000}};
  const std::vector<RectMm> rects = big_store();
  const double begin = monotonic_seconds();
  const auto graph = navigation::VisibilityGraph::make(floor, rects, radius_mm);
  ASSERT_TRUE(graph.ok());
  const double prepared_s = monotonic_seconds() - begin;
  Stream draw = Seed(1).child("ends").stream();
  double worst_s = 0, sum_s = 0;
  constexpr int queries = 200;
  for (int i = 0; i < queries; ++i) {
    PointMm ends[2];
    for (PointMm& p : ends) {
      do
        p = {draw.integer(0, 60000), draw.integer(0, 40000)};
      while (!graph->space().free(p));
    }
    const double start = monotonic_seconds();
    ASSERT_TRUE(graph->shortest_path(ends[0], ends[1]).ok());
    const double spent = monotonic_seconds() - start;
    worst_s = std::max(worst_s, spent);
    sum_s += spent;
  }
  printf("%zu fixtures, %zu corners, %zu edges: prepared in %.1f ms; a query %.3f ms, worst %.3f\n",
         rects.size(),
         graph->corners(),
         graph->edges(),
         1e3 * prepared_s,
         1e3 * sum_s / queries,
         1e3 * worst_s);
  EXPECT_LT(prepared_s, 2.0);
  EXPECT_LT(sum_s / queries, 0.05);
}

// ---- Past what stands there for now. ----

double distance_to_way_mm(PointMm p, PointMm a, PointMm b) {
  double least = 1e9;
  for (int i = 0; i <= 200; ++i)
    least = std::min(least,
                     std::hypot(a[0] + (b[0] - a[0]) * i / 200.0 - p[0],
                                a[1] + (b[1] - a[1]) * i / 200.0 - p[1]));
  return least;
}

TEST(PathPast, KeepsClearOfDiscsAndIsLittleLonger) {
  const auto graph = navigation::VisibilityGraph::make(hall, {}, radius_mm).value();
  const std::vector<navigation::DiscMm> discs{{{6000, 4500}, 1000}, {{4200, 4300}, 600}};
  const PointMm from{1000, 4500}, to{11000, 4500};
  const navigation::FloorPath path = graph.shortest_path_past(from, to, discs).value();
  EXPECT_GT(path.length_m, 10.0);
  EXPECT_LT(path.length_m, 10.4);
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (const navigation::DiscMm& disc : discs)
      EXPECT_GE(distance_to_way_mm(disc.at, path.points[i], path.points[i + 1]), disc.radius_mm);
  EXPECT_EQ(graph.shortest_path(from, to)->length_m, 10.0);
}

TEST(PathPast, ShutPassagesAndStandingInTheGoalAreUnreachable) {
  // Two halves of a hall, joined by a passage of 2 m.
  const std::vector<RectMm> wall{{5500, 0, 6500, 3500}, {5500, 5500, 6500, 9000}};
  const auto graph = navigation::VisibilityGraph::make(hall, wall, radius_mm).value();
  const PointMm from{1000, 4500}, to{11000, 4500};
  const std::vector<navigation::DiscMm> in_passage{{{6000, 4500}, 700}};
  const std::vector<navigation::DiscMm> beside{{{6000, 3800}, 900}}, at_goal{{{11000, 4600}, 200}};
  EXPECT_EQ(code_of(graph.shortest_path_past(from, to, in_passage)), "motion.unreachable");
  EXPECT_EQ(code_of(graph.shortest_path_past(from, to, beside)), "ok");
  EXPECT_EQ(code_of(graph.shortest_path_past(from, to, at_goal)), "motion.unreachable");
}

TEST(PathPast, WhoIsNearerThanTheRadiusGetsAway) {
  const auto graph = navigation::VisibilityGraph::make(hall, {}, radius_mm).value();
  const std::vector<navigation::DiscMm> disc{{{6000, 4500}, 1200}};
  const PointMm from{5200, 4500};
  EXPECT_EQ(code_of(graph.shortest_path_past(from, {2000, 4500}, disc)), "ok");
  const navigation::FloorPath path = graph.shortest_path_past(from, {10000, 4500}, disc).value();
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    EXPECT_GE(distance_to_way_mm(disc[0].at, path.points[i], path.points[i + 1]), 798);
}

TEST(PathPast, WaysThatNobodyIsOnStayAsTheyAre) {
  Stream draw = Seed(5).child("past").stream();
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const std::vector<RectMm> rects = clutter(seed, 8);
    const auto graph = navigation::VisibilityGraph::make(hall, rects, radius_mm).value();
    const PointMm from = free_place(graph.space(), draw), to = free_place(graph.space(), draw),
                  at = free_place(graph.space(), draw);
    constexpr int radius = 500;
    if (distance_mm(at, from) < radius + 50 || distance_mm(at, to) < radius + 50) continue;
    const std::vector<navigation::DiscMm> disc{{at, radius}};
    const auto past = graph.shortest_path_past(from, to, disc);
    const auto plain = graph.shortest_path(from, to);
    if (!plain.ok()) continue;
    EXPECT_GE(past.ok() ? past->length_m : 1e9, plain->length_m - 1e-6);
    bool is_clear = true;
    for (std::size_t i = 0; i + 1 < plain->points.size(); ++i)
      is_clear =
          is_clear && distance_to_way_mm(at, plain->points[i], plain->points[i + 1]) > radius + 5;
    if (!is_clear) continue;
    ASSERT_TRUE(past.ok()) << seed;
    EXPECT_NEAR(past->length_m, plain->length_m, 1e-6) << seed;
  }
}

}  // namespace
}  // namespace marketgen
