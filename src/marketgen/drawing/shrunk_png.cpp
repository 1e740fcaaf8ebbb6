#include "drawing/shrunk_png.h"

#include <algorithm>

#include "drawing/picture.h"
#include "io/picture_file.h"
#include "io/png.h"

namespace marketgen::drawing {

Result<ShrunkPng> shrunk_png(std::string_view bytes,
                             const std::string& where,
                             int longest_side_px) {
  MARKETGEN_TRY(const Image picture, io::decoded_picture(bytes, where));
  cv::Mat bgr = bgr_of(picture);
  shrink(bgr, longest_side_px);
  Image shrunk(bgr.cols, bgr.rows, 3);
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x < bgr.cols; ++x) {
      const cv::Vec3b& from = bgr.at<cv::Vec3b>(y, x);
      std::reverse_copy(from.val, from.val + 3, shrunk.at(x, y));
    }
  }
  MARKETGEN_TRY(std::string png, io::encode_png(shrunk));
  return ShrunkPng{std::move(png), shrunk.width, shrunk.height};
}

}  // namespace marketgen::drawing
