// The lens and sensor of a camera: a pinhole with a free principal point and the distortion of
// Brown and Conrady, both as OpenCV defines them.
//
// Picture points are OpenCV's, in pixels: the CENTRE of the top left pixel is (0, 0), x runs right,
// y down, so that a picture covers -0.5 .. width - 0.5. A centred lens has cx = (width - 1) / 2.
// The camera's frame is OpenCV's: x right, y down, z ahead.
//
// Source: OpenCV, "Camera Calibration and 3D Reconstruction" (calib3d), the model with the five
// coefficients k1, k2, p1, p2, k3; D. C. Brown, "Decentering distortion of lenses", 1966.
#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "geometry/vector.h"

namespace marketgen::render {

// What a lens does to the ideal image plane at distance 1.
struct LensDistortion {
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;  // OpenCV's order
  bool none() const { return k1 == 0 && k2 == 0 && p1 == 0 && p2 == 0 && k3 == 0; }
  friend constexpr bool operator==(const LensDistortion&, const LensDistortion&) = default;
};

struct Intrinsics {
  double fx = 0, fy = 0;  // focal lengths, pixels
  double cx = 0, cy = 0;  // principal point, pixels
  LensDistortion distortion;
  friend constexpr bool operator==(const Intrinsics&, const Intrinsics&) = default;
};

// Of an ideal lens in the middle of the picture, square pixels. `fov_deg` is vertical, edge to edge
// of the picture.
Intrinsics centred_pinhole(int width, int height, double fov_deg);

// Where the ideal point p = (X, Y) / Z really falls on the plane at distance 1.
Vec2 distorted(const LensDistortion& lens, Vec2 p);
// The inverse, by Newton's method; nothing where it does not converge to 1e-12.
std::optional<Vec2> undistorted(const LensDistortion& lens, Vec2 seen);

// The picture point of the point p in the camera's frame, metres; nothing behind the lens, and
// nothing where the lens has folded its image plane (which happens outside the picture of a lens
// that passes check_lens).
std::optional<Vec2> project(const Intrinsics& k, Vec3 p);

// Error camera.bad_lens: numbers that are not finite, focal lengths that are not positive, a field
// of view beyond 170 degrees, and a distortion that brings two directions to one picture point (its
// radius does not grow all the way to the picture's corners).
Result<void> check_lens(const Intrinsics& k, int width, int height, const std::string& where);

}  // namespace marketgen::render
