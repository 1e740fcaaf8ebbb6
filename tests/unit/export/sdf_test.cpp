// What SDF exports alone have: free items in models of their own, joints, and a reader that notices
// what was changed in the file.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "export/export.h"
#include "io/file.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

class SdfExport : public testing::Test {
 protected:
  SdfExport() : folder_(fs::temp_directory_path() / ("marketgen-sdf-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    made_.stock();
    made_.scene.joints.push_back({.name = "door",
                                  .kind = assets::JointKind::hinge,
                                  .position_m = {-0.5F, -0.2F, 0.3F},
                                  .upper = 1.5F,
                                  .friction = 0.2F,
                                  .damping = 0.4F,
                                  .stiffness = 1,
                                  .hold_open = 1.5F,
                                  .mass_kg = 3,
                                  .states = {},
                                  .gasket = 2,
                                  .gasket_reach = 0.02F});
    made_.scene.fixtures[0].joint_count = 1;
    made_.scene.parts.back().joint = 0;
  }
  ~SdfExport() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "shop.sdf"; }
  Result<exporters::ExportSummary> exported(const exporters::ExportOptions& options = {}) const {
    MARKETGEN_CHECK(exporters::export_scene(made_.scene, "sdf", file(), options));
    return exporters::check_export(made_.scene, "sdf", file(), options);
  }
  // What --check says after the first `old` in the file was replaced; "fine" when nothing.
  std::string after(const std::string& old, const std::string& by) const {
    std::string text = *io::read_file(file());
    const std::size_t at = text.find(old);
    if (at == std::string::npos) return "the file has no \"" + old + "\"";
    const std::string kept = text;
    EXPECT_TRUE(io::write_file(file(), text.replace(at, old.size(), by)).ok());
    const auto summary = exporters::check_export(made_.scene, "sdf", file());
    EXPECT_TRUE(io::write_file(file(), kept).ok());
    return summary.ok() ? "fine" : summary.error().message;
  }

  HandMadeScene made_;
  fs::path folder_;
};

TEST_F(SdfExport, AFreeRegionGivesModelsThatCanMove) {
  exporters::ExportOptions options;
  options.free_region_m = {{0, 0, 2.75, 4}};
  const auto summary = exported(options);
  ASSERT_TRUE(summary.ok()) << to_string(summary.error());
  EXPECT_GT(summary->free_bodies, 0U);
  EXPECT_LT(summary->free_bodies, summary->products);
}

TEST_F(SdfExport, WhatHangsFreelyHasAJointAtItsUpperEdge) {
  made_.scene.shelves[1].use = assets::ShelfUse::hang;  // three packs of cereal, 0.28 m high
  exporters::ExportOptions options;
  options.free_region_m = {{0, 0, 6, 4}};
  const auto summary = exported(options);
  ASSERT_TRUE(summary.ok()) << to_string(summary.error());
  const std::string hook =
      "<joint name=\"hook\" type=\"ball\"><parent>world</parent><child>item</child>"
      "<pose>0 0 0.28 0 0 0</pose></joint>";
  const std::string text = *io::read_file(file());
  int hooks = 0;
  for (std::size_t at = text.find(hook); at != std::string::npos; at = text.find(hook, at + 1))
    ++hooks;
  EXPECT_EQ(hooks, 3);
}

TEST_F(SdfExport, JointsMoveUnlessFixturesAreStill) {
  const auto moving = exported();
  ASSERT_TRUE(moving.ok()) << to_string(moving.error());
  EXPECT_EQ(moving->joints, 1U);
  exporters::ExportOptions options;
  options.still_fixtures = true;
  const auto still = exported(options);
  ASSERT_TRUE(still.ok()) << to_string(still.error());
  EXPECT_EQ(still->joints, 0U);
}

TEST_F(SdfExport, CheckNoticesWhatWasChanged) {
  ASSERT_TRUE(exported().ok());
  EXPECT_EQ(after("<gravity>", "<gravity>"), "fine");
  EXPECT_NE(after("mass_kg=\"", "mass_kg=\"1").find("another mass"), std::string::npos);
  EXPECT_NE(after("<mu>", "<mu>1").find("another friction"), std::string::npos);
  EXPECT_NE(after("<damping>", "<damping>1").find("another damping"), std::string::npos);
  EXPECT_NE(after("gasket=\"", "gasket=\"1").find("another gasket"), std::string::npos);
  EXPECT_NE(after("<spring_stiffness>", "<spring_stiffness>1").find("another spring"),
            std::string::npos);
  EXPECT_NE(after("<joint name=\"body/mount\" type=\"fixed\"",
                  "<joint name=\"body/mount\" type=\"revolute\"")
                .find("not fixed to the world"),
            std::string::npos);
  EXPECT_NE(after("<model name=\"dry/run-1/module-1\">",
                  "<model name=\"dry/run-1/module-1\"><static>true</static>")
                .find("nothing moves in a static model"),
            std::string::npos);
  EXPECT_NE(after("<radius>", "<radius>1").find("the solid of"), std::string::npos);
  EXPECT_NE(after("</world>", "").find("no XML"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
