// What the robot's cameras take in a running episode: the one place where a rendered picture
// becomes one that an agent is shown.
#pragma once
#include <string_view>

#include "episodes/track_world.h"
#include "render/render.h"

namespace marketgen::episodes {

// How far off the camera is: nominal_from_true, in its own frame (OpenCV's axes). The same
// throughout an episode.
Pose camera_error(const CalibrationDials& dials, Seed seed, std::string_view camera);

// The lamps' light, for RenderOptions::light. The same throughout an episode.
Vec3f lamps_of(const LightDials& dials, Seed seed);

// What the robot's camera of that name, which the agent takes for standing as `nominal` says, sees
// in the world now: taken from where it truly is; depth and colour as its sensors record them, with
// noise that each control step has anew. Holes on glass and clear packs stay where they are in the
// picture. With ideal realism it is what the renderer gives. Errors: those of Renderer::render.
Result<render::Frame> sensed_picture(const TrackWorld& world,
                                     std::string_view camera,
                                     render::Renderer& renderer,
                                     const render::Camera& nominal,
                                     const render::RenderOptions& options);

}  // namespace marketgen::episodes
