// Annotations: boxes, hidden shares, poses and masks of crates whose pictures are known.
#include "render/annotations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/seed.h"
#include "render/channel_pictures.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

render::Actor crate(std::string name, Vec3 middle, Vec3f half) {
  render::ActorBody body;
  body.name = "body";
  add_box(body.mesh, -half, half, 0, 0);
  body.surfaces.push_back({});
  body.world_from_body.position = middle;
  return {std::move(name), {body}};
}

// The run lengths behind COCO's characters.
std::vector<std::uint32_t> read_runs(const std::string& text) {
  std::vector<std::uint32_t> runs;
  for (std::size_t at = 0; at < text.size();) {
    std::int64_t value = 0;
    int shift = 0;
    for (bool more = true; more; ++at, shift += 5) {
      const std::int64_t group = text[at] - '0';
      value |= (group & 31) << shift;
      more = (group & 32) != 0;
      if (!more && (group & 16) != 0) value |= -(std::int64_t{1} << (shift + 5));
    }
    if (runs.size() > 2) value += runs[runs.size() - 2];
    runs.push_back(static_cast<std::uint32_t>(value));
  }
  return runs;
}

// Two crates before the wall of a room, one half before the other, and a shelf.
struct Stage {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  std::uint32_t shelf = add_box_fixture(scene, {5, 5.5F, 0}, {0, 0, 0.5F}, {0.5F, 0.2F, 0.5F});
  std::unique_ptr<render::Renderer> renderer = render::Renderer::create(scene).value();
  render::Camera camera;
  std::vector<render::PictureActor> named;

  Stage() {
    camera.from = {3, 1, 0.8};
    camera.at = {3, 2, 0.8};
    camera.width = 401, camera.height = 301;
  }

  render::PictureAnnotations annotated(const std::vector<render::Actor>& actors) {
    EXPECT_TRUE(renderer->set_actors(actors).ok());
    for (const render::Actor& actor : actors)
      named.push_back({actor.name, actor.bodies[0].world_from_body});
    frame = renderer->render(camera, {}).value();
    return render::annotate(frame, camera, scene, *renderer, named);
  }
  const render::ObjectAnnotation& of(const render::PictureAnnotations& all,
                                     const std::string& name) const {
    for (const render::ObjectAnnotation& object : all.objects) {
      if (object.name == name) return object;
    }
    ADD_FAILURE() << "there is no " << name;
    return all.objects.front();
  }
  render::Frame frame;
};

TEST(Annotations, SayWhatEachObjectIs) {
  Stage stage;
  const auto all = stage.annotated({crate("crate", {3.1, 2, 0.8}, {0.1F, 0.1F, 0.1F})});
  ASSERT_EQ(all.objects.size(), 3U);
  EXPECT_EQ(all.objects[0].kind, render::ObjectKind::shell);
  EXPECT_FALSE(all.objects[0].camera_from_object);
  EXPECT_FALSE(all.objects[0].full_box_px);
  EXPECT_EQ(all.objects[1].id, stage.shelf);
  EXPECT_EQ(all.objects[1].name, stage.scene.layout.fixtures[0].id);
  EXPECT_EQ(all.objects[1].category, "gondola");
  EXPECT_EQ(all.categories[all.objects[1].category_id - 1U].name, "gondola");
  EXPECT_FALSE(all.objects[1].hidden);
  EXPECT_EQ(all.objects[2].kind, render::ObjectKind::actor);
  EXPECT_EQ(all.objects[2].id, render::first_actor_object(stage.scene));
  EXPECT_EQ(all.objects[2].category, "actor");
  const std::vector<std::uint16_t> categories =
      render::category_ids(stage.frame, render::PictureCategories(stage.scene));
  const auto pixel = static_cast<std::size_t>(150 * 401 + all.objects[2].box_px[0] + 3);
  EXPECT_EQ(categories[pixel], all.objects[2].category_id);
}

// Its face is 0.9 m away and 0.2 m wide; fy = 301 / 2 / tan(30 deg) = 260.67.
TEST(Annotations, BoxesAndDepthAreThoseOfTheFormula) {
  Stage stage;
  const auto all = stage.annotated({crate("crate", {3.0, 2, 0.8}, {0.1F, 0.1F, 0.1F})});
  const render::ObjectAnnotation& found = stage.of(all, "crate");
  const double half = 0.1 / 0.9 * 301 / 2 / std::tan(30 * 3.14159265 / 180);
  ASSERT_TRUE(found.full_box_px);
  EXPECT_NEAR((*found.full_box_px)[0], 200.5 - half, 0.01);
  EXPECT_NEAR((*found.full_box_px)[1], 150.5 - half, 0.01);
  EXPECT_NEAR((*found.full_box_px)[2], 200.5 + half, 0.01);
  EXPECT_NEAR((*found.full_box_px)[3], 150.5 + half, 0.01);
  EXPECT_EQ(found.box_px[2] - found.box_px[0], 57);  // pixel centres within 28.96 of the middle
  EXPECT_EQ(found.pixels, 57 * 57);
  EXPECT_EQ(found.silhouette_px, 57 * 57);
  EXPECT_EQ(found.hidden, 0);
  EXPECT_NEAR(found.depth_m, 0.9, 1e-4);
}

// The whole box against an independent count, that of the mask: a pixel shows the crate when its
// middle does, so each edge lies within half a pixel of the mask's, and on average on it.
TEST(Annotations, WholeBoxesAgreeWithTheMasksOfWhatNothingHides) {
  Stream draw = Seed(8).child("crates").stream();
  std::array<double, 4> off{};
  constexpr int crates = 60;
  for (int i = 0; i < crates; ++i) {
    Stage stage;
    const Vec3 middle{draw.uniform(2.8, 3.2), draw.uniform(2.2, 3), draw.uniform(0.7, 0.9)};
    const auto all = stage.annotated({crate("crate", middle, {0.08F, 0.01F, 0.08F})});
    const render::ObjectAnnotation& found = stage.of(all, "crate");
    ASSERT_TRUE(found.full_box_px);
    int counted_x = 401, counted_y = 301, past_x = 0, past_y = 0;
    for (int pixel = 0; pixel < 401 * 301; ++pixel) {
      if (stage.frame.instance[static_cast<std::size_t>(pixel)] != found.id) continue;
      counted_x = std::min(counted_x, pixel % 401), past_x = std::max(past_x, pixel % 401 + 1);
      counted_y = std::min(counted_y, pixel / 401), past_y = std::max(past_y, pixel / 401 + 1);
    }
    const std::array<int, 4> counted{counted_x, counted_y, past_x, past_y};
    EXPECT_EQ(found.box_px, counted);
    for (std::size_t edge = 0; edge < 4; ++edge) {
      EXPECT_NEAR((*found.full_box_px)[edge], counted[edge], 0.52) << i;
      off[edge] += ((*found.full_box_px)[edge] - counted[edge]) / crates;
    }
  }
  for (const double mean : off)
    EXPECT_NEAR(mean, 0, 0.15);  // of 60 draws from -0.5 .. 0.5: four sigma
}

// The near crate, half as far away, covers the right half of the far one.
TEST(Annotations, HiddenIsTheShareThatOthersCover) {
  Stage stage;
  const auto all = stage.annotated({crate("far", {3.0, 3, 0.8}, {0.2F, 0.01F, 0.2F}),
                                    crate("near", {3.25, 2, 0.8}, {0.25F, 0.01F, 0.25F})});
  const render::ObjectAnnotation &far = stage.of(all, "far"), &near = stage.of(all, "near");
  ASSERT_TRUE(far.hidden && near.hidden);
  EXPECT_EQ(*near.hidden, 0);
  EXPECT_NEAR(*far.hidden, 0.5, 0.02);
  const double half = 0.2 / 1.99 * 301 / 2 / std::tan(30 * 3.14159265 / 180);
  EXPECT_NEAR((*far.full_box_px)[2], 200.5 + half, 0.01);
  EXPECT_NEAR(far.box_px[2], 200.5, 1.1);
  EXPECT_NEAR(*far.silhouette_px, 4 * half * half, 4 * half);
}

TEST(Annotations, AFullBoxReachesBeyondThePictureButNotBehindTheCamera) {
  Stage stage;
  const auto all = stage.annotated({crate("aside", {3.9, 2, 0.8}, {0.4F, 0.1F, 0.1F}),
                                    crate("around", {3.0, 1.5, 0.2}, {0.1F, 1.0F, 0.1F})});
  const render::ObjectAnnotation& aside = stage.of(all, "aside");
  EXPECT_EQ(aside.box_px[2], 401);
  ASSERT_TRUE(aside.full_box_px);
  EXPECT_GT((*aside.full_box_px)[2], 500);
  const render::ObjectAnnotation& around = stage.of(all, "around");
  EXPECT_FALSE(around.full_box_px);
  EXPECT_NEAR(*around.silhouette_px, around.pixels, 5);  // rays along its outline may differ
}

TEST(Annotations, PosesAreInOpenCvsFrame) {
  Stage stage;
  const auto all = stage.annotated({crate("crate", {3.3, 2.5, 0.6}, {0.1F, 0.1F, 0.1F})});
  const render::ObjectAnnotation& found = stage.of(all, "crate");
  ASSERT_TRUE(found.camera_from_object);
  const auto& p = found.camera_from_object->position_m;
  EXPECT_NEAR(p[0], 0.3, 1e-9);  // right
  EXPECT_NEAR(p[1], 0.2, 1e-9);  // down
  EXPECT_NEAR(p[2], 1.5, 1e-9);  // ahead
  // The matrices say the same: opencv_from_world * (3.3, 2.5, 0.6).
  const render::Matrix44& m = all.matrices.opencv_from_world;
  EXPECT_NEAR(m[0][0] * 3.3 + m[0][1] * 2.5 + m[0][2] * 0.6 + m[0][3], 0.3, 1e-9);
  EXPECT_NEAR(m[1][0] * 3.3 + m[1][1] * 2.5 + m[1][2] * 0.6 + m[1][3], 0.2, 1e-9);
  const render::Matrix44& gl = all.matrices.opengl_from_world;
  EXPECT_NEAR(gl[1][0] * 3.3 + gl[1][1] * 2.5 + gl[1][2] * 0.6 + gl[1][3], -0.2, 1e-9);  // up
  EXPECT_NEAR(gl[2][0] * 3.3 + gl[2][1] * 2.5 + gl[2][2] * 0.6 + gl[2][3], -1.5, 1e-9);  // back
}

TEST(Annotations, MasksAreTheInstancePlane) {
  Stage stage;
  const auto all = stage.annotated({crate("far", {3.0, 3, 0.8}, {0.2F, 0.01F, 0.2F}),
                                    crate("near", {3.25, 2, 0.8}, {0.05F, 0.01F, 0.25F})});
  for (const render::ObjectAnnotation& object : all.objects) {
    EXPECT_EQ(object.mask.size, (std::array<int, 2>{301, 401}));
    std::size_t pixel = 0;
    bool inside = false;
    for (const std::uint32_t run : read_runs(object.mask.counts)) {
      for (std::uint32_t i = 0; i < run; ++i, ++pixel) {
        const std::size_t x = pixel / 301, y = pixel % 301;
        ASSERT_EQ(stage.frame.instance[y * 401 + x] == object.id, inside) << object.name;
      }
      inside = !inside;
    }
    EXPECT_EQ(pixel, 301U * 401U);
  }
}

// pycocotools 2.0.11, mask.encode of a 6 x 5 mask with pixels (row, column) (2,1) (3,1) (0,3)
// (5,4), and of one that is full: its counts.
TEST(MaskRuns, AreWrittenAsCocoWritesThem) {
  std::vector<std::uint32_t> plane(30);
  for (const auto& [row, column] : {std::pair{2, 1}, {3, 1}, {0, 3}, {5, 4}})
    plane[static_cast<std::size_t>(row * 5 + column)] = 9;
  EXPECT_EQ(render::mask_runs_of(plane, 5, 6).at(9).counts, "828O20");
  std::fill(plane.begin(), plane.end(), 4);
  EXPECT_EQ(render::mask_runs_of(plane, 5, 6).at(4).counts, "0n0");
  EXPECT_EQ(render::compressed_runs({100000, 3, 70000, 900}), "PeQ33`[T2Ql0");
}

TEST(Channels, EveryPlaneHasItsPicture) {
  Stage stage;
  const auto all = stage.annotated({crate("crate", {3.1, 2, 0.8}, {0.1F, 0.1F, 0.1F})});
  const auto channels = render::channel_pictures(
      stage.frame, stage.scene, all, {stage.frame.color, stage.frame.depth_m});
  ASSERT_EQ(channels.size(), 9U);
  for (const render::ChannelPicture& channel : channels) {
    EXPECT_EQ(channel.image.width, 401) << channel.name;
    EXPECT_EQ(channel.image.height, 301) << channel.name;
  }
  // The crate, nearest, is red in depth; the far wall blue.
  const Image& depth = channels[2].image;
  const auto* near = depth.at(stage.of(all, "crate").box_px[0] + 5, 150);
  const auto* far = depth.at(100, 100);
  EXPECT_GT(near[0], near[2] + 60);
  EXPECT_GT(far[2], far[0]);
  const Image sheet = render::channel_sheet(channels);
  EXPECT_GT(sheet.width, 3 * 401);
  EXPECT_GT(sheet.height, 3 * 301);
}

TEST(Channels, DepthRangeLeavesOutTheFarthestOutliers) {
  std::vector<float> depth(1000, 2.0F);
  depth[0] = 0;
  depth[1] = 0.5F;
  depth[2] = 90;
  EXPECT_EQ(render::depth_range_m(depth), (std::array<float, 2>{0.5F, 2.0F}));
  EXPECT_EQ(render::depth_range_m({0, 0}), (std::array<float, 2>{0, 1}));
}

}  // namespace
}  // namespace marketgen
