// Shelves drawn in zones: how many runs, in which direction, and what is none.
#include "drawing/zone_shelves.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace marketgen {
namespace {

constexpr int floor_px = 800, deep_px = 500;  // a floor of 32 x 20 m

cv::Mat floor_of(const cv::Scalar& colour) {
  cv::Mat bgr(deep_px, floor_px, CV_8UC3, colour);
  cv::rectangle(bgr, cv::Rect(0, 0, floor_px, deep_px), cv::Scalar::all(25), 8);
  return bgr;
}

std::vector<drawing::ShelfStroke> strokes_on(const cv::Mat& bgr) {
  cv::Mat floor = cv::Mat::zeros(bgr.size(), CV_8UC1);
  floor(cv::Rect(8, 8, floor_px - 16, deep_px - 16)).setTo(255);
  return drawing::shelf_strokes(bgr, floor, floor_px, 0);
}

// All of the picture is one part.
std::optional<drawing::DrawnRuns> runs_in(const cv::Mat& bgr) {
  drawing::Segments segments;
  segments.label = cv::Mat::zeros(bgr.size(), CV_32S);
  segments.parts.resize(1);
  return drawing::runs_on(segments, strokes_on(bgr), floor_px, 0)[0];
}

const cv::Scalar green(120, 214, 165), blank = cv::Scalar::all(250), black = cv::Scalar::all(30);

TEST(ZoneShelves, StrokesSideBySideAreRuns) {
  for (const cv::Scalar& ground : {green, blank}) {
    cv::Mat bgr = floor_of(ground);
    for (const int x : {200, 270, 340, 410})
      cv::line(bgr, {x, 100}, {x, 380}, black, 3);
    const auto runs = runs_in(bgr);
    ASSERT_TRUE(runs.has_value());
    EXPECT_EQ(runs->count, 4);
    EXPECT_FALSE(runs->along_x);
    EXPECT_GE(runs->confidence, 0.8);
  }
}

TEST(ZoneShelves, BoxesAndBarsAreRuns) {
  for (const int thickness : {1, 2, static_cast<int>(cv::FILLED)}) {
    cv::Mat bgr = floor_of(green);
    for (const int y : {120, 200, 280})
      cv::rectangle(bgr, cv::Rect(150, y, 300, 26), black, thickness);
    const auto runs = runs_in(bgr);
    ASSERT_TRUE(runs.has_value()) << thickness;
    EXPECT_EQ(runs->count, 3) << thickness;
    EXPECT_TRUE(runs->along_x);
  }
}

TEST(ZoneShelves, PiecesInLineAreOneRun) {  // a name stands between them
  cv::Mat bgr = floor_of(green);
  for (const int x : {200, 270, 340}) {
    cv::line(bgr, {x, 60}, {x, 200}, black, 3);
    cv::line(bgr, {x, 260}, {x, 420}, black, 3);
  }
  const auto runs = runs_in(bgr);
  ASSERT_TRUE(runs.has_value());
  EXPECT_EQ(runs->count, 3);
}

TEST(ZoneShelves, TwoLinesCloseTogetherAreTheSidesOfOneShelf) {
  cv::Mat bgr = floor_of(green);
  for (const int x : {200, 290, 380})
    for (const int across : {0, 25})
      cv::line(bgr, {x + across, 100}, {x + across, 380}, black, 2);
  const auto runs = runs_in(bgr);
  ASSERT_TRUE(runs.has_value());
  EXPECT_EQ(runs->count, 3);
}

TEST(ZoneShelves, HatchingIsNone) {
  cv::Mat bgr = floor_of(blank);
  for (int x = 100; x < 700; x += 12)
    cv::line(bgr, {x, 60}, {x, 440}, black, 1);
  EXPECT_TRUE(strokes_on(bgr).empty());
}

TEST(ZoneShelves, LinesBetweenZonesAreNone) {
  cv::Mat bgr = floor_of(blank);
  cv::line(bgr, {200, 0}, {200, deep_px}, black, 2);
  cv::line(bgr, {400, 0}, {400, deep_px}, black, 2);
  cv::line(bgr, {205, 250}, {395, 250}, black, 2);  // stops short of both
  EXPECT_TRUE(strokes_on(bgr).empty());
}

TEST(ZoneShelves, ALoneLineASquareAndASlantedStrokeAreNone) {
  cv::Mat bgr = floor_of(green);
  cv::line(bgr, {200, 100}, {200, 380}, black, 2);
  cv::rectangle(bgr, cv::Rect(400, 200, 30, 30), black, cv::FILLED);
  cv::line(bgr, {500, 100}, {640, 240}, black, 2);
  EXPECT_TRUE(strokes_on(bgr).empty());
}

TEST(ZoneShelves, WhatStoodUnderThemIsAsAroundThem) {
  cv::Mat bgr = floor_of(green);
  for (const int y : {120, 200})
    cv::rectangle(bgr, cv::Rect(150, y, 300, 26), black, 2);
  const auto strokes = strokes_on(bgr);
  ASSERT_EQ(strokes.size(), 2U);
  const cv::Mat clear = drawing::without_places(bgr, drawing::places_of(strokes, bgr.size()));
  EXPECT_EQ(cv::countNonZero(cv::Mat(clear.reshape(1) != floor_of(green).reshape(1))), 0);
}

}  // namespace
}  // namespace marketgen
