#include "photo/looked.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "drawing/picture.h"
#include "geometry/image.h"

namespace marketgen::photo {
namespace {

// Three channels of any picture, on white.
cv::Mat rgb_of(const Image& image) {
  cv::Mat rgb(image.height, image.width, CV_8UC3);
  for (int y = 0; y < image.height; ++y) {
    auto* row = rgb.ptr<cv::Vec3b>(y);
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      const bool grey = image.channels < 3;
      const int alpha = image.channels == 2 ? p[1] : image.channels == 4 ? p[3] : 255;
      for (int c = 0; c < 3; ++c) {
        const int value = grey ? p[0] : p[c];
        row[x][c] = static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha)) / 255);
      }
    }
  }
  return rgb;
}

// Longer side as the bank's photos have it.
void resize_to_bank(cv::Mat& rgb) {
  const double by = static_cast<double>(longer_side_px) / std::max(rgb.cols, rgb.rows);
  if (by == 1) return;
  const cv::Size size(std::max(min_side_px, static_cast<int>(std::lround(rgb.cols * by))),
                      std::max(min_side_px, static_cast<int>(std::lround(rgb.rows * by))));
  cv::resize(rgb, rgb, size, 0, 0, by < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
}

}  // namespace

Result<Looked> looked_at(std::string_view bytes, const std::string& where) {
  MARKETGEN_TRY(const Image image, drawing::decoded_picture(bytes, where));
  if (std::min(image.width, image.height) < min_side_px) {
    return Error{"image.too_small",
                 where,
                 fmt::format("the photo has {} x {} pixels; give one of at least {} x {}",
                             image.width,
                             image.height,
                             min_side_px,
                             min_side_px)};
  }
  Looked looked;
  looked.rgb = rgb_of(image);
  resize_to_bank(looked.rgb);
  cv::cvtColor(looked.rgb, looked.lab, cv::COLOR_RGB2Lab);
  cv::extractChannel(looked.lab, looked.lightness, 0);
  return looked;
}

}  // namespace marketgen::photo
