// What every format promises, over the rows of export_formats.inc, and the errors of the two calls.
#include "export/export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "export/licences.h"
#include "io/file.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

scene::Scene stocked_scene() {
  HandMadeScene made;
  made.stock();
  const float half_turn = 0.5F;  // of a quarter: the item is turned by 60 degrees
  made.add(2,
           {3.1F, HandMadeScene::shelf_y_m - 0.1F, HandMadeScene::lower_board_m},
           {0.8660254F, 0, 0, half_turn});
  return made.scene;
}

class EveryFormat : public testing::TestWithParam<exporters::ExportFormat> {
 protected:
  EveryFormat() {
    folder_ = fs::temp_directory_path() /
              ("marketgen-export-" + std::to_string(getpid()) + "-" + std::string(GetParam().name));
    fs::create_directories(folder_);
  }
  ~EveryFormat() override { fs::remove_all(folder_); }

  fs::path file(std::string_view stem = "shop") const {
    return folder_ / (std::string(stem) + std::string(GetParam().extension));
  }

  fs::path folder_;
};

using WholeStore = EveryFormat;  // formats that hold every item

TEST_P(WholeStore, ReadsBackAsTheSameScene) {
  const scene::Scene scene = stocked_scene();
  const Result<void> written = exporters::export_scene(scene, GetParam().name, file());
  ASSERT_TRUE(written.ok()) << to_string(written.error());
  const Result<exporters::ExportSummary> summary =
      exporters::check_export(scene, GetParam().name, file());
  ASSERT_TRUE(summary.ok()) << to_string(summary.error());
  EXPECT_EQ(summary->fixtures, 1U);
  EXPECT_EQ(summary->products, 9U);
  EXPECT_EQ(summary->skus, 3U);
  EXPECT_LT(summary->worst_position_error_m, 1e-5);
  // The walls' outer faces, 0.2 m outside the room of 6 x 4 x 3 m.
  EXPECT_NEAR(summary->bounds_low_m[0], -0.2, 1e-3);
  EXPECT_NEAR(summary->bounds_low_m[2], 0, 1e-3);
  EXPECT_NEAR(summary->bounds_high_m[1], 4.2, 1e-3);
  EXPECT_NEAR(summary->bounds_high_m[2], 3, 1e-3);
}

// Every file below the folder, by its path there.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = *io::read_file(entry.path());
  }
  return files;
}

TEST_P(EveryFormat, SameSceneSameBytes) {
  fs::create_directories(folder_ / "a");
  fs::create_directories(folder_ / "b");
  ASSERT_TRUE(exporters::export_scene(stocked_scene(), GetParam().name, file("a/shop")).ok());
  ASSERT_TRUE(exporters::export_scene(stocked_scene(), GetParam().name, file("b/shop")).ok());
  EXPECT_GE(files_in(folder_ / "a").size(), 1U);
  EXPECT_EQ(files_in(folder_ / "a"), files_in(folder_ / "b"));
}

// A map and a table of numbers show nothing that anybody drew.
TEST_P(EveryFormat, WhatShowsTheStoresThingsHasItsLicencesBesideIt) {
  exporters::ExportOptions options;
  options.looks = true;
  ASSERT_TRUE(exporters::export_scene(stocked_scene(), GetParam().name, file(), options).ok());
  const fs::path licences = folder_ / "shop_assets/LICENCES.md";
  const bool shows = GetParam().name != "nav2" && GetParam().name != "planogram";
  ASSERT_EQ(fs::exists(licences), shows);
  if (shows) {
    EXPECT_NE(io::read_file(licences)->find("Apache-2.0"), std::string::npos);
  }
}

TEST(Licences, ImportedModelsAreNotOurs) {
  scene::Scene scene = stocked_scene();
  const std::string ours = exporters::licences_file(scene).bytes;
  catalog::Product& imported = scene.catalog[scene.products[0].sku];
  EXPECT_EQ(ours.find(imported.sku), std::string::npos);
  imported.archetype = "mesh";
  const std::string told = exporters::licences_file(scene).bytes;
  EXPECT_EQ(told.substr(0, ours.size()), ours);
  EXPECT_NE(told.find("- `" + imported.sku + "`\n"), std::string::npos);
}

TEST_P(EveryFormat, IsCheckedAgainstTheSceneItWasMadeOf) {
  const scene::Scene scene = stocked_scene();
  ASSERT_TRUE(exporters::export_scene(scene, GetParam().name, file()).ok());
  const Result<exporters::ExportSummary> summary =
      exporters::check_export(scene, GetParam().name, file());
  ASSERT_TRUE(summary.ok()) << to_string(summary.error());
  EXPECT_EQ(summary->fixtures, 1U);
  EXPECT_FALSE(summary->in_words.empty());
  scene::Scene emptied = scene;
  emptied.layout.fixtures.clear(), emptied.fixtures.clear(), emptied.parts.clear();
  emptied.shelves.clear(), emptied.facings.clear(), emptied.products.clear();
  emptied.price_labels.clear();
  const Result<exporters::ExportSummary> other =
      exporters::check_export(emptied, GetParam().name, file());
  ASSERT_FALSE(other.ok());
  EXPECT_EQ(other.error().code, "export.mismatch");
}

TEST_P(WholeStore, NoticesAnItemThatMovedByAMillimetre) {
  scene::Scene scene = stocked_scene();
  ASSERT_TRUE(exporters::export_scene(scene, GetParam().name, file()).ok());
  scene.products[4].position_m[1] += 0.001F;
  const Result<exporters::ExportSummary> summary =
      exporters::check_export(scene, GetParam().name, file());
  ASSERT_FALSE(summary.ok());
  EXPECT_EQ(summary.error().code, "export.mismatch");
  EXPECT_NE(summary.error().message.find("dry/run-1/module-1/level-0/facing-4/item-0"),
            std::string::npos)
      << summary.error().message;
}

TEST_P(WholeStore, NoticesAMissingAndAnExchangedItem) {
  const scene::Scene scene = stocked_scene();
  ASSERT_TRUE(exporters::export_scene(scene, GetParam().name, file()).ok());
  scene::Scene fewer = scene;
  fewer.products.pop_back();
  EXPECT_EQ(exporters::check_export(fewer, GetParam().name, file()).error().code,
            "export.mismatch");
  scene::Scene exchanged = scene;
  exchanged.catalog[0].sku = "box-other";
  EXPECT_EQ(exporters::check_export(exchanged, GetParam().name, file()).error().code,
            "export.mismatch");
}

TEST_P(WholeStore, NoticesAnotherRoomAndAnotherFixture) {
  const scene::Scene scene = stocked_scene();
  ASSERT_TRUE(exporters::export_scene(scene, GetParam().name, file()).ok());
  scene::Scene higher = scene;
  higher.layout.shell.ceiling_mm += 100;
  EXPECT_NE(
      exporters::check_export(higher, GetParam().name, file()).error().message.find("along z"),
      std::string::npos);
  scene::Scene renamed = scene;
  renamed.layout.fixtures[0].id = "dry/run-1/module-2";
  EXPECT_NE(
      exporters::check_export(renamed, GetParam().name, file()).error().message.find("module-2"),
      std::string::npos);
}

TEST_P(EveryFormat, AnEmptyShopIsExportedToo) {
  const scene::Scene scene = HandMadeScene().scene;
  ASSERT_TRUE(exporters::export_scene(scene, GetParam().name, file()).ok());
  const Result<exporters::ExportSummary> summary =
      exporters::check_export(scene, GetParam().name, file());
  ASSERT_TRUE(summary.ok()) << to_string(summary.error());
  EXPECT_EQ(summary->products, 0U);
}

TEST_P(EveryFormat, ADamagedFileIsAnErrorWhereverItIsCut) {
  const scene::Scene scene = stocked_scene();
  ASSERT_TRUE(exporters::export_scene(scene, GetParam().name, file()).ok());
  const std::string bytes = *io::read_file(file());
  for (const double share : {0.0, 0.0005, 0.1, 0.5, 0.95, 0.999}) {
    // Two bytes at least: in a text the last is the end of its last line, which nothing needs.
    const std::size_t kept = std::min(
        static_cast<std::size_t>(share * static_cast<double>(bytes.size())), bytes.size() - 2);
    ASSERT_TRUE(io::write_file(file("cut"), bytes.substr(0, kept)).ok());
    const Result<exporters::ExportSummary> summary =
        exporters::check_export(scene, GetParam().name, file("cut"));
    ASSERT_FALSE(summary.ok()) << "cut after " << kept << " bytes";
    EXPECT_EQ(summary.error().code, "export.mismatch");
  }
}

TEST_P(EveryFormat, AMissingFileAndAnUnwritablePlaceAreErrors) {
  const scene::Scene scene = stocked_scene();
  EXPECT_EQ(exporters::check_export(scene, GetParam().name, file("none")).error().code,
            "input.not_found");
  const Result<void> written =
      exporters::export_scene(scene, GetParam().name, "/proc/no-such-folder/shop");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, "io.cannot_write");
  EXPECT_TRUE(fs::is_empty(folder_)) << "nothing may be left half-written";
}

std::vector<exporters::ExportFormat> whole_formats() {
  std::vector<exporters::ExportFormat> formats = exporters::export_formats();
  std::erase_if(formats, [](const exporters::ExportFormat& format) { return !format.whole; });
  return formats;
}

constexpr auto name_of_format = [](const auto& format) { return std::string(format.param.name); };

INSTANTIATE_TEST_SUITE_P(Formats,
                         EveryFormat,
                         testing::ValuesIn(exporters::export_formats()),
                         name_of_format);
INSTANTIATE_TEST_SUITE_P(Formats, WholeStore, testing::ValuesIn(whole_formats()), name_of_format);

TEST(Export, AnUnknownFormatNamesTheNearest) {
  const Result<void> written =
      exporters::export_scene(stocked_scene(), "mjfc", "/tmp/never-written.xml");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, "export.unknown_format");
  EXPECT_NE(written.error().message.find("did you mean \"mjcf\"?"), std::string::npos)
      << written.error().message;
  EXPECT_EQ(exporters::check_export(stocked_scene(), "fbx", "/tmp/x").error().code,
            "export.unknown_format");
}

}  // namespace
}  // namespace marketgen
