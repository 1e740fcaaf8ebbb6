#include "drawing/picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "io/exif.h"
#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen::drawing {

namespace {

// The picture as it was seen, from one that the camera wrote down with that orientation
// (io/exif.h).
Image upright(Image image, int orientation) {
  if (orientation == 1) return image;
  const bool turned = orientation >= 5;
  Image seen(
      turned ? image.height : image.width, turned ? image.width : image.height, image.channels);
  for (int y = 0; y < seen.height; ++y) {
    for (int x = 0; x < seen.width; ++x) {
      int from_x = turned ? y : x, from_y = turned ? x : y;
      if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8)
        from_x = image.width - 1 - from_x;
      if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7)
        from_y = image.height - 1 - from_y;
      std::copy_n(image.at(from_x, from_y), image.channels, seen.at(x, y));
    }
  }
  return seen;
}

}  // namespace

Result<Image> decoded_picture(std::string_view bytes, const std::string& where) {
  if (bytes.starts_with("\x89PNG")) return io::decode_png(bytes, where);
  MARKETGEN_TRY(Image image, io::decode_jpeg(bytes, where));
  return upright(std::move(image), io::jpeg_orientation(bytes));
}

cv::Mat bgr_of(const Image& image) {
  cv::Mat bgr(image.height, image.width, CV_8UC3);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      const bool see_through = image.channels == 4 || image.channels == 2;
      const int alpha = see_through ? p[image.channels - 1] : 255;
      const auto over = [&](int value) {
        return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha)) / 255);
      };
      const bool colour = image.channels >= 3;
      bgr.at<cv::Vec3b>(y, x) = {over(p[colour ? 2 : 0]), over(p[colour ? 1 : 0]), over(p[0])};
    }
  }
  return bgr;
}

std::array<int, 256> masked_histogram(const cv::Mat& value, const cv::Mat& mask) {
  std::array<int, 256> counts{};
  for (int y = 0; y < value.rows; ++y) {
    for (int x = 0; x < value.cols; ++x)
      if (mask.at<std::uint8_t>(y, x) != 0) ++counts[value.at<std::uint8_t>(y, x)];
  }
  return counts;
}

double shrink(cv::Mat& picture, int longest_side_px) {
  const int longer = std::max(picture.cols, picture.rows);
  if (longer <= longest_side_px) return 1;
  const double px = static_cast<double>(longer) / longest_side_px;
  cv::resize(picture, picture, {}, 1 / px, 1 / px, cv::INTER_AREA);
  return px;
}

}  // namespace marketgen::drawing
