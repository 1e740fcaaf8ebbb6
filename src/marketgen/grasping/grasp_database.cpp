#include "grasping/grasp_database.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "base/hash.h"
#include "grasping/grasping_fingerprint.h"
#include "io/cache_entry.h"
#include "io/file.h"
#include "io/folder_lock.h"
#include "io/sqlite.h"

namespace marketgen::grasping {
namespace {

constexpr const char* grasp_tables = R"sql(
  CREATE TABLE grasp_rates(sku TEXT, tool TEXT, setting TEXT, archetype TEXT,
    excluded TEXT, reason TEXT, tries INTEGER, held INTEGER, first TEXT, catalogue TEXT, seed TEXT,
    PRIMARY KEY(sku, tool, setting)) WITHOUT ROWID;
  CREATE TABLE grasp_tries(sku TEXT, tool TEXT, setting TEXT, number INTEGER,
    strategy TEXT, ended TEXT, width_mm REAL, force_n REAL, slip_mm REAL, turned_deg REAL,
    neighbour_n REAL, PRIMARY KEY(sku, tool, setting, number)) WITHOUT ROWID;
)sql";

constexpr std::string_view grasps_kind = "grasp-rates/2";
constexpr double wait_s = 20;  // for another process that keeps its own rates

// Sets `value` to the one that is called so. Error io.database: there is none.
template <class Enum>
Result<void> read_name(const std::string& name, Enum& value) {
  const auto found = value_named<Enum>(name);
  if (!found) return Error{"io.database", "sqlite", "has the unknown name \"" + name + "\""};
  value = *found;
  return {};
}

// A rate with what it was made from.
struct KeptRate {
  GraspRate rate;
  std::string catalogue, seed;
};

Result<void> add_rate(const io::SqlDatabase& sql, const KeptRate& kept) {
  const GraspRate& rate = kept.rate;
  MARKETGEN_TRY(io::SqlStatement add,
                sql.prepare("INSERT INTO grasp_rates VALUES(?,?,?,?,?,?,?,?,?,?,?)"));
  const std::string_view first =
      rate.tries.empty() ? std::string_view() : name_of(rate.tries.front().end);
  MARKETGEN_CHECK(add.start()
                      .bind(1, rate.sku)
                      .bind(2, rate.tool)
                      .bind(3, name_of(rate.setting))
                      .bind(4, rate.archetype)
                      .bind(5, name_of(rate.excluded))
                      .bind(6, rate.reason)
                      .bind(7, static_cast<std::int64_t>(rate.tries.size()))
                      .bind(8, std::int64_t{rate.held()})
                      .bind(9, first)
                      .bind(10, kept.catalogue)
                      .bind(11, kept.seed)
                      .run());
  MARKETGEN_TRY(io::SqlStatement tried,
                sql.prepare("INSERT INTO grasp_tries VALUES(?,?,?,?,?,?,?,?,?,?,?)"));
  for (std::size_t i = 0; i < rate.tries.size(); ++i) {
    const GraspTry& t = rate.tries[i];
    MARKETGEN_CHECK(tried.start()
                        .bind(1, rate.sku)
                        .bind(2, rate.tool)
                        .bind(3, name_of(rate.setting))
                        .bind(4, static_cast<std::int64_t>(i))
                        .bind(5, name_of(t.strategy))
                        .bind(6, name_of(t.end))
                        .bind(7, t.width_mm)
                        .bind(8, t.force_n)
                        .bind(9, t.slip_mm)
                        .bind(10, t.turned_deg)
                        .bind(11, t.neighbour_n)
                        .run());
  }
  return {};
}

Result<std::vector<GraspTry>> tries_of(const io::SqlDatabase& sql, const GraspRate& rate) {
  MARKETGEN_TRY(
      io::SqlStatement find,
      sql.prepare("SELECT strategy, ended, width_mm, force_n, slip_mm, turned_deg, "
                  "neighbour_n FROM grasp_tries WHERE sku = ? AND tool = ? AND setting = ? "
                  "ORDER BY number"));
  find.start().bind(1, rate.sku).bind(2, rate.tool).bind(3, name_of(rate.setting));
  std::vector<GraspTry> tries;
  while (true) {
    MARKETGEN_TRY(const bool row, find.step());
    if (!row) return tries;
    GraspTry& tried = tries.emplace_back();
    MARKETGEN_CHECK(read_name(find.text(0), tried.strategy));
    MARKETGEN_CHECK(read_name(find.text(1), tried.end));
    tried.width_mm = find.number(2);
    tried.force_n = find.number(3);
    tried.slip_mm = find.number(4);
    tried.turned_deg = find.number(5);
    tried.neighbour_n = find.number(6);
  }
}

Result<std::vector<KeptRate>> rates_in(const std::string& bytes) {
  MARKETGEN_TRY(const io::SqlDatabase sql, io::SqlDatabase::open(bytes));
  MARKETGEN_TRY(
      io::SqlStatement find,
      sql.prepare("SELECT sku, archetype, tool, setting, excluded, reason, catalogue, seed "
                  "FROM grasp_rates ORDER BY sku, tool, setting"));
  find.start();
  std::vector<KeptRate> all;
  while (true) {
    MARKETGEN_TRY(const bool row, find.step());
    if (!row) return all;
    KeptRate kept{{find.text(0), find.text(1), find.text(2), {}, {}, find.text(5), {}},
                  find.text(6),
                  find.text(7)};
    MARKETGEN_CHECK(read_name(find.text(3), kept.rate.setting));
    MARKETGEN_CHECK(read_name(find.text(4), kept.rate.excluded));
    MARKETGEN_TRY(kept.rate.tries, tries_of(sql, kept.rate));
    all.push_back(std::move(kept));
  }
}

// By SKU, tool and setting; none when there is no file that can be used.
std::vector<KeptRate> all_kept() {
  const std::filesystem::path file = grasp_database_file();
  const std::optional<std::string> bytes = io::kept_entry(file, grasps_kind);
  if (!bytes) return {};
  Result<std::vector<KeptRate>> rates = rates_in(*bytes);
  if (rates.ok()) return std::move(rates).value();
  io::drop_entry(file, rates.error().message);
  return {};
}

}  // namespace

std::filesystem::path grasp_database_file() {
  return io::cache_folder() / "grasps" / "grasps.sqlite";
}

Result<std::string> grasp_study_key(const std::filesystem::path& data,
                                    const std::string& catalog_hash,
                                    const StudyOptions& options) {
  std::set<std::filesystem::path> files;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(data / "robots", failed))
    files.insert(entry.path());
  Hasher hasher;
  for (const std::filesystem::path& file : files) {
    MARKETGEN_TRY(const std::string text, io::read_file(file));
    hasher.add(text);
  }
  hasher.add(catalog_hash);
  hasher.add(grasping_fingerprint);
  hasher.add(
      fmt::format("seed {}, tries {}, {}", options.seed, options.tries, options.enough_held));
  return hasher.hex();
}

Result<void> keep_grasp_rates(const std::vector<GraspRate>& rates,
                              const std::string& study_key,
                              std::uint64_t seed) {
  const std::filesystem::path folder = grasp_database_file().parent_path();
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{"io.cannot_write", folder.string(), failed.message()};
  MARKETGEN_TRY(const io::FolderLock lock, io::FolderLock::wait_for(folder, wait_s));
  const std::vector<KeptRate> before = all_kept();
  std::map<std::array<std::string, 3>, KeptRate> merged;
  const auto put = [&](const KeptRate& kept) {
    const GraspRate& rate = kept.rate;
    merged[{rate.sku, rate.tool, std::string(name_of(rate.setting))}] = kept;
  };
  std::ranges::for_each(before, put);
  for (const GraspRate& rate : rates)
    put({rate, study_key, std::to_string(seed)});

  MARKETGEN_TRY(io::SqlDatabase sql, io::SqlDatabase::create());
  MARKETGEN_CHECK(sql.run("BEGIN"));
  MARKETGEN_CHECK(sql.run(grasp_tables));
  for (const auto& [key, kept] : merged)
    MARKETGEN_CHECK(add_rate(sql, kept));
  MARKETGEN_CHECK(sql.run("COMMIT"));
  MARKETGEN_TRY(const std::string bytes, sql.bytes());
  return io::keep_entry(grasp_database_file(), grasps_kind, bytes);
}

std::vector<GraspRate> kept_grasp_rates(const std::string& study_key) {
  std::vector<GraspRate> rates;
  for (const KeptRate& kept : all_kept()) {
    if (kept.catalogue == study_key) rates.push_back(kept.rate);
  }
  return rates;
}

}  // namespace marketgen::grasping
