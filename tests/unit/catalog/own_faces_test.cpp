// Pictures of packs' sides as rows name them: read, made ready, kept, carried by stores.
#include "catalog/own_faces.h"

#include <gtest/gtest.h>

#include "catalog/own_files.h"
#include "catalog/user_products.h"
#include "support/exif_bytes.h"
#include "support/face_pictures.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

class OwnFaces : public testing::Test {
 protected:
  void SetUp() override { setenv("MARKETGEN_CACHE", (scratch_.path() / "cache").c_str(), 1); }
  void TearDown() override { unsetenv("MARKETGEN_CACHE"); }

  Result<catalog::Product> row(const std::string& faces) const {
    write_bytes(scratch_.path() / "own.json",
                R"([{"sku": "own-tea", "ean": "2999999999991", "name": "Tea",
      "category": "dry_goods", "subcategory": "tea", "archetype": "box", "size_mm": [60, 60, 120],
      "mass_kg": 0.1, "faces": )" +
                    faces + "}]");
    MARKETGEN_TRY(const auto rows, catalog::read_user_products(scratch_.path() / "own.json"));
    return rows.at(0);
  }
  static Result<Image> front_of(const catalog::Product& product) {
    return catalog::kept_face(catalog::face_name(product, catalog::face_slots[0]));
  }
  void expect_refused(const std::string& faces,
                      const std::string& code,
                      const std::string& where,
                      const std::string& says) const {
    const auto product = row(faces);
    ASSERT_FALSE(product.ok()) << faces;
    EXPECT_EQ(product.error().code, code) << to_string(product.error());
    EXPECT_NE(product.error().where.find(where), std::string::npos) << to_string(product.error());
    EXPECT_NE(product.error().message.find(says), std::string::npos) << to_string(product.error());
  }

  ScratchFolder scratch_;
};

TEST_F(OwnFaces, ArePartOfARowByTheirContent) {
  const Image picture = graded_picture(120, 240, 30);
  write_png_face(scratch_.path() / "pictures/tea front.png", picture);
  const auto tea = row(R"({"front": "pictures/tea front.png"})");
  ASSERT_TRUE(tea.ok()) << to_string(tea.error());
  ASSERT_TRUE(tea->faces.has_value());
  EXPECT_EQ(tea->faces->front.size(), 68U);
  EXPECT_TRUE(tea->faces->back.empty());
  EXPECT_EQ(front_of(*tea)->pixels, picture.pixels);
  write_png_face(scratch_.path() / "other.png", picture);
  EXPECT_EQ(row(R"({"front": "other.png"})")->faces->front, tea->faces->front);
  EXPECT_EQ(catalog::kept_face_size(catalog::face_names(*tea)[0]).value(), (PictureSize{120, 240}));
}

TEST_F(OwnFaces, ColumnsOfACsvNameThem) {
  write_png_face(scratch_.path() / "f.png", graded_picture(120, 240, 30));
  write_bytes(scratch_.path() / "own.csv",
              "sku,ean,name,category,subcategory,archetype,size_mm,mass_kg,faces.front,"
              "contents.color,country\n"
              "own-a,2999999999991,A,dry_goods,tea,box,60x60x120,0.1,f.png,,\n"
              "own-b,2999999999984,B,dry_goods,tea,jar,60x60x120,0.1,,#102030,us\n");
  const auto rows = catalog::read_user_products(scratch_.path() / "own.csv");
  ASSERT_TRUE(rows.ok()) << to_string(rows.error());
  ASSERT_TRUE(rows->at(0).faces.has_value());
  EXPECT_EQ(rows->at(0).faces->front.size(), 68U);
  EXPECT_FALSE(rows->at(0).contents.has_value());
  EXPECT_FALSE(rows->at(1).faces.has_value());
  EXPECT_EQ(rows->at(1).contents.value().color, "#102030");
  EXPECT_EQ(rows->at(1).country, "us");
}

// A photo stands as the camera was held, and nothing else of its file is kept.
TEST_F(OwnFaces, APhotoIsTurnedAndLosesWhatElseItSays) {
  const std::string jpeg = io::encode_jpeg(graded_picture(240, 120, 30)).value();
  write_bytes(scratch_.path() / "photo.jpg", with_orientation(jpeg, 6, true));
  const auto tea = row(R"({"front": "photo.jpg"})");
  ASSERT_TRUE(tea.ok()) << to_string(tea.error());
  EXPECT_TRUE(tea->faces->front.ends_with(".jpg"));
  const Image upright = front_of(*tea).value();
  EXPECT_EQ(upright.width, 120);
  EXPECT_EQ(upright.height, 240);
  EXPECT_NEAR(upright.at(60, 10)[0], 20 + 200 * 10.5 / 240, 4);  // turned right: x runs downwards
  const std::string kept = contents_of(scratch_.path() / "cache/faces" / tea->faces->front);
  EXPECT_EQ(kept.find("Exif"), std::string::npos);
}

// See-through borders are cut off; what is see-through within has the colour beside it.
TEST_F(OwnFaces, ACutOutPackFillsItsPicture) {
  Image cut(100, 100, 4);
  const auto paint = [&](int x0, int x1, int y0, int y1, std::uint8_t red) {
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        cut.at(x, y)[0] = red;
        cut.at(x, y)[3] = 255;
      }
    }
  };
  paint(40, 60, 10, 30, 200);  // a neck
  paint(30, 70, 30, 90, 100);  // on a body
  write_png_face(scratch_.path() / "cut.png", cut);
  const auto tea = row(R"({"front": "cut.png"})");
  ASSERT_TRUE(tea.ok()) << to_string(tea.error());
  const Image front = front_of(*tea).value();
  EXPECT_EQ(front.width, 40);
  EXPECT_EQ(front.height, 80);
  EXPECT_EQ(front.channels, 3);
  EXPECT_EQ(front.at(0, 0)[0], 200);
  EXPECT_EQ(front.at(39, 19)[0], 200);
  EXPECT_EQ(front.at(0, 20)[0], 100);
}

TEST_F(OwnFaces, LargeOnesAreMadeSmaller) {
  write_png_face(scratch_.path() / "large.png", graded_picture(2000, 4000, 30));
  const Image front = front_of(row(R"({"front": "large.png"})").value()).value();
  EXPECT_EQ(front.width, catalog::max_face_px / 2);
  EXPECT_EQ(front.height, catalog::max_face_px);
  EXPECT_NEAR(front.at(400, 800)[0], 120, 1);
  EXPECT_NEAR(front.at(400, 800)[1], 120, 1);
}

TEST_F(OwnFaces, FaultsNameTheFileOrTheRow) {
  write_bytes(scratch_.path() / "text.png", "no picture");
  const std::string png = io::encode_png(graded_picture(60, 120, 0)).value();
  write_bytes(scratch_.path() / "half.png", png.substr(0, png.size() / 2));
  write_png_face(scratch_.path() / "tiny.png", graded_picture(8, 16, 0));
  write_png_face(scratch_.path() / "clear.png", Image(40, 40, 4));
  expect_refused(R"({"front": "text.png"})", "image.bad_file", "text.png", "not a readable");
  expect_refused(R"({"front": "half.png"})", "image.bad_file", "half.png", "damaged");
  expect_refused(R"({"front": "tiny.png"})", "image.too_small", "tiny.png", "at least 16");
  expect_refused(R"({"front": "clear.png"})", "image.bad_file", "clear.png", "see-through");
  expect_refused(R"({"back": "none.png"})", "input.not_found", "none.png", "");
  expect_refused(R"({"back": "../a.png"})",
                 "input.outside_folder",
                 "own.json:own-tea/faces/back",
                 "not in the folder");
  expect_refused("{}", "catalog.bad_row", "own.json:own-tea/faces", "names no picture");
  expect_refused(R"({"fornt": "a.png"})", "json.unknown_field", "faces/fornt", "\"front\"");
}

TEST_F(OwnFaces, StoresCarryThem) {
  write_png_face(scratch_.path() / "f.png", graded_picture(120, 240, 30));
  write_png_face(scratch_.path() / "b.png", graded_picture(120, 240, 60));
  const catalog::Product tea = row(R"({"front": "f.png", "back": "b.png"})").value();
  const fs::path shop = scratch_.path() / "shop";
  ASSERT_TRUE(catalog::save_own_files({tea}, shop).ok());
  fs::remove_all(scratch_.path() / "cache");
  EXPECT_EQ(front_of(tea).error().code, "input.not_found");
  ASSERT_TRUE(catalog::restore_own_files({tea}, shop).ok());
  EXPECT_TRUE(front_of(tea).ok());

  write_bytes(scratch_.path() / "cache/faces" / tea.faces->front, "changed");
  EXPECT_EQ(front_of(tea).error().code, "input.not_found");  // not used
  ASSERT_TRUE(row(R"({"front": "f.png"})").ok());            // put right by its catalogue
  EXPECT_TRUE(front_of(tea).ok());

  fs::remove_all(scratch_.path() / "cache");
  write_bytes(shop / "faces" / tea.faces->front, "changed");
  EXPECT_EQ(catalog::restore_own_files({tea}, shop).error().code, "image.bad_file");
  catalog::Product hostile = tea;
  hostile.faces->front = "../../../etc/passwd";
  EXPECT_EQ(front_of(hostile).error().code, "image.bad_file");
  EXPECT_EQ(catalog::restore_own_files({hostile}, shop).error().code, "image.bad_file");
}

// What no item shows yet goes along where it is there.
TEST_F(OwnFaces, StoresCarryWhatAnEditMayNeed) {
  write_png_face(scratch_.path() / "f.png", graded_picture(120, 240, 30));
  write_png_face(scratch_.path() / "b.png", graded_picture(120, 240, 60));
  const catalog::Product tea = row(R"({"front": "f.png", "back": "b.png"})").value();
  fs::remove(scratch_.path() / "cache/faces" / tea.faces->back);
  const fs::path shop = scratch_.path() / "shop";
  EXPECT_FALSE(catalog::save_own_files({tea}, shop).ok());
  fs::remove_all(shop);
  ASSERT_TRUE(catalog::save_spare_files({tea}, shop).ok());
  EXPECT_TRUE(fs::exists(shop / "faces" / tea.faces->front));
  fs::remove_all(scratch_.path() / "cache");
  ASSERT_TRUE(catalog::restore_spare_files({tea}, shop).ok());
  EXPECT_TRUE(front_of(tea).ok());
  EXPECT_FALSE(catalog::kept_face(catalog::face_names(tea)[1]).ok());
}

}  // namespace
}  // namespace marketgen
