#include "store/save.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/build_info.h"
#include "catalog/own_files.h"
#include "io/field_check.h"
#include "io/json.h"
#include "io/png.h"
#include "layout/layout_picture.h"
#include "scene/query.h"
#include "scene/scene_file.h"
#include "store/previews.h"

namespace marketgen::store {
namespace fs = std::filesystem;
namespace {

StoreBounds bounds_of(const scene::Scene& scene) {
  const plan::Shell& shell = scene.layout.shell;
  return {{0, 0, 0}, {shell.width_mm * 1e-3, shell.depth_mm * 1e-3, shell.ceiling_mm * 1e-3}};
}

// Digests of every file in the draft, sorted by path.
Result<std::vector<FileDigest>> digests_of(const fs::path& folder) {
  std::vector<FileDigest> digests;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string path = fs::relative(entry.path(), folder).generic_string();
    if (path == "store.json" || path == "report.json") continue;
    MARKETGEN_TRY(const std::string sha256, io::sha256_of_file(entry.path()));
    digests.push_back({path, sha256, entry.file_size()});
  }
  std::sort(digests.begin(), digests.end(), [](const FileDigest& a, const FileDigest& b) {
    return a.path < b.path;
  });
  return digests;
}

// A described document as text that its reader accepts.
template <class Document>
Result<std::string> text_of(const Document& document, const char* name) {
  MARKETGEN_CHECK(io::check_fields(document, name));
  return io::write_json(document);
}

Result<std::string> bytes_of(const scene::Scene& scene) {
  std::string bytes = scene::encode_scene(scene);
  MARKETGEN_CHECK(scene::decode_scene(std::as_bytes(std::span(bytes)), "scene.bin"));
  return bytes;
}

struct StageFile {
  const char* name;
  std::string bytes;
};

// What the stages leave in a store's folder, each such that opening takes it.
Result<std::vector<StageFile>> stage_files(const plan::Plan& plan,
                                           const scene::Scene& scene,
                                           const catalog::Catalog& catalog) {
  MARKETGEN_CHECK(plan::validate_plan(plan, "plan.json", catalog));
  MARKETGEN_TRY(std::string layout_text, text_of(scene.layout, "layout.json"));
  MARKETGEN_TRY(std::string scene_bytes, bytes_of(scene));
  MARKETGEN_TRY(const scene::Table planogram, scene::query_scene(scene, "planogram", ""));
  std::vector<StageFile> files;
  files.push_back({"plan.json", io::write_json(plan)});
  files.push_back({"layout.json", std::move(layout_text)});
  files.push_back({"scene.bin", std::move(scene_bytes)});
  files.push_back({"planogram.csv", scene::to_csv(planogram)});
  return files;
}

Result<void> write_stages(const fs::path& folder,
                          const plan::Plan& plan,
                          const scene::Scene& scene,
                          const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const std::vector<StageFile> files, stage_files(plan, scene, catalog));
  for (const StageFile& file : files)
    MARKETGEN_CHECK(io::write_file(folder / file.name, file.bytes));
  return {};
}

Result<void> write_documents(const fs::path& folder, const Created& created) {
  MARKETGEN_TRY(const std::string manifest, text_of(created.manifest, "store.json"));
  MARKETGEN_TRY(const std::string report, text_of(created.report, "report.json"));
  MARKETGEN_CHECK(io::write_file(folder / "store.json", manifest));
  return io::write_file(folder / "report.json", report);
}

Result<void> write_previews(const fs::path& folder,
                            const scene::Scene& scene,
                            const catalog::Catalog& catalog,
                            Progress& progress) {
  MARKETGEN_CHECK(io::write_png(folder / "layout.png", layout::draw_layout(scene.layout, catalog)));
  std::error_code failed;
  fs::create_directory(folder / "previews", failed);
  if (failed) return Error{"io.cannot_write", (folder / "previews").string(), failed.message()};
  return draw_previews(scene, folder / "previews", progress);
}

}  // namespace

Result<void> check_stages(const plan::Plan& plan,
                          const scene::Scene& scene,
                          const catalog::Catalog& catalog) {
  MARKETGEN_CHECK(stage_files(plan, scene, catalog));
  return {};
}

Result<void> require_no_hard_violation(const std::vector<layout::Violation>& rules) {
  for (const layout::Violation& v : rules) {
    if (v.severity == layout::Severity::hard)
      return Error{"layout.violation", v.where, fmt::format("{}: {}", v.code, v.message)};
  }
  return {};
}

Manifest manifest_of(const plan::Plan& plan,
                     const scene::Scene& scene,
                     const catalog::Catalog& catalog,
                     std::uint64_t seed) {
  Manifest manifest;
  manifest.name = plan.name;
  manifest.seed = seed;
  manifest.versions = {program_version, catalog.content_hash};
  if (!catalog.own.empty()) manifest.own.emplace();
  for (const std::string& sku : catalog.own)
    manifest.own->push_back(*catalog.product(sku));
  manifest.counts = scene::count(scene);
  manifest.bounds = bounds_of(scene);
  manifest.scene_hash = scene::scene_hash(scene);
  manifest.look_hash = scene::look_hash(scene);
  return manifest;
}

Result<Created> save_store(io::FolderDraft& draft,
                           const plan::Plan& plan,
                           const scene::Scene& scene,
                           Created created,
                           bool previews,
                           const catalog::Catalog& catalog,
                           Stages& stages) {
  MARKETGEN_CHECK(
      stages.run("save", [&] { return write_stages(draft.folder(), plan, scene, catalog); }));
  MARKETGEN_CHECK(catalog::save_own_files(scene.catalog, draft.folder()));
  if (created.manifest.own)
    MARKETGEN_CHECK(catalog::save_spare_files(*created.manifest.own, draft.folder()));
  if (previews) {
    MARKETGEN_CHECK(stages.run("previews", [&] {
      return write_previews(draft.folder(), scene, catalog, silent_progress());
    }));
  }
  MARKETGEN_TRY(created.manifest.files, digests_of(draft.folder()));
  created.report.timing_s = stages.take();
  created.report.peak_rss_mb = peak_rss_mb();
  MARKETGEN_CHECK(write_documents(draft.folder(), created));
  MARKETGEN_CHECK(check_interrupt());
  MARKETGEN_CHECK(draft.commit());
  return created;
}

}  // namespace marketgen::store
