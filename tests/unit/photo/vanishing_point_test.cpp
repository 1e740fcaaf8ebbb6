#include "photo/vanishing_point.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace marketgen::photo {
namespace {

constexpr int width = 640, height = 480;

// Segments that lead to `at` from all around it, and shelves' level edges.
std::vector<Segment> aisle(cv::Point2d at) {
  std::vector<Segment> segments;
  for (const cv::Point2d from : {cv::Point2d(0, 0),
                                 cv::Point2d(0, 140),
                                 cv::Point2d(60, 479),
                                 cv::Point2d(639, 30),
                                 cv::Point2d(639, 420),
                                 cv::Point2d(420, 479)}) {
    segments.push_back({from, from + 0.4 * (at - from)});
  }
  for (int y = 50; y < height; y += 40)
    segments.push_back({{100, y * 1.0}, {400, y + 2.0}});
  return segments;
}

TEST(VanishingPoint, LiesWhereSegmentsLead) {
  for (const cv::Point2d at :
       {cv::Point2d(320, 200), cv::Point2d(150, 260), cv::Point2d(500, 180)}) {
    const VanishingPoint found = vanishing_point(aisle(at), {width, height});
    EXPECT_NEAR(found.at.x, at.x, 12);
    EXPECT_NEAR(found.at.y, at.y, 12);
    EXPECT_GE(found.leading.size(), 5U);
  }
}

TEST(VanishingPoint, LevelAndUprightSegmentsLeadNowhere) {
  const std::vector<Segment> level = {{{0, 100}, {300, 101}}, {{50, 20}, {51, 400}}};
  const VanishingPoint found = vanishing_point(level, {width, height});
  EXPECT_EQ(found.length, 0);
  EXPECT_TRUE(found.leading.empty());
  EXPECT_FALSE(is_slanted(level[0]));
  EXPECT_FALSE(is_slanted(level[1]));
}

TEST(VanishingPoint, OfAFloorThatIsDrawn) {
  cv::Mat picture(height, width, CV_8UC1, cv::Scalar(230));
  const std::vector<cv::Point> floor = {{40, 479}, {310, 210}, {330, 210}, {600, 479}};
  cv::fillConvexPoly(picture, floor, cv::Scalar(60));
  const std::vector<Segment> segments = segments_of(picture);
  ASSERT_GE(segments.size(), 2U);
  EXPECT_GE(segments[0].length(), segments[1].length());
  const VanishingPoint found = vanishing_point(segments, picture.size());
  EXPECT_NEAR(found.at.x, 320, 12);
  EXPECT_NEAR(found.at.y, 200, 20);
}

TEST(Segments, ThereAreNoneInAnEvenPicture) {
  EXPECT_TRUE(segments_of(cv::Mat(height, width, CV_8UC1, cv::Scalar(128))).empty());
}

}  // namespace
}  // namespace marketgen::photo
