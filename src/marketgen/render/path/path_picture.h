// Whole pictures by path tracing: passes of paths until there are enough, noise taken out, exposed.
#pragma once
#include "base/progress.h"
#include "render/path/path.h"
#include "render/render.h"

namespace marketgen::render::raytrace {

// The picture that `view` sees. Reports one stage "paths"; looks for interrupts after every tile.
// options.time_s ends the work between passes. Errors: internal.interrupted; usage.unavailable
// (denoiser). Pixels are identical for any thread count, unless time_s is set or the denoiser is
// neural.
Result<Frame> path_picture(const PathScene& scene,
                           const View& view,
                           const RenderOptions& options,
                           Progress& progress);

// Paths a pixel that a quality asks for, and whether they end in stored light.
struct PathEffort {
  int paths = 24;
  bool end_in_stored_light = true;
};
PathEffort path_effort(Quality quality);

}  // namespace marketgen::render::raytrace
