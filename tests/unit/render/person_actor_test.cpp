// People in pictures: as tall as they are, of a category of their own.
#include "render/stage/person_actor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/seed.h"
#include "render/annotations.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

assets::PlacedPerson standing_person(std::uint64_t seed, Vec3 at) {
  const assets::PersonLook look =
      assets::draw_person(assets::PersonRole::shopper, {0, 0.3F, 0}, Seed(seed));
  return {look, assets::standing_pose(look), {at, rotation_about({0, 0, 1}, -1.5707963267948966)}};
}

struct PeopleStage {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  std::unique_ptr<render::Renderer> renderer = render::Renderer::create(scene).value();
  render::Camera camera;

  PeopleStage() {
    camera.from = {3, 1, 1};
    camera.at = {3, 4, 1};
    camera.width = 301, camera.height = 401;
  }
};

TEST(PersonActor, IsAsTallInThePictureAsInTheRoom) {
  PeopleStage stage;
  const assets::PlacedPerson person = standing_person(3, {3, 4, 0});
  const std::vector<render::Actor> actors{render::person_actor(person)};
  ASSERT_TRUE(render::check_actor(actors[0]).ok());
  ASSERT_TRUE(stage.renderer->set_actors(actors).ok());
  const render::Frame frame = stage.renderer->render(stage.camera, {}).value();
  const auto seen = render::annotate(
      frame, stage.camera, stage.scene, *stage.renderer, render::picture_actors(actors));
  const auto found = std::find_if(seen.objects.begin(), seen.objects.end(), [](const auto& object) {
    return object.kind == render::ObjectKind::actor;
  });
  ASSERT_NE(found, seen.objects.end());
  EXPECT_EQ(found->name, "person");
  EXPECT_EQ(found->category, "person");
  EXPECT_EQ(found->category_id, seen.categories.back().id);
  const double metre_px = seen.matrices.k[1][1] / 3;
  const double height_m = (found->box_px[3] - found->box_px[1]) / metre_px;
  EXPECT_NEAR(height_m, person.look.stature_m + 0.03, 0.10);
  EXPECT_NEAR(found->depth_m, 2.95, 0.15);
}

TEST(PersonActor, RobotsKeepTheirCategoryBesidePeople) {
  const scene::Scene scene = empty_room(6000, 6000, 3000);
  const render::PictureCategories plain(scene), mixed(scene, {"actor", "person", "actor"});
  const std::uint32_t first = render::first_actor_object(scene);
  EXPECT_EQ(plain.of(first), 2);
  EXPECT_EQ(mixed.of(first), 2);
  EXPECT_EQ(mixed.of(first + 1), mixed.rows().back().id);
  EXPECT_EQ(mixed.of(first + 2), 2);
  EXPECT_EQ(mixed.rows().size(), plain.rows().size() + 1);
  EXPECT_EQ(mixed.rows().back().name, "person");
}

TEST(PersonActor, LightThatWandersTooFarIsRefused) {
  render::Actor actor =
      render::person_actor(standing_person(1, {3, 4, 0}), assets::PersonDetail::far);
  actor.bodies[0].surfaces[0].scatter_m = -1;
  EXPECT_EQ(render::check_actor(actor).error().code, "render.bad_actor");
}

}  // namespace
}  // namespace marketgen
