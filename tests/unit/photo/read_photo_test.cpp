// The committed bank, and photos that it was not made with.
#include "photo/read_photo.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/jpeg.h"
#include "io/json.h"
#include "io/png.h"
#include "support/run_program.h"

namespace marketgen::photo {
namespace {

const std::filesystem::path source = MARKETGEN_SOURCE_DIR;
const std::filesystem::path herringbone = source / "tests/shop_photos/0014-0.jpg";  // an oak floor

const Bank& bank() {
  static const Bank loaded = [] {
    auto bank = load_bank(source / "data");
    if (!bank.ok()) fatal(to_string(bank.error()).c_str());
    return std::move(bank).value();
  }();
  return loaded;
}

PhotoReading reading_of(const std::string& bytes) {
  auto reading = read_photo_bytes(bytes, "photo", bank());
  EXPECT_TRUE(reading.ok()) << to_string(reading.error());
  return reading.ok() ? reading.value() : PhotoReading{};
}

std::string code_of(const std::string& bytes) {
  const auto reading = read_photo_bytes(bytes, "photo", bank());
  return reading.ok() ? "" : reading.error().code;
}

TEST(PhotoBank, HasEveryAttributeOnce) {
  const std::vector<std::string> wanted = {"floor",
                                           "floor_color",
                                           "wall",
                                           "wall_color",
                                           "ceiling",
                                           "ceiling_color",
                                           "fixture",
                                           "fixture_color",
                                           "lamps",
                                           "light",
                                           "direction",
                                           "aisle",
                                           "levels",
                                           "shop",
                                           "subject"};
  std::vector<std::string> names;
  for (const Attribute& attribute : bank().attributes)
    names.push_back(attribute.name);
  EXPECT_EQ(names, wanted);
}

TEST(ReadPhoto, KnowsAShop) {
  const PhotoReading read = reading_of(contents_of(herringbone));
  EXPECT_EQ(read.subject, "room");
  EXPECT_GE(read.subject_confidence, sure);
  ASSERT_NE(read.find("floor"), nullptr);
  EXPECT_EQ(read.find("floor")->value, "wood");
  EXPECT_EQ(read.find("smell"), nullptr);
}

TEST(ReadPhoto, KnowsThatACatIsNoShop) {
  EXPECT_EQ(reading_of(contents_of(source / "tests/fixtures/photos/cat.jpg")).subject, "other");
}

TEST(ReadPhoto, IsTheSameEachTime) {
  const std::string bytes = contents_of(herringbone);
  EXPECT_EQ(io::write_json(reading_of(bytes)), io::write_json(reading_of(bytes)));
}

TEST(ReadPhoto, TakesGreyAndSeeThroughPictures) {
  const Image color = io::decode_jpeg(contents_of(herringbone), "photo").value();
  Image grey(color.width, color.height, 1), clear(color.width, color.height, 4);
  for (int y = 0; y < color.height; ++y) {
    for (int x = 0; x < color.width; ++x) {
      grey.at(x, y)[0] = color.at(x, y)[1];
      std::copy_n(color.at(x, y), 3, clear.at(x, y));
      clear.at(x, y)[3] = 255;
    }
  }
  const auto subject_of = [&](const Image& image) {
    return reading_of(io::encode_png(image).value()).subject;
  };
  EXPECT_EQ(subject_of(grey), "room");
  EXPECT_EQ(io::write_json(reading_of(io::encode_png(clear).value())),
            io::write_json(reading_of(io::encode_png(color).value())));
}

TEST(ReadPhoto, PaletteIsSortedAndAtMostTheWholePhoto) {
  const PhotoReading read = reading_of(contents_of(herringbone));
  ASSERT_FALSE(read.palette.empty());
  EXPECT_LE(read.palette.size(), 6U);
  double all = 0;
  for (std::size_t i = 0; i < read.palette.size(); ++i) {
    all += read.palette[i].share;
    if (i > 0) {
      EXPECT_LE(read.palette[i].share, read.palette[i - 1].share);
    }
  }
  EXPECT_LE(all, 1 + 1e-9);
}

TEST(ReadPhoto, RefusesWhatIsNoPhoto) {
  EXPECT_EQ(code_of(""), "image.bad_file");
  EXPECT_EQ(code_of("not a picture"), "image.bad_file");
  EXPECT_EQ(code_of(io::encode_png(Image(1, 1)).value()), "image.too_small");
  EXPECT_EQ(code_of(io::encode_png(Image(63, 640)).value()), "image.too_small");
  const auto missing = read_photo("no-such-photo.jpg", bank());
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, "input.not_found");
}

TEST(ReadPhoto, OddShapesAndEvenPicturesAreRead) {
  for (const auto& [width, height] :
       {std::pair(64, 64), std::pair(2000, 64), std::pair(64, 3000)}) {
    const std::string bytes = io::encode_png(Image(width, height)).value();
    EXPECT_NE(reading_of(bytes).subject, "room") << width << " x " << height;
  }
}

PhotoReading one(std::string attribute,
                 std::string value,
                 double confidence,
                 std::string material) {
  PhotoReading reading;
  reading.attributes = {{std::move(attribute), std::move(value), confidence, std::move(material)}};
  return reading;
}

TEST(Together, ConfidencesOfOneValueAddUp) {
  const std::vector<AttributeReading> all = together({one("floor", "wood", 0.7, "wood-oak"),
                                                      one("floor", "tiles", 0.5, "tile-white"),
                                                      one("floor", "tiles", 0.6, "tile-grey"),
                                                      one("lamps", "line", 0.2, "")});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].value, "tiles");
  EXPECT_EQ(all[0].material, "tile-grey");
  EXPECT_EQ(all[0].confidence, 0.6);
  EXPECT_EQ(all[1].value, "line");
  EXPECT_TRUE(together({}).empty());
}

TEST(Surface, IsOfTheSurerOfKindAndColour) {
  const std::vector<AttributeReading> readings = {{"floor", "wood", 0.6, "wood-oak"},
                                                  {"floor_color", "brown", 0.8, "wood-dark"},
                                                  {"wall", "brick", 0.4, "brick-red"},
                                                  {"wall_color", "red", 0.5, "brick-red"},
                                                  {"ceiling", "grid", 0.49, "ceiling-black"}};
  ASSERT_NE(surface_of(readings, "floor"), nullptr);
  EXPECT_EQ(surface_of(readings, "floor")->material, "wood-dark");
  ASSERT_NE(surface_of(readings, "wall"), nullptr);
  EXPECT_EQ(surface_of(readings, "wall")->attribute, "wall_color");
  EXPECT_EQ(surface_of(readings, "ceiling"), nullptr);
  EXPECT_EQ(surface_of(readings, "fixture"), nullptr);
}

}  // namespace
}  // namespace marketgen::photo
