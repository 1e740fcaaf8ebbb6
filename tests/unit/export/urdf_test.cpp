// What URDF exports alone have: MuJoCo, which has a reader of its own, finds the same tree; nothing
// is free.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "export/exporter.h"
#include "scene/placements.h"
#include "scene/scene.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

TEST(UrdfExport, MujocoFindsEveryItemInItsPlaceWithItsMass) {
  HandMadeScene made;
  made.stock();
  const fs::path folder =
      fs::temp_directory_path() / ("marketgen-urdf-" + std::to_string(getpid()));
  fs::create_directories(folder);
  ASSERT_TRUE(exporters::export_scene(made.scene, "urdf", folder / "shop.urdf").ok());
  char fault[500] = "";
  const std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model(
      mj_loadXML((folder / "shop.urdf").c_str(), nullptr, fault, sizeof fault), mj_deleteModel);
  fs::remove_all(folder);
  ASSERT_NE(model, nullptr) << fault;
  const std::unique_ptr<mjData, decltype(&mj_deleteData)> data(mj_makeData(model.get()),
                                                               mj_deleteData);
  mj_kinematics(model.get(), data.get());
  ASSERT_FALSE(made.scene.products.empty());
  for (std::uint32_t row = 0; row < made.scene.products.size(); ++row) {
    const std::string id = scene::product_id(made.scene, row);
    const int body = mj_name2id(model.get(), mjOBJ_BODY, id.c_str());
    ASSERT_GE(body, 0) << id;
    const Vec3 wanted = scene::world_from_product(made.scene.products[row]).position;
    const mjtNum* at = data->xpos + 3 * body;
    EXPECT_LT(length(Vec3{at[0], at[1], at[2]} - wanted), 1e-5) << id;
    EXPECT_NEAR(
        model->body_mass[body], made.scene.catalog[made.scene.products[row].sku].mass_kg, 1e-6);
  }
}

TEST(UrdfExport, AFreeRegionIsRefused) {
  exporters::ExportOptions options;
  options.free_region_m = {{0, 0, 1, 1}};
  const auto files = exporters::write_urdf(HandMadeScene().scene, options);
  ASSERT_FALSE(files.ok());
  EXPECT_EQ(files.error().code, "usage.bad_flag");
  EXPECT_EQ(files.error().where, "--free-region");
}

}  // namespace
}  // namespace marketgen
