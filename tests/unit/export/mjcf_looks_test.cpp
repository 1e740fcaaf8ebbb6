// Meshes, pictures and robots of an MJCF export: the files beside it, and what MuJoCo makes of
// them.
#include "export/mjcf_looks.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "export/export.h"
#include "export/goods_sheets.h"
#include "export/mjcf.h"
#include "io/file.h"
#include "io/png.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

class MjcfFiles : public testing::Test {
 protected:
  MjcfFiles()
      : folder_(fs::temp_directory_path() / ("marketgen-mjcf-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    made_.stock();
    options_.looks = true;
  }
  ~MjcfFiles() override { fs::remove_all(folder_); }

  void put_robots(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      const auto spec = robots::parse_robot_spec(text, text);
      ASSERT_TRUE(spec.ok()) << to_string(spec.error());
      auto placed = robots::place_robot(fs::path(MARKETGEN_SOURCE_DIR) / "data", *spec, text);
      ASSERT_TRUE(placed.ok()) << to_string(placed.error());
      options_.robots.push_back(std::move(placed).value());
    }
  }
  void write() {
    const Result<void> written = exporters::export_scene(made_.scene, "mjcf", file_, options_);
    ASSERT_TRUE(written.ok()) << to_string(written.error());
  }
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> load() const {
    char fault[1000] = "";
    mjSpec* spec = mj_parseXML(file_.c_str(), nullptr, fault, sizeof fault);
    EXPECT_NE(spec, nullptr) << fault;
    std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model(mj_compile(spec, nullptr),
                                                              mj_deleteModel);
    EXPECT_NE(model, nullptr) << mjs_getError(spec);
    mj_deleteSpec(spec);
    return model;
  }

  HandMadeScene made_;
  exporters::ExportOptions options_;
  fs::path folder_, file_ = folder_ / "shop.xml";
};

TEST_F(MjcfFiles, EveryProductHasAMeshWithAPictureThatTouchesNothing) {
  write();
  const Result<exporters::ExportSummary> summary =
      exporters::check_export(made_.scene, "mjcf", file_, options_);
  ASSERT_TRUE(summary.ok()) << to_string(summary.error());
  EXPECT_EQ(summary->looks, made_.scene.products.size());
  EXPECT_TRUE(fs::exists(folder_ / "shop_assets/can-cola.png"));
  const auto model = load();
  ASSERT_NE(model, nullptr);
  int looks = 0;
  for (int geom = 0; geom < model->ngeom; ++geom) {
    if (model->geom_type[geom] != mjGEOM_MESH) continue;
    ++looks;
    EXPECT_EQ(model->geom_contype[geom] + model->geom_conaffinity[geom], 0);
    EXPECT_EQ(model->geom_group[geom], exporters::group_product);
    const int material = model->geom_matid[geom];
    ASSERT_GE(material, 0);
    EXPECT_GE(model->mat_texid[mjNTEXROLE * material + mjTEXROLE_RGB], 0);
    EXPECT_GE(model->mesh_texcoordadr[model->geom_dataid[geom]], 0);
  }
  EXPECT_EQ(looks, static_cast<int>(made_.scene.products.size()));
}

TEST_F(MjcfFiles, AreTheSameBytesEachTimeAndMayBeMoved) {
  write();
  const std::string picture = io::read_file(folder_ / "shop_assets/can-cola.png").value();
  const std::string text = io::read_file(file_).value();
  write();
  EXPECT_EQ(io::read_file(folder_ / "shop_assets/can-cola.png").value(), picture);
  EXPECT_EQ(io::read_file(file_).value(), text);
  fs::create_directory(folder_ / "elsewhere");
  fs::rename(folder_ / "shop_assets", folder_ / "elsewhere/shop_assets");
  fs::rename(file_, folder_ / "elsewhere/shop.xml");
  file_ = folder_ / "elsewhere/shop.xml";
  EXPECT_NE(load(), nullptr);
}

TEST_F(MjcfFiles, TheCheckMissesWhatIsNotThere) {
  write();
  exporters::ExportOptions without = options_;
  without.looks = false;
  EXPECT_EQ(exporters::check_export(made_.scene, "mjcf", file_, without).error().code,
            "export.mismatch");
  fs::remove(folder_ / "shop_assets/can-cola.png");
  const Result<exporters::ExportSummary> summary =
      exporters::check_export(made_.scene, "mjcf", file_, options_);
  ASSERT_FALSE(summary.ok());
  EXPECT_NE(summary.error().message.find("can-cola.png"), std::string::npos)
      << summary.error().message;
}

TEST_F(MjcfFiles, PrimitivesAloneAreOneFile) {
  options_.looks = false;
  write();
  EXPECT_FALSE(fs::exists(folder_ / "shop_assets"));
}

TEST_F(MjcfFiles, RobotsStandAndHoldWhereTheyWerePut) {
  put_robots({"panda-on-stand@3,1.2,90", "panda-on-stand@1.2,1.2", "realman-rm75@4.6,1.2,180"});
  write();
  const Result<exporters::ExportSummary> summary =
      exporters::check_export(made_.scene, "mjcf", file_, options_);
  ASSERT_TRUE(summary.ok()) << to_string(summary.error());
  EXPECT_EQ(summary->robots, 3U);
  const auto model = load();
  ASSERT_NE(model, nullptr);
  const std::unique_ptr<mjData, decltype(&mj_deleteData)> data(mj_makeData(model.get()),
                                                               mj_deleteData);
  ASSERT_EQ(model->nkey, 1);
  mj_resetDataKeyframe(model.get(), data.get(), 0);
  mj_forward(model.get(), data.get());
  for (int drive = 0; drive < model->nu; ++drive) {
    const bool servo = model->actuator_biastype[drive] == mjBIAS_AFFINE;  // wheels have forces
    EXPECT_NEAR(data->ctrl[drive], servo ? data->actuator_length[drive] : 0, 1e-5)  // six digits
        << mj_id2name(model.get(), mjOBJ_ACTUATOR, drive);
  }
  for (const char* joint : {"panda-on-stand/", "panda-on-stand-2/", "realman-rm75/"}) {
    int found = 0;
    for (int j = 0; j < model->njnt; ++j)
      found += std::string(mj_id2name(model.get(), mjOBJ_JOINT, j)).starts_with(joint) ? 1 : 0;
    EXPECT_GE(found, 7) << joint;
  }
  const std::vector<double> before(data->qpos, data->qpos + model->nq);
  for (int i = 0; i < 250; ++i)
    mj_step(model.get(), data.get());
  for (int q = 0; q < model->nq; ++q)
    EXPECT_NEAR(data->qpos[q], before[static_cast<std::size_t>(q)], 0.02) << q;
}

// The label keeps its place at the top of the sheet; what is not printed shows its own swatch.
TEST(MjcfLook, OneSheetHasTheLabelAndASwatchForEveryOtherSurface) {
  assets::ProductModel model;
  model.surfaces = {{.texture = "label"}, {.color = {1, 0, 0}}, {.texture = "steel-test"}};
  const auto corner = model.mesh.add_vertex({0, 0, 0}, {0, -1, 0}, {1, 1});
  model.mesh.add_vertex({1, 0, 0}, {0, -1, 0}, {0, 0});
  model.mesh.add_vertex({0, 0, 1}, {0, -1, 0}, {0.5F, 0.5F});
  for (const std::uint16_t surface : {std::uint16_t{0}, std::uint16_t{1}, std::uint16_t{2}})
    model.mesh.add_triangle(corner, 1, 2, surface);
  Image label(40, 24);
  std::ranges::fill(label.pixels, std::uint8_t{90});
  catalog::MaterialRow steel;
  steel.id = "steel-test";
  steel.color = "#0000ff";
  const Result<exporters::SheetLook> look = exporters::sheet_look(model, label, {steel});
  ASSERT_TRUE(look.ok()) << to_string(look.error());
  EXPECT_EQ(look->mesh.triangles.size(), 3U);
  EXPECT_EQ(look->mesh.positions.size(), 9U);  // each surface has its own corners
  const auto pixel = [&](std::size_t triangle, std::size_t at) {
    const Vec2f uv = look->mesh.uvs[look->mesh.triangles[triangle][at]];
    const std::uint8_t* p =
        look->sheet.at(std::min(static_cast<int>(uv.x * static_cast<float>(look->sheet.width)), 39),
                       static_cast<int>(uv.y * static_cast<float>(look->sheet.height)));
    return std::array<int, 3>{p[0], p[1], p[2]};
  };
  for (std::size_t at = 0; at < 3; ++at) {
    EXPECT_EQ(pixel(0, at), (std::array<int, 3>{90, 90, 90}));
    EXPECT_EQ(pixel(1, at), (std::array<int, 3>{255, 0, 0}));
    EXPECT_EQ(pixel(2, at), (std::array<int, 3>{0, 0, 255}));
  }
}

}  // namespace
}  // namespace marketgen
