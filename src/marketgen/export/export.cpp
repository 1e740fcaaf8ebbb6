#include "export/export.h"

#include <algorithm>
#include <array>
#include <set>

#include "base/interrupt.h"
#include "base/text.h"
#include "export/exporter.h"
#include "io/output.h"
#include "scene/placements.h"

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

// Writes what lies beside a file, into a folder of its own that is made for the first.
class Beside {
 public:
  Beside(io::Outputs& outputs, std::filesystem::path folder)
      : outputs_(outputs), folder_(std::move(folder)) {}

  Result<void> put(const std::string& name, std::string_view bytes) {
    MARKETGEN_CHECK(check_interrupt());
    const std::filesystem::path file = folder_ / name;
    if (made_.insert(file.parent_path()).second)
      MARKETGEN_CHECK(outputs_.add_folder(file.parent_path()));
    return outputs_.put(file, bytes);
  }

 private:
  io::Outputs& outputs_;
  std::filesystem::path folder_;
  std::set<std::filesystem::path> made_;
};

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
  io::Outputs outputs;
  Beside beside(outputs, out.parent_path() / named.beside);
  named.put_beside = [&](const std::string& name, std::string_view bytes) {
    return beside.put(name, bytes);
  };
  MARKETGEN_TRY(const ExportFiles files, exporter->write(scene, named));
  for (const BesideFile& file : files.beside)
    MARKETGEN_CHECK(beside.put(file.name, file.bytes));
  MARKETGEN_CHECK(outputs.put(out, files.main));
  return outputs.commit();
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

bool hangs_on_peg(const scene::Scene& scene, std::uint32_t product) {
  const std::uint32_t facing = scene.products[product].facing;
  return facing != scene::no_facing &&
         scene.shelves[scene.facings[facing].shelf].use == assets::ShelfUse::hang;
}

}  // namespace marketgen::exporters
