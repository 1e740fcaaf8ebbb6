// Whether a camera stands where one can: in the store, and in nothing solid.
#pragma once
#include <string>

#include "base/result.h"
#include "render/cameras/camera.h"
#include "scene/scene.h"

namespace marketgen::render {

// Renderer::render() takes a camera anywhere; whoever places one asks here first. Orthographic
// views stand nowhere and always pass. Products count by their meshes, fixtures by their parts,
// columns as boxes; signs, lamps and actors do not count (a wrist camera sits in its robot).
// Errors: camera.outside_store; camera.inside_object, which names the object.
Result<void> check_viewpoint(const scene::Scene& scene,
                             const Camera& camera,
                             const std::string& where);

}  // namespace marketgen::render
