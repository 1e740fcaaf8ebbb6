#include "scene/reskin.h"

#include <algorithm>

#include "layout/finish.h"
#include "plan/style_look.h"

namespace marketgen::scene {
namespace {

layout::Layout in_look(layout::Layout layout,
                       const plan::Look& look,
                       const catalog::Catalog& catalog) {
  for (layout::Fixture& fixture : layout.fixtures)
    layout::change_finish(fixture, layout.look, look, catalog);
  layout.look = look;
  return layout;
}

// A plan under which nothing is stocked.
plan::Plan bare_plan(const layout::Layout& layout) {
  plan::Plan plan;
  plan.shell = layout.shell;
  for (const layout::LayoutZone& zone : layout.zones) {
    plan::Zone bare;
    bare.id = zone.id;
    bare.type = zone.type;
    bare.stock.categories = {"nothing"};
    plan.zones.push_back(std::move(bare));
  }
  return plan;
}

bool same_piece(const ScenePart& a, const ScenePart& b) {
  return a.fixture == b.fixture && a.unit == b.unit && a.shape == b.shape &&
         a.half_size_m == b.half_size_m;
}

}  // namespace

Result<Scene> reskin(Scene scene, const catalog::StyleRow& style, const catalog::Catalog& catalog) {
  layout::Layout layout = in_look(scene.layout, plan::look_of(style), catalog);
  MARKETGEN_TRY(Scene bare, build_scene(layout, bare_plan(layout), catalog, Seed(scene.seed)));
  if (!std::ranges::equal(scene.parts, bare.parts, same_piece)) {
    return Error{"scene.wrong_version",
                 "--skin",
                 "the store's fixtures were made by another version or from other rows; generate "
                 "it again with --skin"};
  }
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    ScenePart& part = scene.parts[i];
    const ScenePart& painted = bare.parts[i];
    part.kind = painted.kind;
    part.color = painted.color;
    part.roughness = painted.roughness;
    part.metallic = painted.metallic;
    part.material = painted.material;
  }
  scene.layout = std::move(layout);
  scene.materials = std::move(bare.materials);
  return scene;
}

}  // namespace marketgen::scene
