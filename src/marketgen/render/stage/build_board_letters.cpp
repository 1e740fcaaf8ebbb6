#include "render/picture_objects.h"
#include "render/stage/build_signage.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float min_board_m = 0.3F, min_letters_m = 0.08F;  // smaller parts stay blank
constexpr int letters_px = 160;
constexpr std::string_view invitation = "Try it today";

// Nothing where the fixture's boards stay as they are.
std::string words_on(const layout::Layout& layout, const layout::Fixture& fixture) {
  if (fixture.kind.starts_with("tasting")) return std::string(invitation);
  const layout::LayoutZone* zone = layout::find_zone(layout, fixture.zone);
  return fixture.endcap_of.empty() || zone == nullptr ? "" : zone->label;
}

// A board upright along the front, large enough to be read.
bool is_board(const scene::ScenePart& part) {
  const bool named = part.unit == assets::UnitKind::header || part.unit == assets::UnitKind::sign;
  const bool upright = part.rotation_wxyz[0] > 0.999F;
  return named && upright && part.shape == assets::PartShape::box &&
         2 * part.half_size_m[0] >= min_board_m && 2 * part.half_size_m[2] >= min_letters_m;
}

}  // namespace

BoardLetters::BoardLetters(Draft& draft) {
  const scene::Scene& scene = draft.scene();
  if (scene.layout.outfit != plan::Outfit::full) return;
  for (std::uint32_t f = 0; f < scene.fixtures.size(); ++f) {
    const std::string words = words_on(scene.layout, scene.layout.fixtures[f]);
    if (words.empty()) continue;
    const scene::SceneFixture& row = scene.fixtures[f];
    for (std::uint32_t p = row.first_part; p < row.first_part + row.part_count; ++p) {
      const scene::ScenePart& part = scene.parts[p];
      if (!is_board(part)) continue;
      boards_.push_back({f,
                         p,
                         sign_material(draft,
                                       words,
                                       scene.layout.look.accent,
                                       2 * part.half_size_m[0],
                                       2 * part.half_size_m[2],
                                       letters_px)});
    }
  }
}

void BoardLetters::build(Draft& draft) const {
  World& world = draft.world();
  for (const Board& board : boards_) {
    const scene::ScenePart& part = draft.scene().parts[board.part];
    const auto& [x, y, z] = part.half_size_m;
    const auto& at = part.position_m;
    // x to the left of who looks at the front, y towards them.
    const Placement front{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {at[0], at[1], at[2]}};
    Mesh mesh;
    add_wall_picture(mesh, front, -x, x, y + 1e-3F, -z, z, 0);
    TracedMesh traced;
    append(traced.solid, traced.glass, mesh, {board.material}, world, {});
    Instance instance;
    instance.mesh = static_cast<std::uint32_t>(world.meshes.size());
    instance.id = first_fixture_object + board.fixture;
    instance.fixture = static_cast<std::int32_t>(board.fixture);
    instance.world_from_mesh =
        placement_of(scene::world_from_fixture(draft.scene(), board.fixture));
    world.meshes.push_back(std::move(traced));
    world.instances.push_back(instance);
  }
}

}  // namespace marketgen::render::raytrace
