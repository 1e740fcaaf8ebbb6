#include <gtest/gtest.h>

#include "base/result.h"
#include "base/safe_line.h"

namespace marketgen {
namespace {

TEST(SafeLine, OrdinaryTextStaysAsItIs) {
  for (const char* text :
       {"", "shop.json:/zones/2", "Käse, 1,99 € \"frisch\"", "牛奶 \\ 1 l", "👩 x"})
    EXPECT_EQ(safe_line(text), text);
}

TEST(SafeLine, WhatMovesACursorIsWritten) {
  EXPECT_EQ(safe_line("a\nb\r\tc"), R"(a\nb\r\tc)");
  EXPECT_EQ(safe_line("\x1b[2J\x1b]0;title\x07"), R"(\x1b[2J\x1b]0;title\x07)");
  EXPECT_EQ(safe_line(std::string_view("a\0b\x7f", 4)), R"(a\x00b\x7f)");
  EXPECT_EQ(safe_line("\u009b31m"), R"(\x9b31m)");  // C1: a terminal may take it for ESC [
}

TEST(SafeLine, WhatTurnsOrHidesTextIsWritten) {
  EXPECT_EQ(safe_line("price \u202e99.1"), R"(price \u202e99.1)");
  EXPECT_EQ(safe_line("\u2066x\u2069\u200b\ufeff\u2028\u061c"),
            R"(\u2066x\u2069\u200b\ufeff\u2028\u061c)");
}

TEST(SafeLine, BytesThatAreNoUtf8AreWritten) {
  EXPECT_EQ(safe_line("a\xff\xc0\xaf"), R"(a\xff\xc0\xaf)");
  EXPECT_EQ(safe_line("abc\xe2\x82"), R"(abc\xe2\x82)");
}

TEST(SafeLine, LongTextLosesItsMiddle) {
  const std::string line = safe_line(std::string(5000, 'x') + "end", 100);
  EXPECT_EQ(line,
            std::string(75, 'x') + "[... 4903 characters ...]" + std::string(22, 'x') + "end");
  EXPECT_EQ(safe_line(std::string(100, 'x'), 100), std::string(100, 'x'));
}

TEST(SafeLine, ErrorsAreOneSafeLine) {
  const std::string line =
      to_string({"catalog.bad_row", "own\n.csv:3", "\x1b[31m" + std::string(9000, 'n')});
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(line.find('\x1b'), std::string::npos);
  EXPECT_TRUE(line.starts_with("error[catalog.bad_row] own\\n.csv:3: \\x1b[31m")) << line;
  EXPECT_LT(line.size(), 2500U);
}

}  // namespace
}  // namespace marketgen
