// What an agent sees with: cameras whose place and lens it knows, as a calibrated robot does.
//
// Nothing is taken that nobody asks for. Base frame: that of the robot's arm. Metres.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/image.h"
#include "geometry/pose.h"

namespace marketgen::agent {

// Picture points are OpenCV's: the centre of the top left pixel is (0, 0).
struct PinholeLens {
  double fx = 0, fy = 0, cx = 0, cy = 0;  // pixels
};

// One picture with depth. The camera's frame is OpenCV's: x right, y down, z ahead.
struct View {
  std::string camera;
  double time_s = 0;  // when it was taken, on the clock of Observation::time_s
  PinholeLens lens;
  Pose base_from_camera;  // then
  Image color;
  std::vector<float> depth_m;  // along the optical axis, row-major; 0 = none

  int width() const { return color.width; }
  int height() const { return color.height; }
};

class Eyes {
 public:
  virtual ~Eyes() = default;
  // As things stand now, or stood a little before where pictures come late. Errors: usage.bad_flag
  // for a camera that the agent does not have; what the camera reports.
  virtual Result<View> look(std::string_view camera) = 0;
};

}  // namespace marketgen::agent
