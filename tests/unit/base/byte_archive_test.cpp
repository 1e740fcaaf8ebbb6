// Values go to bytes and come back; bytes that end too soon, or go on, are told.
#include "base/byte_archive.h"

#include <gtest/gtest.h>

#include <limits>

namespace marketgen {
namespace {

struct Padded {
  bool first = false;
  double second = 0;
  std::vector<std::string> names;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.first, self.second, self.names);
  }
  friend bool operator==(const Padded&, const Padded&) = default;
};

struct Everything {
  int number = 0;
  std::vector<double> numbers;
  std::vector<bool> flags;
  std::vector<std::byte> raw;
  std::map<std::uint32_t, Padded> by_row;
  std::set<int> rows;
  std::optional<double> there, absent = 1.0;
  std::array<bool, 3> three{};
  std::vector<std::pair<std::uint32_t, double>> pairs;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.number, self.numbers, self.flags, self.raw, self.by_row, self.rows);
    archive(self.there, self.absent, self.three, self.pairs);
  }
  friend bool operator==(const Everything&, const Everything&) = default;
};

Everything sample() {
  Everything made;
  made.number = -7;
  made.numbers = {0.1, -0.0, std::numeric_limits<double>::infinity()};
  made.flags = {true, false, true};
  made.raw = {std::byte{0}, std::byte{255}};
  made.by_row = {{3, {true, 0.3, {"a", std::string("b\0c", 3)}}}, {9, {}}};
  made.rows = {-1, 4};
  made.there = 2.5;
  made.absent.reset();
  made.three = {true, false, true};
  made.pairs = {{1, 0.5}};
  return made;
}

std::string bytes_of(const Everything& value) {
  ByteWriter writer;
  writer(value);
  return writer.take();
}

TEST(ByteArchive, EverythingComesBack) {
  Everything back;
  const std::string bytes = bytes_of(sample());
  ByteReader whole(bytes);
  whole(back);
  EXPECT_TRUE(whole.ok());
  EXPECT_EQ(back, sample());
  EXPECT_EQ(bytes_of(back), bytes);
}

TEST(ByteArchive, EveryShorterOneAndALongerOneAreTold) {
  const std::string bytes = bytes_of(sample());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    Everything back;
    ByteReader reader(std::string_view(bytes).substr(0, length));
    reader(back);
    EXPECT_FALSE(reader.ok()) << length;
  }
  const std::string longer = bytes + "x";
  Everything back;
  ByteReader reader(longer);
  reader(back);
  EXPECT_FALSE(reader.ok());
}

TEST(ByteArchive, ALengthThatCannotBeTakesNoMemory) {
  const std::string bytes(16, '\xff');
  std::vector<Padded> back;
  ByteReader reader(bytes);
  reader(back);
  EXPECT_FALSE(reader.ok());
  EXPECT_TRUE(back.empty());
}

}  // namespace
}  // namespace marketgen
