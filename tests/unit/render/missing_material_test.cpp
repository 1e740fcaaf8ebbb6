// A material that the store lacks is not hidden: a bright checker in the picture, and a warning.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/render.h"
#include "support/committed_catalog.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

// Share of pixels that are far more red and blue than green.
double magenta_share(const scene::Scene& scene) {
  const auto renderer = render::Renderer::create(scene);
  EXPECT_TRUE(renderer.ok());
  render::Camera camera;
  camera.from = {3, 1, 1.6};
  camera.at = {3, 3, 0};
  camera.width = 80;
  camera.height = 60;
  const Image picture = (*renderer)->render(camera, {})->color;
  int count = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); i += 3)
    count += picture.pixels[i] > picture.pixels[i + 1] + 80 &&
             picture.pixels[i + 2] > picture.pixels[i + 1] + 80;
  return count / (80.0 * 60.0);
}

TEST(MissingMaterial, IsDrawnAsACheckerAndSaid) {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  scene.materials = committed_catalog().materials;
  scene.layout.look.floor = scene.materials.front().id;
  testing::internal::CaptureStderr();
  EXPECT_EQ(magenta_share(scene), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr().find("checker"), std::string::npos);
  scene.layout.look.floor = "no-such-floor";
  testing::internal::CaptureStderr();
  const double share = magenta_share(scene);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 0.8);
  EXPECT_NE(said.find("material \"no-such-floor\""), std::string::npos) << said;
}

}  // namespace
}  // namespace marketgen
