#include "render/picture_objects.h"
#include "render/stage/build_signage.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float min_board_m = 0.3F, min_letters_m = 0.08F;  // smaller parts stay blank
constexpr int letters_px = 160;
constexpr std::string_view invitation = "Try it today";
constexpr float number_width = 0.7F;  // of a lamp's face: light comes past it on both sides

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

bool is_lamp(const scene::ScenePart& part) {
  return part.unit == assets::UnitKind::light && part.shape == assets::PartShape::box;
}

}  // namespace

BoardLetters::BoardLetters(Draft& draft) {
  const layout::Layout& layout = draft.scene().layout;
  if (layout.outfit != plan::Outfit::full) return;
  for (std::uint32_t f = 0; f < draft.scene().fixtures.size(); ++f)
    write(draft, {f, words_on(layout, layout.fixtures[f]), is_board, false, 1});
  const std::vector<std::uint32_t> lanes = lanes_in_order(layout);
  for (std::size_t i = 0; i < lanes.size(); ++i)
    write(draft, {lanes[i], std::to_string(i + 1), is_lamp, true, number_width});
}

void BoardLetters::write(Draft& draft, const Words& words) {
  if (words.text.empty()) return;
  const scene::SceneFixture& row = draft.scene().fixtures[words.fixture];
  for (std::uint32_t p = row.first_part; p < row.first_part + row.part_count; ++p) {
    const scene::ScenePart& part = draft.scene().parts[p];
    if (!words.are_on(part)) continue;
    const float half_width = words.share * part.half_size_m[0], half_height = part.half_size_m[2];
    const std::uint16_t material = sign_material(draft,
                                                 words.text,
                                                 draft.scene().layout.look.accent,
                                                 2 * half_width,
                                                 2 * half_height,
                                                 letters_px);
    boards_.push_back({words.fixture, p, material, half_width, words.both_sides});
  }
}

void BoardLetters::build(Draft& draft) const {
  World& world = draft.world();
  for (const Board& board : boards_) {
    const scene::ScenePart& part = draft.scene().parts[board.part];
    const float y = part.half_size_m[1], z = part.half_size_m[2];
    // x to the left of who looks at the face, y towards them.
    const Placement front{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {}}, behind{};
    Mesh mesh;
    const auto add = [&](const Placement& face) {
      add_wall_picture(mesh, face, -board.half_width, board.half_width, y + 1e-3F, -z, z, 0);
    };
    add(front);
    if (board.both_sides) add(behind);
    TracedMesh traced;
    append(traced.solid, traced.glass, mesh, {board.material}, world, {});
    Instance instance;
    instance.mesh = static_cast<std::uint32_t>(world.meshes.size());
    instance.id = first_fixture_object + board.fixture;
    instance.fixture = static_cast<std::int32_t>(board.fixture);
    instance.world_from_mesh = placement_of(
        scene::world_from_fixture(draft.scene(), board.fixture) * scene::fixture_from_part(part));
    world.meshes.push_back(std::move(traced));
    world.instances.push_back(instance);
  }
}

}  // namespace marketgen::render::raytrace
