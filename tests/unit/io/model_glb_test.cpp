// Kept models: one picture, one file, nothing lost.
#include "io/model_glb.h"

#include <gtest/gtest.h>

#include "support/run_program.h"

namespace marketgen {
namespace {

Image plain(int width, int height, Rgb8 color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y)[0] = color.r;
      image.at(x, y)[1] = color.g;
      image.at(x, y)[2] = color.b;
    }
  }
  return image;
}

// Two squares side by side: the first shows a red picture, the second a white one under half-bright
// green; both share two vertices.
io::OutsideModel two_squares() {
  io::OutsideModel model;
  for (int i = 0; i < 6; ++i) {
    const auto column = static_cast<float>(i % 3), row = static_cast<float>(i / 3);
    model.mesh.add_vertex({column, row, 0}, {0, 0, 1}, {column, 1 - row});
  }
  model.mesh.add_triangle(0, 1, 4, 0);
  model.mesh.add_triangle(0, 4, 3, 0);
  model.mesh.add_triangle(1, 2, 5, 1);
  model.mesh.add_triangle(1, 5, 4, 1);
  model.materials = {
      {.name = "red", .picture = 0}, {.name = "green", .picture = 1}, {.name = "none"}};
  model.materials[0].color = {1, 1, 1};
  model.materials[1].color = {0, 0.5F, 0};
  model.materials[2].color = {0.25F, 0.5F, 0.75F};
  model.pictures = {plain(8, 8, {255, 0, 0}), plain(4, 2, {255, 255, 255}), plain(2, 2, {1, 2, 3})};
  return model;
}

Rgb8 color_at(const Image& image, Vec2f uv) {
  const auto at = [](float v, int size) {
    return std::min(size - 1, static_cast<int>(v * static_cast<float>(size)));
  };
  const std::uint8_t* p = image.at(at(uv.x, image.width), at(uv.y, image.height));
  return {p[0], p[1], p[2]};
}

TEST(MergePictures, EveryCornerStillShowsItsColour) {
  io::OutsideModel model = two_squares();
  io::merge_pictures(model);
  ASSERT_EQ(model.pictures.size(), 1U);  // and the picture that nothing shows is gone
  EXPECT_EQ(model.pictures[0].width, 8);
  for (std::size_t t = 0; t < 4; ++t) {
    for (const std::uint32_t vertex : model.mesh.triangles[t]) {
      // 0.5 in linear light is 188 in sRGB (IEC 61966-2-1).
      const Rgb8 expected = t < 2 ? Rgb8{255, 0, 0} : Rgb8{0, 188, 0};
      EXPECT_EQ(color_at(model.pictures[0], model.mesh.uvs[vertex]), expected) << t;
    }
  }
  EXPECT_EQ(model.materials[1].picture, 0);
  EXPECT_EQ(model.materials[1].color, (Vec3f{1, 1, 1}));
  EXPECT_EQ(model.materials[2].picture, -1);
  EXPECT_TRUE(model.remarks.empty());  // the second square is a whole repeat away: moved, not cut
}

TEST(MergePictures, OneRepeatingPictureStaysAsItIs) {
  io::OutsideModel model = two_squares();
  for (std::uint16_t& surface : model.mesh.surfaces)
    surface = 0;
  io::merge_pictures(model);
  EXPECT_EQ(model.pictures.at(0).pixels, plain(8, 8, {255, 0, 0}).pixels);
  EXPECT_EQ(bounds_of(model.mesh).size().x, 2);
  EXPECT_EQ(model.mesh.uvs[model.mesh.triangles[2][1]].x, 2);
}

TEST(EncodeGlb, ReadsBackAsItWas) {
  io::OutsideModel model = two_squares();
  model.materials[2].clear = true;
  model.mesh.surfaces[3] = 2;
  io::merge_pictures(model);
  model.pieces = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                  {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {2, 0, 1}}};
  const auto bytes = io::encode_glb(model, "squares");
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(*bytes, *io::encode_glb(model, "squares"));
  const auto read = io::parse_glb(*bytes, "again");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->mesh.triangles.size(), 4U);
  EXPECT_NEAR(bounds_of(read->mesh).size().x, 2, 1e-6);
  EXPECT_NEAR(bounds_of(read->mesh).size().y, 1, 1e-6);
  EXPECT_EQ(read->pictures.at(0).pixels, model.pictures.at(0).pixels);
  ASSERT_EQ(read->pieces.size(), 2U);
  EXPECT_NEAR(read->pieces[1][1].x, 3, 1e-6);
  const io::ModelMaterial& clear = read->materials.at(read->mesh.surfaces[3]);
  EXPECT_TRUE(clear.clear);
  EXPECT_FLOAT_EQ(clear.color.z, 0.75F);
}

}  // namespace
}  // namespace marketgen
