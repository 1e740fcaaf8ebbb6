#include "build_library.h"

#include <fmt/format.h>

#include "base/parallel.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "render/stage/label_library.h"

namespace marketgen::app {
namespace {

struct LibraryReport {
  int labels = 0, drawn = 0, kept = 0;
  double megabytes = 0, seconds = 0;
  std::string folder;
  static constexpr auto fields =
      field_list(field("labels", &LibraryReport::labels, "products that show a printed sheet"),
                 field("drawn", &LibraryReport::drawn, "sheets drawn now, not read"),
                 field("kept", &LibraryReport::kept, "sheets that lie in the folder now"),
                 field("megabytes", &LibraryReport::megabytes, "of all textures in memory"),
                 field("seconds", &LibraryReport::seconds, "wall clock"),
                 field("folder", &LibraryReport::folder, "where they are kept"));
};

void print_report(const LibraryReport& report) {
  fmt::print("{} label sheets, {:.0f} MB, {} drawn in {:.1f} s, {} kept in {}\n",
             report.labels,
             report.megabytes,
             report.drawn,
             report.seconds,
             report.kept == report.labels ? "all" : std::to_string(report.kept),
             report.folder);
}

}  // namespace

Result<void> build_library(const catalog::Catalog& catalog, const CommonFlags& flags) {
  const ThreadLimit limit(flags.threads);
  const std::filesystem::path folder = io::cache_folder() / "labels";
  io::Outputs cache;  // that they are kept is what this is for
  MARKETGEN_CHECK(cache.add_folder(folder));
  MARKETGEN_CHECK(cache.commit());
  const double started_s = monotonic_seconds();
  MARKETGEN_TRY(const render::raytrace::LabelLibrary library,
                render::raytrace::build_label_library(catalog.products, progress_for(flags)));
  const LibraryReport report{static_cast<int>(library.labels),
                             static_cast<int>(library.drawn),
                             static_cast<int>(library.kept),
                             static_cast<double>(library.bytes) * 1e-6,
                             monotonic_seconds() - started_s,
                             folder.string()};
  if (flags.json)
    fmt::print("{}", io::write_json(report));
  else
    print_report(report);
  if (!library.unkept) return {};
  return Error{library.unkept->code,
               report.folder,
               fmt::format("{} of {} label sheets are not kept: {}",
                           report.labels - report.kept,
                           report.labels,
                           library.unkept->message)};
}

}  // namespace marketgen::app
