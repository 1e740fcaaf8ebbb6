// How alike two pictures look: structural similarity (Wang, Bovik, Sheikh, Simoncelli, "Image
// quality assessment: from error visibility to structural similarity", IEEE TIP 13(4), 2004).
#pragma once
#include "geometry/image.h"

namespace marketgen {
inline namespace geometry {

// Mean structural similarity of the two pictures' luma (BT.601, as encoded): 1 = the same, 0 =
// nothing in common, negative where light and dark have changed places. As in the paper: a Gaussian
// window of 11 x 11 pixels with a standard deviation of 1.5, K1 = 0.01, K2 = 0.03, and only windows
// that lie wholly in the picture; smaller pictures take the weights that fall into them.
// Preconditions: equal widths and heights, neither 0, and 1, 3 or 4 channels each (alpha is not
// read).
double ssim(const Image& a, const Image& b);

}  // namespace geometry
}  // namespace marketgen
