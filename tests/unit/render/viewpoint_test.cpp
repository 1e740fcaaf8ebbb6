// Where a camera may stand.
#include "render/cameras/viewpoint.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "catalog/catalog.h"
#include "io/file.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

Error refusal(const scene::Scene& scene, Vec3 eye) {
  render::Camera camera;
  camera.from = eye;
  camera.at = eye + Vec3{1, 0, 0};
  const Result<void> checked = render::check_viewpoint(scene, camera, "--from");
  return checked.ok() ? Error{} : checked.error();
}

TEST(Viewpoint, StandsInTheRoomOnly) {
  const scene::Scene scene = empty_room(6000, 4000, 3000);
  EXPECT_EQ(refusal(scene, {3, 2, 1.5}).code, "");
  for (const Vec3 outside : {Vec3{-0.1, 2, 1.5},
                             {6.1, 2, 1.5},
                             {3, 4.2, 1},
                             {3, 2, 3.1},
                             {3, 2, -0.01},
                             Vec3{1e9, 0, 1}}) {
    EXPECT_EQ(refusal(scene, outside).code, "camera.outside_store") << outside.x;
  }
  EXPECT_NE(refusal(scene, {-0.1, 2, 1.5}).message.find("0 to 6 m east"), std::string::npos);
  render::Camera top;
  top.from = {3, 2, 50};
  top.at = {3, 2, 0};
  top.ortho_height_m = 4;
  EXPECT_TRUE(render::check_viewpoint(scene, top, "--camera").ok());
}

// An L: the room's bounds hold the point, its outline does not.
TEST(Viewpoint, TheOutlineCountsNotItsBounds) {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  scene.layout.shell.outline_mm =
      PolygonMm{{0, 0}, {6000, 0}, {6000, 3000}, {3000, 3000}, {3000, 6000}, {0, 6000}};
  EXPECT_EQ(refusal(scene, {2, 5, 1}).code, "");
  EXPECT_EQ(refusal(scene, {5, 5, 1}).code, "camera.outside_store");
}

TEST(Viewpoint, NotInAFixtureOrAColumn) {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  add_box_fixture(scene, {3, 3, 0}, {0, 0, 0.5F}, {0.5F, 0.2F, 0.5F});
  scene.layout.shell.columns.push_back({1000, 1000, 400});
  const Error held = refusal(scene, {3.3, 3.1, 0.9});
  EXPECT_EQ(held.code, "camera.inside_object");
  EXPECT_NE(held.message.find(scene.layout.fixtures[0].id), std::string::npos) << held.message;
  EXPECT_EQ(refusal(scene, {3.3, 3.1, 1.1}).code, "");  // above it
  EXPECT_EQ(refusal(scene, {1.1, 0.9, 1.5}).code, "camera.inside_object");
  EXPECT_EQ(refusal(scene, {1.3, 0.9, 1.5}).code, "");
}

// Beside the neck of a bottle is in its box and not in the bottle.
TEST(Viewpoint, ProductsCountByTheirShape) {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  const catalog::Catalog catalog = catalog::load_catalog(io::data_folder().value()).value();
  const auto bottle =
      std::find_if(catalog.products.begin(), catalog.products.end(), [](const catalog::Product& p) {
        return p.archetype == "wine_bottle";
      });
  ASSERT_NE(bottle, catalog.products.end());
  scene.catalog.push_back(*bottle);
  scene::SceneProduct item;
  item.position_m = {3, 3, 1};
  item.facing = 0xFFFFFFFF;
  scene.products.push_back(item);
  const double r = bottle->width_m() / 2, h = bottle->height_m();
  EXPECT_EQ(refusal(scene, {3, 3, 1 + 0.3 * h}).code, "camera.inside_object");
  EXPECT_EQ(refusal(scene, {3 + 0.8 * r, 3, 1 + 0.3 * h}).code, "camera.inside_object");
  EXPECT_EQ(refusal(scene, {3, 3, 1 + 0.95 * h}).code, "camera.inside_object");
  EXPECT_EQ(refusal(scene, {3 + 0.8 * r, 3, 1 + 0.95 * h}).code, "");
  EXPECT_EQ(refusal(scene, {3 + 1.2 * r, 3, 1 + 0.3 * h}).code, "");
}

}  // namespace
}  // namespace marketgen
