// A shape shown in a room beside what its scene has: for pictures of the asset library.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/mesh.h"
#include "render/render.h"

namespace marketgen::render::raytrace {

struct Exhibit {
  Mesh mesh;             // in the store frame; all of it of one material
  std::string material;  // a row of the scene's materials, tiled by the mesh's UVs
};

// Renderer::create with exhibits in the room.
Result<std::unique_ptr<Renderer>> create_renderer(const scene::Scene& scene,
                                                  const std::vector<Exhibit>& exhibits,
                                                  Progress& progress,
                                                  const RendererOptions& options = {});

}  // namespace marketgen::render::raytrace
