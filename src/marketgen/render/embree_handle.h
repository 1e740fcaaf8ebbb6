// Embree's reference-counted handles as owning pointers.
#pragma once
#include <embree3/rtcore.h>

#include <memory>

namespace marketgen::render::raytrace {

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using Bvh = std::unique_ptr<RTCSceneTy, ReleaseScene>;

}  // namespace marketgen::render::raytrace
