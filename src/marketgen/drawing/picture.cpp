#include "drawing/picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen::drawing {

Result<Image> decoded_picture(std::string_view bytes, const std::string& where) {
  if (bytes.starts_with("\x89PNG")) return io::decode_png(bytes, where);
  return io::decode_jpeg(bytes, where);
}

double shrink(cv::Mat& picture, int longest_side_px) {
  const int longer = std::max(picture.cols, picture.rows);
  if (longer <= longest_side_px) return 1;
  const double px = static_cast<double>(longer) / longest_side_px;
  cv::resize(picture, picture, {}, 1 / px, 1 / px, cv::INTER_AREA);
  return px;
}

}  // namespace marketgen::drawing
