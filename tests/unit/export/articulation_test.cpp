// Every fixture row that has joints, alone in a room, as MuJoCo sees the file that we export: each
// joint goes through its whole range, and what moves meets nothing.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "export/export.h"
#include "export/mjcf.h"
#include "scene/fixture_stage.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double radians_of(double degrees) {
  return degrees * pi / 180;
}

constexpr int sweep_steps = 24;
constexpr double deepest_m = 0.001;
constexpr double let_go_rad = radians_of(45), closed_rad = radians_of(2), close_within_s = 10;

// A row's fixture and what MuJoCo makes of it. A parent's parts count as any other's.
struct Stage {
  scene::Scene scene;
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data{nullptr, mj_deleteData};

  std::string name_of_joint(const scene::SceneJoint& joint) const {
    return scene.layout.fixtures[0].id + "/" + joint.name;
  }
  int joint(const scene::SceneJoint& row) const {
    return mj_name2id(model.get(), mjOBJ_JOINT, name_of_joint(row).c_str());
  }
  double& position(const scene::SceneJoint& row) {
    return data->qpos[model->jnt_qposadr[joint(row)]];
  }
  double& push(const scene::SceneJoint& row) {
    return data->qfrc_applied[model->jnt_dofadr[joint(row)]];
  }
  void step(double seconds) {
    for (double t = 0; t < seconds; t += model->opt.timestep)
      mj_step(model.get(), data.get());
  }
};

Stage stage_of(const catalog::FixtureKind& kind) {
  Stage stage;
  Result<scene::Scene> scene = scene::stage_fixture(kind, committed_catalog());
  EXPECT_TRUE(scene.ok()) << to_string(scene.error());
  stage.scene = std::move(scene).value();
  if (stage.scene.joints.empty()) return stage;
  const Result<exporters::ExportFiles> text = exporters::write_mjcf(stage.scene, {});
  EXPECT_TRUE(text.ok()) << to_string(text.error());
  char fault[500] = "";
  mjSpec* spec = mj_parseXMLString(text->main.c_str(), nullptr, fault, sizeof fault);
  EXPECT_NE(spec, nullptr) << fault;
  stage.model.reset(mj_compile(spec, nullptr));
  EXPECT_NE(stage.model, nullptr) << mjs_getError(spec);
  mj_deleteSpec(spec);
  stage.model->opt.disableflags |= mjDSBL_FILTERPARENT;
  stage.data.reset(mj_makeData(stage.model.get()));
  return stage;
}

// Calls `check` with the stage of every row that has joints; returns how many there are.
template <class Check>
int for_every_articulated_row(Check check) {
  int rows = 0;
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    SCOPED_TRACE(kind.kind);
    Stage stage = stage_of(kind);
    if (stage.scene.joints.empty()) continue;
    ++rows;
    check(stage);
  }
  return rows;
}

bool moves(const scene::SceneJoint& joint) {
  return joint.kind != assets::JointKind::belt;
}

// A wheel's range is many turns; one is enough to look at.
std::pair<double, double> range_to_sweep(const scene::SceneJoint& joint) {
  if (joint.upper - joint.lower > 4 * pi) return {-pi, pi};
  return {joint.lower, joint.upper};
}

struct Touch {
  double depth = 0;
  std::string what;
};

// The deepest contact where the joints now stand.
Touch deepest_contact(Stage& stage) {
  const mjModel& model = *stage.model;
  mj_kinematics(&model, stage.data.get());
  mj_comPos(&model, stage.data.get());
  mj_collision(&model, stage.data.get());
  Touch worst;
  for (int i = 0; i < stage.data->ncon; ++i) {
    const mjContact& contact = stage.data->contact[i];
    if (-contact.dist <= worst.depth) continue;
    worst.depth = -contact.dist;
    worst.what = std::string(mj_id2name(&model, mjOBJ_GEOM, contact.geom[0])) + " and " +
                 mj_id2name(&model, mjOBJ_GEOM, contact.geom[1]);
  }
  return worst;
}

TEST(Articulation, EveryJointGoesThroughItsRangeAndMeetsNothing) {
  const int rows = for_every_articulated_row([](Stage& stage) {
    for (const scene::SceneJoint& joint : stage.scene.joints) {
      if (!moves(joint)) continue;
      const auto [low, high] = range_to_sweep(joint);
      for (int step = 0; step <= sweep_steps; ++step) {
        stage.position(joint) = low + (high - low) * step / sweep_steps;
        const Touch touch = deepest_contact(stage);
        ASSERT_LE(touch.depth, deepest_m)
            << joint.name << " at " << stage.position(joint) << ": " << touch.what;
      }
      stage.position(joint) = 0;
    }
  });
  EXPECT_GE(rows, 40);
}

TEST(Articulation, LimitsAndStatesAreAsTheRowsSay) {
  for_every_articulated_row([](Stage& stage) {
    std::set<std::string> names;
    for (const scene::SceneJoint& joint : stage.scene.joints) {
      SCOPED_TRACE(joint.name);
      EXPECT_TRUE(names.insert(joint.name).second);
      EXPECT_LT(joint.lower, joint.upper);
      ASSERT_FALSE(joint.states.empty());
      EXPECT_EQ(joint.states.front().position, 0);
      for (const assets::JointState& state : joint.states) {
        EXPECT_GE(state.position, double(joint.lower) - 1e-5) << state.name;
        EXPECT_LE(state.position, double(joint.upper) + 1e-5) << state.name;
      }
      if (!moves(joint)) continue;
      const int id = stage.joint(joint);
      ASSERT_GE(id, 0);
      EXPECT_NEAR(stage.model->jnt_range[2 * id], joint.lower, 1e-6);
      EXPECT_NEAR(stage.model->jnt_range[2 * id + 1], joint.upper, 1e-6);
      EXPECT_EQ(stage.model->jnt_limited[id], 1);
    }
  });
}

// Doors and flaps that a spring pulls shut.
bool closes_itself(const scene::SceneJoint& joint) {
  return joint.kind == assets::JointKind::hinge && joint.stiffness > 0 &&
         joint.states.front().name == "closed" && double(joint.upper) > radians_of(20);
}

double start_of(const scene::SceneJoint& joint) {
  const double last = joint.hold_open > 0 ? joint.hold_open : joint.upper;
  return std::min(let_go_rad, 0.6 * last);
}

TEST(Articulation, SelfClosingDoorsCloseWhenLetGoHalfWay) {
  int doors = 0;
  for_every_articulated_row([&](Stage& stage) {
    mj_resetData(stage.model.get(), stage.data.get());
    std::vector<const scene::SceneJoint*> opened;
    for (const scene::SceneJoint& joint : stage.scene.joints) {
      if (!closes_itself(joint)) continue;
      opened.push_back(&joint);
      stage.position(joint) = start_of(joint);
    }
    const auto ajar = [&](const scene::SceneJoint* joint) {
      return std::abs(stage.position(*joint)) >= closed_rad;
    };
    for (double t = 0; t < close_within_s && std::ranges::any_of(opened, ajar); t += 0.5)
      stage.step(0.5);
    for (const scene::SceneJoint* joint : opened) {
      EXPECT_LT(std::abs(stage.position(*joint)), closed_rad) << joint->name;
      ++doors;
    }
  });
  EXPECT_GE(doors, 10);
}

TEST(Articulation, DoorsThatHoldOpenStayOpen) {
  int doors = 0;
  for_every_articulated_row([&](Stage& stage) {
    mj_resetData(stage.model.get(), stage.data.get());
    std::vector<const scene::SceneJoint*> opened;
    for (const scene::SceneJoint& joint : stage.scene.joints) {
      if (!closes_itself(joint) || joint.hold_open == 0) continue;
      opened.push_back(&joint);
      stage.position(joint) = (joint.hold_open + joint.upper) / 2;
    }
    if (opened.empty()) return;
    stage.step(close_within_s / 2);
    for (const scene::SceneJoint* joint : opened) {
      EXPECT_GE(stage.position(*joint), joint->hold_open) << joint->name;
      ++doors;
    }
  });
  EXPECT_GE(doors, 6);
}

// Moved by a constant force for a second, from where it rests.
double moved_by(Stage& stage, const scene::SceneJoint& joint, double force) {
  mj_resetData(stage.model.get(), stage.data.get());
  stage.push(joint) = force;
  stage.step(1);
  return stage.position(joint);
}

TEST(Articulation, AFreezersLidSlidesWhenPushedHarderThanItsFriction) {
  const catalog::FixtureKind* kind = committed_catalog().fixture_kind("chest_freezer");
  ASSERT_NE(kind, nullptr);
  Stage stage = stage_of(*kind);
  ASSERT_EQ(stage.scene.joints.size(), 2U);
  for (const scene::SceneJoint& lid : stage.scene.joints) {
    EXPECT_GT(lid.friction, 5) << "N";  // a lid of 7 to 10 kg on plastic runners
    EXPECT_LT(lid.friction, 20) << "N";
    EXPECT_LT(moved_by(stage, lid, 0.8 * double(lid.friction)), 0.002);
    EXPECT_GT(moved_by(stage, lid, 1.5 * double(lid.friction)), 0.1);
  }
}

TEST(Articulation, AButtonGivesWayToAFingerAndComesBack) {
  const catalog::FixtureKind* kind = committed_catalog().fixture_kind("checkout_lane");
  ASSERT_NE(kind, nullptr);
  Stage stage = stage_of(*kind);
  const auto key = std::ranges::find_if(
      stage.scene.joints, [](const scene::SceneJoint& joint) { return joint.name == "key-5"; });
  ASSERT_NE(key, stage.scene.joints.end());
  EXPECT_NEAR(moved_by(stage, *key, 4), key->upper, 0.0006);  // N; limits are soft
  EXPECT_LT(moved_by(stage, *key, 1), 0.7 * double(key->upper));
  stage.push(*key) = 0;
  stage.step(0.5);
  EXPECT_LT(stage.position(*key), 0.0004);
}

TEST(Articulation, ABeltIsABodyThatStandsStillAndSaysHowItRuns) {
  const catalog::FixtureKind* kind = committed_catalog().fixture_kind("checkout_lane");
  ASSERT_NE(kind, nullptr);
  const Stage stage = stage_of(*kind);
  const mjModel& model = *stage.model;
  const int body = mj_name2id(&model, mjOBJ_BODY, "checkout_lane/belt");
  const int numeric = mj_name2id(&model, mjOBJ_NUMERIC, "checkout_lane/belt");
  ASSERT_GE(body, 1);
  ASSERT_GE(numeric, 0);
  EXPECT_EQ(model.body_jntnum[body], 0);
  EXPECT_EQ(model.body_weldid[body], 0);
  ASSERT_EQ(model.numeric_size[numeric], 5);
  // The lane is deeper than wide: its belt brings goods from the back (+Y) to the cashier.
  const mjtNum* data = model.numeric_data + model.numeric_adr[numeric];
  const double expected[5] = {0, -1, 0, 0, 0.25};
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(data[i], expected[i], 1e-6) << i;
}

TEST(Articulation, StillFixturesHaveNoBodies) {
  const catalog::FixtureKind* kind = committed_catalog().fixture_kind("glass_door_cooler");
  ASSERT_NE(kind, nullptr);
  const Result<scene::Scene> scene = scene::stage_fixture(*kind, committed_catalog());
  ASSERT_TRUE(scene.ok());
  exporters::ExportOptions still;
  still.still_fixtures = true;
  const Result<exporters::ExportFiles> text = exporters::write_mjcf(*scene, still);
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(text->main.find("<body"), std::string::npos);
  EXPECT_EQ(text->main.find("<joint"), std::string::npos);
}

TEST(Articulation, TheReaderFindsAJointThatIsNotAsItShouldBe) {
  const catalog::FixtureKind* kind = committed_catalog().fixture_kind("checkout_lane");
  ASSERT_NE(kind, nullptr);
  Result<scene::Scene> scene = scene::stage_fixture(*kind, committed_catalog());
  ASSERT_TRUE(scene.ok());
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("articulation-" + std::to_string(getpid()) + ".xml");
  ASSERT_TRUE(exporters::export_scene(*scene, "mjcf", file).ok());
  const Result<exporters::ExportSummary> same = exporters::check_export(*scene, "mjcf", file);
  ASSERT_TRUE(same.ok()) << to_string(same.error());
  EXPECT_EQ(same->joints, scene->joints.size());

  const auto message_after = [&](auto change) {
    scene::Scene other = *scene;
    change(other.joints.front());
    const Result<exporters::ExportSummary> differs = exporters::check_export(other, "mjcf", file);
    return differs.ok() ? std::string() : differs.error().message;
  };
  const std::string name = scene->joints.front().name;
  for (const std::string& message :
       {message_after([](scene::SceneJoint& j) { j.upper += 0.01F; }),
        message_after([](scene::SceneJoint& j) { j.position_m[2] += 0.001F; }),
        message_after([](scene::SceneJoint& j) { j.mass_kg *= 1.01F; }),
        message_after([](scene::SceneJoint& j) { j.name += "-other"; })}) {
    EXPECT_NE(message.find("checkout_lane/" + name), std::string::npos) << message;
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace marketgen
