#include "photo/cells.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "photo/palette.h"
#include "photo/parts.h"

namespace marketgen::photo {
namespace {

Looked looked(const cv::Mat& rgb) {
  Looked photo;
  photo.rgb = rgb;
  cv::cvtColor(rgb, photo.lab, cv::COLOR_RGB2Lab);
  cv::extractChannel(photo.lab, photo.lightness, 0);
  return photo;
}

cv::Mat even(const cv::Scalar& rgb) {
  return cv::Mat(100, 150, CV_8UC3, rgb);
}

TEST(Cells, CoverThePhotoToItsEdges) {
  const Cells cells = cells_of(looked(even({200, 200, 200})));
  EXPECT_EQ(cells.columns, 10);  // 9 of 16 pixels, and 6 left over
  EXPECT_EQ(cells.rows, 7);
  EXPECT_EQ(cells.numbers.size(), 70U);
}

TEST(Cells, AnEvenColourHasNoSpreadAndNoGrain) {
  const Cells cells = cells_of(looked(even({255, 255, 255})));
  for (const CellNumbers& cell : cells.numbers) {
    EXPECT_DOUBLE_EQ(cell[number::mean], 1);
    EXPECT_NEAR(cell[number::spread], 0, 1e-6);
    EXPECT_EQ(cell[number::white], 1);
    EXPECT_EQ(cell[number::dark], 0);
    for (int i = 0; i < 2 * grain_scales; ++i)
      EXPECT_EQ(cell[number::grain + i], 0);
  }
}

TEST(Cells, StripesHaveADirection) {
  cv::Mat upright = even({120, 120, 120});
  for (int x = 0; x < upright.cols; x += 8)
    upright(cv::Rect(x, 0, 4, upright.rows)) = cv::Scalar(220, 220, 220);
  const CellNumbers cell = cells_of(looked(upright)).at(3, 3);
  EXPECT_GT(cell[number::grain], 0.1);
  EXPECT_EQ(cell[number::grain + 1], 0);
  EXPECT_NEAR(cell[number::orientation], 1, 1e-6);
}

TEST(Cells, SharesOfLightnessAddUpToOne) {
  cv::Mat halves = even({20, 20, 20});
  halves(cv::Rect(0, 0, 8, halves.rows)) = cv::Scalar(255, 255, 255);
  const CellNumbers cell = cells_of(looked(halves)).at(0, 0);
  double shares = 0;
  for (int i = 0; i < lightness_bins; ++i)
    shares += cell[number::lightness + i];
  EXPECT_NEAR(shares, 1, 1e-9);
  EXPECT_NEAR(cell[number::dark], 0.5, 1e-9);
}

TEST(Parts, SharesAddUpToOneForAnyWeights) {
  const Cells cells = cells_of(looked(even({90, 160, 200})));
  Bank bank;
  const auto fit = [](PartModel& model, std::size_t numbers, double weight) {
    model.mean.assign(numbers, 0.1);
    model.scale.assign(numbers, 2);
    model.hidden.assign(3 * (numbers + 1), weight);
    for (std::size_t i = 0; i < part_count * 4; ++i)
      model.output.push_back(weight * static_cast<double>(i));
  };
  for (const double weight : {0.0, 0.5, 500.0, -500.0}) {
    bank = {};
    fit(bank.first_parts, first_number_count(), weight);
    fit(bank.second_parts, second_number_count(), weight);
    for (const PartShares& shares : parts_of(cells, bank)) {
      double sum = 0;
      for (const double share : shares)
        sum += share;
      EXPECT_NEAR(sum, 1, 1e-9) << weight;
    }
  }
}

TEST(Palette, HasTheColoursByTheirShare) {
  cv::Mat picture = even({200, 30, 30});
  picture(cv::Rect(0, 0, 50, 100)) = cv::Scalar(30, 60, 200);
  const std::vector<PaletteColor> palette = palette_of(looked(picture));
  ASSERT_EQ(palette.size(), 2U);
  EXPECT_EQ(palette[0].color, "#c81e1e");
  EXPECT_NEAR(palette[0].share, 2.0 / 3, 1e-9);
  EXPECT_EQ(palette[1].color, "#1e3cc8");
}

}  // namespace
}  // namespace marketgen::photo
