#include "io/sqlite.h"

#include <sqlite3.h>

#include <cstring>

#include <fmt/format.h>

namespace marketgen::io {
namespace {

Error database_error(sqlite3* connection, std::string_view what) {
  const char* fault = connection == nullptr ? "out of memory" : sqlite3_errmsg(connection);
  return {"io.database", "sqlite", fmt::format("{}: {}", what, fault)};
}

}  // namespace

void SqlStatement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void SqlDatabase::Close::operator()(sqlite3* connection) const {
  sqlite3_close_v2(connection);  // waits for statements that outlive it
}

SqlStatement& SqlStatement::start() {
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
  return *this;
}

SqlStatement& SqlStatement::bind(int parameter, std::int64_t value) {
  sqlite3_bind_int64(statement_.get(), parameter, value);
  return *this;
}

SqlStatement& SqlStatement::bind(int parameter, double value) {
  sqlite3_bind_double(statement_.get(), parameter, value);
  return *this;
}

SqlStatement& SqlStatement::bind(int parameter, std::string_view text) {
  sqlite3_bind_text64(
      statement_.get(), parameter, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  return *this;
}

Result<bool> SqlStatement::step() {
  const int state = sqlite3_step(statement_.get());
  if (state == SQLITE_ROW) return true;
  if (state == SQLITE_DONE) return false;
  return database_error(sqlite3_db_handle(statement_.get()), "a query failed");
}

Result<void> SqlStatement::run() {
  if (const Result<bool> done = step(); !done.ok()) return done.error();
  return {};
}

std::int64_t SqlStatement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double SqlStatement::number(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string SqlStatement::text(int column) const {
  const auto* bytes = sqlite3_column_text(statement_.get(), column);
  const int count = sqlite3_column_bytes(statement_.get(), column);
  return bytes == nullptr
             ? std::string()
             : std::string(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
}

Result<SqlDatabase> SqlDatabase::create() {
  SqlDatabase database;
  sqlite3* connection = nullptr;
  const int state =
      sqlite3_open_v2(":memory:",
                      &connection,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX,
                      nullptr);
  database.connection_.reset(connection);
  if (state != SQLITE_OK) return database_error(connection, "no database in memory");
  sqlite3_db_config(connection, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  return database;
}

Result<SqlDatabase> SqlDatabase::open(std::string_view bytes) {
  MARKETGEN_TRY(SqlDatabase database, create());
  sqlite3* connection = database.connection_.get();
  auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size()));
  if (copy == nullptr) return database_error(nullptr, "the database cannot be opened");
  std::memcpy(copy, bytes.data(), bytes.size());
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  if (sqlite3_deserialize(connection,
                          "main",
                          copy,
                          size,
                          size,
                          SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_READONLY) !=
      SQLITE_OK) {
    return database_error(connection, "the database cannot be opened");
  }
  MARKETGEN_TRY(SqlStatement check, database.prepare("PRAGMA quick_check(1)"));
  MARKETGEN_TRY(const bool answered, check.step());
  if (!answered || check.text(0) != "ok")
    return Error{"io.database", "sqlite", "the database is damaged: " + check.text(0)};
  return database;
}

Result<void> SqlDatabase::run(const char* sql) {
  if (sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return database_error(connection_.get(), "a statement failed");
}

Result<SqlStatement> SqlDatabase::prepare(std::string_view sql) const {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(
          connection_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr) !=
      SQLITE_OK) {
    return database_error(connection_.get(), "a query is wrong");
  }
  return SqlStatement(statement);
}

std::string_view SqlDatabase::engine_version() {
  return sqlite3_libversion();
}

Result<std::string> SqlDatabase::bytes() const {
  sqlite3_int64 size = 0;
  unsigned char* bytes = sqlite3_serialize(connection_.get(), "main", &size, 0);
  if (bytes == nullptr) return database_error(connection_.get(), "the database cannot be copied");
  std::string copy(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  sqlite3_free(bytes);
  return copy;
}

}  // namespace marketgen::io
