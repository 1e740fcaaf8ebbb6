// Pictures made smaller or drawn elsewhere: what a pixel shows is the mean of what it covers.
#pragma once
#include "geometry/image.h"

namespace marketgen {
inline namespace geometry {

// A rectangle of a picture in its pixels: (0, 0) is the outer corner of the upper left pixel.
struct PixelBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

// The mean colour under the box, each pixel by the part that is covered; sRGB values, rounded. A
// box narrower than a pixel is widened to one about its middle, so that an enlarged picture is
// smooth. Past its border a picture goes on as its outermost pixels. The picture is not empty and
// has three channels or more, of which the first three count. Same box, same colour on every
// machine.
Rgb8 area_mean(const Image& picture, const PixelBox& box);

// The first three channels, at least one pixel a side.
Image area_scaled(const Image& picture, int width, int height);

}  // namespace geometry
}  // namespace marketgen
