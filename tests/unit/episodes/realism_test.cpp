// What stands between the world and the robot: rows and files of dials, what each dial does, and
// that nothing of it is left to chance.
#include "episodes/realism.h"
#include "episodes/named_dials.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/parallel.h"
#include "episodes/camera_senses.h"
#include "episodes/checkout/checkout_senses.h"
#include "io/file.h"
#include "io/json.h"
#include "physics/goods/contact_shape.h"
#include "render/sensor/lamp_light.h"
#include "support/realistic_worlds.h"

namespace marketgen {
namespace {

constexpr double rad_a_degree = std::numbers::pi / 180;

std::string own_file(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
  const auto written = io::write_file(file, text);
  if (!written.ok()) fatal(to_string(written.error()).c_str());
  return file.string();
}

struct Spread {
  double mean = 0, sigma = 0;
};
Spread spread_of(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double value : values)
    sum += value, squares += value * value;
  const auto count = static_cast<double>(values.size());
  return {sum / count, std::sqrt(squares / count - sum / count * (sum / count))};
}

// ---- Rows and files ----

TEST(RealismRows, IdealIsNothingAndHardIsMoreThanStandard) {
  EXPECT_EQ(io::write_json(realism_row("ideal")), io::write_json(episodes::Realism{}));
  const episodes::Realism standard = realism_row("standard"), hard = realism_row("hard");
  EXPECT_EQ(standard.name, "standard");
  EXPECT_TRUE(standard.depth.stereo && hard.depth.stereo);
  EXPECT_GT(hard.depth.disparity_noise_px, standard.depth.disparity_noise_px);
  EXPECT_GT(hard.calibration.camera_m, standard.calibration.camera_m);
  EXPECT_GT(hard.joints.turn_deg, standard.joints.turn_deg);
  EXPECT_GT(hard.latency.commands.max_s, standard.latency.commands.max_s);
  EXPECT_GT(hard.latency.images.max_s, standard.latency.images.max_s);
  EXPECT_GT(hard.latency.readings.max_s, standard.latency.readings.max_s);
  EXPECT_GT(hard.light.stops, standard.light.stops);
  EXPECT_GT(hard.light.mired, standard.light.mired);
  EXPECT_GT(hard.joints.external_force_n, standard.joints.external_force_n);
  EXPECT_GT(standard.joints.external_force_n, 0);
  EXPECT_GT(hard.tools.opening_m, standard.tools.opening_m);
  EXPECT_GT(hard.tools.vacuum_s, standard.tools.vacuum_s);
  EXPECT_GT(hard.map.place_m, standard.map.place_m);
  EXPECT_GT(hard.localisation.off_m, standard.localisation.off_m);
  EXPECT_GT(hard.basket.place_m, standard.basket.place_m);
  EXPECT_LT(hard.color.full_well_e, standard.color.full_well_e) << "fewer electrons, more noise";
  for (const episodes::LatenessDials& late :
       {standard.latency.commands, standard.latency.images, standard.latency.readings})
    EXPECT_GT(late.min_s, 0);
  EXPECT_GT(std::min({standard.light.stops, standard.light.mired, standard.map.place_m}), 0);
  EXPECT_GT(std::min(standard.tools.opening_m, standard.tools.vacuum_s), 0);
}

TEST(RealismRows, AFileOfOnesOwnIsNamedByItsDials) {
  const auto named = [](const char* name, const char* dials) {
    return or_die(episodes::load_realism(
                      data_rows(),
                      own_file(std::string(name) + ".json",
                               std::string(R"({"schema": "market-realism/1", "name": ")") + name +
                                   "\", " + dials + "}")))
        .name;
  };
  const std::string one = named("one", R"("joints": {"turn_deg": 0.1})");
  EXPECT_TRUE(one.starts_with(episodes::own_dials)) << one;
  EXPECT_EQ(named("two", R"("joints": {"turn_deg": 0.1})"), one);
  EXPECT_NE(named("standard", R"("joints": {"turn_deg": 0.2})"), one);
}

TEST(RealismRows, BadOnesSayWhatMendsThem) {
  const auto error_of = [](const std::string& asked) {
    const auto read = episodes::load_realism(data_rows(), asked);
    return read.ok() ? "read" : to_string(read.error());
  };
  const auto error_of_dials = [&](const char* dials) {
    return error_of(
        own_file("bad.json",
                 std::string(R"({"schema": "market-realism/1", "name": "mine", )") + dials + "}"));
  };
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  says(error_of("standart"), "did you mean \"standard\"?");
  says(error_of("nowhere.json"), "input.not_found");
  says(error_of_dials(R"("joints": {"turn_deg": 11})"), "/joints/turn_deg: 11 is outside 0 to 10");
  says(error_of_dials(R"("depth": {"disparity_noise": 1})"), "did you mean");
  for (const std::string what : {"commands", "images", "readings"})
    says(error_of_dials(
             (R"("latency": {")" + what + R"(": {"min_s": 0.05, "max_s": 0.02}})").c_str()),
         ("/latency/" + what + "/max_s").c_str());
}

// ---- Latency ----

// Physics steps from the first on: where the arm's second joint is while it is told to turn.
std::vector<double> step_response(const episodes::Realism& realism) {
  const auto world = counter_at(realism);
  std::vector<double> places;
  const int joint = mj_name2id(&world->model(), mjOBJ_JOINT, "joint2");
  const int place = world->model().jnt_qposadr[joint];
  world->watch_physics(
      [&](const mjModel_&, const mjData_& data) { places.push_back(data.qpos[place]); });
  agent::Action action{world->told(), {{0.06, 20}}};
  action.position[1] += 0.05;
  for (int i = 0; i < 6; ++i)
    or_die(world->step(action));
  return places;
}

episodes::Realism late(double seconds) {
  episodes::Realism realism;
  realism.latency.commands = {seconds, seconds};
  return realism;
}

// The same response, as many steps of physics later: of less than a control step, and of more.
TEST(Latency, ActionsActLate) {
  const std::vector<double> prompt = step_response(late(0));
  ASSERT_GT(prompt.back() - prompt.front(), 0.045) << "it does turn";
  for (const double seconds : {0.02, 0.04, 0.06}) {
    const std::vector<double> delayed = step_response(late(seconds));
    const auto steps = static_cast<std::size_t>(std::lround(seconds / physics::time_step_s));
    for (std::size_t i = 0; i + steps < prompt.size(); ++i)
      ASSERT_NEAR(delayed[i + steps], prompt[i], 2e-4) << seconds << " s, step " << i;
    for (std::size_t i = 0; i < steps; ++i)
      ASSERT_NEAR(delayed[i], prompt.front(), 2e-4) << seconds << " s, before it arrives";
  }
}

TEST(Latency, IsDrawnOnceAnEpisode) {
  episodes::Realism realism;
  realism.latency.commands = {0.02, 0.06};
  const auto world = counter_at({});
  std::vector<double> drawn_s;
  for (std::uint64_t seed = 0; seed < 400; ++seed)
    drawn_s.push_back(
        episodes::RobotSenses(realism, episodes::realism_seed(seed), world->robot(), {}, {})
            .late_steps() *
        physics::time_step_s);
  EXPECT_GE(std::ranges::min(drawn_s), 0.02 - 1e-9);
  EXPECT_LE(std::ranges::max(drawn_s), 0.06 + 1e-9);
  EXPECT_NEAR(spread_of(drawn_s).mean, 0.04, 0.003);
  EXPECT_NEAR(spread_of(drawn_s).sigma, 0.04 / std::sqrt(12), 0.002);
}

TEST(Latency, NoneIsTheControlStepItself) {
  const auto world = counter_at({});
  const std::vector<int> commanded = episodes::commanded_dofs(world->robot());
  agent::Action action = episodes::still_action(world->observe());
  action.position[0] += 0.1;
  episodes::CommandLink link(world->robot(), commanded, 0, {});
  link.give(action);
  const episodes::ControlStep step(world->controller(), world->robot(), commanded, action);
  for (int i = 0; i < episodes::ControlStep::count(); ++i) {
    const physics::RobotReference told = link.next(world->controller()), same = step.at(i);
    for (std::size_t j = 0; j < told.joints.size(); ++j) {
      EXPECT_EQ(told.joints[j].position, same.joints[j].position);
      EXPECT_EQ(told.joints[j].velocity, same.joints[j].velocity);
    }
  }
}

// ---- What the robot reads of itself ----

TEST(RobotSenses, JointsErrByTheirDialsAndTheSameWhenAskedTwice) {
  const auto aisles = can_world(can_episode(*can_aisle()));
  episodes::Realism realism;
  realism.joints = {0.1, 1, 0.001, 0.01};
  const episodes::RobotSenses senses(
      realism, episodes::realism_seed(3), aisles->robot(), {}, aisles->observe().base);
  const agent::Observation truth = aisles->observe();
  const std::vector<int> commanded = episodes::commanded_dofs(aisles->robot());
  std::vector<double> turned, slid, speeds;
  for (int step = 0; step < 400; ++step) {
    const agent::Observation told = senses.told(truth, step);
    ASSERT_EQ(told.position, senses.told(truth, step).position);
    for (std::size_t j = 0; j < commanded.size(); ++j) {
      const bool slides =
          aisles->robot().joint_of_dof(static_cast<std::size_t>(commanded[j])).kind ==
          robots::JointType::prismatic;
      (slides ? slid : turned).push_back(told.position[j] - truth.position[j]);
      if (!slides) speeds.push_back(told.velocity[j] - truth.velocity[j]);
    }
    ASSERT_EQ(told.base.x_m, truth.base.x_m) << "its localisation has no dial on";
  }
  EXPECT_NEAR(spread_of(turned).sigma, 0.1 * rad_a_degree, 0.005 * rad_a_degree);
  EXPECT_NEAR(spread_of(speeds).sigma, rad_a_degree, 0.05 * rad_a_degree);
  EXPECT_NEAR(spread_of(slid).sigma, 0.001, 1e-4);
  EXPECT_NEAR(spread_of(turned).mean, 0, 0.01 * rad_a_degree);
}

// Of a gripper; a cup has no opening that could be read wrongly, and pads are not read to be nearer
// than closed.
TEST(RobotSenses, OpeningsErrByTheirDial) {
  const auto world = counter_at({});
  episodes::Realism realism;
  realism.tools.opening_m = 0.001;
  const episodes::RobotSenses senses(realism, episodes::realism_seed(3), world->robot(), {}, {});
  agent::Observation truth = world->observe();
  truth.openings_m = {0.04};
  std::vector<double> off;
  for (int step = 0; step < 2000; ++step) {
    const agent::Observation told = senses.told(truth, step);
    ASSERT_EQ(told.openings_m, senses.told(truth, step).openings_m);
    ASSERT_EQ(told.position, truth.position);
    off.push_back(told.openings_m[0] - 0.04);
  }
  EXPECT_NEAR(spread_of(off).sigma, 0.001, 5e-5);
  EXPECT_NEAR(spread_of(off).mean, 0, 1e-4);
  truth.openings_m = {0};
  for (int step = 0; step < 20; ++step)
    ASSERT_GE(senses.told(truth, step).openings_m[0], 0);
}

// And none is read that pulls the other way.
TEST(RobotSenses, WhatPressesOnAnArmErrsByItsDial) {
  const auto world = counter_at({});
  episodes::Realism realism;
  realism.joints.external_force_n = 2;
  const episodes::RobotSenses senses(realism, episodes::realism_seed(3), world->robot(), {}, {});
  agent::Observation truth = world->observe();
  ASSERT_EQ(truth.external_force_n, std::vector<double>{0});
  truth.external_force_n = {30};
  std::vector<double> off;
  for (int step = 0; step < 2000; ++step) {
    const agent::Observation told = senses.told(truth, step);
    ASSERT_EQ(told.external_force_n, senses.told(truth, step).external_force_n);
    ASSERT_EQ(told.openings_m, truth.openings_m);
    off.push_back(told.external_force_n[0] - 30);
  }
  EXPECT_NEAR(spread_of(off).sigma, 2, 0.1);
  EXPECT_NEAR(spread_of(off).mean, 0, 0.2);
  truth.external_force_n = {0};
  for (int step = 0; step < 20; ++step)
    ASSERT_GE(senses.told(truth, step).external_force_n[0], 0);
}

// It stands still: what it believes is off by the dial, and changes slowly.
TEST(BelievedPlace, CorrectionsAreOffAndRememberIt) {
  const episodes::LocalisationDials dials{0.01, 0.01, 0.1, 0.02, 1, 2};
  const robots::BasePlace truth{5, 4, 1};
  std::vector<double> off, turned;
  double together = 0, pairs = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    episodes::BelievedPlace place(dials, Seed(seed), truth, {});
    double before = place.told().x_m - truth.x_m;
    for (int step = 1; step <= 400; ++step) {
      const double was = place.told().x_m;
      place.drive({}, truth, step);
      if (step % 2 != 0) {
        ASSERT_EQ(place.told().x_m, was) << "corrections come at 10 Hz";
        continue;
      }
      const double now = place.told().x_m - truth.x_m;
      together += now * before, pairs += 1;
      before = now;
      off.push_back(now);
      off.push_back(place.told().y_m - truth.y_m);
      turned.push_back(place.told().heading - truth.heading);
    }
  }
  // Each 20 s are as good as some 5 independent draws: 300 of them.
  EXPECT_NEAR(spread_of(off).sigma, 0.02, 0.0015);
  EXPECT_NEAR(spread_of(turned).sigma, rad_a_degree, 0.1 * rad_a_degree);
  EXPECT_NEAR(together / pairs / (0.02 * 0.02), std::exp(-0.1 / 2), 0.15);
}

// Ten metres ahead by the wheels, without corrections.
TEST(BelievedPlace, ReckoningErrsWithTheWay) {
  const episodes::LocalisationDials dials{0.02, 0.03, 0, 0, 0, 2};
  std::vector<double> too_far, turned_too_far;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    episodes::BelievedPlace place(dials, Seed(seed), {1, 2, 0}, {1, 2, 0});
    for (int step = 1; step <= 200; ++step)
      place.drive({1 + 0.05 * step, 2, 0}, {1, 2, 0}, step);
    too_far.push_back(place.told().x_m - 11);
    place.drive({11, 2, 2}, {1, 2, 0}, 201);
    turned_too_far.push_back(place.told().heading - 2);
  }
  EXPECT_NEAR(spread_of(too_far).sigma, 0.02 * 10, 0.02);
  EXPECT_NEAR(spread_of(turned_too_far).sigma, 0.03 * 2, 0.006);
}

// ---- Cameras ----

TEST(CameraSenses, CalibrationErrsByItsDialsOnceAnEpisode) {
  const episodes::CalibrationDials dials{0.003, 0.5};
  std::vector<double> off, turned;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Pose error = episodes::camera_error(dials, Seed(seed), "wrist_camera");
    const Pose again = episodes::camera_error(dials, Seed(seed), "wrist_camera");
    ASSERT_EQ(error.position.x, again.position.x);
    ASSERT_NE(error.position.x,
              episodes::camera_error(dials, Seed(seed), "scene_camera").position.x);
    for (const double value : {error.position.x, error.position.y, error.position.z})
      off.push_back(value);
    for (const double value : {error.rotation.x, error.rotation.y, error.rotation.z})
      turned.push_back(2 * value);
  }
  EXPECT_NEAR(spread_of(off).sigma, 0.003, 2e-4);
  EXPECT_NEAR(spread_of(turned).sigma, 0.5 * rad_a_degree, 0.035 * rad_a_degree);
}

// Of a lamp so many mired warmer, red over blue.
double lamp_redness(double mired) {
  const Vec3f light = render::lamp_light(0, mired);
  return light.x / light.z;
}

agent::View seen(const episodes::Realism& realism, int threads = 0) {
  const ThreadLimit limit(threads);
  const auto world = counter_at(realism);
  episodes::CheckoutEyes eyes(*world);
  return or_die(eyes.look("scene_camera"));
}

double share_of_holes(const agent::View& view) {
  return static_cast<double>(std::ranges::count(view.depth_m, 0.0F)) /
         static_cast<double>(view.depth_m.size());
}

// The nominal place is told, whatever the true one is.
TEST(CameraSenses, PicturesAreOfTheirRealismAndPlacesNominal) {
  const agent::View ideal = seen({});
  episodes::Realism noisy = realism_row("standard");
  noisy.basket = {};
  const agent::View one = seen(noisy, 1), two = seen(noisy, 2);
  EXPECT_EQ(one.depth_m, two.depth_m);
  EXPECT_EQ(one.color.pixels, two.color.pixels);
  EXPECT_EQ(one.base_from_camera.position.x, ideal.base_from_camera.position.x);
  EXPECT_EQ(share_of_holes(ideal), 0);
  EXPECT_GT(share_of_holes(one), 0.01);
  EXPECT_LT(share_of_holes(one), 0.5);
  EXPECT_NE(one.color.pixels, ideal.color.pixels);
}

// With its calibration alone off, a picture is what the camera would see from there.
TEST(CameraSenses, PicturesAreTakenFromWhereTheCameraIs) {
  episodes::Realism off;
  off.calibration = {0.01, 0};
  const auto world = counter_at(off);
  const auto view = or_die(episodes::CheckoutView::create(*world));
  const render::Camera nominal = view->camera(episodes::StationCamera::scene);
  const Pose error = episodes::camera_error(off.calibration, world->noise(), "scene_camera");
  ASSERT_GT(length(error.position), 0.002);
  render::Camera there = nominal;
  there.world_from_camera = render::opencv_pose_of(nominal) * error;
  episodes::CheckoutEyes eyes(*world);
  const agent::View seen_so = or_die(eyes.look("scene_camera"));
  const render::Frame taken = or_die(view->renderer().render(there, {}));
  double far_off = 0;
  for (std::size_t i = 0; i < taken.depth_m.size(); ++i)
    far_off += std::abs(taken.depth_m[i] - seen_so.depth_m[i]) > 1e-4F ? 1 : 0;
  EXPECT_LT(far_off / static_cast<double>(taken.depth_m.size()), 0.002);
}

TEST(CameraSenses, LampsAreDrawnOnceAnEpisodeAlikeForAllCameras) {
  const episodes::LightDials dials{0.5, 30};
  std::vector<double> stops, redder;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Vec3f light = episodes::lamps_of(dials, Seed(seed));
    ASSERT_EQ(light, episodes::lamps_of(dials, Seed(seed)));
    stops.push_back(std::log2(0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z));
    redder.push_back(light.x / light.z);
  }
  EXPECT_NEAR(spread_of(stops).sigma, 1 / std::sqrt(12), 0.02);
  EXPECT_LE(std::ranges::max(stops), 0.5 + 1e-5);
  EXPECT_GE(std::ranges::min(stops), -0.5 - 1e-5);
  EXPECT_LE(std::ranges::max(redder), lamp_redness(30) + 1e-5);
  EXPECT_GE(std::ranges::min(redder), lamp_redness(-30) - 1e-5);
  EXPECT_GT(std::ranges::max(redder), lamp_redness(27));
  EXPECT_EQ(episodes::lamps_of({}, Seed(3)), (Vec3f{1, 1, 1}));
}

double mean_of(const Image& picture, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < picture.pixels.size(); i += 3)
    sum += picture.pixels[i];
  return sum / static_cast<double>(picture.pixels.size() / 3);
}

// And with nothing on, a picture is the renderer's own.
TEST(CameraSenses, LampsChangeColorAndNothingElse) {
  const auto world = counter_at({});
  const auto view = or_die(episodes::CheckoutView::create(*world));
  const render::Frame taken =
      or_die(view->renderer().render(view->camera(episodes::StationCamera::scene), {}));
  const agent::View ideal = seen({});
  EXPECT_EQ(ideal.color.pixels, taken.color.pixels);
  EXPECT_EQ(ideal.depth_m, taken.depth_m);
  episodes::Realism lit;
  lit.light = {1, 50};
  const Vec3f light = episodes::lamps_of(lit.light, world->noise());
  const agent::View other = seen(lit);
  EXPECT_EQ(other.depth_m, ideal.depth_m);
  for (const auto& [channel, gain] :
       {std::pair{0U, light.x}, std::pair{1U, light.y}, std::pair{2U, light.z}}) {
    ASSERT_GT(std::abs(gain - 1), 0.02) << "this seed shows nothing";
    EXPECT_EQ(mean_of(other.color, channel) > mean_of(ideal.color, channel), gain > 1) << channel;
  }
}

// ---- The basket ----

// Where it stands is drawn; what lies in it lies as before; nothing is pressed into anything; who
// is told the place is told the row's.
TEST(SlowBasketDials, TheBasketStandsASideWithWhatLiesInIt) {
  episodes::Realism realism;
  realism.basket = {0.03, 5};
  double farthest = 0, max_turned = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    episodes::EpisodeSpec spec = drawn(7, 0);
    spec.seed = seed;
    const auto world = counter_at(realism, spec);
    const Pose nominal = world->station().basket_pose(), now = world->basket_pose();
    const Vec3 aside = now.position - nominal.position;
    EXPECT_LE(std::max(std::abs(aside.x), std::abs(aside.y)), 0.03 + 1e-9);
    EXPECT_LE(std::abs(yaw_of(now.rotation)), 5 * rad_a_degree + 1e-9);
    EXPECT_TRUE(world->station().has_room_for_basket(now));
    farthest = std::max(farthest, length(aside));
    max_turned = std::max(max_turned, std::abs(yaw_of(now.rotation)));
    for (std::size_t i = 0; i < world->item_count(); ++i)
      EXPECT_LT(
          length((inverse(now) * world->item_pose(i)).position - spec.items[i].pose().position),
          1e-6);
    or_die(world->step(episodes::still_action(world->observe())));
    EXPECT_LE(world->deepest_overlap_m(), 0.003);
    EXPECT_EQ(episodes::workplace_of(world->station()).base_from_basket.position.x,
              nominal.position.x);
  }
  EXPECT_GT(farthest, 0.02);
  EXPECT_GT(max_turned, 2.5 * rad_a_degree);
}

// ---- Repeatable ----

TEST(Realism, TheSameSeedGivesTheSameEpisodeAndGoesOnFromAMoment) {
  const episodes::Realism standard = realism_row("standard");
  const auto one = counter_at(standard), two = counter_at(standard);
  agent::Action action = episodes::still_action(one->observe());
  for (int i = 0; i < 10; ++i) {
    action.position[0] += 0.02;
    const agent::Observation a = or_die(one->step(action)), b = or_die(two->step(action));
    ASSERT_EQ(a.position, b.position);
    if (i == 4) {
      ASSERT_TRUE(two->restore(one->save()).ok());
    }
  }
  EXPECT_EQ(one->state_hash(), two->state_hash());
}

// What an oracle rehearses errs otherwise than what then happens.
TEST(Realism, ATwinHasNoiseOfItsOwnInTheSameWorld) {
  const auto world = counter_at(realism_row("standard"));
  const auto twin = or_die(world->twin());
  or_die(world->step(episodes::still_action(world->observe())));
  ASSERT_TRUE(twin->restore(world->save()).ok());
  EXPECT_EQ(twin->state_hash(), world->state_hash());
  EXPECT_EQ(twin->basket_pose().position.x, world->basket_pose().position.x);
  EXPECT_NE(twin->observe().position, world->observe().position);
  EXPECT_EQ(twin->robot_state(), world->robot_state());
  EXPECT_NE(twin->noise().value(), world->noise().value());
}

TEST(Realism, ResultsSayWhichItWas) {
  const auto world = counter_at(realism_row("standard"));
  agent::Action stop = episodes::still_action(world->observe());
  stop.stop = true;
  or_die(world->step(stop));
  EXPECT_EQ(or_die(world->finish()).realism, "standard");
}

}  // namespace
}  // namespace marketgen
