// What is written in a store with full outfit: words on boards, numbers on lanes, ways out.
#include <gtest/gtest.h>

#include <numbers>

#include "render/render.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

constexpr Vec3 room_middle{4, 3, 1.4};

scene::Scene furnished(plan::Outfit outfit) {
  scene::Scene scene = empty_room(8000, 6000, 3200);
  scene.layout.outfit = outfit;
  scene.layout.look.accent = "#b01010";
  return scene;
}

// A lamp of a lane along X or along Y, in the middle of the room.
std::uint32_t add_lane(scene::Scene& scene, bool along_x) {
  const std::uint32_t lane =
      add_box_fixture(scene, {4, 3, 0}, {0, 0, 1.4F}, {0.12F, 0.045F, 0.075F});
  scene.parts.back().unit = assets::UnitKind::light;
  constexpr float half_turn = std::numbers::sqrt2_v<float> / 2;
  if (!along_x) scene.parts.back().rotation_wxyz = {half_turn, 0, 0, half_turn};
  scene.layout.fixtures.back().kind = "checkout_lane";
  scene.layout.fixtures.back().width_mm = along_x ? 3600 : 1200;
  scene.layout.fixtures.back().depth_mm = along_x ? 1200 : 3600;
  return lane;
}

struct Print {
  int coloured = 0, white = 0;
};

// Of the pixels that show what `id` is of; of all pixels without one.
Print print_seen(const scene::Scene& scene, Vec3 from, Vec3 at, std::optional<std::uint32_t> id) {
  const auto renderer = render::Renderer::create(scene).value();
  render::Camera camera;
  camera.from = from;
  camera.at = at;
  camera.width = camera.height = 120;
  camera.fov_deg = 12;
  const render::Frame frame = renderer->render(camera, {}).value();
  Print print;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      if (id && frame.instance[static_cast<std::size_t>(y * camera.width + x)] != *id) continue;
      const auto* rgb = frame.color.at(x, y);
      const int low = std::min({rgb[0], rgb[1], rgb[2]}), high = std::max({rgb[0], rgb[1], rgb[2]});
      if (low > 190) ++print.white;
      if (high > 2 * low) ++print.coloured;
    }
  }
  return print;
}

TEST(Signs, TheLampOfALaneHasItsNumberOnBothSides) {
  for (const bool along_x : {true, false}) {
    const Vec3 aside = along_x ? Vec3{0, 1.4, 0} : Vec3{1.4, 0, 0};
    scene::Scene plain = furnished(plan::Outfit::plain), full = furnished(plan::Outfit::full);
    const std::uint32_t lane = add_lane(plain, along_x);
    ASSERT_EQ(add_lane(full, along_x), lane);
    for (const Vec3 from : {room_middle + aside, room_middle - aside}) {
      EXPECT_LT(print_seen(plain, from, room_middle, lane).coloured, 5);
      const Print number = print_seen(full, from, room_middle, lane);
      EXPECT_GT(number.coloured, 300) << along_x << " from " << from.x << ", " << from.y;
      EXPECT_GT(number.white, 30) << along_x << " from " << from.x << ", " << from.y;
    }
  }
}

TEST(Signs, OverTheEndOfARunStandsTheNameOfItsZone) {
  for (const plan::Outfit outfit : {plan::Outfit::plain, plan::Outfit::full}) {
    scene::Scene scene = furnished(outfit);
    const std::uint32_t end = add_box_fixture(scene, {4, 3, 0}, {0, 0, 1.4F}, {0.4F, 0.02F, 0.08F});
    scene.parts.back().unit = assets::UnitKind::header;
    layout::Fixture& fixture = scene.layout.fixtures.back();
    fixture.endcap_of = fixture.run;
    layout::LayoutZone& zone = scene.layout.zones.emplace_back();
    zone.id = fixture.zone;
    zone.label = "Dairy";
    const Print front = print_seen(scene, room_middle - Vec3{0, 2.5, 0}, room_middle, end);
    const Print behind = print_seen(scene, room_middle + Vec3{0, 2.5, 0}, room_middle, end);
    EXPECT_EQ(front.coloured > 300 && front.white > 30, outfit == plan::Outfit::full);
    EXPECT_LT(behind.coloured, 5);
  }
}

TEST(Signs, AGreenBoardHangsOverTheWayOut) {
  for (const plan::Outfit outfit : {plan::Outfit::plain, plan::Outfit::full}) {
    scene::Scene scene = furnished(outfit);
    scene.layout.look.accent = "#ffffff";
    plan::Opening door;
    door.kind = plan::OpeningKind::exit;
    door.width_mm = 1800;
    scene.layout.shell.openings.push_back(door);
    const Print board = print_seen(scene, {4, 2.5, 1.6}, {4, 0, 2.3}, std::nullopt);
    EXPECT_EQ(board.coloured > 100, outfit == plan::Outfit::full) << board.coloured;
  }
}

}  // namespace
}  // namespace marketgen
