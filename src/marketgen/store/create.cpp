#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "base/build_info.h"
#include "base/interrupt.h"
#include "catalog/own_mesh.h"
#include "io/field_check.h"
#include "io/file.h"
#include "io/json.h"
#include "io/png.h"
#include "layout/layout_picture.h"
#include "plan/plan_place.h"
#include "plan/style_look.h"
#include "planners/make_planner.h"
#include "scene/query.h"
#include "scene/scene_file.h"
#include "store/design.h"
#include "store/previews.h"
#include "store/store.h"

namespace marketgen::store {
namespace fs = std::filesystem;
namespace {

// Runs stages, times each, and tells the progress.
class Stages {
 public:
  explicit Stages(Progress& progress) : progress_(progress) {}

  template <class Work>
  auto run(std::string name, const Work& work) -> decltype(work()) {
    MARKETGEN_CHECK(check_interrupt());
    progress_.begin(name, 1);
    const double start = monotonic_seconds();
    auto result = work();
    timings_.push_back({std::move(name), monotonic_seconds() - start});
    progress_.end();
    return result;
  }
  std::vector<StageTiming> take() { return std::move(timings_); }

 private:
  Progress& progress_;
  std::vector<StageTiming> timings_;
};

Result<intake::Planned> read_planned(const std::filesystem::path& file,
                                     const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const std::string text, io::read_file(file, 64U << 20));
  intake::Planned planned;
  MARKETGEN_TRY(planned.plan, plan::read_plan(text, file.string(), catalog));
  return planned;
}

// The look that was asked for apart from the plan: the layout does not depend on it.
Result<void> put_on_skin(plan::Plan& plan,
                         const intake::Brief& brief,
                         const catalog::Catalog& catalog) {
  if (!brief.skin) return {};
  MARKETGEN_TRY(const catalog::StyleRow* style, plan::style_called(catalog, *brief.skin, "--skin"));
  plan.look = plan::look_of(*style);
  std::erase_if(plan.provenance,
                [](const plan::Provenance& entry) { return entry.path.starts_with("/look/"); });
  plan::Provenance flag;
  flag.path = "/look";
  flag.source = plan::Source::flag;
  plan.provenance.push_back(flag);
  return {};
}

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

// What the planner leaves beside the stages.
Result<void> write_planner_files(const fs::path& folder,
                                 const std::vector<intake::PlannerFile>& files) {
  for (const intake::PlannerFile& file : files) {
    const fs::path place = folder / file.path;
    std::error_code failed;
    fs::create_directories(place.parent_path(), failed);
    if (failed) return Error{"io.cannot_write", place.string(), failed.message()};
    MARKETGEN_CHECK(io::write_file(place, file.bytes));
  }
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

Result<void> require_no_hard_violation(const std::vector<layout::Violation>& rules) {
  for (const layout::Violation& v : rules) {
    if (v.severity == layout::Severity::hard)
      return Error{"layout.violation", v.where, fmt::format("{}: {}", v.code, v.message)};
  }
  return {};
}

constexpr std::string_view layout_stream = "layout", scene_stream = "scene";

struct Built {
  intake::Planned planned;
  layout::Repaired repaired;
  scene::Scene scene;
  audit::Audit audit;
  std::vector<scene::Unstocked> unstocked;
};

// The plan of the options' file, or of their brief with what had to be conceded.
Result<intake::Planned> plan_of(const CreateOptions& options,
                                const catalog::Catalog& catalog,
                                const intake::Planner* planner,
                                const intake::Concessions& concessions) {
  intake::Planned planned;
  if (options.plan_file) {
    MARKETGEN_TRY(planned, read_planned(*options.plan_file, catalog));
  } else {
    const Seed seed = Seed(options.seed).child("plan");
    MARKETGEN_TRY(planned,
                  intake::plan_from_brief(options.brief, catalog, *planner, seed, concessions));
  }
  MARKETGEN_CHECK(put_on_skin(planned.plan, options.brief, catalog));
  return planned;
}

Result<void> require_understood(const intake::Planned& planned) {
  if (planned.understood) return {};
  return Error{"brief.not_understood",
               "prompt",
               "nothing of it was understood; describe the store in English, as in \"a 24 x 15 m "
               "supermarket with a bakery and five checkouts\" (docs/prompts.md has the words)"};
}

Result<Designed> design(const CreateOptions& options,
                        const catalog::Catalog& catalog,
                        Stages& stages) {
  const Seed layout_seed = Seed(options.seed).child(layout_stream);
  std::unique_ptr<intake::Planner> planner;  // for words only
  if (!options.plan_file) {
    MARKETGEN_TRY(planner,
                  planners::make_planner(options.brief.planner, options.planner, layout_seed));
  }
  const PlanAgain plan = [&](const intake::Concessions& concessions) {
    return plan_of(options, catalog, planner.get(), concessions);
  };
  Designed designed;
  MARKETGEN_TRY(designed.planned, stages.run("plan", [&] { return plan({}); }));
  if (options.strict) MARKETGEN_CHECK(require_understood(designed.planned));
  MARKETGEN_TRY(designed.repaired, stages.run("repair", [&] {
    return layout::repair_plan(designed.planned.plan, catalog, layout_seed);
  }));
  MARKETGEN_TRY(designed.layout, stages.run("layout", [&] {
    // A plan that somebody wrote says itself what it is: nothing is conceded.
    return options.plan_file ? layout::make_layout(designed.repaired.plan, catalog, layout_seed)
                             : layout_of(designed.repaired, catalog, layout_seed);
  }));
  if (options.plan_file || keeps_hard_rules(designed.layout.violations)) return designed;
  std::optional<intake::PlannerRecord> record = std::move(designed.planned.record);
  std::vector<intake::PlannerFile> files = std::move(designed.planned.files);
  MARKETGEN_TRY(Designed conceded, stages.run("concede", [&] {
    return concede(std::move(designed), plan, catalog, layout_seed);
  }));
  conceded.planned.record = std::move(record);
  conceded.planned.files = std::move(files);
  return conceded;
}

// Why a wish was not met is what was measured, and what stood in its way.
void add_reasons(std::vector<audit::RequirementResult>& results,
                 const std::vector<intake::Conflict>& conflicts) {
  for (audit::RequirementResult& result : results) {
    if (result.met) continue;
    for (const intake::Conflict& conflict : conflicts) {
      if (conflict.dropped == result.text) result.why += "; " + conflict.why;
    }
  }
}

Result<Built> build(const CreateOptions& options, const catalog::Catalog& catalog, Stages& stages) {
  const Seed seed(options.seed);
  MARKETGEN_TRY(Designed designed, design(options, catalog, stages));
  MARKETGEN_TRY(scene::Scene scene, stages.run("scene", [&] {
    return scene::build_scene(
        designed.layout, designed.repaired.plan, catalog, seed.child(scene_stream));
  }));
  MARKETGEN_TRY(audit::Audit audit, stages.run("audit", [&] {
    return audit::audit_store(scene, catalog, designed.planned.requirements);
  }));
  add_reasons(audit.requirements, designed.planned.conflicts);
  if (options.strict) MARKETGEN_CHECK(require_no_hard_violation(audit.rules));
  std::vector<scene::Unstocked> unstocked =
      scene::unstocked_products(scene, designed.repaired.plan, catalog);
  return Built{std::move(designed.planned),
               std::move(designed.repaired),
               std::move(scene),
               std::move(audit),
               std::move(unstocked)};
}

// Faults of a plan that somebody wrote name its file.
Result<Built> built_from(const CreateOptions& options,
                         const catalog::Catalog& catalog,
                         Stages& stages) {
  Result<Built> built = build(options, catalog, stages);
  if (!built.ok() && options.plan_file)
    return plan::in_plan_file(built.error(), options.plan_file->string());
  return built;
}

StoreReport report_of(Built& built) {
  StoreReport report;
  report.requirements = std::move(built.audit.requirements);
  report.rules = std::move(built.audit.rules);
  report.metrics = built.audit.metrics;
  report.understood = built.planned.understood;
  report.unparsed = std::move(built.planned.unparsed);
  report.conflicts = std::move(built.planned.conflicts);
  report.repairs = std::move(built.repaired.changes);
  report.unstocked = std::move(built.unstocked);
  report.planner = std::move(built.planned.record);
  return report;
}

Manifest manifest_of(const Built& built,
                     const CreateOptions& options,
                     const catalog::Catalog& catalog) {
  Manifest manifest;
  manifest.name = built.repaired.plan.name;
  manifest.seed = options.seed;
  manifest.versions = {program_version, catalog.content_hash};
  manifest.brief = options.brief;
  manifest.requirements = built.planned.requirements;
  if (!catalog.own.empty()) manifest.own.emplace();
  for (const std::string& sku : catalog.own)
    manifest.own->push_back(*catalog.product(sku));
  manifest.counts = scene::count(built.scene);
  manifest.bounds = bounds_of(built.scene);
  manifest.scene_hash = scene::scene_hash(built.scene);
  manifest.look_hash = scene::look_hash(built.scene);
  return manifest;
}

}  // namespace

Result<scene::Scene> scene_of_plan(const plan::Plan& plan,
                                   const catalog::Catalog& catalog,
                                   std::uint64_t seed) {
  MARKETGEN_TRY(const layout::Layout layout,
                layout::make_layout(plan, catalog, Seed(seed).child(layout_stream)));
  return scene::build_scene(layout, plan, catalog, Seed(seed).child(scene_stream));
}

Result<StoreReport> try_store(const CreateOptions& options,
                              const catalog::Catalog& catalog,
                              Progress& progress) {
  Stages stages(progress);
  MARKETGEN_TRY(Built built, built_from(options, catalog, stages));
  MARKETGEN_CHECK(stage_files(built.repaired.plan, built.scene, catalog));
  StoreReport report = report_of(built);
  report.timing_s = stages.take();
  report.peak_rss_mb = peak_rss_mb();
  MARKETGEN_CHECK(io::check_fields(report, "report.json"));
  return report;
}

Result<Created> create_store(const CreateOptions& options,
                             const catalog::Catalog& catalog,
                             Progress& progress) {
  MARKETGEN_TRY(io::FolderDraft draft, io::FolderDraft::begin(options.folder));
  Stages stages(progress);
  MARKETGEN_TRY(Built built, built_from(options, catalog, stages));
  MARKETGEN_CHECK(stages.run("save", [&] {
    return write_stages(draft.folder(), built.repaired.plan, built.scene, catalog);
  }));
  MARKETGEN_CHECK(write_planner_files(draft.folder(), built.planned.files));
  MARKETGEN_CHECK(catalog::save_meshes(built.scene.catalog, draft.folder()));
  if (options.previews) {
    MARKETGEN_CHECK(stages.run("previews", [&] {
      return write_previews(draft.folder(), built.scene, catalog, silent_progress());
    }));
  }
  Created created;
  created.manifest = manifest_of(built, options, catalog);
  MARKETGEN_TRY(std::vector<FileDigest> files, digests_of(draft.folder()));
  created.manifest.files = std::move(files);
  created.report = report_of(built);
  created.report.timing_s = stages.take();
  created.report.peak_rss_mb = peak_rss_mb();
  MARKETGEN_CHECK(write_documents(draft.folder(), created));
  MARKETGEN_CHECK(check_interrupt());
  MARKETGEN_CHECK(draft.commit());
  return created;
}

}  // namespace marketgen::store
