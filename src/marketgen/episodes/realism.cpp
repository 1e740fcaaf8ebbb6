#include "episodes/realism.h"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/hash.h"
#include "base/text.h"
#include "episodes/realism_rows.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::episodes {
namespace {

Result<Realism> read_realism(const std::filesystem::path& file, const std::string& called) {
  MARKETGEN_TRY(const std::string text, io::read_file(file, 1U << 20));
  MARKETGEN_TRY(Realism read, io::read_json<Realism>(text, called));
  const LatencyDials& late = read.latency;
  for (const auto& [name, dials] : {std::pair{"commands", late.commands},
                                    std::pair{"images", late.images},
                                    std::pair{"readings", late.readings}})
    if (dials.max_s < dials.min_s)
      return Error{
          "catalog.bad_row",
          fmt::format("{}:/latency/{}/max_s", called, name),
          fmt::format("is {}, less than min_s, {}: give the larger one", dials.max_s, dials.min_s)};
  return read;
}

}  // namespace

Result<Realism> load_realism(const std::filesystem::path& data, const std::string& asked) {
  for (const std::string_view row : realism_rows) {
    if (row != asked) continue;
    const std::string file = asked + ".json";
    MARKETGEN_TRY(Realism read, read_realism(data / "benchmark" / "realism" / file, file));
    if (read.name != asked)
      return Error{"catalog.bad_row", file + ":/name", "expected the name of its file: " + asked};
    return read;
  }
  if (!asked.ends_with(".json"))
    return Error{"usage.bad_flag",
                 "--realism",
                 fmt::format("there is no realism \"{}\"{}; there are {}, or a file of your own "
                             "that ends with .json",
                             asked,
                             did_you_mean(asked, realism_rows),
                             fmt::join(realism_rows, ", "))};
  MARKETGEN_TRY(Realism own, read_realism(asked, asked));
  own.name = "own";
  own.name = fmt::format("{}{:016x}", own_realism, hash64(io::write_json_line(own)));
  return own;
}

}  // namespace marketgen::episodes
