// Depth as a stereo camera measures it: noise in disparity, steps, what is too near or seen by one
// eye only, flying pixels at edges, holes where nothing can be matched.
//
// Sources:
//   disparity = fx * baseline / depth; error of depth = depth^2 * error of disparity / (fx *
//     baseline): A. Grunnet-Jepsen, J. Sweetser, J. Woodfill, "Tuning depth cameras for best
//     performance", Intel RealSense documentation; its D435 has subpixel errors below 0.1 px.
//   Disparity has five fractional bits: librealsense, proc/disparity-transform.
//   The left edge without depth, fx * baseline / depth wide, the baseline of 50 mm and the least
//     depths: "Intel RealSense D400 Series Product Family Datasheet", 337029, sections "Invalid
//     Depth Band" and "Minimum-Z Depth".
//   Neighbours are matched by windows that overlap, and err alike: two pixels share (1 - |dx| / w)
//     (1 - |dy| / w) of a window of w, and of its error. Costs are added up
//     over 7 x 7: L. Keselman et al., "Intel RealSense stereoscopic depth cameras", CVPR Workshops
//     2017, of the R200; the D400 adds semi-global matching to it, whose reach is not published.
//   Edges: depth is looked up half a pixel away at random and interpolated, A. Handa et al., "A
//     benchmark for RGB-D visual odometry, 3D reconstruction and SLAM", ICRA 2014. What is looked
//     up has grown: a window that holds an edge of something near takes its disparity (foreground
//     fattening, D. Scharstein and R. Szeliski, "A taxonomy and evaluation of dense two-frame
//     stereo correspondence algorithms", IJCV 2002), at most half a window, 3 px. One pixel is our
//     assumption for a sensor that rejects what its two eyes do not agree on.
//   What a missing match looks like on glass and clear packs (holes, and depth of what is behind):
//     S. Sajjan et al., "ClearGrasp", ICRA 2020. The shares below are our assumptions.
#pragma once
#include <vector>

#include "base/result.h"
#include "render/cameras/camera.h"
#include "render/render.h"
#include "render/sensor/sensor_noise.h"

namespace marketgen::render {

struct StereoCamera {
  double baseline_m = 0.050;
  double disparity_noise_px = 0.08;  // one sigma
  int match_window_px = 7;           // noise of pixels as far apart as this is independent
  double disparity_step_px = 1.0 / 32;
  double largest_disparity_px = 126;  // what is nearer has no depth
  double farthest_m = 10;
  double edge_shift_px = 0.5;  // one sigma
  // Shares of the surface without depth, in patches that stay where they are from frame to frame.
  double glass_holes = 0.5, clear_holes = 0.4;
  double clear_noise_factor = 3;   // of disparity_noise_px on clear packs
  double min_metal_facing = 0.35;  // cosine of the view to bare metal: below, it has no depth
  int overexposed = 250;           // all channels at least: no print to match
};

// The shortest depth that it measures, metres: fx * baseline / largest disparity. Within 10 % of
// the datasheet's 280, 195, 175 mm at widths of 1280, 848, 640.
double min_depth_m(const StereoCamera& stereo, const Intrinsics& intrinsics);

// Depth along the optical axis in metres, 0 = none, as the left eye at `camera` measures it; its
// right eye is baseline_m to the right. `frame` is what `camera` sees. Distortion is taken as
// rectified away. Error camera.degenerate: an orthographic camera.
Result<std::vector<float>> noisy_depth(const Frame& frame,
                                       const Camera& camera,
                                       const StereoCamera& stereo,
                                       const NoiseSource& source);

}  // namespace marketgen::render
