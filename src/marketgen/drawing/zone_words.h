// What is written on a drawing of zones: lines of letters are found on the picture and read by the
// outside program tesseract.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

#include "base/result.h"

namespace marketgen::drawing {

struct WrittenLine {
  cv::Rect box;  // on the picture
  std::string words;
  double confidence = 0;  // 0 to 1
};

// 255 where something is darker than what is around it, as letters on any colour are.
cv::Mat letter_ink(const cv::Mat& bgr, double longer_side, bool hatched);
// Boxes around lines of writing in `ink`: small marks side by side. None goes over `borders`.
std::vector<cv::Rect> lines_of_writing(const cv::Mat& ink, const cv::Mat& borders, double longer_side);
// Reads them, all in one call. Errors: usage.unavailable with the packages that bring tesseract,
// program.failed.
Result<std::vector<WrittenLine>> read_lines(const cv::Mat& bgr,
                                            const cv::Mat& ink,
                                            const std::vector<cv::Rect>& boxes,
                                            double longer_side);
// The words of each line in tesseract's TSV; line i stands between rows[i] and rows[i + 1].
std::vector<WrittenLine> lines_of_tsv(std::string_view tsv, const std::vector<int>& rows);

// "20 m", "20,5 m", "20.5 米", "2050 cm", "20500 mm", "20500": millimetres. Nothing for other words
// and for lengths that no shop has.
std::optional<double> dimension_mm(std::string_view words);

}  // namespace marketgen::drawing
