// Floor plans with known truth, made by tests/floor_plans/make_floor_plans.py: how much of the
// floor is found, how many openings and columns.
//
//   .venv/bin/python tests/floor_plans/make_floor_plans.py FOLDER
//   MARKETGEN_FLOOR_PLANS=FOLDER build/release/tests/test_drawing --gtest_filter='FloorPlanSet.*'
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "drawing/floor_plan.h"
#include "drawing/polygons.h"
#include "io/file.h"
#include "io/program.h"

namespace marketgen {
namespace {

using nlohmann::json;

struct Score {
  double iou = 0, seconds = 0;
  int openings = 0, openings_found = 0, openings_too_many = 0;
  int columns = 0, columns_found = 0, columns_too_many = 0;
};

double apart(double x, double y, double u, double v) {
  return std::hypot(x - u, y - v);
}

void score_openings(Score& score, const json& truth, const drawing::FloorPlan& plan) {
  constexpr double near_mm = 300;
  std::vector<drawing::DrawnOpening> left = plan.openings;
  for (const json& one : truth.at("openings")) {
    const double x0 = one[0], y0 = one[1], x1 = one[2], y1 = one[3];
    const double width = apart(x0, y0, x1, y1);
    const auto found = std::ranges::find_if(left, [&](const drawing::DrawnOpening& o) {
      const double middle = apart(
          (x0 + x1) / 2, (y0 + y1) / 2, (o.from[0] + o.to[0]) / 2.0, (o.from[1] + o.to[1]) / 2.0);
      const double w = apart(o.from[0], o.from[1], o.to[0], o.to[1]);
      return middle <= near_mm && std::abs(w - width) <= std::max(200.0, 0.2 * width);
    });
    ++score.openings;
    if (found == left.end()) continue;
    ++score.openings_found;
    left.erase(found);
  }
  score.openings_too_many = static_cast<int>(left.size());
  for (const drawing::DrawnOpening& o : left)
    fmt::print("  no opening at {}, {} to {}, {}\n", o.from[0], o.from[1], o.to[0], o.to[1]);
}

void score_columns(Score& score, const json& truth, const drawing::FloorPlan& plan) {
  constexpr double near_mm = 100;
  std::vector<plan::Column> left = plan.shell.columns;
  for (const json& one : truth.at("columns")) {
    const double x = one[0], y = one[1], size = one[2];
    const auto found = std::ranges::find_if(left, [&](const plan::Column& c) {
      return apart(x, y, c.x_mm, c.y_mm) <= near_mm && std::abs(c.size_mm - size) <= 0.25 * size;
    });
    ++score.columns;
    if (found == left.end()) continue;
    ++score.columns_found;
    left.erase(found);
  }
  score.columns_too_many = static_cast<int>(left.size());
}

Score score_of(const json& truth, const std::filesystem::path& folder) {
  const std::string file = (folder / truth.at("file").get<std::string>()).string();
  drawing::ReadOptions options;
  const auto scale = truth.at("scale").get<std::string>();
  if (!scale.empty()) options.scale = drawing::parse_scale(scale, "scale").value();
  const auto start = std::chrono::steady_clock::now();
  const auto plan = drawing::read_floor_plan(file, options);
  Score score;
  score.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!plan.ok()) {
    fmt::print("{}\n", to_string(plan.error()));
    score.openings = static_cast<int>(truth.at("openings").size());
    score.columns = static_cast<int>(truth.at("columns").size());
    return score;
  }
  drawing::Polygon known, found;
  for (const json& p : truth.at("outline"))
    known.push_back({p[0], p[1]});
  const plan::Shell& shell = plan->shell;
  for (const PointMm& p :
       shell.outline_mm.value_or(polygon_of(RectMm{0, 0, shell.width_mm, shell.depth_mm})))
    found.push_back({static_cast<double>(p[0]), static_cast<double>(p[1])});
  score.iou = drawing::overlap_share(known, found);
  constexpr double doubtful = 0.995;
  if (score.iou < doubtful) {
    for (const drawing::Polygon& polygon : {known, found}) {
      for (const Vec2& p : polygon)
        fmt::print(" {:.0f},{:.0f}", p.x, p.y);
      fmt::print("\n");
    }
  }
  score_openings(score, truth, *plan);
  score_columns(score, truth, *plan);
  return score;
}

// The folder that was named, or a few drawings made now.
std::filesystem::path drawings() {
  if (const char* folder = std::getenv("MARKETGEN_FLOOR_PLANS")) return folder;
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "floor_plans";
  const auto made =
      io::run_program({io::worker_python(),
                       std::string(MARKETGEN_SOURCE_DIR) + "/tests/floor_plans/make_floor_plans.py",
                       folder.string(),
                       "--count",
                       "10",
                       "--seed",
                       "2"},
                      "");
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : to_string(made.error()));
  return folder;
}

TEST(FloorPlanSet, OutlinesOpeningsAndColumnsAreFound) {
  const std::filesystem::path folder = drawings();
  const auto text = io::read_file(folder / "truth.json");
  ASSERT_TRUE(text.ok());
  std::vector<double> shares, seconds;
  Score all;
  for (const json& truth : json::parse(*text)) {
    const Score one = score_of(truth, folder);
    fmt::print("{:8} IoU {:.4f}  openings {}/{} +{}  columns {}/{} +{}  {:.2f} s  {}\n",
               truth.at("file").get<std::string>(),
               one.iou,
               one.openings_found,
               one.openings,
               one.openings_too_many,
               one.columns_found,
               one.columns,
               one.columns_too_many,
               one.seconds,
               truth.at("style").get<std::string>());
    shares.push_back(one.iou);
    seconds.push_back(one.seconds);
    all.openings += one.openings;
    all.openings_found += one.openings_found;
    all.openings_too_many += one.openings_too_many;
    all.columns += one.columns;
    all.columns_found += one.columns_found;
    all.columns_too_many += one.columns_too_many;
  }
  std::ranges::sort(shares);
  std::ranges::sort(seconds);
  fmt::print(
      "{} drawings: IoU median {:.4f}, worst {:.4f}; openings {}/{}, {} too many; columns {}/{}, "
      "{} too "
      "many; seconds median {:.2f}, worst {:.2f}\n",
      shares.size(),
      shares[shares.size() / 2],
      shares.front(),
      all.openings_found,
      all.openings,
      all.openings_too_many,
      all.columns_found,
      all.columns,
      all.columns_too_many,
      seconds[seconds.size() / 2],
      seconds.back());
  EXPECT_GE(shares.front(), 0.98);
  EXPECT_GE(all.openings_found, 0.95 * all.openings);
  EXPECT_GE(all.columns_found, 0.95 * all.columns);
}

}  // namespace
}  // namespace marketgen
