// What the check of a planogram sees.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "export/export.h"
#include "io/file.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

class Planogram : public testing::Test {
 protected:
  Planogram()
      : folder_(fs::temp_directory_path() / ("marketgen-planogram-" + std::to_string(getpid()))) {
    HandMadeScene made;
    made.stock();
    scene_ = made.scene;
    fs::create_directories(folder_);
    const Result<void> written = exporters::export_scene(scene_, "planogram", file());
    EXPECT_TRUE(written.ok()) << to_string(written.error());
    text_ = *io::read_file(file());
  }
  ~Planogram() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "shop.csv"; }

  std::string fault_of(const std::string& text) const {
    EXPECT_TRUE(io::write_file(file(), text).ok());
    const auto checked = exporters::check_export(scene_, "planogram", file());
    if (checked.ok()) return "";
    EXPECT_EQ(checked.error().code, "export.mismatch");
    return checked.error().where + ": " + checked.error().message;
  }
  // Of the text with its first `from` changed.
  std::string fault_with(const std::string& from, const std::string& to) const {
    std::string text = text_;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    return fault_of(text);
  }
  static testing::AssertionResult says(const std::string& fault, const std::string& what) {
    if (fault.find(what) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "\"" << fault << "\" says nothing of " << what;
  }

  scene::Scene scene_;
  fs::path folder_;
  std::string text_;
};

TEST_F(Planogram, HasARowForEachBlockInTheWordsOfTheTrade) {
  EXPECT_EQ(fault_of(text_), "");
  EXPECT_TRUE(says(text_, "Corner & Co <test>,dry/run-1,dry/run-1/module-1,front,1,1250,1,150,1,"));
  EXPECT_TRUE(says(text_,
                   ",2000000000015,can-cola,Cola,Fonda,beverages,soft drinks,66,115,66,1,1,1,"
                   "1,1,front,unit,0.99,false\r\n"));
  EXPECT_EQ(std::ranges::count(text_, '\n'), 1 + 8);
}

TEST_F(Planogram, EachFaultIsNamedWithItsRow) {
  EXPECT_TRUE(says(fault_with("2000000000015", "2000000000022"), "shop.csv:2: \"2000000000022\""));
  EXPECT_TRUE(says(fault_with("can-cola", "can-lime"), "has no product \"can-lime\""));
  EXPECT_TRUE(says(fault_with(",1,1,front", ",1,0,front"), "it has 4 units of \"can-cola\" on"));
  EXPECT_TRUE(says(fault_with(",66,1,1,1,1,", ",66,2,1,1,1,"), "2 x 1 x 1 packs are no capacity"));
  EXPECT_TRUE(says(fault_with("66,115,66", "66,115,67"), "\"can-cola\" is of another size"));
  EXPECT_TRUE(says(fault_with(",unit,0.99", ",unit,1.99"), "1.99 is not the price"));
  EXPECT_TRUE(says(fault_with(",front,1,1250,1,150,1,", ",back,1,1250,1,150,1,"), "\", front"));
  EXPECT_TRUE(says(fault_with(",1,1,front", ",1,2,front"), "2 units stand where 1 have room"));
  EXPECT_TRUE(says(fault_with(",1250,1,150,1,5,", ",1250,1,150,1,1200,"), "from 1200 to 1266 mm"));
  EXPECT_TRUE(says(fault_with(",1250,1,", ",wide,1,"), "\"wide\" in column \"bay_width_mm\""));
  EXPECT_TRUE(says(fault_with("gtin", "upc"), "no column \"gtin\""));
  EXPECT_TRUE(says(fault_of(text_.substr(0, text_.size() - 2)), "cut off"));
  const std::size_t last_row = text_.rfind("Corner & Co");
  EXPECT_TRUE(says(fault_of(text_.substr(0, last_row)), "it has 7 rows, the store 8 blocks"));
}

TEST_F(Planogram, WhatIsSoldByWeightHasNoNumber) {
  for (catalog::Product& product : scene_.catalog)
    product.ean.clear();
  ASSERT_TRUE(exporters::export_scene(scene_, "planogram", file()).ok());
  EXPECT_EQ(fault_of(*io::read_file(file())), "");
  EXPECT_TRUE(says(fault_of(text_), "is not the GTIN"));  // a number where there is none
}

}  // namespace
}  // namespace marketgen
