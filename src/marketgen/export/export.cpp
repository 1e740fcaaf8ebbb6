#include "export/export.h"

#include <algorithm>
#include <array>

#include "base/interrupt.h"
#include "base/text.h"
#include "export/exporter.h"
#include "io/file.h"

namespace marketgen::exporters {
namespace {

// Of `read` and `check` one is null: whole stores are read and compared, extracts check themselves.
struct Exporter {
  ExportFormat format;
  Result<ExportFiles> (*write)(const scene::Scene&, const ExportOptions&);
  Result<ExportContents> (*read)(const std::filesystem::path&,
                                 const std::vector<catalog::Product>&);
  Result<ExportSummary> (*check)(const scene::Scene&,
                                 const std::filesystem::path&,
                                 const ExportOptions&);
};

constexpr Exporter exporters[] = {
#define EXPORT_FORMAT(name, description, extension) \
  {{#name, description, extension, true}, write_##name, read_##name, nullptr},
#define EXPORT_EXTRACT(name, description, extension) \
  {{#name, description, extension, false}, write_##name, nullptr, check_##name},
#include "export/export_formats.inc"
#undef EXPORT_FORMAT
#undef EXPORT_EXTRACT
};

Result<const Exporter*> exporter_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Exporter& exporter : exporters) {
    if (exporter.format.name == name) return &exporter;
    names.push_back(exporter.format.name);
  }
  std::string known;
  for (const std::string_view n : names)
    known += (known.empty() ? "" : ", ") + std::string(n);
  return Error{"export.unknown_format",
               "--format",
               "there is no format \"" + std::string(name) + "\"" + did_you_mean(name, names) +
                   " (formats: " + known + ")"};
}

Result<void> make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{"io.cannot_write", folder.string(), failed.message()};
  return {};
}

Result<void> write_beside(const std::filesystem::path& folder,
                          const std::vector<BesideFile>& files) {
  for (const BesideFile& file : files) {
    MARKETGEN_CHECK(check_interrupt());
    MARKETGEN_CHECK(make_folder((folder / file.name).parent_path()));
    MARKETGEN_CHECK(io::write_file(folder / file.name, file.bytes));
  }
  return {};
}

}  // namespace

std::vector<ExportFormat> export_formats() {
  std::vector<ExportFormat> formats;
  for (const Exporter& exporter : exporters)
    formats.push_back(exporter.format);
  return formats;
}

Result<void> export_scene(const scene::Scene& scene,
                          std::string_view format,
                          const std::filesystem::path& out,
                          const ExportOptions& options) {
  MARKETGEN_TRY(const Exporter* exporter, exporter_named(format));
  ExportOptions named = options;
  named.beside = out.stem().string() + "_assets";
  MARKETGEN_TRY(const ExportFiles files, exporter->write(scene, named));
  MARKETGEN_CHECK(write_beside(out.parent_path() / named.beside, files.beside));
  return io::write_file(out, files.main);
}

Result<ExportSummary> check_export(const scene::Scene& scene,
                                   std::string_view format,
                                   const std::filesystem::path& file,
                                   const ExportOptions& options) {
  MARKETGEN_TRY(const Exporter* exporter, exporter_named(format));
  if (exporter->check != nullptr) return exporter->check(scene, file, options);
  MARKETGEN_TRY(const ExportContents contents, exporter->read(file, scene.catalog));
  return compare_with_scene(scene, options, contents, file.string());
}

std::vector<bool> products_in_free_region(const scene::Scene& scene, const ExportOptions& options) {
  std::vector<bool> inside(scene.products.size(), false);
  if (!options.free_region_m) return inside;
  const auto& [x0, y0, x1, y1] = *options.free_region_m;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const Vec3 p = scene::world_from_product(scene.products[i]).position;
    inside[i] = p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1;
  }
  return inside;
}

}  // namespace marketgen::exporters
