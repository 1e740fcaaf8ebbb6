// Photos of known shops (tests/shop_photos), drawn with full light transport, that the bank was not
// made with.
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "io/json.h"
#include "photo/read_photo.h"
#include "support/run_program.h"

namespace marketgen::photo {
namespace {

struct KnownValue {
  std::string attribute, value;

  static constexpr auto fields =
      field_list(field("attribute", &KnownValue::attribute, "what is known", required()),
                 field("value", &KnownValue::value, "its class", required()));
};

struct KnownPhoto {
  std::string file;
  std::vector<KnownValue> truth;

  static constexpr auto fields =
      field_list(field("file", &KnownPhoto::file, "the photo", required()),
                 field("truth", &KnownPhoto::truth, "what is known of it", required()));
};

struct Count {
  int known = 0, right = 0, sure = 0, sure_right = 0;
};

TEST(PhotoSet, AtLeast85In100SureReadingsAreRight) {
  const std::filesystem::path source = MARKETGEN_SOURCE_DIR, folder = source / "tests/shop_photos";
  const auto bank = load_bank(source / "data");
  ASSERT_TRUE(bank.ok()) << to_string(bank.error());
  const auto photos =
      io::read_json<std::vector<KnownPhoto>>(contents_of(folder / "truth.json"), "truth.json");
  ASSERT_TRUE(photos.ok()) << to_string(photos.error());
  ASSERT_EQ(photos->size(), 30U);
  Count all;
  for (const KnownPhoto& photo : photos.value()) {
    const auto read = read_photo(folder / photo.file, bank.value());
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_NE(read->subject, "drawing") << photo.file;
    for (const auto& [attribute, value] : photo.truth) {
      const AttributeReading* reading = read->find(attribute);
      if (attribute == "subject") continue;
      ASSERT_NE(reading, nullptr) << attribute;
      const bool right = reading->value == value, is_sure = reading->confidence >= sure;
      ++all.known;
      all.right += right ? 1 : 0;
      all.sure += is_sure ? 1 : 0;
      all.sure_right += right && is_sure ? 1 : 0;
    }
  }
  RecordProperty("right", all.right);
  RecordProperty("of", all.known);
  EXPECT_GE(all.sure, 100);
  EXPECT_GE(all.sure_right, 0.85 * all.sure) << all.sure_right << " of " << all.sure;
}

}  // namespace
}  // namespace marketgen::photo
