// CSV as RFC 4180 has it.
#include "io/csv.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

using Fields = std::vector<std::string>;

TEST(Csv, FieldsQuotesAndLineEnds) {
  const auto rows = io::parse_csv(
      "\xEF\xBB\xBFsku,name\r\na,\"Cola, \"\"Zero\"\"\"\nb,\"two\nlines\"\n\nc,\n", "x.csv");
  ASSERT_TRUE(rows.ok()) << to_string(rows.error());
  ASSERT_EQ(rows->size(), 4U);
  EXPECT_EQ(rows->at(0).fields, (Fields{"sku", "name"}));
  EXPECT_EQ(rows->at(1).fields, (Fields{"a", "Cola, \"Zero\""}));
  EXPECT_EQ(rows->at(2).fields, (Fields{"b", "two\nlines"}));
  EXPECT_EQ(rows->at(2).line, 3);
  EXPECT_EQ(rows->at(3).fields, (Fields{"c", ""}));
  EXPECT_EQ(rows->at(3).line, 6);  // after the two lines of a field and an empty one
}

TEST(Csv, SeparatorIsTheHeaders) {
  EXPECT_EQ(io::parse_csv("a;b\n1,5;2\n", "x.csv")->at(1).fields, (Fields{"1,5", "2"}));
  EXPECT_EQ(io::parse_csv("a\tb\n1,5\t2\n", "x.csv")->at(1).fields, (Fields{"1,5", "2"}));
  EXPECT_EQ(io::parse_csv("\"a;b;c\",d\n1,2\n", "x.csv")->at(1).fields, (Fields{"1", "2"}));
}

TEST(Csv, FaultsNameTheirLine) {
  const auto refused = [](std::string_view text, const char* where, const char* says) {
    const auto rows = io::parse_csv(text, "x.csv");
    ASSERT_FALSE(rows.ok());
    EXPECT_EQ(rows.error().code, "csv.syntax");
    EXPECT_EQ(rows.error().where, where);
    EXPECT_NE(rows.error().message.find(says), std::string::npos) << rows.error().message;
  };
  refused("a,b\n1\n", "x.csv:2", "has 1 fields, the header has 2");
  refused("a,b\n1,\"2\n3,4\n", "x.csv:2", "never ends");
  refused("a,b\n1,\"2\"x\n", "x.csv:2", "expected a comma");
  refused("a;b\n1;\"2\"x\n", "x.csv:2", "expected a semicolon");
  EXPECT_EQ(io::parse_csv("a\n\xFF\n", "x.csv").error().code, "input.not_utf8");
}

TEST(Csv, NothingIsNoRow) {
  EXPECT_TRUE(io::parse_csv("", "x.csv")->empty());
  EXPECT_TRUE(io::parse_csv("\n\r\n", "x.csv")->empty());
}

}  // namespace
}  // namespace marketgen
