#include "episodes/camera_senses.h"

#include <array>
#include <numbers>

#include "render/sensor/color_noise.h"
#include "render/sensor/depth_noise.h"
#include "render/sensor/lamp_light.h"

namespace marketgen::episodes {
namespace {

render::StereoCamera stereo_of(const DepthDials& dials) {
  render::StereoCamera stereo;
  stereo.disparity_noise_px = dials.disparity_noise_px;
  stereo.edge_shift_px = dials.edge_shift_px;
  stereo.glass_holes = dials.glass_holes;
  stereo.clear_holes = dials.clear_holes;
  return stereo;
}

}  // namespace

Pose camera_error(const CalibrationDials& dials, Seed seed, std::string_view camera) {
  Stream draw = seed.child("calibration", camera).stream();
  std::array<double, 3> off{}, turned{};
  for (double& along : off)
    along = dials.camera_m * draw.normal();
  for (double& about : turned)
    about = dials.camera_deg * std::numbers::pi / 180 * draw.normal();
  return {{off[0], off[1], off[2]},
          rotation_about({1, 0, 0}, turned[0]) * rotation_about({0, 1, 0}, turned[1]) *
              rotation_about({0, 0, 1}, turned[2])};
}

Vec3f lamps_of(const LightDials& dials, Seed seed) {
  Stream draw = seed.child("light").stream();
  const double stops = draw.uniform(-dials.stops, dials.stops);
  return render::lamp_light(stops, draw.uniform(-dials.mired, dials.mired));
}

Result<render::Frame> sensed_picture(const TrackWorld& world,
                                     std::string_view camera,
                                     render::Renderer& renderer,
                                     const render::Camera& nominal,
                                     const render::RenderOptions& options) {
  const Realism& realism = world.realism();
  const CalibrationDials& dials = realism.calibration;
  render::Camera there = nominal;
  if (dials.camera_m > 0 || dials.camera_deg > 0)
    there = render::posed_camera(
        nominal.name,
        render::opencv_pose_of(nominal) * camera_error(dials, world.noise(), camera),
        render::intrinsics_of(nominal),
        nominal.width,
        nominal.height);
  render::RenderOptions lit = options;
  lit.light = options.light * lamps_of(realism.light, world.noise());
  MARKETGEN_TRY(render::Frame frame, renderer.render(there, lit));
  const render::NoiseSource source{world.noise().child("picture", camera).value(),
                                   static_cast<std::uint64_t>(world.steps())};
  if (realism.depth.stereo) {
    MARKETGEN_TRY(frame.depth_m,
                  render::noisy_depth(frame, there, stereo_of(realism.depth), source));
  }
  if (realism.color.full_well_e > 0) {
    render::ColorSensor sensor;
    sensor.full_well_e = realism.color.full_well_e;
    frame.color = render::noisy_color(frame.color, there, sensor, source);
  }
  return frame;
}

}  // namespace marketgen::episodes
