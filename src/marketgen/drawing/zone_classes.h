// Pixels of a drawing sorted into classes: by colour, or by whatever else two numbers say of them.
#pragma once
#include <vector>

#include <opencv2/core.hpp>

namespace marketgen::drawing {

constexpr int unlabelled = -1;
constexpr double narrowest = 0.012;  // half a zone's width, of the floor's longer side
constexpr double min_inked = 0.06;   // share of coloured pixels around one

cv::Mat chroma_of(const cv::Mat& ab);
// The odd number of pixels that is nearest, at least 3.
int odd(double px);
cv::Mat square(int side);

// Values that many pixels have: peaks of a histogram over a and b, from -128 to 128.
std::vector<cv::Vec2d> main_colours(const cv::Mat& ab, const cv::Mat& mask, double apart);

// Pixels that lie amid their like. Peaks on the way from one colour to another at whose border both
// mix hold few of them.
cv::Mat core_of(const cv::Mat& colours, const cv::Mat& coloured, int window);

// Every pixel of `where` that has no label takes that of the nearest that has one.
void fill_from_nearest(cv::Mat& label, const cv::Mat& where);

cv::Mat share_around(const cv::Mat& mask, int window);

// The class with the most strokes around each pixel.
cv::Mat strongest_class(const cv::Mat& colours,
                        const cv::Mat& coloured,
                        const std::vector<cv::Vec2d>& classes,
                        int window);

// Connected parts of each value of `label`; those too small and those too narrow lose it.
cv::Mat connected_parts(
    const cv::Mat& label, int values, double min_px, double half_px, int& count);

}  // namespace marketgen::drawing
