// A photo made ready to be looked at: of one size, in CIE Lab.
#pragma once
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace marketgen::photo {

constexpr int longer_side_px = 640;
constexpr int min_side_px = 64;

struct Looked {
  cv::Mat rgb;        // CV_8UC3
  cv::Mat lab;        // CV_8UC3, as OpenCV has it: L from 0 to 255, a and b from 128
  cv::Mat lightness;  // CV_8UC1: L of it
};

// PNG or JPEG, larger or smaller, of 1, 3 or 4 channels; what is transparent is white. Errors:
// image.bad_file, input.too_large, image.too_small.
Result<Looked> looked_at(std::string_view bytes, const std::string& where);
// Errors: those, and input.not_found.
Result<Looked> looked_at(const std::filesystem::path& path);

}  // namespace marketgen::photo
