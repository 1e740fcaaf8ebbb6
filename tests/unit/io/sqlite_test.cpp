// SQLite databases: what goes in comes out, also by way of a file; faults are errors.
#include "io/sqlite.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

io::SqlDatabase three_goods() {
  io::SqlDatabase sql = io::SqlDatabase::create().value();
  EXPECT_TRUE(sql.run("CREATE TABLE goods(name TEXT, price REAL, count INTEGER)").ok());
  io::SqlStatement insert = sql.prepare("INSERT INTO goods VALUES(?, ?, ?)").value();
  EXPECT_TRUE(insert.start().bind(1, "milk").bind(2, 1.25).bind(3, std::int64_t{3}).run().ok());
  EXPECT_TRUE(insert.start().bind(1, "o'neil; DROP").bind(2, 0.5).run().ok());
  EXPECT_TRUE(insert.start().bind(1, std::string("a\0b", 3)).run().ok());
  return sql;
}

TEST(Sqlite, RowsComeBackAsTheyWere) {
  const io::SqlDatabase sql = three_goods();
  io::SqlStatement all = sql.prepare("SELECT name, price, count FROM goods ORDER BY rowid").value();
  ASSERT_TRUE(all.start().step().value());
  EXPECT_EQ(all.text(0), "milk");
  EXPECT_EQ(all.number(1), 1.25);
  EXPECT_EQ(all.integer(2), 3);
  ASSERT_TRUE(all.step().value());
  EXPECT_EQ(all.text(0), "o'neil; DROP");
  EXPECT_EQ(all.integer(2), 0);  // was not bound
  ASSERT_TRUE(all.step().value());
  EXPECT_EQ(all.text(0), std::string("a\0b", 3));
  EXPECT_FALSE(all.step().value());
}

TEST(Sqlite, BytesAreAFileAndReadBack) {
  const std::string bytes = three_goods().bytes().value();
  EXPECT_EQ(bytes.substr(0, 15), "SQLite format 3");
  EXPECT_EQ(bytes, three_goods().bytes().value());  // the same rows, the same bytes
  const auto again = io::SqlDatabase::open(bytes);
  ASSERT_TRUE(again.ok());
  io::SqlStatement count = again->prepare("SELECT count(*) FROM goods").value();
  ASSERT_TRUE(count.step().value());
  EXPECT_EQ(count.integer(0), 3);
}

TEST(Sqlite, HasFullTextSearch) {
  io::SqlDatabase sql = io::SqlDatabase::create().value();
  EXPECT_TRUE(sql.run("CREATE VIRTUAL TABLE t USING fts5(x, tokenize = 'porter unicode61')").ok());
}

TEST(Sqlite, FaultsAreErrors) {
  io::SqlDatabase sql = three_goods();
  EXPECT_EQ(sql.run("CREATE TABLE goods(x)").error().code, "io.database");
  EXPECT_EQ(sql.prepare("SELECT nothing FROM goods").error().code, "io.database");
  const std::string bytes = sql.bytes().value();
  EXPECT_FALSE(io::SqlDatabase::open("").ok());
  EXPECT_FALSE(io::SqlDatabase::open("no database at all").ok());
  std::string torn = bytes;
  torn.replace(4096, 64, 64, '\xFF');
  EXPECT_EQ(io::SqlDatabase::open(torn).error().code, "io.database");
}

}  // namespace
}  // namespace marketgen
