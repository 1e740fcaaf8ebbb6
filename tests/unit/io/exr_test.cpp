#include "io/exr.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/file.h"

namespace marketgen {
namespace {

io::FloatImage ramp() {
  io::FloatImage image{5, 3, {}};
  for (int i = 0; i < 45; ++i)
    image.pixels.push_back(static_cast<float>(i * i) * 0.37F);
  return image;
}

TEST(Exr, WhatIsWrittenIsReadBack) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "marketgen_ramp.exr";
  ASSERT_TRUE(io::write_exr(path, ramp()).ok());
  const Result<std::string> bytes = io::read_file(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(bytes->substr(0, 4), "\x76\x2f\x31\x01");  // the format's magic number
  const Result<io::FloatImage> read = io::decode_exr(*bytes, "ramp");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->width, 5);
  EXPECT_EQ(read->height, 3);
  for (std::size_t i = 0; i < 45; ++i)  // halves have 11 bits
    EXPECT_NEAR(read->pixels[i], ramp().pixels[i], ramp().pixels[i] / 2000 + 1e-6F);
}

TEST(Exr, WhatHalvesCannotHoldIsCut) {
  const auto bytes = io::encode_exr({1, 1, {1e9F, 65504, 0.5F}});
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(io::decode_exr(*bytes, "bright")->pixels, (std::vector<float>{65504, 65504, 0.5F}));
}

TEST(Exr, OtherFilesAreRefused) {
  const auto nothing = io::decode_exr("", "empty"),
             text = io::decode_exr(std::string(200, 'x'), "x.exr");
  ASSERT_FALSE(nothing.ok());
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.error().code, "image.bad_file");
  EXPECT_EQ(text.error().where, "x.exr");
}

TEST(Exr, ACutFileIsRefused) {
  const std::string bytes = io::encode_exr(ramp()).value();
  EXPECT_FALSE(io::decode_exr(std::string_view(bytes).substr(0, bytes.size() / 3), "cut").ok());
}

TEST(Exr, NothingIsLeftWhereNothingCanBeWritten) {
  EXPECT_FALSE(io::write_exr("/dev/null/all.exr", ramp()).ok());
}

}  // namespace
}  // namespace marketgen
