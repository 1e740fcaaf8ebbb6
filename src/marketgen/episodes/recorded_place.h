// Where a recorded episode happened and who acted in it: what is to be drawn of its motion without
// a world (episodes/motion.h).
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "render/stage/actor.h"
#include "robots/robot.h"
#include "scene/scene.h"

namespace marketgen::episodes {

struct RecordedPlace {
  // Rows of moved products and joints are its; the episode's items are not in it. Of the aisles:
  // the store itself.
  std::shared_ptr<const scene::Scene> scene;
  std::string id;  // of the places of one store; empty: the store itself
  robots::Robot robot;
  std::optional<render::Actor> basket;  // ThingKind::basket; one body
};

}  // namespace marketgen::episodes
