// Goods as a catalogue shows them.
#pragma once
#include <memory>
#include <string>

#include "base/result.h"
#include "render/render.h"
#include "scene/scene.h"

namespace marketgen::render {

// As Renderer::create, with goods that nobody has handled: without the tint of a print batch and
// the wear by which items of one product differ, so that a product looks the same whatever else is
// in the scene.
Result<std::unique_ptr<Renderer>> create_catalogue_renderer(const scene::Scene& scene);

// Changes with the sources that shape and draw goods, and that light and render them.
std::string drawing_key();

}  // namespace marketgen::render
