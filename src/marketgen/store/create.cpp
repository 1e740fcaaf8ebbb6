#include <algorithm>

#include <fmt/format.h>

#include "intake/conflicts.h"
#include "io/field_check.h"
#include "io/file.h"
#include "io/json.h"
#include "plan/plan_edit.h"
#include "plan/plan_place.h"
#include "plan/store_time.h"
#include "plan/style_look.h"
#include "planners/make_planner.h"
#include "store/design.h"
#include "store/made_store.h"
#include "store/planogram.h"
#include "store/save.h"
#include "store/stages.h"
#include "store/store.h"

namespace marketgen::store {
namespace {

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

// The time that was asked for takes the place of the plan's own.
Result<void> set_time(plan::Plan& plan, const intake::Brief& brief) {
  if (!brief.time) return {};
  MARKETGEN_TRY(const plan::StoreTime time,
                plan::parse_store_time(*brief.time, "brief.bad_time", "--time"));
  plan.time = plan::text_of(time);
  plan::note_provenance(plan, {"/time"}, plan::Source::flag);
  return {};
}

// The same of single axes' seeds, each by itself.
void set_vary(plan::Plan& plan, const intake::Brief& brief) {
  if (!brief.vary) return;
  plan.vary = plan::with_vary(plan.vary.value_or(plan::Vary{}), *brief.vary);
  plan::note_provenance(plan, {"/vary"}, plan::Source::flag);
}

struct Built {
  intake::Planned planned;
  layout::Repaired repaired;
  scene::Scene scene;
  audit::Audit audit;
  std::vector<scene::Unstocked> unstocked;
};

// The plan of the options' file, or of the brief with what had to be conceded.
Result<intake::Planned> plan_of(const CreateOptions& options,
                                const intake::Brief& brief,
                                const catalog::Catalog& catalog,
                                const intake::Planner* planner,
                                const intake::Concessions& concessions) {
  intake::Planned planned;
  if (options.plan_file) {
    MARKETGEN_TRY(planned, read_planned(*options.plan_file, catalog));
  } else {
    const Seed seed = plan_seed(brief.vary, Seed(options.seed));
    MARKETGEN_TRY(planned, intake::plan_from_brief(brief, catalog, *planner, seed, concessions));
  }
  MARKETGEN_CHECK(put_on_skin(planned.plan, brief, catalog));
  MARKETGEN_CHECK(set_time(planned.plan, brief));
  set_vary(planned.plan, brief);
  return planned;
}

Result<void> require_understood(const intake::Planned& planned) {
  if (planned.understood) return {};
  return Error{"brief.not_understood",
               "prompt",
               "nothing of it was understood; describe the store in English, as in \"a 24 x 15 m "
               "supermarket with a bakery and five checkouts\" (docs/prompts.md has the words)"};
}

Result<void> require_no_contradiction(const intake::Planned& planned) {
  const auto found = std::ranges::find_if(planned.conflicts, intake::is_contradiction);
  if (found == planned.conflicts.end()) return {};
  const std::string both = found->why.substr(0, found->why.rfind(';'));
  return Error{
      "brief.contradiction",
      "prompt",
      both + " (" + found->what + ": \"" + found->dropped + "\", \"" + found->kept +
          "\"); say which of them holds, or leave out --strict: then what was said last does"};
}

Result<Designed> design(const CreateOptions& options,
                        const catalog::Catalog& catalog,
                        Stages& stages) {
  std::unique_ptr<intake::Planner> planner;  // for words only
  if (!options.plan_file) {
    MARKETGEN_TRY(planner,
                  planners::make_planner(options.brief.planner,
                                         options.planner,
                                         layout_seed(options.brief.vary, Seed(options.seed))));
  }
  intake::Brief brief = options.brief;
  const PlanAgain plan = [&](const intake::Concessions& concessions) {
    return plan_of(options, brief, catalog, planner.get(), concessions);
  };
  Designed designed;
  MARKETGEN_TRY(designed.planned, stages.run("plan", [&] { return plan({}); }));
  brief.seen = designed.planned.seen;
  const Seed seed = layout_seed(designed.planned.plan.vary, Seed(options.seed));
  if (options.strict) {
    MARKETGEN_CHECK(require_understood(designed.planned));
    MARKETGEN_CHECK(require_no_contradiction(designed.planned));
  }
  MARKETGEN_TRY(designed.repaired, stages.run("repair", [&] {
    return layout::repair_plan(designed.planned.plan, catalog, seed);
  }));
  MARKETGEN_TRY(designed.layout, stages.run("layout", [&] {
    // A plan that somebody wrote says itself what it is: nothing is conceded.
    return options.plan_file ? layout::make_layout(designed.repaired.plan, catalog, seed)
                             : layout_of(designed.repaired, catalog, seed);
  }));
  if (options.plan_file || keeps_hard_rules(designed.layout.violations)) return designed;
  return stages.run("concede", [&] { return concede(std::move(designed), plan, catalog, seed); });
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

// The plan with the shelves that the file stocks otherwise than `scene` has them.
Result<plan::Plan> with_shelves_of(const std::filesystem::path& file,
                                   const plan::Plan& plan,
                                   const scene::Scene& scene,
                                   const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const scene::PlanogramFile said, read_planogram_file(file, scene, plan, catalog));
  if (!said.refused.empty()) return scene::refusal_of(said.refused);
  const scene::PlanogramChanges changes = scene::changes_by(said, scene, plan, catalog);
  if (changes.patches.patches.empty()) return plan;
  return plan::apply_patches(plan, changes.patches, file.string(), plan::Source::flag, catalog);
}

// The stocked scene; the plan gets the shelves of the options' planogram.
Result<scene::Scene> scene_of(const CreateOptions& options,
                              const layout::Layout& layout,
                              plan::Plan& plan,
                              const catalog::Catalog& catalog) {
  const Seed seed = Seed(options.seed).child(scene::scene_stream);
  MARKETGEN_TRY(scene::Scene scene, scene::build_scene(layout, plan, catalog, seed));
  if (!options.planogram_file) return scene;
  MARKETGEN_TRY(plan, with_shelves_of(*options.planogram_file, plan, scene, catalog));
  return scene::build_scene(layout, plan, catalog, seed);
}

Result<Built> build(const CreateOptions& options, const catalog::Catalog& catalog, Stages& stages) {
  MARKETGEN_TRY(Designed designed, design(options, catalog, stages));
  MARKETGEN_TRY(scene::Scene scene, stages.run("scene", [&] {
    return scene_of(options, designed.layout, designed.repaired.plan, catalog);
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

// What the planner leaves in the store's folder.
Result<void> write_planner_files(const std::filesystem::path& folder,
                                 const std::vector<intake::PlannerFile>& files) {
  for (const intake::PlannerFile& file : files) {
    const std::filesystem::path place = folder / file.path;
    std::error_code failed;
    std::filesystem::create_directories(place.parent_path(), failed);
    if (failed) return Error{"io.cannot_write", place.string(), failed.message()};
    MARKETGEN_CHECK(io::write_file(place, file.bytes));
  }
  return {};
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
  if (built.planned.drawn)
    report.drawing = intake::drawn_fit(*built.planned.drawn, built.repaired.plan);
  return report;
}

// Its folder is empty, and its manifest has no digests.
Result<MadeStore> made_in(const CreateOptions& options,
                          const catalog::Catalog& catalog,
                          Stages& stages) {
  MARKETGEN_TRY(Built built, built_from(options, catalog, stages));
  MadeStore made;
  made.store.manifest = manifest_of(built.repaired.plan, built.scene, catalog, options.seed);
  made.store.manifest.brief = options.brief;
  made.store.manifest.requirements = built.planned.requirements;
  made.planner_files = std::move(built.planned.files);
  made.report = report_of(built);
  made.store.plan = std::move(built.repaired.plan);
  made.store.scene = std::move(built.scene);
  return made;
}

Result<Created> saved_in(io::FolderDraft& draft,
                         const MadeStore& made,
                         bool previews,
                         const catalog::Catalog& catalog,
                         Stages& stages) {
  MARKETGEN_CHECK(write_planner_files(draft.folder(), made.planner_files));
  return save_store(draft,
                    made.store.plan,
                    made.store.scene,
                    {made.store.manifest, made.report},
                    previews,
                    catalog,
                    stages);
}

}  // namespace

Result<scene::Scene> scene_of_plan(const plan::Plan& plan,
                                   const catalog::Catalog& catalog,
                                   std::uint64_t seed) {
  MARKETGEN_TRY(const layout::Layout layout,
                layout::make_layout(plan, catalog, layout_seed(plan.vary, Seed(seed))));
  return scene::build_scene(layout, plan, catalog, Seed(seed).child(scene::scene_stream));
}

Result<MadeStore> made_store(const CreateOptions& options,
                             const catalog::Catalog& catalog,
                             Progress& progress) {
  Stages stages(progress);
  MARKETGEN_TRY(MadeStore made, made_in(options, catalog, stages));
  made.report.timing_s = stages.take();
  return made;
}

Result<Created> save_made(const MadeStore& made,
                          const std::filesystem::path& folder,
                          bool previews,
                          const catalog::Catalog& catalog,
                          Progress& progress) {
  MARKETGEN_TRY(io::FolderDraft draft, io::FolderDraft::begin(folder));
  Stages stages(progress, made.report.timing_s);
  return saved_in(draft, made, previews, catalog, stages);
}

Result<StoreReport> try_store(const CreateOptions& options,
                              const catalog::Catalog& catalog,
                              Progress& progress) {
  MARKETGEN_TRY(MadeStore made, made_store(options, catalog, progress));
  MARKETGEN_CHECK(check_stages(made.store.plan, made.store.scene, catalog));
  made.report.peak_rss_mb = peak_rss_mb();
  MARKETGEN_CHECK(io::check_fields(made.report, "report.json"));
  return std::move(made.report);
}

Result<Created> create_store(const CreateOptions& options,
                             const catalog::Catalog& catalog,
                             Progress& progress) {
  MARKETGEN_TRY(io::FolderDraft draft, io::FolderDraft::begin(options.folder));
  Stages stages(progress);
  MARKETGEN_TRY(const MadeStore made, made_in(options, catalog, stages));
  return saved_in(draft, made, options.previews, catalog, stages);
}

}  // namespace marketgen::store
