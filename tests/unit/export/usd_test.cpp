// What USD exports alone have: names, meshes without joints of more than two faces, free goods,
// still fixtures, and what is said without OpenUSD.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "export/exporter.h"
#include "export/usd_geometry.h"
#include "export/usd_text.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

std::string beside(const exporters::ExportFiles& files, const std::string& name) {
  for (const exporters::BesideFile& file : files.beside) {
    if (file.name == name) return file.bytes;
  }
  ADD_FAILURE() << name << " is missing";
  return {};
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++found;
  return found;
}

TEST(UsdNames, AreIdentifiersAndNoTwoAlike) {
  exporters::UsdNames names;
  EXPECT_EQ(names.of("dairy/run-1"), "dairy_run_1");
  EXPECT_EQ(names.of("dairy-run/1"), "dairy_run_1_2");
  EXPECT_EQ(names.of("7-up"), "_7_up");
  EXPECT_EQ(exporters::usd_quoted("6\" \\ pack"), "\"6\\\" \\\\ pack\"");
}

// OpenUSD takes the angle from w: single precision would make 1 of it, and no turn.
TEST(UsdText, KeepsTurnsOfAHundredthOfADegree) {
  EXPECT_EQ(exporters::usd_orient(rotation_about({0, 0, 1}, 2e-4)).substr(0, 15),
            "(0.999999995, 0");
}

// Two boxes that share an edge, as boards and uprights do.
TEST(UsdMeshes, NoEdgeHasMoreThanTwoFaces) {
  Mesh mesh;
  add_box(mesh, {0, 0, 0}, {1, 1, 1}, 0, 0);
  const auto second = static_cast<std::uint32_t>(mesh.positions.size());
  add_box(mesh, {1, 1, 0}, {2, 2, 1}, 0, 0);
  const std::vector<exporters::UsdMesh> made = exporters::usd_meshes(mesh, {true}, {0, second});
  ASSERT_EQ(made.size(), 2U);
  for (const exporters::UsdMesh& one : made) {
    EXPECT_EQ(one.points.size(), 8U);
    EXPECT_EQ(one.normals.size(), 6U);
    EXPECT_EQ(one.corners.size(), 36U);
    EXPECT_EQ(one.corner_st.size(), one.corners.size());
    std::map<std::pair<int, int>, int> edges;
    for (std::size_t i = 0; i < one.corners.size(); ++i) {
      const int a = one.corners[i], b = one.corners[i % 3 == 2 ? i - 2 : i + 1];
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
    for (const auto& [edge, faces] : edges)
      EXPECT_EQ(faces, 2);
  }
}

TEST(UsdMeshes, DropTrianglesWithoutAnArea) {
  Mesh mesh;
  for (const Vec3f p : {Vec3f{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}})
    mesh.add_vertex(p, {0, 0, 1}, {});
  mesh.add_triangle(0, 1, 2, 0);
  mesh.add_triangle(0, 1, 3, 0);
  const std::vector<exporters::UsdMesh> made = exporters::usd_meshes(mesh, {false});
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(made[0].corners.size(), 3U);
  EXPECT_EQ(made[0].points.size(), 3U);
  EXPECT_TRUE(made[0].st.empty());
}

TEST(UsdExport, OnlyGoodsInTheRegionAreFree) {
  HandMadeScene made;
  made.stock();
  exporters::ExportOptions options;
  const Result<exporters::ExportFiles> still = exporters::write_usd(made.scene, options);
  ASSERT_TRUE(still.ok()) << to_string(still.error());
  EXPECT_EQ(count(beside(*still, "products.usda"), "PhysicsRigidBodyAPI"), 0U);
  options.free_region_m = {{-1, -1, 100, 100}};
  const Result<exporters::ExportFiles> free = exporters::write_usd(made.scene, options);
  ASSERT_TRUE(free.ok()) << to_string(free.error());
  EXPECT_EQ(count(beside(*free, "goods.usda"), "string physics = \"free\""),
            made.scene.products.size());
  EXPECT_GT(count(beside(*free, "products.usda"), "physics:diagonalInertia"), 0U);
}

TEST(UsdExport, WithoutOpenUsdTheCheckSaysWhatToInstall) {
  HandMadeScene made;
  made.stock();
  const fs::path folder = fs::temp_directory_path() / ("marketgen-usd-" + std::to_string(getpid()));
  fs::create_directories(folder);
  ASSERT_TRUE(exporters::export_scene(made.scene, "usd", folder / "shop.usda").ok());
  const char* before = std::getenv("MARKETGEN_PYTHON");
  const std::string kept = before == nullptr ? "" : before;
  setenv("MARKETGEN_PYTHON", "/nonexistent/python", 1);
  const Result<exporters::ExportSummary> summary =
      exporters::check_export(made.scene, "usd", folder / "shop.usda");
  before == nullptr ? unsetenv("MARKETGEN_PYTHON") : setenv("MARKETGEN_PYTHON", kept.c_str(), 1);
  fs::remove_all(folder);
  ASSERT_FALSE(summary.ok());
  EXPECT_NE(summary.error().code, "export.mismatch") << to_string(summary.error());
}

}  // namespace
}  // namespace marketgen
