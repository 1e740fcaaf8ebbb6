// Several noisy pictures of one scene as one.
#include "perception/steady_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/seed.h"
#include "support/drawn_boxes.h"

namespace marketgen {
namespace {

constexpr double wall_m = 1.0, pixel_noise_m = 0.0035;

agent::View wall() {
  const std::vector<DrawnBox> boxes{
      {{{wall_m + 0.01, 0, -1}, {}}, {0.02, 2, 2}, plain({120, 120, 120})}};
  const Pose eye{{}, rotation_with_axes({0, -1, 0}, {1, 0, 0})};
  return drawn_view(boxes, eye, 80, 60, 60);
}

// As stereo errs: with the square of distance.
agent::View noisy_wall(std::uint64_t number, double sigma_m = pixel_noise_m) {
  agent::View view = wall();
  Stream draw = Seed(7).child("picture", number).stream();
  for (float& depth : view.depth_m)
    depth += static_cast<float>(sigma_m * draw.normal()) * depth * depth;
  return view;
}

perception::SteadyView looked_until_enough(double sigma_m, int* pictures) {
  perception::SteadyView steady;
  for (*pictures = 0; steady.wants_more(); ++*pictures)
    steady.add(noisy_wall(static_cast<std::uint64_t>(*pictures), sigma_m));
  return steady;
}

double rms_off(const agent::View& view) {
  const agent::View truth = wall();
  double squares = 0;
  for (std::size_t i = 0; i < truth.depth_m.size(); ++i)
    squares += std::pow(static_cast<double>(view.depth_m[i] - truth.depth_m[i]), 2);
  return std::sqrt(squares / static_cast<double>(truth.depth_m.size()));
}

TEST(SteadyView, TwoPicturesTellThatDepthIsExact) {
  int pictures = 0;
  perception::SteadyView steady = looked_until_enough(0, &pictures);
  EXPECT_EQ(pictures, 2);
  EXPECT_EQ(steady.take().depth_m, wall().depth_m);
  EXPECT_TRUE(steady.empty());
}

TEST(SteadyView, TakesAsManyPicturesAsTheNoiseAsksFor) {
  int few = 0, many = 0;
  perception::SteadyView steady = looked_until_enough(pixel_noise_m, &few);
  EXPECT_NEAR(steady.noise_m(), pixel_noise_m, 0.1 * pixel_noise_m);
  EXPECT_GT(few, 2);
  EXPECT_LT(rms_off(steady.take()), 1.2 * pixel_noise_m / std::sqrt(few));
  looked_until_enough(3 * pixel_noise_m, &many);
  EXPECT_GT(many, few);
  EXPECT_LE(many, 12) << "a very bad camera is not looked through forever";
}

TEST(SteadyView, AnEdgeStaysWhereItIsMostlySeenAndMostHolesStay) {
  perception::SteadyView steady;
  for (std::uint64_t i = 0; i < 5; ++i) {
    agent::View view = noisy_wall(i);
    if (i < 2) view.depth_m[0] += 0.3F;  // jumped to what is behind
    if (i < 3) view.depth_m[1] = 0;
    if (i < 2) view.depth_m[2] = 0;
    steady.add(std::move(view));
  }
  const agent::View view = steady.take();
  EXPECT_NEAR(view.depth_m[0], wall().depth_m[0], 4 * pixel_noise_m);
  EXPECT_EQ(view.depth_m[1], 0);
  EXPECT_NEAR(view.depth_m[2], wall().depth_m[2], 4 * pixel_noise_m);
}

TEST(SteadyView, LeavesOutWhatWasTakenFromElsewhere) {
  perception::SteadyView steady;
  steady.add(wall());
  agent::View moved = wall();
  moved.base_from_camera.position.y += 0.01;
  for (float& depth : moved.depth_m)
    depth += 0.1F;
  steady.add(std::move(moved));
  EXPECT_EQ(steady.noise_m(), 0);
  EXPECT_EQ(steady.take().depth_m, wall().depth_m);
}

}  // namespace
}  // namespace marketgen
