#include <algorithm>

#include <fmt/format.h>

#include "catalog/own_files.h"
#include "io/file.h"
#include "io/json.h"
#include "physics/settle/settle.h"
#include "scene/scene_file.h"
#include "store/store.h"

namespace marketgen::store {
namespace fs = std::filesystem;
namespace {

template <class Document>
Result<Document> read_document(const fs::path& file) {
  MARKETGEN_TRY(const std::string text, io::read_file(file));
  return io::read_json<Document>(text, file.string());
}

std::string_view text_of(const io::MappedFile& file) {
  return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
}

Error changed(const fs::path& path, std::string what) {
  return {"store.changed",
          path.string(),
          std::move(what) + "; restore the file or generate the store again"};
}

// The bytes of one of the store's files, if they are those that the manifest was written for.
Result<io::MappedFile> open_unchanged(const fs::path& folder, const FileDigest& file) {
  const fs::path path = folder / file.path;
  if (fs::path(file.path).is_absolute() || file.path.find("..") != std::string::npos)
    return Error{"store.changed", file.path, "the manifest names a file outside the store"};
  std::error_code failed;
  if (!fs::exists(path, failed))
    return changed(path, "the manifest names this file, but it is gone");
  MARKETGEN_TRY(io::MappedFile mapped, io::MappedFile::open(path));
  const std::string found = io::sha256_hex(text_of(mapped));
  if (found == file.sha256) return mapped;
  return changed(path,
                 fmt::format("SHA-256 is {}..., the manifest says {}...",
                             found.substr(0, 12),
                             file.sha256.substr(0, 12)));
}

Result<io::MappedFile> open_unchanged(const fs::path& folder,
                                      const Manifest& manifest,
                                      std::string_view name) {
  const auto file = std::ranges::find(manifest.files, name, &FileDigest::path);
  if (file == manifest.files.end())
    return changed(folder / "store.json", fmt::format("names no {}", name));
  return open_unchanged(folder, *file);
}

Result<scene::Scene> scene_of(const fs::path& folder, const Manifest& manifest) {
  MARKETGEN_TRY(const io::MappedFile file, open_unchanged(folder, manifest, "scene.bin"));
  MARKETGEN_TRY(scene::Scene scene,
                scene::decode_scene(file.bytes(), (folder / "scene.bin").string()));
  // Files of products are called after their own digests, and are read only when those are right.
  MARKETGEN_CHECK(catalog::restore_own_files(scene.catalog, folder));
  if (manifest.own) MARKETGEN_CHECK(catalog::restore_spare_files(*manifest.own, folder));
  return scene;
}

}  // namespace

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

Result<scene::Scene> open_store_scene(const fs::path& folder) {
  MARKETGEN_TRY(const Manifest manifest, read_manifest(folder));
  return scene_of(folder, manifest);
}

Result<Store> open_store(const fs::path& folder, const catalog::Catalog& catalog) {
  MARKETGEN_TRY(Manifest manifest, read_manifest(folder));
  MARKETGEN_TRY(const io::MappedFile plan_file, open_unchanged(folder, manifest, "plan.json"));
  MARKETGEN_TRY(plan::Plan plan,
                plan::read_plan(text_of(plan_file), (folder / "plan.json").string(), catalog));
  MARKETGEN_TRY(scene::Scene scene, scene_of(folder, manifest));
  return Store{folder, std::move(manifest), std::move(plan), std::move(scene)};
}

Result<StoreReport> read_report(const fs::path& folder) {
  return read_document<StoreReport>(folder / "report.json");
}

Result<void> verify_store(const fs::path& folder, const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const Manifest manifest, read_manifest(folder));
  for (const FileDigest& file : manifest.files)
    MARKETGEN_CHECK(open_unchanged(folder, file));
  MARKETGEN_TRY(const Store store, open_store(folder, catalog));
  const std::string hash = scene::scene_hash(store.scene);
  if (hash != manifest.scene_hash) {
    return changed(
        folder / "scene.bin",
        fmt::format("scene_hash is {}, the manifest says {}", hash, manifest.scene_hash));
  }
  return {};
}

Result<StoreReport> full_report(const Store& store,
                                const catalog::Catalog& catalog,
                                Progress& progress) {
  MARKETGEN_TRY(StoreReport report, read_report(store.folder));
  progress.begin("audit", 1);
  MARKETGEN_TRY(audit::Audit audit,
                audit::audit_store(store.scene, catalog, store.manifest.requirements));
  progress.end();
  report.requirements = std::move(audit.requirements);
  report.rules = std::move(audit.rules);
  report.metrics = audit.metrics;
  progress.begin("settle", 1);
  constexpr int let_go = 200;
  physics::SettleOptions options;
  options.region_m = physics::region_around_aisle(store.scene, let_go);
  options.max_products = let_go;
  MARKETGEN_TRY(const physics::SettleReport settled, physics::settle(store.scene, options));
  progress.end();
  report.metrics.STB = settled.share_below_5_cm;
  report.metrics.stb_products = settled.products;
  report.peak_rss_mb = peak_rss_mb();
  return report;
}

}  // namespace marketgen::store
