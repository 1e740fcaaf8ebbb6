// SQLite databases in memory: SQL in, rows out, errors as values.
//
// A database is filled in memory, may be saved as the bytes of an ordinary SQLite file (any SQLite
// program opens it) and opened again from such bytes. One thread at a time.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace marketgen::io {

// One prepared statement. Parameters and columns count from 1 and from 0, as in SQLite.
class SqlStatement {
 public:
  // Forgets the last run and its parameters; then `bind` each parameter, then `step` row by row.
  SqlStatement& start();
  SqlStatement& bind(int parameter, std::int64_t value);
  SqlStatement& bind(int parameter, double value);
  SqlStatement& bind(int parameter, std::string_view text);
  // True: a row is ready. False: there is none (left). Error: io.database.
  Result<bool> step();
  // For statements that return nothing.
  Result<void> run();

  std::int64_t integer(int column) const;
  double number(int column) const;
  std::string text(int column) const;

 private:
  friend class SqlDatabase;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  explicit SqlStatement(sqlite3_stmt* statement) : statement_(statement) {}
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class SqlDatabase {
 public:
  // An empty database.
  static Result<SqlDatabase> create();
  // From the bytes of an SQLite file, checked page by page. Error: io.database.
  static Result<SqlDatabase> open(std::string_view bytes);

  // One or more statements that return nothing. `sql` is ours, never a user's text.
  Result<void> run(const char* sql);
  Result<SqlStatement> prepare(std::string_view sql) const;
  // The bytes of the SQLite file.
  Result<std::string> bytes() const;
  static std::string_view engine_version();  // "3.40.1"

 private:
  struct Close {
    void operator()(sqlite3* connection) const;
  };
  std::unique_ptr<sqlite3, Close> connection_;
};

}  // namespace marketgen::io
