#include "io/gzip.h"

#include <gtest/gtest.h>

#include <string>

namespace marketgen::io {
namespace {

std::string text_of(std::size_t bytes) {
  std::string text;
  for (std::size_t i = 0; text.size() < bytes; ++i)
    text += std::to_string(i * 2654435761U) + "\n";
  return text;
}

TEST(Gzip, UnpacksToWhatWasPackedAndPacksAlike) {
  for (const std::string& text : {std::string(), std::string("a"), text_of(3 << 20)}) {
    const std::string packed = gzip(text);
    EXPECT_TRUE(is_gzip(packed));
    EXPECT_EQ(gzip(text), packed);
    const auto back = gunzip(packed, "here");
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(*back, text);
  }
  EXPECT_FALSE(is_gzip("{}"));
}

// As `gzip -9n` of Debian writes it.
TEST(Gzip, ReadsWhatOtherProgramsPacked) {
  const std::string packed(
      "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\xcb\x48\xcd\xc9\xc9\xe7\x02\x00\x20\x30\x3a\x36\x06"
      "\x00\x00\x00",
      26);
  const auto back = gunzip(packed, "here");
  ASSERT_TRUE(back.ok()) << back.error().message;
  EXPECT_EQ(*back, "hello\n");
}

TEST(Gzip, WhatIsCutOffChangedOrLongerIsAnError) {
  const std::string packed = gzip(text_of(200'000));
  for (std::size_t kept : {0UL, 1UL, 9UL, packed.size() / 2, packed.size() - 1}) {
    const auto cut = gunzip(packed.substr(0, kept), "here");
    ASSERT_FALSE(cut.ok()) << kept;
    EXPECT_EQ(cut.error().code, "input.malformed");
    EXPECT_EQ(cut.error().where, "here");
  }
  std::string changed = packed;
  changed[changed.size() / 2] ^= 1;
  EXPECT_FALSE(gunzip(changed, "here").ok());
  EXPECT_FALSE(gunzip(packed + "more", "here").ok());
}

TEST(Gzip, UnpacksNoMoreThanIsAllowed) {
  const auto bomb = gunzip(gzip(std::string(1 << 20, 'a')), "here", 1000);
  ASSERT_FALSE(bomb.ok());
  EXPECT_EQ(bomb.error().code, "input.too_large");
}

}  // namespace
}  // namespace marketgen::io
