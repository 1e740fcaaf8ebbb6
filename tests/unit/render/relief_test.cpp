// Normals and gloss from textures: known answers.
#include <gtest/gtest.h>

#include <cmath>

#include "render/stage/relief_texture.h"
#include "render/stage/world.h"

namespace marketgen::render::raytrace {
namespace {

// Two channels of tilt, roughness and metallic, all texels alike unless changed.
Image flat_relief(int size, std::uint8_t roughness) {
  Image image(size, size, 4);
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    image.pixels[i] = image.pixels[i + 1] = 128;
    image.pixels[i + 2] = roughness;
    image.pixels[i + 3] = 255;
  }
  return image;
}

TEST(ReliefTexture, FlatSurfacesKeepTheirGlossAtEveryDistance) {
  const ReliefTexture texture(flat_relief(64, 51), 0);
  for (const float lod : {0.0F, 2.5F, 6.0F}) {
    const Relief relief = texture.sample(0.3F, 0.7F, lod);
    EXPECT_EQ(relief.tilt_x, 0);
    EXPECT_EQ(relief.tilt_y, 0);
    EXPECT_NEAR(relief.roughness, 0.2F, 0.005F);
    EXPECT_FLOAT_EQ(relief.metallic, 1);
  }
}

TEST(ReliefTexture, RidgesThatRunTogetherBecomeRoughness) {
  Image image = flat_relief(64, 51);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x)
      *image.at(x, y) = x % 2 == 0 ? 166 : 90;  // tilt of 0.298 each way
  }
  const ReliefTexture texture(image, 0);
  EXPECT_NEAR(texture.sample(0.5F / 64, 0.5F, 0).tilt_x, 0.298F, 0.003F);
  const Relief far = texture.sample(0.5F, 0.5F, 3);
  EXPECT_NEAR(far.tilt_x, 0, 0.004F);
  // alpha squared = 0.2^4 + 0.298^2, roughness its fourth root.
  EXPECT_NEAR(far.roughness, std::pow(0.0016 + 0.298 * 0.298, 0.25), 0.01);
}

struct Corners {
  std::array<Vec3f, 3> positions;
  std::array<Vec2f, 3> uvs;
};

void expect_axes(const Corners& t, Vec3f normal, Vec3f along, Vec3f up) {
  const TextureAxes axes = texture_axes(packed_tangent(t.positions, t.uvs, normal), normal);
  EXPECT_NEAR(length(axes.along - along), 0, 4e-4F);
  EXPECT_NEAR(length(axes.up - up), 0, 4e-4F);
}

TEST(PackedTangent, OfAFloorWhoseRowsRunEast) {  // v grows southwards: the top is north
  expect_axes({{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}, {{{0, 0}, {1, 0}, {0, -1}}}},
              {0, 0, 1},
              {1, 0, 0},
              {0, 1, 0});
}

TEST(PackedTangent, OfACeilingSeenMirrored) {  // the same rows from below
  expect_axes({{{{0, 0, 3}, {0, 2, 3}, {2, 0, 3}}}, {{{0, 0}, {0, -1}, {1, 0}}}},
              {0, 0, -1},
              {1, 0, 0},
              {0, 1, 0});
}

TEST(PackedTangent, OfAWallTurnedInItsTexture) {  // rows run down the wall, columns to the east
  expect_axes({{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}}, {{{0, 0}, {0, 1}, {-1, 0}}}},
              {0, -1, 0},
              {0, 0, -1},
              {-1, 0, 0});
}

}  // namespace
}  // namespace marketgen::render::raytrace
