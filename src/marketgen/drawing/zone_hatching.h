// Hatching with one pen: areas told apart by the direction and the distance of their strokes.
#pragma once
#include <opencv2/core.hpp>

namespace marketgen::drawing {

// Ink without what is as small as a letter and no straight stroke.
cv::Mat strokes_among(const cv::Mat& ink, double longer_side);

// How many strokes lie side by side around each pixel, on a length of the longer side: CV_32F, up
// to 1.4 times as many when they slant.
cv::Mat stroke_density(const cv::Mat& strokes, double longer_side);

// Where strokes lie side by side as hatching has them: 255. `strokes`: CV_8UC1, ink without
// letters. A few lines between zones are no hatching.
cv::Mat hatched_area(const cv::Mat& strokes, double longer_side);

struct Hatching {
  cv::Mat kind;  // CV_32S: index of a direction and distance, or unlabelled
  int kinds = 0;
};
// Of the strokes within `where`.
Hatching hatching_in(const cv::Mat& strokes, const cv::Mat& where, double longer_side);

// Of ink the letters: what is left without strokes of hatching, whole or cut short by the patch
// that a name stands on.
cv::Mat letters_on_hatching(const cv::Mat& ink, double longer_side);

}  // namespace marketgen::drawing
