// The store folder: made in one piece, opened, checked. docs/formats.md describes the files.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "audit/audit.h"
#include "base/fields.h"
#include "base/progress.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "intake/brief.h"
#include "intake/drawn_fit.h"
#include "layout/layout.h"
#include "plan/patch.h"
#include "plan/plan.h"
#include "planners/make_planner.h"
#include "scene/own_goods.h"
#include "scene/scene.h"

namespace marketgen::store {

struct FileDigest {
  std::string path, sha256;
  std::uint64_t bytes = 0;
  static constexpr auto fields =
      field_list(field("path", &FileDigest::path, "relative to the store", required()),
                 field("sha256", &FileDigest::sha256, "of its bytes", required()),
                 field("bytes", &FileDigest::bytes, "size"));
};

struct StoreVersions {
  std::string marketgen, catalog;  // program version; hash of the catalogue's rows
  static constexpr auto fields =
      field_list(field("marketgen", &StoreVersions::marketgen, "program"),
                 field("catalog", &StoreVersions::catalog, "hash of the catalogue's rows"));
};

struct StoreBounds {
  std::array<double, 3> low_m{}, high_m{};
  static constexpr auto fields =
      field_list(field("low_m", &StoreBounds::low_m, "lowest corner"),
                 field("high_m", &StoreBounds::high_m, "highest corner"));
};

// An edit that this store has behind it (store/edit.h).
struct StoreEdit {
  std::string words;                 // as they were said; empty when patches were given
  std::vector<plan::Patch> patches;  // what was done
  std::string from;                  // scene_hash of the store that was edited
  static constexpr auto fields =
      field_list(field("words", &StoreEdit::words, "as they were said", at_most_bytes(20000)),
                 field("patches", &StoreEdit::patches, "what was done", required()),
                 field("from", &StoreEdit::from, "scene_hash of the store that was edited"));
};

// store.json
struct Manifest {
  std::string schema = "market-store/1";
  std::string name;
  std::uint64_t seed = 0;
  StoreVersions versions;
  intake::Brief brief;
  std::vector<plan::Requirement> requirements;
  std::optional<std::vector<catalog::Product>> own;  // rows of the user's own that it was made with
  std::optional<std::vector<StoreEdit>> edits;       // the oldest first
  scene::SceneCounts counts;
  StoreBounds bounds;
  std::string scene_hash, look_hash;
  std::vector<FileDigest> files;  // every file but store.json and report.json, sorted by path

  static constexpr auto fields =
      field_list(field("schema", &Manifest::schema, "schema tag", constant("market-store/1")),
                 field("name", &Manifest::name, "the store's name"),
                 field("seed", &Manifest::seed, "seed it was made with"),
                 field("versions", &Manifest::versions, "what made it"),
                 field("brief", &Manifest::brief, "what was asked"),
                 field("requirements", &Manifest::requirements, "atomic wishes, as understood"),
                 field("own", &Manifest::own, "rows of the user's own that it was made with"),
                 field("edits", &Manifest::edits, "edits since it was generated, the oldest first"),
                 field("counts", &Manifest::counts, "how much there is"),
                 field("bounds", &Manifest::bounds, "of everything"),
                 field("scene_hash", &Manifest::scene_hash, "over SKU, geometry and pose"),
                 field("look_hash", &Manifest::look_hash, "over materials and light"),
                 field("files", &Manifest::files, "every other file but report.json"));
};

struct StageTiming {
  std::string stage;
  double seconds = 0;
  static constexpr auto fields = field_list(field("stage", &StageTiming::stage, "stage"),
                                            field("seconds", &StageTiming::seconds, "wall time"));
};

// report.json
struct StoreReport {
  std::string schema = "market-report/1";
  std::vector<audit::RequirementResult> requirements;
  std::vector<layout::Violation> rules;
  audit::Metrics metrics;
  bool understood = true;
  std::vector<intake::UnparsedWord> unparsed;
  std::vector<intake::Conflict> conflicts;
  std::vector<std::string> repairs;         // what repair changed
  std::vector<scene::Unstocked> unstocked;  // products of the user's own that stand nowhere
  std::vector<StageTiming> timing_s;
  double peak_rss_mb = 0;
  std::optional<intake::PlannerRecord> planner;
  std::optional<intake::DrawnFit> drawing;

  static constexpr auto fields = field_list(
      field("schema", &StoreReport::schema, "schema tag", constant("market-report/1")),
      field("requirements", &StoreReport::requirements, "wishes and whether they hold"),
      field("rules", &StoreReport::rules, "broken rules"),
      field("metrics", &StoreReport::metrics, "measured on the scene"),
      field("understood",
            &StoreReport::understood,
            "false: not one word of the prompt said anything; the store is the usual one"),
      field("unparsed", &StoreReport::unparsed, "words not understood"),
      field("conflicts", &StoreReport::conflicts, "wishes that could not all hold"),
      field("repairs", &StoreReport::repairs, "what repair changed"),
      field("unstocked", &StoreReport::unstocked, "products of the user's own that stand nowhere"),
      field("timing_s", &StoreReport::timing_s, "wall time by stage"),
      field("peak_rss_mb", &StoreReport::peak_rss_mb, "most memory in use"),
      field("planner", &StoreReport::planner, "how a language model planned; absent: none did"),
      field("drawing",
            &StoreReport::drawing,
            "how much of the drawing of zones the plan keeps; absent: there was none"));
};

struct CreateOptions {
  std::filesystem::path folder;  // must not exist, or be empty
  intake::Brief brief;
  std::optional<std::filesystem::path> plan_file;  // skips the planner
  // What stands on the shelves that it names (scene/planogram_file.h); its fixtures are the
  // store's.
  std::optional<std::filesystem::path> planogram_file;
  planners::PlannerAccess planner;  // of the language model that brief.planner names
  std::uint64_t seed = 1;
  bool previews = true;
  bool strict = false;  // hard violations fail: layout.violation; so does a prompt of which nothing
                        // was understood: brief.not_understood
};

struct Created {
  Manifest manifest;
  StoreReport report;
};

// The scene of a store that was made from this (repaired) plan with this seed, again.
Result<scene::Scene> scene_of_plan(const plan::Plan& plan,
                                   const catalog::Catalog& catalog,
                                   std::uint64_t seed);

// Plans, lays out, stocks, checks, draws and saves. Nothing is left behind when it fails.
Result<Created> create_store(const CreateOptions& options,
                             const catalog::Catalog& catalog,
                             Progress& progress = silent_progress());

// What create_store would report, without a folder: the same repairs, the same rules, the same
// refusals.
Result<StoreReport> try_store(const CreateOptions& options,
                              const catalog::Catalog& catalog,
                              Progress& progress = silent_progress());

struct Store {
  std::filesystem::path folder;
  Manifest manifest;
  plan::Plan plan;
  scene::Scene scene;
};
// Reads manifest, plan and scene; each file that is read must have the digest that the manifest
// says. Errors: store.not_a_store, store.changed, scene.*, json.*.
Result<Store> open_store(const std::filesystem::path& folder, const catalog::Catalog& catalog);
// The scene alone, verified alike.
Result<scene::Scene> open_store_scene(const std::filesystem::path& folder);
// The manifest alone. Errors: input.not_found, store.not_a_store, json.*.
Result<Manifest> read_manifest(const std::filesystem::path& folder);
Result<StoreReport> read_report(const std::filesystem::path& folder);
// Every file against its digest, scene against its hash. Error: store.changed with the file's name.
Result<void> verify_store(const std::filesystem::path& folder, const catalog::Catalog& catalog);

// The report with what needs physics (STB) measured too.
Result<StoreReport> full_report(const Store& store,
                                const catalog::Catalog& catalog,
                                Progress& progress = silent_progress());

}  // namespace marketgen::store
