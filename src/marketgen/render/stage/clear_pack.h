// Packs of clear glass or plastic with a clear liquid in them, as path tracing draws them: below
// the fill height the wall bends light into the liquid, above it is a thin sheet, and the liquid
// has a surface. Labels and caps stay as they are.
//
// The outline does not change. Whoever takes walls for opaque sees the pack as before: new
// triangles lie behind the wall.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "assets/product_model.h"
#include "render/stage/world.h"

namespace marketgen::render::raytrace {

// Labels seen from within the pack.
constexpr Vec3f label_back{0.7F, 0.7F, 0.68F};

// Whether light passes any wall of the pack.
bool is_clear_pack(const assets::ProductModel& model);

// The materials of a clear surface, by the number of its opaque look: `material` plus what light
// does in it. The colour is what is left of white
// light after crossing `depth_m` of the liquid twice, in and out again, as one sees a pack.
struct ClearMaterials {
  Material liquid, sheet;
};
ClearMaterials clear_materials(const marketgen::assets::Surface& surface,
                               const Material& look,
                               float depth_m);

// The mesh with its clear surfaces parted at the fill height: clear surface k keeps its number
// below it, and has number sheet_of[k] above. The liquid's surface has the number of the first.
struct ClearPack {
  Mesh mesh;
  std::vector<std::uint16_t> sheet_of;  // by surface; of opaque ones their own number
  std::uint16_t surface_count = 0;
  std::size_t outline_triangles = 0;  // the mesh's first so many; the rest is the liquid's surface
};
ClearPack clear_pack(const assets::ProductModel& model);

}  // namespace marketgen::render::raytrace
