#include <fmt/format.h>

#include "io/file.h"
#include "io/json.h"
#include "physics/settle.h"
#include "scene/scene_file.h"
#include "store/store.h"

namespace marketgen {
namespace fs = std::filesystem;
namespace {

template <class Document>
Result<Document> read_document(const fs::path& file) {
  MARKETGEN_TRY(const std::string text, read_file(file));
  return read_json<Document>(text, file.string());
}

Result<Manifest> read_manifest(const fs::path& folder) {
  std::error_code failed;
  if (!fs::exists(folder, failed))
    return Error{"input.not_found", folder.string(), "there is no such folder"};
  if (!fs::exists(folder / "store.json", failed)) {
    return Error{
        "store.not_a_store",
        folder.string(),
        "has no store.json; make a store with: marketgen generate \"...\" -o " + folder.string()};
  }
  return read_document<Manifest>(folder / "store.json");
}

}  // namespace

Result<Store> open_store(const fs::path& folder, const Catalog& catalog) {
  MARKETGEN_TRY(Manifest manifest, read_manifest(folder));
  MARKETGEN_TRY(const std::string plan_text, read_file(folder / "plan.json"));
  MARKETGEN_TRY(Plan plan, read_plan(plan_text, (folder / "plan.json").string(), catalog));
  MARKETGEN_TRY(Scene scene, open_scene(folder / "scene.bin"));
  return Store{folder, std::move(manifest), std::move(plan), std::move(scene)};
}

Result<StoreReport> read_report(const fs::path& folder) {
  return read_document<StoreReport>(folder / "report.json");
}

Result<void> verify_store(const fs::path& folder, const Catalog& catalog) {
  MARKETGEN_TRY(const Manifest manifest, read_manifest(folder));
  for (const FileDigest& file : manifest.files) {
    const fs::path path = folder / file.path;
    if (fs::path(file.path).is_absolute() || file.path.find("..") != std::string::npos) {
      return Error{"store.changed", file.path, "the manifest names a file outside the store"};
    }
    if (!fs::exists(path))
      return Error{"store.changed", path.string(), "the manifest names this file, but it is gone"};
    MARKETGEN_TRY(const std::string found, sha256_of_file(path));
    if (found != file.sha256) {
      return Error{"store.changed",
                   path.string(),
                   fmt::format("SHA-256 is {}..., the manifest says {}...",
                               found.substr(0, 12),
                               file.sha256.substr(0, 12))};
    }
  }
  MARKETGEN_TRY(const Store store, open_store(folder, catalog));
  const std::string hash = scene_hash(store.scene);
  if (hash != manifest.scene_hash) {
    return Error{"store.changed",
                 (folder / "scene.bin").string(),
                 fmt::format("scene_hash is {}, the manifest says {}", hash, manifest.scene_hash)};
  }
  return {};
}

Result<StoreReport> full_report(const Store& store, const Catalog& catalog, Progress& progress) {
  MARKETGEN_TRY(StoreReport report, read_report(store.folder));
  progress.begin("audit", 1);
  MARKETGEN_TRY(Audit audit, audit_store(store.scene, catalog, store.manifest.requirements));
  progress.end();
  report.requirements = std::move(audit.requirements);
  report.rules = std::move(audit.rules);
  report.metrics = audit.metrics;
  progress.begin("settle", 1);
  constexpr int let_go = 200;
  SettleOptions options;
  options.region_m = region_around_aisle(store.scene, let_go);
  options.most_products = let_go;
  MARKETGEN_TRY(const SettleReport settled, settle(store.scene, options));
  progress.end();
  report.metrics.STB = settled.share_below_5_cm;
  report.metrics.stb_products = settled.products;
  report.peak_rss_mb = peak_rss_mb();
  return report;
}

}  // namespace marketgen
