// Packs of clear glass or plastic, as path tracing draws them: the wall bends light into a clear
// liquid, above what it holds it is a thin sheet, and the contents have a surface. Labels and caps
// stay as they are.
//
// The outline does not change. Whoever takes walls for opaque sees the pack as before: new
// triangles lie behind the wall.
#pragma once
#include "assets/product_model.h"
#include "render/stage/world.h"

namespace marketgen::render::raytrace {

// Labels seen from within the pack.
constexpr Vec3f label_back{0.7F, 0.7F, 0.68F};

// The wall before a clear liquid, of a surface with a refraction: `material` plus what light does
// in the liquid. The surface's colour is what is left of white light after crossing `depth_m` of it
// twice, in and out again, as one sees a pack.
Material liquid_material(const marketgen::assets::Surface& surface,
                         Material material,
                         float depth_m);
// The wall above the contents: an empty surface.
Material sheet_material(Material material);

// The mesh with the surface of what the pack holds, level and facing up, behind the triangles of
// the model; the mesh itself when nothing in it is seen.
Mesh with_level(const assets::ProductModel& model);

}  // namespace marketgen::render::raytrace
