// The classical policy with nothing but pictures, a catalogue and a robot's row: no world stands
// behind it.
#include "policy/classical_checkout.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "robots/robot_row.h"
#include "support/drawn_boxes.h"

namespace marketgen {
namespace {

std::filesystem::path data_folder_of_tests() {
  return std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
}

// Every camera hangs over the counter and sees the boxes.
class DrawnEyes : public agent::Eyes {
 public:
  explicit DrawnEyes(std::vector<DrawnBox> boxes) : boxes_(std::move(boxes)) {}
  Result<agent::View> look(std::string_view) override {
    ++looks;
    return drawn_view(boxes_, camera_over({0.52, 0, 0.6}), 320, 240, 300);
  }
  int looks = 0;

 private:
  std::vector<DrawnBox> boxes_;
};

class DrawnProducts : public agent::KnownProducts {
 public:
  void add(const std::string& sku, Vec3 size, Rgb8 color) {
    catalog::Product row;
    row.sku = sku;
    row.archetype = "box";
    row.mass_kg = 0.2;
    for (std::size_t i = 0; i < 3; ++i)
      row.size_mm[i] = static_cast<int>(1000 * std::array{size.x, size.y, size.z}[i]);
    rows_.push_back(row);
    agent::KnownProduct known{row, {}, 0.6};
    assets::ContactPiece piece;
    piece.center = to_float({0, 0, size.z / 2});
    piece.half_size = to_float(size * 0.5);
    known.body.pieces = {piece};
    known.body.center_of_mass = piece.center;
    known_.emplace(sku, known);
    pictures_.emplace(sku, drawn_pictures(size, plain(color)));
  }
  const std::vector<catalog::Product>& rows() const override { return rows_; }
  Result<const agent::KnownProduct*> product(const std::string& sku) override {
    return &known_.at(sku);
  }
  Result<std::vector<agent::ProductPictures>> pictures(
      const std::vector<std::string>& skus) const override {
    std::vector<agent::ProductPictures> all;
    for (const std::string& sku : skus)
      all.push_back(pictures_.at(sku));
    return all;
  }

 private:
  std::vector<catalog::Product> rows_;
  std::map<std::string, agent::KnownProduct> known_;
  std::map<std::string, agent::ProductPictures> pictures_;
};

class Classical : public ::testing::Test {
 protected:
  Classical() {
    auto robot = robots::load_robot(data_folder_of_tests(), "panda", {{"tool", "panda-long-hand"}});
    if (!robot.ok()) fatal(to_string(robot.error()).c_str());
    robot_ = std::make_unique<robots::Robot>(std::move(robot).value());
    setup_.robot = robot_.get();
    auto tool = robots::load_grasp_tool(data_folder_of_tests(), "panda-long-hand");
    if (!tool.ok()) fatal(to_string(tool.error()).c_str());
    setup_.tool = std::move(tool).value();
    setup_.place.counter = {{-0.25, -0.95}, {0.85, 0.95}};
    setup_.place.unloading = {{0.31, -0.66}, {0.65, -0.26}};
    setup_.place.set_aside = {{0.2, -0.75}, {0.62, 0.75}};
    setup_.place.base_from_basket = {{0.52, 0, 0.003}, {}};
    setup_.place.rim_m = 0.15;
    setup_.place.inner_half = {0.15, 0.215, 0};
    products_.add("carton", {0.06, 0.09, 0.12}, {200, 40, 30});
    setup_.products = &products_;
    setup_.looks = &looks_;
    ready_.position = {0, -0.785, 0, -2.356, 0, 1.571, 0.785};
    ready_.velocity.assign(7, 0);
    ready_.openings_m = {0.08};
  }

  // Acts until it stops or a time is over; the arm follows at once, and the fingers shut.
  std::unique_ptr<agent::Policy> act(agent::Eyes& eyes,
                                     double until_s,
                                     std::vector<agent::Action>& actions) {
    setup_.eyes = &eyes;
    auto policy = policy::make_classical_checkout(std::move(setup_), Seed(1));
    if (!policy.ok()) fatal(to_string(policy.error()).c_str());
    agent::Observation now = ready_;
    EXPECT_TRUE((*policy)->begin(task_, now).ok());
    for (; now.time_s < until_s; now.time_s += 0.05) {
      const auto action = (*policy)->act(now);
      if (!action.ok()) fatal(to_string(action.error()).c_str());
      actions.push_back(*action);
      if (action->stop) break;
      now.position = action->position;
    }
    return std::move(*policy);
  }

  std::unique_ptr<robots::Robot> robot_;
  DrawnProducts products_;
  perception::LookLibrary looks_;
  policy::ClassicalSetup setup_;
  agent::Observation ready_;
  agent::Task task_{"Put the carton there.", 60, {{"carton", 1}}};
};

// Knows the one word.
class CartonReader : public perception::GoalReader {
 public:
  Result<std::vector<std::string>> read(const std::string& text) const override {
    if (text == "the carton") return std::vector<std::string>{"carton"};
    return Error{"perception.not_understood", text, "is not the carton"};
  }
};

TEST_F(Classical, LooksAtAnEmptyCounterAndStops) {
  DrawnEyes eyes({{{{0.5, 0, -0.02}, {}}, {1.2, 1.9, 0.02}, plain({120, 120, 120})}});
  std::vector<agent::Action> actions;
  const auto policy = act(eyes, 30, actions);
  EXPECT_TRUE(actions.back().stop);
  EXPECT_EQ(policy->failure(), "NotFound");
  EXPECT_EQ(eyes.looks, 4);  // both cameras, twice: no noise between
}

TEST_F(Classical, GoesToWhatItSees) {
  const Vec3 at{0.5, 0.05, 0};
  DrawnEyes eyes(
      {{{{0.5, 0, -0.02}, {}}, {1.2, 1.9, 0.02}, plain({120, 120, 120})},
       {{at, rotation_about({0, 0, 1}, 0.3)}, {0.06, 0.09, 0.12}, plain({200, 40, 30})}});
  std::vector<agent::Action> actions;
  act(eyes, 8, actions);
  // Somewhere on its way the tip is in the carton.
  double nearest = 1;
  const robots::JointGroup& arm = *robot_->find_group("arm");
  for (const agent::Action& action : actions) {
    std::vector<double> q = robots::neutral_state(*robot_);
    for (std::size_t j = 0; j < arm.dofs.size(); ++j)
      q[static_cast<std::size_t>(arm.dofs[j])] = action.position[j];
    const Pose tip = robots::frame_pose(*robot_, q, arm.tip);
    nearest = std::min(nearest, length(tip.position - (at + Vec3{0, 0, 0.06})));
  }
  EXPECT_LT(nearest, 0.07);
}

TEST_F(Classical, LooksForWhatItReads) {
  DrawnEyes eyes({{{{0.5, 0, -0.02}, {}}, {1.2, 1.9, 0.02}, plain({120, 120, 120})},
                  {{{0.5, 0.05, 0}, rotation_about({0, 0, 1}, 0.3)},
                   {0.06, 0.09, 0.12},
                   plain({200, 40, 30})}});
  setup_.modules.language = std::make_unique<CartonReader>();
  task_.goals = {{"", 1, "the carton"}};
  std::vector<agent::Action> actions;
  act(eyes, 4, actions);
  EXPECT_FALSE(actions.back().stop);
  EXPECT_GT(actions.size(), 40U);
}

// Nothing else is disturbed for its sake.
TEST_F(Classical, WhatItCannotReadIsNotFound) {
  DrawnEyes eyes({{{{0.5, 0, -0.02}, {}}, {1.2, 1.9, 0.02}, plain({120, 120, 120})},
                  {{{0.5, 0.05, 0}, rotation_about({0, 0, 1}, 0.3)},
                   {0.06, 0.09, 0.12},
                   plain({200, 40, 30})}});
  setup_.modules.language = std::make_unique<CartonReader>();
  task_.goals = {{"", 1, "the zyxwv"}};
  std::vector<agent::Action> actions;
  const auto policy = act(eyes, 30, actions);
  EXPECT_TRUE(actions.back().stop);
  EXPECT_EQ(policy->failure(), "NotFound");
  EXPECT_EQ(eyes.looks, 4);
}

TEST_F(Classical, SaysSoWhenTheTimeIsOver) {
  DrawnEyes eyes({{{{0.5, 0, -0.02}, {}}, {1.2, 1.9, 0.02}, plain({120, 120, 120})}});
  ready_.time_s = 55;
  std::vector<agent::Action> actions;
  EXPECT_EQ(act(eyes, 60, actions)->failure(), "Timeout");
}

}  // namespace
}  // namespace marketgen
