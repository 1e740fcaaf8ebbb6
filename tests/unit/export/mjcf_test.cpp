// What MuJoCo makes of the model that write_mjcf describes.
#include "export/mjcf.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <memory>

#include "render/cameras/camera.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

constexpr float on_shelf_y = HandMadeScene::shelf_y_m - 0.1F;
constexpr float lower = HandMadeScene::lower_board_m, upper = HandMadeScene::upper_board_m;
constexpr std::uint32_t cereal = 0, can = 1;

struct Loaded {
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data{nullptr, mj_deleteData};
  int geom(const char* name) const { return mj_name2id(model.get(), mjOBJ_GEOM, name); }
  int body(const char* name) const { return mj_name2id(model.get(), mjOBJ_BODY, name); }
};

Loaded load(const scene::Scene& scene, const exporters::ExportOptions& options = {}) {
  const Result<exporters::ExportFiles> text = exporters::write_mjcf(scene, options);
  EXPECT_TRUE(text.ok()) << (text.ok() ? "" : to_string(text.error()));
  char fault[500] = "";
  mjSpec* spec = mj_parseXMLString(text->main.c_str(), nullptr, fault, sizeof fault);
  EXPECT_NE(spec, nullptr) << fault;
  Loaded loaded;
  loaded.model.reset(mj_compile(spec, nullptr));
  EXPECT_NE(loaded.model, nullptr) << mjs_getError(spec);
  mj_deleteSpec(spec);
  loaded.data.reset(mj_makeData(loaded.model.get()));
  mj_forward(loaded.model.get(), loaded.data.get());
  return loaded;
}

constexpr char first_can[] = "dry/run-1/module-1/level-0/facing-0/item-0";

TEST(Mjcf, StaticGoodsAreGeomsOfTheWorldWithTheirRowsShape) {
  HandMadeScene made;
  made.add(can, {3, on_shelf_y, lower});
  const Loaded m = load(made.scene);
  const int geom = m.geom(first_can);
  ASSERT_GE(geom, 0);
  EXPECT_EQ(m.model->nbody, 1);
  EXPECT_EQ(m.model->geom_type[geom], mjGEOM_CYLINDER);
  EXPECT_NEAR(m.model->geom_size[3 * geom], 0.033, 1e-6);
  EXPECT_NEAR(m.model->geom_size[3 * geom + 1], 0.0575, 1e-6);
  EXPECT_NEAR(m.data->geom_xpos[3 * geom + 2], lower + 0.0575, 1e-6);
}

TEST(Mjcf, GoodsInTheFreeRegionAreBodiesWithTheirMassAndFriction) {
  HandMadeScene made;
  made.add(can, {3, on_shelf_y, lower});
  made.add(cereal, {2.6F, on_shelf_y, upper});
  exporters::ExportOptions options;
  options.free_region_m = {2.9, 3, 3.5, 4};
  const Loaded m = load(made.scene, options);
  const int body = m.body(first_can);
  ASSERT_EQ(m.model->nbody, 2);
  ASSERT_GE(body, 1);
  EXPECT_NEAR(m.model->body_mass[body], 0.35, 1e-9);
  // Inertia of a full cylinder about its axis, m r^2 / 2; the can has a seam and a neck.
  const double cylinder = 0.35 * 0.033 * 0.033 / 2;
  EXPECT_NEAR(m.model->body_inertia[3 * body + 2], cylinder, 0.01 * cylinder);
  EXPECT_NEAR(m.model->geom_friction[3 * m.geom(first_can)], 0.4, 1e-9);
  EXPECT_EQ(m.model->nq, 7);
}

TEST(Mjcf, AFreeCanStaysWhereItStandsAndSlidesByItsOwnFriction) {
  HandMadeScene made;
  made.add(can, {3, on_shelf_y, lower});
  exporters::ExportOptions options;
  options.free_region_m = {0, 0, 6, 4};
  const Loaded m = load(made.scene, options);
  for (int i = 0; i < 500; ++i)
    mj_step(m.model.get(), m.data.get());
  const int body = m.body(first_can);
  EXPECT_NEAR(m.data->xpos[3 * body], 3, 1e-3);
  EXPECT_NEAR(m.data->xpos[3 * body + 2], lower, 1e-3);
  // A slow push of 0.4 +- 10 % of its weight: below friction it stays, above it moves.
  const double weight = 0.35 * 9.81;
  m.data->xfrc_applied[6 * body] = 0.36 * weight;
  for (int i = 0; i < 250; ++i)
    mj_step(m.model.get(), m.data.get());
  EXPECT_NEAR(m.data->xpos[3 * body], 3, 2e-3);
  m.data->xfrc_applied[6 * body] = 0.44 * weight;
  for (int i = 0; i < 250; ++i)
    mj_step(m.model.get(), m.data.get());
  EXPECT_GT(m.data->xpos[3 * body], 3.02);
}

TEST(Mjcf, OptionsHoldAGrasp) {
  const Loaded m = load(HandMadeScene().scene);
  EXPECT_EQ(m.model->opt.timestep, 0.002);
  EXPECT_EQ(m.model->opt.integrator, mjINT_IMPLICITFAST);
  EXPECT_EQ(m.model->opt.cone, mjCONE_ELLIPTIC);
  EXPECT_EQ(m.model->opt.impratio, 10);
  EXPECT_EQ(m.model->opt.noslip_iterations, 3);
}

TEST(Mjcf, ARayPassesTheEntranceAndStopsAtTheWallBesideIt) {
  const Loaded m = load(HandMadeScene().scene);
  const mjtNum from_entrance[3] = {1.5, 1, 1}, from_wall[3] = {3, 1, 1}, south[3] = {0, -1, 0};
  int geom = -1;
  mjtNum normal[3];
  EXPECT_LT(
      mj_ray(m.model.get(), m.data.get(), from_entrance, south, nullptr, 1, -1, &geom, normal), 0);
  EXPECT_NEAR(mj_ray(m.model.get(), m.data.get(), from_wall, south, nullptr, 1, -1, &geom, normal),
              1.0,
              1e-6);
}

TEST(Mjcf, HasTheStandardCamerasAndAtMostEightLights) {
  HandMadeScene made;
  made.stock();
  const Loaded m = load(made.scene);
  EXPECT_GE(mj_name2id(m.model.get(), mjOBJ_CAMERA, "top"), 0);
  EXPECT_GE(mj_name2id(m.model.get(), mjOBJ_CAMERA, "entrance"), 0);
  EXPECT_LE(m.model->nlight, 8);
}

// The words for a camera without perspective came and went between MuJoCo 3.3 and 4.
TEST(Mjcf, SaysOnlyWhatAllItsReadersKnow) {
  HandMadeScene made;
  made.stock();
  const auto files = exporters::write_mjcf(made.scene, {});
  ASSERT_TRUE(files.ok()) << to_string(files.error());
  const std::string& text = files->main;
  EXPECT_NE(text.find("<camera name=\"top\""), std::string::npos);
  for (const char* word : {"projection=", "orthographic="})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
}

TEST(Mjcf, TheFlatViewsShowTheWholeFloorFromFarOff) {
  HandMadeScene made;
  made.stock();
  const Loaded m = load(made.scene);
  const render::Camera flat = render::camera_named(made.scene, "top", 1280, 720).value();
  const int top = mj_name2id(m.model.get(), mjOBJ_CAMERA, "top");
  const double away = m.model->cam_pos[3 * top + 2] - flat.at.z;
  EXPECT_NEAR(2 * away * std::tan(m.model->cam_fovy[top] * 3.14159265358979 / 360),
              flat.ortho_height_m,
              1e-3);
  EXPECT_LT(away, 1.0 * m.model->vis.map.zfar * m.model->stat.extent);
}

TEST(Mjcf, FreeGoodsOnPegsHangFromASwitchableHook) {
  HandMadeScene made;
  made.scene.shelves[1].use = assets::ShelfUse::hang;
  made.add(cereal, {3, 3.0F, 1.2F});
  exporters::ExportOptions options;
  options.free_region_m = {0, 0, 6, 4};
  const Loaded m = load(made.scene, options);
  const int body = m.body("dry/run-1/module-1/level-1/facing-0/item-0");
  ASSERT_EQ(m.model->neq, 1);
  for (int i = 0; i < 250; ++i)
    mj_step(m.model.get(), m.data.get());
  EXPECT_NEAR(m.data->xpos[3 * body + 2], 1.2, 1e-3);
  m.data->eq_active[0] = 0;
  for (int i = 0; i < 250; ++i)
    mj_step(m.model.get(), m.data.get());
  EXPECT_LT(m.data->xpos[3 * body + 2], 0.8);
}

TEST(Mjcf, ATextWithMarkupInTheStoresNameIsEscaped) {  // "Corner & Co <test>"
  const Result<exporters::ExportFiles> text = exporters::write_mjcf(HandMadeScene().scene, {});
  ASSERT_TRUE(text.ok());
  EXPECT_NE(text->main.find("model=\"Corner &amp; Co &lt;test&gt;\""), std::string::npos);
}

}  // namespace
}  // namespace marketgen
