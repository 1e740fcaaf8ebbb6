// Looks are learnt once, in this process or in one before.
#include "perception/look_library.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "io/scratch_folder.h"
#include "support/drawn_boxes.h"

namespace marketgen {
namespace {

// Cartons whose colour is their number.
class Cartons : public agent::KnownProducts {
 public:
  explicit Cartons(std::string key, int count = 3) : key_(std::move(key)) {
    for (int i = 0; i < count; ++i) {
      rows_.emplace_back().sku = "carton-" + std::to_string(i);
      rows_.back().archetype = "box";
    }
  }
  const std::vector<catalog::Product>& rows() const override { return rows_; }
  Result<const agent::KnownProduct*> product(const std::string& sku) override {
    return Error{"catalog.unknown_sku", sku, "nobody takes hold of it here"};
  }
  Result<std::vector<agent::ProductPictures>> pictures(
      const std::vector<std::string>& skus) const override {
    std::vector<agent::ProductPictures> all;
    for (const std::string& sku : skus) {
      asked_.push_back(sku);
      const auto red = static_cast<std::uint8_t>(50 * (sku.back() - '0'));
      all.push_back(drawn_pictures({0.06, 0.04, 0.03}, plain({red, 120, 40})));
    }
    return all;
  }
  std::string pictures_key() const override { return key_; }

  std::vector<const catalog::Product*> all() const {
    std::vector<const catalog::Product*> rows;
    for (const catalog::Product& row : rows_)
      rows.push_back(&row);
    return rows;
  }
  const std::vector<std::string>& asked() const { return asked_; }

 private:
  std::string key_;
  std::vector<catalog::Product> rows_;
  mutable std::vector<std::string> asked_;
};

class LooksKept : public ::testing::Test {
 protected:
  void SetUp() override { setenv("MARKETGEN_CACHE", scratch_.path().c_str(), 1); }
  void TearDown() override { unsetenv("MARKETGEN_CACHE"); }

  io::ScratchFolder scratch_ = io::ScratchFolder::make("looks").value();
};

TEST_F(LooksKept, EachProductIsPicturedOnce) {
  const Cartons cartons("as drawn here");
  perception::LookLibrary library;
  std::vector<const catalog::Product*> rows = cartons.all();
  rows.push_back(rows.front());
  const auto looks = library.of(rows, cartons);
  ASSERT_TRUE(looks.ok()) << to_string(looks.error());
  ASSERT_EQ(looks->size(), 4U);
  EXPECT_EQ(looks->front(), looks->back());
  EXPECT_EQ((*looks)[2]->sku(), "carton-2");
  EXPECT_EQ(cartons.asked().size(), 3U);
  EXPECT_EQ(library.of(rows, cartons).value().front(), looks->front());
  EXPECT_EQ(cartons.asked().size(), 3U);
}

// What another process finds on disk is to the last bit what this one learnt.
TEST_F(LooksKept, AnotherProcessFindsThemTheSame) {
  const Cartons cartons("as drawn here"), again("as drawn here");
  perception::LookLibrary first, second;
  const auto made = first.of(cartons.all(), cartons), kept = second.of(again.all(), again);
  ASSERT_TRUE(made.ok() && kept.ok());
  EXPECT_TRUE(again.asked().empty());
  for (std::size_t i = 0; i < made->size(); ++i) {
    const auto& a = (*made)[i]->surfels();
    const auto& b = (*kept)[i]->surfels();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_EQ(a[k].point, b[k].point);
      EXPECT_EQ(a[k].normal, b[k].normal);
      EXPECT_EQ(a[k].color, b[k].color);
    }
  }
  EXPECT_NE((*kept)[0]->surfels().front().color, (*kept)[2]->surfels().front().color);
}

// Round things have normals in all directions, which the grid of what is kept does not hold.
TEST(ProductLook, PacksToWhatItWasUnpackedFrom) {
  std::vector<perception::PackedSurfel> packed;
  for (int i = 0; i < 2000; ++i) {
    const double z = 1 - (2 * i + 1.0) / 2000, r = std::sqrt(1 - z * z), angle = 2.4 * i;
    perception::PackedSurfel surfel;
    std::size_t axis = 0;
    for (const double part : {r * std::cos(angle), r * std::sin(angle), z}) {
      surfel.normal[axis] = static_cast<std::int16_t>(std::lround(part * 32767));
      surfel.point[axis] = static_cast<std::int16_t>(std::lround(part * 700));
      surfel.color[axis++] = static_cast<std::uint8_t>(i % 256);
    }
    packed.push_back(surfel);
  }
  const auto again = perception::ProductLook::of("ball", packed).packed();
  ASSERT_EQ(again.size(), packed.size());
  for (std::size_t i = 0; i < packed.size(); ++i) {
    EXPECT_EQ(again[i].normal, packed[i].normal) << i;
    EXPECT_EQ(again[i].point, packed[i].point) << i;
    EXPECT_EQ(again[i].color, packed[i].color) << i;
  }
}

TEST_F(LooksKept, NotWherePicturesAreOthersOrNobodySaysWhatDecidesThem) {
  for (const char* key : {"as drawn here", "with another light", "", ""}) {
    const Cartons cartons(key);
    perception::LookLibrary library;
    ASSERT_TRUE(library.of(cartons.all(), cartons).ok());
    EXPECT_EQ(cartons.asked().size(), 3U) << key;
  }
}

TEST_F(LooksKept, AFileThatIsNoLookIsMadeAnew) {
  const Cartons cartons("as drawn here");
  ASSERT_TRUE(perception::LookLibrary().of(cartons.all(), cartons).ok());
  for (const auto& entry : std::filesystem::directory_iterator(scratch_.path() / "looks"))
    std::filesystem::resize_file(entry, 100);
  perception::LookLibrary library;
  ASSERT_TRUE(library.of(cartons.all(), cartons).ok());
  EXPECT_EQ(cartons.asked().size(), 6U);
}

}  // namespace
}  // namespace marketgen
