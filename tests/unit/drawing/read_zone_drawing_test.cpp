// Drawings of zones part by part: colours, hatching, lines, legends, dimensions, and what is wrong
// with a picture.
#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "drawing/zone_drawing.h"
#include "drawing/zone_picture.h"
#include "drawing/zone_segments.h"
#include "drawing/zone_words.h"
#include "geometry/image.h"
#include "io/png.h"

namespace marketgen {
namespace {

constexpr int width = 600, depth = 400;

cv::Mat paper() {
  return cv::Mat(depth, width, CV_8UC3, cv::Scalar::all(250));
}

drawing::Segments segments(const cv::Mat& bgr) {
  const cv::Mat floor(bgr.size(), CV_8UC1, cv::Scalar(255));
  return drawing::segments_of(bgr, drawing::dark_ink(bgr), floor, width);
}

// Stripes of a pen between two columns.
void hatch(cv::Mat& bgr, int from, int to, const cv::Scalar& pen, int slope) {
  cv::Mat part = bgr(cv::Rect(from, 0, to - from, bgr.rows));
  for (int x = -bgr.rows; x < part.cols + bgr.rows; x += 9)
    cv::line(part, {x, 0}, {x + slope * bgr.rows, bgr.rows}, pen, 1, cv::LINE_AA);
}

std::string png_of(const cv::Mat& bgr) {
  Image image(bgr.cols, bgr.rows);
  for (int y = 0; y < bgr.rows; ++y)
    for (int x = 0; x < bgr.cols; ++x)
      for (int k = 0; k < 3; ++k)
        image.at(x, y)[k] = bgr.at<cv::Vec3b>(y, x)[2 - k];
  return io::encode_png(image).value();
}

// A sheet with walls of 8 pixels, a door in the southern one, and two coloured halves.
cv::Mat two_halves(bool coloured) {
  cv::Mat sheet(560, 800, CV_8UC3, cv::Scalar::all(250));
  if (coloured) {
    cv::rectangle(sheet, cv::Rect(100, 80, 300, 400), cv::Scalar(120, 214, 165), cv::FILLED);
    cv::rectangle(sheet, cv::Rect(400, 80, 300, 400), cv::Scalar(138, 143, 244), cv::FILLED);
  }
  cv::rectangle(sheet, cv::Rect(92, 72, 616, 416), cv::Scalar::all(25), 8);
  cv::rectangle(sheet, cv::Rect(200, 470, 60, 40), cv::Scalar::all(250), cv::FILLED);
  if (coloured)
    cv::rectangle(sheet, cv::Rect(200, 470, 60, 10), cv::Scalar(120, 214, 165), cv::FILLED);
  return sheet;
}

drawing::ReadOptions of_size(double width_mm) {
  drawing::ReadOptions options;
  options.width_mm = width_mm;
  return options;
}

std::string code_of(const std::string& bytes) {
  const auto read = drawing::read_zone_drawing_bytes(bytes, "drawing", of_size(20000));
  return read.ok() ? "" : read.error().code;
}

TEST(ZoneSegments, FlatColoursAreParts) {
  cv::Mat bgr = paper();
  bgr(cv::Rect(0, 0, 300, 400)).setTo(cv::Scalar(120, 214, 165));
  bgr(cv::Rect(300, 0, 300, 200)).setTo(cv::Scalar(138, 143, 244));
  const drawing::Segments found = segments(bgr);
  ASSERT_EQ(found.parts.size(), 3U);  // the third is bare
  EXPECT_NE(found.label.at<int>(100, 290), found.label.at<int>(100, 310));
  EXPECT_EQ(found.label.at<int>(20, 20), found.label.at<int>(380, 280));
  EXPECT_TRUE(found.parts[found.label.at<int>(300, 450)].bare);
  EXPECT_FALSE(found.parts[found.label.at<int>(100, 450)].bare);
}

TEST(ZoneSegments, HatchingInTwoColoursIsTwoParts) {
  cv::Mat bgr = paper();
  hatch(bgr, 0, 300, cv::Scalar(205, 95, 30), 1);
  hatch(bgr, 300, 600, cv::Scalar(40, 45, 205), -1);
  const drawing::Segments found = segments(bgr);
  ASSERT_EQ(found.parts.size(), 2U);
  EXPECT_TRUE(found.hatched);
  for (int x = 10; x < width; x += 20) {
    if (std::abs(x - 300) < 15) continue;
    EXPECT_EQ(found.label.at<int>(200, x), found.label.at<int>(200, x < 300 ? 50 : 550)) << x;
  }
  EXPECT_NE(found.label.at<int>(200, 50), found.label.at<int>(200, 550));
}

// Four quarters of black hatching: two directions, one of them at two distances, and bare floor.
cv::Mat black_quarters(const cv::Scalar& pen) {
  cv::Mat bgr = paper();
  const auto stripes = [&](const cv::Rect& where, cv::Point way, int gap) {
    cv::Mat part = bgr(where);
    const int far = where.width + where.height;
    for (int at = -far; at < far; at += gap) {
      const cv::Point from = way.y == 0 ? cv::Point(0, at) : cv::Point(at, 0);
      cv::line(part, from, from + way * far, pen, 2, cv::LINE_AA);
    }
  };
  stripes({0, 0, 300, 200}, {1, 1}, 14);
  stripes({300, 0, 300, 200}, {0, 1}, 8);
  stripes({0, 200, 300, 200}, {0, 1}, 17);
  bgr(cv::Rect(100, 85, 100, 30)).setTo(cv::Scalar::all(250));  // the place of a name
  return bgr;
}

TEST(ZoneSegments, BlackHatchingIsToldApartByDirectionAndDistance) {
  const drawing::Segments found = segments(black_quarters(cv::Scalar::all(30)));
  EXPECT_TRUE(found.hatched);
  EXPECT_FALSE(found.coloured);
  ASSERT_EQ(found.parts.size(), 4U);
  const auto at = [&](int x, int y) { return found.label.at<int>(y, x); };
  EXPECT_EQ((std::set<int>{at(50, 50), at(450, 100), at(150, 300), at(450, 300)}.size()), 4U);
  EXPECT_TRUE(found.parts[at(450, 300)].bare);
  EXPECT_EQ(at(150, 100), at(50, 50));
  for (const int x : {20, 280})
    EXPECT_EQ(at(x, 100), at(50, 50)) << x;
}

TEST(ZoneSegments, OnePenInTwoDirectionsIsTwoParts) {
  cv::Mat bgr = paper();
  hatch(bgr, 0, 300, cv::Scalar(205, 95, 30), 1);
  hatch(bgr, 300, 600, cv::Scalar(205, 95, 30), -1);
  const drawing::Segments found = segments(bgr);
  ASSERT_EQ(found.parts.size(), 2U);
  EXPECT_NE(found.label.at<int>(200, 50), found.label.at<int>(200, 550));
  EXPECT_EQ(found.label.at<int>(20, 50), found.label.at<int>(380, 250));
}

TEST(ZoneSegments, ALineDividesAreasOfOneColour) {
  cv::Mat bgr(depth, width, CV_8UC3, cv::Scalar(120, 214, 165));
  EXPECT_EQ(segments(bgr).parts.size(), 1U);
  cv::line(bgr, {250, 0}, {250, depth}, cv::Scalar::all(30), 2);
  cv::line(bgr, {252, 180}, {width, 180}, cv::Scalar::all(30), 2);
  const drawing::Segments found = segments(bgr);
  ASSERT_EQ(found.parts.size(), 3U);
  EXPECT_EQ((std::set<int>{found.label.at<int>(100, 100),
                           found.label.at<int>(100, 400),
                           found.label.at<int>(300, 400)}
                 .size()),
            3U);
}

TEST(ZoneSegments, LinesEncloseParts) {
  cv::Mat bgr = paper();
  cv::line(bgr, {300, 0}, {300, 400}, cv::Scalar::all(110), 2);
  cv::line(bgr, {303, 200}, {600, 200}, cv::Scalar::all(110), 2);  // stops short of the other
  const drawing::Segments found = segments(bgr);
  EXPECT_FALSE(found.coloured);
  ASSERT_EQ(found.parts.size(), 3U);
  const std::set<int> labels{
      found.label.at<int>(100, 100), found.label.at<int>(100, 500), found.label.at<int>(300, 500)};
  EXPECT_EQ(labels.size(), 3U);
}

TEST(ZoneSegments, SquaresBesideThePlanAreALegend) {
  cv::Mat bgr = paper();
  bgr(cv::Rect(20, 20, 300, 300)).setTo(cv::Scalar(120, 214, 165));
  bgr(cv::Rect(400, 40, 20, 20)).setTo(cv::Scalar(120, 214, 165));
  bgr(cv::Rect(400, 80, 20, 20)).setTo(cv::Scalar(138, 143, 244));
  bgr(cv::Rect(400, 120, 150, 4)).setTo(cv::Scalar(138, 143, 244));  // a stroke
  const auto swatches = drawing::swatches_of(bgr, cv::Rect(10, 10, 320, 320), 320);
  ASSERT_EQ(swatches.size(), 2U);
  EXPECT_EQ(swatches[0].box, cv::Rect(400, 40, 20, 20));
  EXPECT_LT(swatches[0].ab[0], 0);  // green
  EXPECT_GT(swatches[1].ab[0], 0);  // red
}

TEST(ZoneWords, DimensionsAreLengthsOfShops) {
  EXPECT_DOUBLE_EQ(drawing::dimension_mm("20 m").value(), 20000);
  EXPECT_DOUBLE_EQ(drawing::dimension_mm("20,5 m").value(), 20500);
  EXPECT_DOUBLE_EQ(drawing::dimension_mm("20.5米").value(), 20500);
  EXPECT_DOUBLE_EQ(drawing::dimension_mm("2050 cm").value(), 20500);
  EXPECT_DOUBLE_EQ(drawing::dimension_mm("20500").value(), 20500);
  for (const char* none : {"", "Dairy", "20", "2 m", "900 m", "20 kg", "m", "20.5", "20 m wide"})
    EXPECT_FALSE(drawing::dimension_mm(none).has_value()) << none;
}

TEST(ZoneWords, WordsOfATableGoToTheLinesTheyStandOn) {
  const std::string tsv =
      "level\tpage_num\tblock_num\tpar_num\tline_num\tword_"
      "num\tleft\ttop\twidth\theight\tconf\ttext\n"
      "4\t1\t1\t1\t1\t0\t34\t28\t200\t30\t-1\t\n"
      "5\t1\t1\t1\t1\t1\t34\t28\t84\t30\t90\tFruit\n"
      "5\t1\t1\t1\t1\t2\t130\t28\t28\t30\t80\t&\n"
      "5\t1\t1\t1\t1\t3\t175\t28\t71\t30\t70\tVeg\n"
      "5\t1\t1\t1\t2\t1\t34\t104\t36\t30\t96\t乳\n"
      "5\t1\t1\t1\t2\t2\t80\t104\t36\t30\t94\t品\n"
      "5\t1\t1\t1\t2\t3\t120\t104\t36\t30\t5\tx\n";
  const auto lines = drawing::lines_of_tsv(tsv, {10, 86, 162});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].words, "Fruit & Veg");
  EXPECT_NEAR(lines[0].confidence, 0.8, 1e-9);
  EXPECT_EQ(lines[1].words, "乳品");
}

TEST(ZonePicture, SidesOfATiltedRectangleKeepTheirRatio) {
  // 3 : 2, turned about its upright middle axis by 25 degrees, seen from 2.2 widths away.
  std::array<cv::Point2d, 4> corners;
  const double tilt = 25 * CV_PI / 180, far = 2.2 * 900;
  const std::array<cv::Point2d, 4> flat{{{-450, -300}, {450, -300}, {450, 300}, {-450, 300}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = flat[i].x * std::cos(tilt),
                 z = far + flat[i].x * std::sin(tilt) + flat[i].y * 0.2;
    corners[i] = {500 + x * far / z, 400 + flat[i].y * std::cos(std::asin(0.2)) * far / z};
  }
  EXPECT_NEAR(drawing::aspect_of(corners, {1000, 800}), 1.5, 0.1);
}

TEST(ZoneDrawing, ReadsWallsDoorsAndParts) {
  const auto read =
      drawing::read_zone_drawing_bytes(png_of(two_halves(true)), "drawing", of_size(24000));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_NEAR(read->floor.shell.width_mm, 24000, 2);
  EXPECT_NEAR(read->floor.shell.depth_mm, 16000, 200);
  ASSERT_EQ(read->floor.openings.size(), 1U);
  EXPECT_NEAR((read->floor.openings[0].from[0] + read->floor.openings[0].to[0]) / 2.0, 5200, 200);
  ASSERT_EQ(read->zones.size(), 2U);
  EXPECT_NEAR(read->zones[0].area_m2, 192, 5);
  EXPECT_NE(read->map.at(10, 80), read->map.at(230, 80));
  EXPECT_EQ(read->map.at(10, 10), read->map.at(110, 150));
}

TEST(ZoneDrawing, WallsThatMakeNoRectangleAreThoseOfAFloorPlan) {
  cv::Mat sheet(600, 800, CV_8UC3, cv::Scalar::all(250));
  sheet(cv::Rect(100, 100, 300, 400)).setTo(cv::Scalar(120, 214, 165));
  sheet(cv::Rect(400, 300, 300, 200)).setTo(cv::Scalar(138, 143, 244));
  const std::vector<cv::Point> corners{
      {100, 100}, {400, 100}, {400, 300}, {700, 300}, {700, 500}, {100, 500}};
  cv::polylines(sheet, std::vector<std::vector<cv::Point>>{corners}, true, cv::Scalar::all(25), 9);
  drawing::ReadOptions options;
  options.scale = drawing::Scale{40, 0};
  const auto read = drawing::read_zone_drawing_bytes(png_of(sheet), "drawing", options);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_TRUE(read->floor.shell.outline_mm.has_value());
  EXPECT_EQ(read->floor.shell.outline_mm->size(), 6U);
  EXPECT_NEAR(read->floor.shell.width_mm, 23640, 150);
  ASSERT_EQ(read->zones.size(), 2U);
  const int west = read->map.at(20, 120), east = read->map.at(220, 20);
  EXPECT_NE(west, east);
  EXPECT_EQ(read->map.at(20, 20), west);
  EXPECT_EQ(read->map.at(220, 140), drawing::ZoneMap::outside);
}

TEST(ZoneDrawing, ScaleIsSaidOrGuessedOrAnError) {
  const std::string png = png_of(two_halves(true));
  const auto unsaid = drawing::read_zone_drawing_bytes(png, "drawing", {});
  ASSERT_FALSE(unsaid.ok());
  EXPECT_EQ(unsaid.error().code, "drawing.no_scale");
  drawing::ReadOptions usual;
  usual.usual_area_m2 = 600;
  const auto guessed = drawing::read_zone_drawing_bytes(png, "drawing", usual);
  ASSERT_TRUE(guessed.ok()) << to_string(guessed.error());
  EXPECT_TRUE(guessed->scale_is_guessed);
  EXPECT_NEAR(guessed->floor.shell.width_mm * 1e-6 * guessed->floor.shell.depth_mm, 600, 3);
  drawing::ReadOptions said;
  said.scale = drawing::Scale{40, 0};
  const auto scaled = drawing::read_zone_drawing_bytes(png, "drawing", said);
  ASSERT_TRUE(scaled.ok()) << to_string(scaled.error());
  EXPECT_NEAR(scaled->floor.shell.width_mm, 24320, 150);  // 608 pixels
  EXPECT_FALSE(scaled->scale_is_guessed);
}

TEST(ZoneDrawing, ShelvesDoNotBreakZonesAndAreRuns) {
  cv::Mat sheet = two_halves(true);
  for (const int y : {150, 230, 310, 390})
    cv::rectangle(sheet, cv::Rect(140, y, 220, 22), cv::Scalar::all(30), 2);
  const auto read = drawing::read_zone_drawing_bytes(png_of(sheet), "drawing", of_size(24000));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->zones.size(), 2U);
  const auto& west = read->zones[static_cast<std::size_t>(read->map.at(10, 80))];
  const auto& east = read->zones[static_cast<std::size_t>(read->map.at(230, 80))];
  EXPECT_NEAR(west.area_m2, 192, 5);
  EXPECT_FALSE(east.runs.has_value());
  ASSERT_TRUE(west.runs.has_value());
  EXPECT_EQ(west.runs->count, 4);
  EXPECT_TRUE(west.runs->along_x);
  EXPECT_TRUE(west.words.empty()) << west.words;
}

TEST(ZoneDrawing, ASizeWithOtherSidesIsSaidWithBothNumbers) {
  drawing::ReadOptions options;  // the drawing is 24 x 16
  options.width_mm = 24000;
  options.depth_mm = 16000;
  const std::string png = png_of(two_halves(true));
  const auto same = drawing::read_zone_drawing_bytes(png, "drawing", options);
  ASSERT_TRUE(same.ok()) << to_string(same.error());
  EXPECT_TRUE(same->warnings.empty());
  options.depth_mm = 24000;
  const auto other = drawing::read_zone_drawing_bytes(png, "drawing", options);
  ASSERT_TRUE(other.ok()) << to_string(other.error());
  ASSERT_EQ(other->warnings.size(), 1U);
  EXPECT_EQ(other->warnings[0],
            "it is drawn 1.49 times as wide as deep, but the size of 24 x 24 m is 1.00 times as "
            "wide as deep: all that is drawn is stretched; 24x16.1m would keep its sides");
  options.width_mm = 16000;
  const auto turned = drawing::read_zone_drawing_bytes(png, "drawing", options);
  ASSERT_EQ(turned->warnings.size(), 1U);
  EXPECT_NE(turned->warnings[0].find("24x16m would keep its sides"), std::string::npos)
      << turned->warnings[0];
}

// Bars of a chart in its frame, from the lower side up.
cv::Mat bar_chart(const std::vector<int>& heights) {
  cv::Mat sheet(560, 800, CV_8UC3, cv::Scalar::all(250));
  int x = 130;
  for (const int tall : heights) {
    cv::rectangle(sheet, cv::Rect(x, 480 - tall, 80, tall), cv::Scalar(180, 120, 60), cv::FILLED);
    x += 140;
  }
  cv::rectangle(sheet, cv::Rect(97, 77, 606, 406), cv::Scalar::all(20), 6);
  return sheet;
}

cv::Mat pie_chart(int slices) {
  cv::Mat sheet(560, 800, CV_8UC3, cv::Scalar::all(250));
  const std::vector<cv::Scalar> colours{
      {120, 214, 165}, {138, 143, 244}, {240, 190, 120}, {110, 240, 240}};
  for (int i = 0; i < slices; ++i)
    cv::ellipse(sheet,
                {400, 280},
                {200, 200},
                0,
                360.0 * i / slices,
                360.0 * (i + 1) / slices,
                colours[static_cast<std::size_t>(i)],
                cv::FILLED,
                cv::LINE_AA);
  return sheet;
}

TEST(ZoneDrawing, ChartsAreNoDrawings) {
  EXPECT_EQ(code_of(png_of(bar_chart({300, 180, 240, 90}))), "drawing.chart");
  EXPECT_EQ(code_of(png_of(pie_chart(4))), "drawing.chart");
  EXPECT_EQ(code_of(png_of(pie_chart(3))), "drawing.chart");
  EXPECT_NE(code_of(png_of(bar_chart({300, 180}))), "drawing.chart");
}

TEST(ZoneDrawing, ZonesAlongAWallWithADoorAreNoChart) {
  cv::Mat sheet = bar_chart({300, 180, 240, 90});
  cv::rectangle(sheet, cv::Rect(500, 60, 60, 40), cv::Scalar::all(250), cv::FILLED);
  EXPECT_NE(code_of(png_of(sheet)), "drawing.chart");
}

TEST(ZoneDrawing, WhatIsNoDrawingOfZonesIsAnError) {
  EXPECT_EQ(code_of(png_of(two_halves(false))), "drawing.no_zones");
  EXPECT_EQ(code_of(png_of(paper())), "drawing.no_outline");
  EXPECT_EQ(code_of(png_of(cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(0)))), "drawing.bad_file");
  EXPECT_EQ(code_of(png_of(paper()).substr(0, 60)), "image.bad_file");
  EXPECT_EQ(code_of("a text"), "drawing.bad_file");
  EXPECT_EQ(code_of(""), "drawing.bad_file");
  cv::Mat noise(300, 400, CV_8UC3);
  cv::theRNG().state = 7;
  cv::randu(noise, 0, 255);
  EXPECT_EQ(code_of(png_of(noise)), "drawing.no_outline");
}

// For as long as it lives, programs are looked up in one folder only.
class PathFor {
 public:
  explicit PathFor(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~PathFor() { setenv("PATH", before_.c_str(), 1); }
  PathFor(const PathFor&) = delete;
  PathFor& operator=(const PathFor&) = delete;

 private:
  std::string before_;
};

TEST(ZoneDrawing, WithoutTesseractItSaysWhatToInstall) {
  cv::Mat sheet = two_halves(true);
  cv::putText(sheet, "DAIRY", {180, 280}, cv::FONT_HERSHEY_SIMPLEX, 1, cv::Scalar::all(20), 2);
  const std::string png = png_of(sheet);
  const PathFor nothing(testing::TempDir() + "no_programs_here");
  const auto read = drawing::read_zone_drawing_bytes(png, "drawing", of_size(24000));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->zones[0].words.empty());
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_NE(read->warnings[0].find("tesseract-ocr-chi-sim"), std::string::npos)
      << read->warnings[0];
  EXPECT_NE(read->warnings[0].find("usage.unavailable"), std::string::npos) << read->warnings[0];
}

}  // namespace
}  // namespace marketgen
