#include "photo/looked.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "drawing/picture.h"
#include "geometry/image.h"
#include "io/file.h"
#include "io/picture_file.h"

namespace marketgen::photo {
namespace {

// Longer side as the bank's photos have it.
void resize_to_bank(cv::Mat& picture) {
  const double by = static_cast<double>(longer_side_px) / std::max(picture.cols, picture.rows);
  if (by == 1) return;
  const cv::Size size(std::max(min_side_px, static_cast<int>(std::lround(picture.cols * by))),
                      std::max(min_side_px, static_cast<int>(std::lround(picture.rows * by))));
  cv::resize(picture, picture, size, 0, 0, by < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
}

}  // namespace

Result<Looked> looked_at(std::string_view bytes, const std::string& where) {
  MARKETGEN_TRY(const Image image, io::decoded_picture(bytes, where));
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
  cv::Mat bgr = drawing::bgr_of(image);
  resize_to_bank(bgr);
  cv::cvtColor(bgr, looked.rgb, cv::COLOR_BGR2RGB);
  cv::cvtColor(looked.rgb, looked.lab, cv::COLOR_RGB2Lab);
  cv::extractChannel(looked.lab, looked.lightness, 0);
  return looked;
}

Result<Looked> looked_at(const std::filesystem::path& path) {
  constexpr std::uint64_t max_photo_bytes = 256U << 20;
  MARKETGEN_TRY(const std::string bytes, io::read_file(path, max_photo_bytes));
  return looked_at(bytes, path.string());
}

}  // namespace marketgen::photo
