// Drawings of zones with known truth, made by tests/zone_drawings/make_zone_drawings.py: how much
// of the floor belongs to the right zone, how many doors and names are found.
//
//   .venv/bin/python tests/zone_drawings/make_zone_drawings.py FOLDER --seed 11
//   MARKETGEN_ZONE_DRAWINGS=FOLDER build/release/tests/test_drawing
//   --gtest_filter='ZoneDrawingSet.*'
//
// MARKETGEN_ZONE_RASTERS=FOLDER has the zones of each drawing written there as a picture.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "drawing/zone_drawing.h"
#include "geometry/image.h"
#include "io/file.h"
#include "io/png.h"

namespace marketgen {
namespace {

using nlohmann::json;

struct ZoneScore {
  bool unread = false;
  double share = 0, seconds = 0, aspect_off = 0, size_off = -1;
  int names = 0, names_right = 0;
  int doors = 0, doors_found = 0, doors_too_many = 0;
  int runs = 0, runs_right = 0, ways_right = 0, runs_too_many = 0;  // zones with shelves
};

// Squares of the truth, 60 a side, with the zone that is drawn there.
constexpr int side = 60;

int truth_at(const json& truth, double u, double v) {
  const double x = u * truth.at("width").get<double>(), y = v * truth.at("depth").get<double>();
  int index = 0;
  for (const json& zone : truth.at("zones")) {
    const double x0 = zone.at("x"), y0 = zone.at("y"), w = zone.at("w"), d = zone.at("d");
    if (x >= x0 && x < x0 + w && y >= y0 && y < y0 + d) return index;
    ++index;
  }
  return -1;
}

int drawn_at(const drawing::ZoneDrawing& drawn, double u, double v) {
  const plan::Shell& shell = drawn.floor.shell;
  const int column = static_cast<int>(u * shell.width_mm / drawn.map.cell_mm);
  const int row = static_cast<int>(v * shell.depth_mm / drawn.map.cell_mm);
  return drawn.map.at(std::min(column, drawn.map.columns - 1), std::min(row, drawn.map.rows - 1));
}

// Which drawn zone is which of the truth: the pairs with the largest overlap, one to one.
std::map<int, int> matches(const std::map<std::pair<int, int>, int>& overlaps) {
  std::vector<std::pair<int, std::pair<int, int>>> all;
  for (const auto& [pair, count] : overlaps)
    all.emplace_back(-count, pair);
  std::ranges::sort(all);
  std::map<int, int> drawn_of;
  std::map<int, bool> taken;
  for (const auto& [count, pair] : all) {
    if (drawn_of.contains(pair.first) || taken[pair.second]) continue;
    drawn_of[pair.first] = pair.second;
    taken[pair.second] = true;
  }
  return drawn_of;
}

std::string plain(const std::string& words) {
  std::string text;
  for (const char c : words)
    if (c != ' ') text += static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return text;
}

// Of a zone: as many runs of shelves as are drawn, in the direction in which they are drawn.
void score_runs(ZoneScore& score, const json& zone, const std::optional<drawing::DrawnRuns>& read) {
  if (!zone.contains("runs")) {
    score.runs_too_many += read && read->confidence > 0.6 ? 1 : 0;
    return;
  }
  const int count = zone.at("runs")[0];
  const bool along_x = zone.at("runs")[1] == "x";
  if (read && read->along_x == along_x) ++score.ways_right;
  if (read && read->along_x == along_x && read->count == count)
    ++score.runs_right;
  else
    fmt::print("  {}: {} runs {} were read as {} {}\n",
               zone.at("words").get<std::string>(),
               count,
               along_x ? "x" : "y",
               read ? read->count : 0,
               read && read->along_x ? "x" : "y");
}

void score_zones(ZoneScore& score, const json& truth, const drawing::ZoneDrawing& drawn) {
  std::map<std::pair<int, int>, int> overlaps;
  int bare_right = 0;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double u = (column + 0.5) / side, v = (row + 0.5) / side;
      const int known = truth_at(truth, u, v), found = drawn_at(drawn, u, v);
      const bool bare = truth.at("zones")[known].at("words").get<std::string>().empty();
      if (bare) bare_right += found == drawing::ZoneMap::bare ? 1 : 0;
      if (!bare && found >= 0) ++overlaps[{known, found}];
    }
  }
  const std::map<int, int> drawn_of = matches(overlaps);
  int right = bare_right;
  for (const auto& [known, found] : drawn_of) {
    right += overlaps.at({known, found});
    const auto words = truth.at("zones")[known].at("words").get<std::string>();
    const std::string& read = drawn.zones[found].words;
    score_runs(score, truth.at("zones")[known], drawn.zones[found].runs);
    if (plain(words) == plain(read))
      ++score.names_right;
    else
      fmt::print("  \"{}\" was read as \"{}\"\n", words, read);
  }
  score.share = static_cast<double>(right) / (side * side);
}

void score_doors(ZoneScore& score, const json& truth, const drawing::ZoneDrawing& drawn) {
  const double w = truth.at("width"), d = truth.at("depth");
  const double by_x = w / drawn.floor.shell.width_mm, by_y = d / drawn.floor.shell.depth_mm;
  std::vector<drawing::DrawnOpening> left = drawn.floor.openings;
  for (const json& door : truth.at("doors")) {
    const double x = (door[0].get<double>() + door[2].get<double>()) / 2;
    const double y = (door[1].get<double>() + door[3].get<double>()) / 2;
    const double width = std::hypot(door[2].get<double>() - door[0].get<double>(),
                                    door[3].get<double>() - door[1].get<double>());
    const auto found = std::ranges::find_if(left, [&](const drawing::DrawnOpening& o) {
      const double u = (o.from[0] + o.to[0]) / 2.0 * by_x, v = (o.from[1] + o.to[1]) / 2.0 * by_y;
      const double drawn_width =
          std::hypot((o.to[0] - o.from[0]) * by_x, (o.to[1] - o.from[1]) * by_y);
      return std::hypot(u - x, v - y) < 500 && std::abs(drawn_width - width) < 0.3 * width;
    });
    if (found == left.end()) continue;
    ++score.doors_found;
    left.erase(found);
  }
  score.doors_too_many = static_cast<int>(left.size());
}

void write_raster(const drawing::ZoneDrawing& drawn, const std::string& file) {
  const char* folder = std::getenv("MARKETGEN_ZONE_RASTERS");
  if (folder == nullptr) return;
  Image image(drawn.map.columns, drawn.map.rows);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int zone = drawn.map.at(x, image.height - 1 - y);
      for (int k = 0; k < 3; ++k)
        image.at(x, y)[k] =
            static_cast<std::uint8_t>(zone < 0 ? 255 + 60 * zone
                                               : 40 + ((zone + 1) * (k == 0   ? 83
                                                                     : k == 1 ? 131
                                                                              : 197)) %
                                                          200);
    }
  }
  EXPECT_TRUE(io::write_png(std::filesystem::path(folder) / (file + ".png"), image).ok());
}

ZoneScore zone_score_of(const json& truth, const std::filesystem::path& folder) {
  const auto name = truth.at("file").get<std::string>();
  drawing::ReadOptions options;
  options.usual_area_m2 = 400;
  const auto start = std::chrono::steady_clock::now();
  const auto drawn = drawing::read_zone_drawing(folder / name, options);
  ZoneScore score;
  score.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  score.doors = static_cast<int>(truth.at("doors").size());
  for (const json& zone : truth.at("zones")) {
    score.names += zone.at("words").get<std::string>().empty() ? 0 : 1;
    score.runs += zone.contains("runs") ? 1 : 0;
  }
  if (!drawn.ok()) {
    fmt::print("{}\n", to_string(drawn.error()));
    score.unread = true;
    return score;
  }
  for (const std::string& warning : drawn->warnings)
    fmt::print("  {}\n", warning);
  score_zones(score, truth, *drawn);
  score_doors(score, truth, *drawn);
  write_raster(*drawn, name);
  const double w = truth.at("width"), d = truth.at("depth");
  score.aspect_off =
      std::abs(drawn->floor.shell.width_mm / (drawn->floor.shell.depth_mm * w / d) - 1);
  if (truth.at("dimensions")[0].get<double>() > 0)
    score.size_off = std::abs(drawn->floor.shell.width_mm / w - 1);
  return score;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 0 : values[values.size() / 2];
}

struct Totals {
  std::vector<double> shares, seconds, aspects;
  int unread = 0, names = 0, names_right = 0, doors = 0, doors_found = 0, doors_too_many = 0;
  int sized = 0, sized_right = 0;
  int runs = 0, runs_right = 0, ways_right = 0, runs_too_many = 0;

  void add(const ZoneScore& one) {
    shares.push_back(one.share);
    seconds.push_back(one.seconds);
    aspects.push_back(one.aspect_off);
    unread += one.unread ? 1 : 0;
    names += one.names;
    names_right += one.names_right;
    doors += one.doors;
    doors_found += one.doors_found;
    doors_too_many += one.doors_too_many;
    runs += one.runs;
    runs_right += one.runs_right;
    ways_right += one.ways_right;
    runs_too_many += one.runs_too_many;
    sized += one.size_off >= 0 ? 1 : 0;
    sized_right += one.size_off >= 0 && one.size_off < 0.02 ? 1 : 0;
  }
  double mean() const {
    double sum = 0;
    for (const double share : shares)
      sum += share;
    return sum / static_cast<double>(shares.size());
  }
  void print(const std::string& name) const {
    fmt::print(
        "{:22} {:3} drawings, {} unread: right squares {:.4f} (median {:.4f}, worst {:.4f}); names "
        "{}/{}; doors {}/{} +{}; written sizes {}/{}; runs {}/{}, direction "
        "{}/{}, +{}; sides off by {:.3f} (worst {:.3f}); seconds "
        "{:.2f} (worst {:.2f})\n",
        name,
        shares.size(),
        unread,
        mean(),
        median(shares),
        *std::ranges::min_element(shares),
        names_right,
        names,
        doors_found,
        doors,
        doors_too_many,
        sized_right,
        sized,
        runs_right,
        runs,
        ways_right,
        runs,
        runs_too_many,
        median(aspects),
        *std::ranges::max_element(aspects),
        median(seconds),
        *std::ranges::max_element(seconds));
  }
};

// The folder that was named, or a few drawings that lie beside the tests.
std::filesystem::path zone_drawings() {
  if (const char* folder = std::getenv("MARKETGEN_ZONE_DRAWINGS")) return folder;
  return std::string(MARKETGEN_SOURCE_DIR) + "/tests/fixtures/zone_drawings";
}

TEST(SlowZoneDrawingSet, ZonesNamesAndDoorsAreFound) {
  const std::filesystem::path folder = zone_drawings();
  const auto text = io::read_file(folder / "truth.json");
  ASSERT_TRUE(text.ok());
  std::map<std::string, Totals> by_style;
  Totals all;
  for (const json& truth : json::parse(*text)) {
    const ZoneScore one = zone_score_of(truth, folder);
    const std::string style = truth.at("style").get<std::string>() +
                              (truth.at("photographed").get<bool>() ? ", photographed" : "");
    fmt::print(
        "{:8} right {:.4f}  names {}/{}  doors {}/{} +{}  sides off {:.3f} size off {:.3f} {:.2f} "
        "s  {}\n",
        truth.at("file").get<std::string>(),
        one.share,
        one.names_right,
        one.names,
        one.doors_found,
        one.doors,
        one.doors_too_many,
        one.aspect_off,
        one.size_off,
        one.seconds,
        style);
    by_style[style].add(one);
    all.add(one);
  }
  for (const auto& [style, totals] : by_style)
    totals.print(style);
  all.print("all");
  EXPECT_GE(all.mean(), 0.92);
  EXPECT_GE(all.doors_found, 0.95 * all.doors);
}

}  // namespace
}  // namespace marketgen
