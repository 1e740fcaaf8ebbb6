// Pictures of a recorded episode, as the cameras of its station take them: exact, without what a
// realism puts between the world and the robot.
#pragma once
#include <string_view>
#include <vector>

#include "episodes/late_senses.h"
#include "episodes/motion.h"
#include "render/render.h"

namespace marketgen::episodes {

// Where everything was at a control step: of products those that had moved by then, of the items
// all. `first_item`: row of the first item in the view's scene. Precondition: step < steps.
Scenery scenery_at(const Motion& motion, std::size_t step, std::uint32_t first_item);
// Joints that had moved by then.
std::vector<render::MovedJoint> joints_at(const Motion& motion, std::size_t step);

// Not thread-safe.
class RecordedView {
 public:
  virtual ~RecordedView() = default;
  // 0: as many pixels as the station's row says. Errors: camera.unknown, render.bad_move; those of
  // Renderer::render.
  virtual Result<Image> picture(std::string_view camera,
                                std::size_t step,
                                int width = 0,
                                int height = 0) = 0;
};

}  // namespace marketgen::episodes
