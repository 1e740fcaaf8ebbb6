// Documents of dials of which some are rows of the program, and others a user's own files
// (episodes/realism.h, episodes/difficulty.h).
#pragma once
#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/hash.h"
#include "base/result.h"
#include "base/text.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::episodes {

inline constexpr std::string_view own_dials = "own-";

// What one kind of them is called: of its flag, its folder of data/benchmark and its messages.
struct DialsKind {
  std::string_view name;
  std::span<const std::string_view> rows;
};

// A row by its name, data/benchmark/KIND/NAME.json, or a file of one's own, which ends with .json.
// Its `name` is then own_dials and the hash of its dials, so that what is made with equal dials can
// be compared. `check` says what is wrong with dials that are valid one by one, of a document that
// is called so. Errors: usage.bad_flag at the kind's flag, with the nearest name; catalog.bad_row
// for a row that is not called as its file; those of read_file, read_json and `check`.
template <class Dials, class Check>
Result<Dials> load_named_dials(const std::filesystem::path& data,
                               const DialsKind& kind,
                               const std::string& asked,
                               const Check& check) {
  const auto read = [&](const std::filesystem::path& file,
                        const std::string& called) -> Result<Dials> {
    MARKETGEN_TRY(const std::string text, io::read_file(file, 1U << 20));
    MARKETGEN_TRY(Dials dials, io::read_json<Dials>(text, called));
    MARKETGEN_CHECK(check(dials, called));
    return dials;
  };
  if (std::ranges::find(kind.rows, asked) != kind.rows.end()) {
    const std::string file = asked + ".json";
    MARKETGEN_TRY(Dials row, read(data / "benchmark" / kind.name / file, file));
    if (row.name != asked)
      return Error{"catalog.bad_row", file + ":/name", "expected the name of its file: " + asked};
    return row;
  }
  if (!asked.ends_with(".json"))
    return Error{"usage.bad_flag",
                 fmt::format("--{}", kind.name),
                 fmt::format("there is no {} \"{}\"{}; there are {}, or a file of your own "
                             "that ends with .json",
                             kind.name,
                             asked,
                             did_you_mean(asked, kind.rows),
                             fmt::join(kind.rows, ", "))};
  MARKETGEN_TRY(Dials own, read(asked, asked));
  own.name = "own";
  own.name = fmt::format("{}{:016x}", own_dials, hash64(io::write_json_line(own)));
  return own;
}

}  // namespace marketgen::episodes
