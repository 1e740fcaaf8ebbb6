#include "store/edit.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/build_info.h"
#include "io/json.h"
#include "layout/kept_layout.h"
#include "layout/layout_rules.h"
#include "layout/repair_moves.h"
#include "plan/plan_place.h"
#include "scene/block_swap.h"
#include "scene/fitted_shelves.h"
#include "scene/own_goods.h"
#include "scene/restock.h"
#include "store/design.h"
#include "store/save.h"
#include "store/stages.h"

namespace marketgen::store {
namespace {

bool is_broken_in(const std::vector<layout::Violation>& rules, const layout::Violation& rule) {
  return std::ranges::any_of(rules, [&](const layout::Violation& known) {
    return known.code == rule.code && known.where == rule.where && known.severity == rule.severity;
  });
}

std::vector<layout::Violation> newly_broken(const std::vector<layout::Violation>& before,
                                            const std::vector<layout::Violation>& after) {
  std::vector<layout::Violation> offences;
  for (const layout::Violation& rule : after) {
    if (rule.severity == layout::Severity::hard && !is_broken_in(before, rule))
      offences.push_back(rule);
  }
  return offences;
}

// Fixtures by id, as they stand; finishes go with the look.
std::map<std::string, std::string> fixtures_of(const layout::Layout& layout,
                                               const std::set<std::string>& without_zones) {
  std::map<std::string, std::string> rows;
  for (layout::Fixture fixture : layout.fixtures) {
    if (without_zones.contains(fixture.zone)) continue;
    fixture.material.clear();
    fixture.color.clear();
    rows[fixture.id] = io::write_json_line(fixture);
  }
  return rows;
}

template <class Row>
bool is_in(const std::vector<Row>& rows, const Row& row) {
  const std::string line = io::write_json_line(row);
  return std::ranges::any_of(rows, [&](const Row& r) { return io::write_json_line(r) == line; });
}

// Zones of fixtures with a value that is newly pinned, and zones that are gone.
std::set<std::string> zones_pinned(const plan::Plan& before, const plan::Plan& after) {
  std::set<std::string> zones;
  for (const plan::Override& pin : after.overrides) {
    if (is_in(before.overrides, pin)) continue;
    for (const plan::Zone& zone : after.zones) {
      if (pin.fixture.starts_with(zone.id + "/")) zones.insert(zone.id);
    }
  }
  for (const plan::Zone& zone : before.zones) {
    if (plan::find_zone(after, zone.id) == nullptr) zones.insert(zone.id);
  }
  return zones;
}

std::string planogram_of(const plan::Plan& plan, const std::string& zone) {
  std::string lines;
  for (const plan::StockedShelf& shelf : plan.planogram.value_or(std::vector<plan::StockedShelf>{}))
    if (shelf.fixture.starts_with(zone + "/")) lines += io::write_json_line(shelf);
  return lines;
}

// Also those whose goods the plans say differently: at another hour all of them.
std::set<std::string> zones_named(const plan::Plan& before, const plan::Plan& after) {
  std::set<std::string> named = zones_pinned(before, after);
  for (const plan::Zone& zone : after.zones) {
    const plan::Zone* old = plan::find_zone(before, zone.id);
    if (old == nullptr || before.time != after.time ||
        io::write_json_line(old->stock) != io::write_json_line(zone.stock) ||
        planogram_of(before, zone.id) != planogram_of(after, zone.id))
      named.insert(zone.id);
  }
  return named;
}

// The plan alone where that gives the other zones what they have, so that the plan goes on saying
// the whole store; round what stands otherwise.
Result<layout::Layout> layout_after(const Store& store,
                                    const plan::Plan& plan,
                                    const std::set<std::string>& furnish,
                                    const catalog::Catalog& catalog) {
  const Seed seed = layout_seed(plan.vary, Seed(store.manifest.seed));
  Result<layout::Layout> plain = layout::make_layout(plan, catalog, seed);
  if (!plain.ok() && plain.error().code != "layout.impossible") return plain;
  const layout::Layout& before = store.scene.layout;
  std::set<std::string> gone = furnish;
  std::ranges::copy(zones_pinned(store.plan, plan), std::inserter(gone, gone.end()));
  if (plain.ok() && fixtures_of(*plain, gone) == fixtures_of(before, gone)) return plain;
  return layout::make_layout_keeping(plan, catalog, seed, before, furnish);
}

// That nothing changed but where the patches let it. The user's own products are spread over all
// bays that sell them: they may find another.
Result<void> require_rest_kept(const Store& store,
                               const Replanned& now,
                               const SceneChanges& changes,
                               const catalog::Catalog& catalog) {
  if (!catalog.own.empty()) return {};
  const std::set<std::string> named = zones_named(store.plan, now.plan);
  for (const std::string& zone : changes.zones_touched) {
    if (zone.empty() || named.contains(zone) || now.furnished.contains(zone)) continue;
    return Error{"scene.wrong_version",
                 store.folder.string(),
                 "zone " + zone +
                     " would change although nothing was said of it: the store was made by "
                     "another version of marketgen or from other rows; generate it again"};
  }
  return {};
}

// With what was measured anew; what was said about the brief stays true.
StoreReport report_after(StoreReport before,
                         audit::Audit audit,
                         std::vector<scene::Unstocked> unstocked) {
  before.requirements = std::move(audit.requirements);
  before.rules = std::move(audit.rules);
  before.metrics = audit.metrics;
  before.unstocked = std::move(unstocked);
  before.drawing.reset();  // that was measured on the plan before
  return before;
}

std::vector<std::string> lost_wishes(const StoreReport& before, const StoreReport& after) {
  std::vector<std::string> lost;
  const std::size_t wishes = std::min(before.requirements.size(), after.requirements.size());
  for (std::size_t i = 0; i < wishes; ++i) {
    if (before.requirements[i].met && !after.requirements[i].met)
      lost.push_back(after.requirements[i].text);
  }
  return lost;
}

// Brief, wishes and edits; this one is the last.
void keep_history(Manifest& now, const Manifest& before, const EditStep& step) {
  now.brief = before.brief;
  now.requirements = before.requirements;
  now.edits = before.edits.value_or(std::vector<StoreEdit>{});
  now.edits->push_back({step.words, step.patches.patches, before.scene_hash});
}

// Only what the edit reaches is stocked anew where that is known to be all.
Result<scene::Scene> scene_after(const Store& store,
                                 const Replanned& now,
                                 const std::string& source,
                                 const catalog::Catalog& catalog) {
  const auto shelves = scene::shelves_changed(store.plan, now.plan, catalog, store.scene);
  const StoreVersions& made_by = store.manifest.versions;
  const bool same_floor = shelves && made_by.marketgen == program_version &&
                          made_by.catalog == catalog.content_hash &&
                          scene::same_but_for_boards(store.scene.layout, now.layout);
  Result<scene::Scene> scene =
      same_floor ? scene::restocked(store.scene, *shelves, now.plan, catalog)
                 : scene::build_scene(now.layout,
                                      now.plan,
                                      catalog,
                                      Seed(store.manifest.seed).child(scene::scene_stream));
  if (!scene.ok()) return plan::in_plan_file(scene.error(), source + " (plan)");
  return scene;
}

Result<EditedStore> edited_in(Stages& stages,
                              const Store& store,
                              const StoreReport& report,
                              const EditStep& step,
                              const catalog::Catalog& catalog) {
  MARKETGEN_TRY(Replanned now, stages.run("layout", [&] {
    return replan(store, step.patches, step.source, catalog);
  }));
  if (!now.offences.empty()) return error_of(now.offences.front());
  MARKETGEN_TRY(scene::Scene scene,
                stages.run("scene", [&] { return scene_after(store, now, step.source, catalog); }));
  EditedStore edited;
  edited.changes = changes_between(store.scene, scene);
  MARKETGEN_CHECK(require_rest_kept(store, now, edited.changes, catalog));
  MARKETGEN_TRY(audit::Audit audit, stages.run("audit", [&] {
    return audit::audit_store(scene, catalog, store.manifest.requirements);
  }));
  const std::vector<layout::Violation> offences = newly_broken(report.rules, audit.rules);
  if (!offences.empty()) return error_of(offences.front());
  edited.store.folder = store.folder;
  edited.store.manifest = manifest_of(now.plan, scene, catalog, store.manifest.seed);
  keep_history(edited.store.manifest, store.manifest, step);
  edited.report =
      report_after(report, std::move(audit), scene::unstocked_products(scene, now.plan, catalog));
  edited.lost = lost_wishes(report, edited.report);
  edited.store.plan = std::move(now.plan);
  edited.store.scene = std::move(scene);
  return edited;
}

Result<Created> saved_in(io::FolderDraft& draft,
                         Stages& stages,
                         const EditedStore& edited,
                         bool previews,
                         const catalog::Catalog& catalog) {
  return save_store(draft,
                    edited.store.plan,
                    edited.store.scene,
                    {edited.store.manifest, edited.report},
                    previews,
                    catalog,
                    stages);
}

}  // namespace

// The store's report; measured anew when its file is gone, which no digest protects.
Result<StoreReport> report_before(const Store& store, const catalog::Catalog& catalog) {
  if (Result<StoreReport> report = read_report(store.folder); report.ok()) return report;
  MARKETGEN_TRY(audit::Audit audit,
                audit::audit_store(store.scene, catalog, store.manifest.requirements));
  StoreReport report;
  report.requirements = std::move(audit.requirements);
  report.rules = std::move(audit.rules);
  return report;
}

Error error_of(const layout::Violation& offence) {
  std::string message = fmt::format("{}: {}", offence.code, offence.message);
  const std::vector<layout::LayoutRule>& rules = layout::layout_rules();
  const auto rule = std::ranges::find(rules, offence.code, &layout::LayoutRule::code);
  if (rule != rules.end()) {
    std::vector<std::string_view> helps;
    for (const layout::RepairMove move : rule->repairs)
      helps.push_back(layout::words_of(move));
    message += fmt::format(" (must hold: {}", rule->summary);
    if (!helps.empty())
      message += fmt::format("; a patch helps that {}", fmt::join(helps, ", or "));
    if (offence.code == "RELATION_BROKEN")
      message += ", or takes the relation back (set_relation with \"drop\": true)";
    message += ")";
  }
  return {"layout.violation", offence.where, message + "; nothing was written"};
}

Result<Replanned> replan(const Store& store,
                         const plan::PatchSet& patches,
                         const std::string& source,
                         const catalog::Catalog& catalog) {
  Replanned now;
  MARKETGEN_TRY(const plan::Plan said,
                scene::with_swapped_shelves(store.plan, patches, source, store.scene, catalog));
  MARKETGEN_TRY(now.plan, plan::apply_patches(said, patches, source, plan::Source::flag, catalog));
  now.furnished = layout::zones_to_furnish(store.plan, now.plan, catalog);
  Result<layout::Layout> layout = layout_after(store, now.plan, now.furnished, catalog);
  if (!layout.ok()) return plan::in_plan_file(layout.error(), source + " (plan)");
  now.layout = std::move(layout).value();
  if (fixtures_of(store.scene.layout, {}) == fixtures_of(now.layout, {}))
    MARKETGEN_CHECK(scene::check_swapped(now.plan, patches, source, store.scene, catalog));
  now.offences = newly_broken(store.scene.layout.violations, now.layout.violations);
  return now;
}

Result<EditedStore> edited_store(const Store& store,
                                 const StoreReport& report,
                                 const EditStep& step,
                                 const catalog::Catalog& catalog,
                                 Progress& progress) {
  Stages stages(progress);
  return edited_in(stages, store, report, step, catalog);
}

Result<Created> save_edited(const EditedStore& edited,
                            const std::filesystem::path& folder,
                            bool previews,
                            const catalog::Catalog& catalog,
                            Progress& progress) {
  MARKETGEN_TRY(io::FolderDraft draft, io::FolderDraft::begin(folder));
  Stages stages(progress);
  return saved_in(draft, stages, edited, previews, catalog);
}

Result<bool> follows_from_plan(const Store& store, const catalog::Catalog& catalog) {
  const Seed seed = layout_seed(store.plan.vary, Seed(store.manifest.seed));
  MARKETGEN_TRY(const layout::Repaired repaired, layout::repair_plan(store.plan, catalog, seed));
  if (io::write_json_line(repaired.plan) != io::write_json_line(store.plan)) return false;
  const Result<layout::Layout> plain = layout::make_layout(store.plan, catalog, seed);
  if (!plain.ok() && plain.error().code == "layout.impossible") return false;
  if (!plain.ok()) return plain.error();
  return scene::same_but_for_boards(*plain, store.scene.layout);
}

Result<Edited> edit_store(const Store& store,
                          const EditOptions& options,
                          const catalog::Catalog& catalog,
                          Progress& progress) {
  MARKETGEN_TRY(io::FolderDraft draft, io::FolderDraft::begin(options.folder));
  Stages stages(progress);
  MARKETGEN_TRY(const StoreReport report, report_before(store, catalog));
  MARKETGEN_TRY(EditedStore edited, edited_in(stages, store, report, options.step, catalog));
  MARKETGEN_TRY(Created created, saved_in(draft, stages, edited, options.previews, catalog));
  return Edited{std::move(created), std::move(edited.changes), std::move(edited.lost)};
}

std::filesystem::path next_edit_folder(const std::filesystem::path& store) {
  std::filesystem::path folder = store.lexically_normal();
  if (folder.filename().empty()) folder = folder.parent_path();  // "shop/"
  std::string name = folder.filename().string();
  const std::size_t mark = name.rfind("-edit-");
  int number = 1;
  if (mark != std::string::npos) {
    const std::string tail = name.substr(mark + 6);
    const bool digits = !tail.empty() && tail.size() < 7 &&
                        tail.find_first_not_of("0123456789") == std::string::npos;
    if (digits) {
      number = std::stoi(tail) + 1;
      name.resize(mark);
    }
  }
  std::error_code failed;
  for (;; ++number) {
    std::filesystem::path next = folder.parent_path() / fmt::format("{}-edit-{}", name, number);
    if (!std::filesystem::exists(next, failed)) return next;
  }
}

}  // namespace marketgen::store
