#include "server/editor.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "catalog/catalog.h"
#include "io/json.h"
#include "layout/accessories.h"
#include "layout/overrides.h"
#include "plan/bsp.h"
#include "server/answering.h"
#include "web/edit_asks.h"

namespace marketgen::server {
namespace {

template <class Document>
Result<Document> body_of(const web::HttpAsk& ask) {
  return io::read_json<Document>(ask.body, body_name);
}

Error taken_error() {
  return {"server.edit_taken",
          "token",
          "another page edits this store; it is shown as it was opened. Who edits ends it by "
          "closing his panel or page"};
}

std::vector<EditCut> cuts_of(const plan::Plan& plan) {
  std::vector<EditCut> cuts;
  for (const plan::NodeRect& placed : plan::node_rectangles(plan)) {
    const plan::Node& node = plan.nodes[placed.node];
    if (node.children.empty()) continue;
    const RectMm& r = placed.rect;
    cuts.push_back({node.id,
                    node.split.value_or(plan::Axis::y),
                    node.ratio.value_or(plan::default_split_ratio),
                    node.gap_mm.value_or(plan::default_gap_mm),
                    {r.x0, r.y0, r.x1, r.y1}});
  }
  return cuts;
}

std::vector<EditRun> runs_of(const layout::Layout& layout,
                             const std::vector<plan::Override>& places) {
  std::map<std::string, std::pair<EditRun, RectMm>> runs;
  for (const layout::Fixture& fixture : layout.fixtures) {
    if (layout::is_accessory(fixture) || !fixture.endcap_of.empty()) continue;
    const RectMm at = layout::footprint_of(fixture);
    EditRun run{fixture.run, fixture.zone, fixture.id, {fixture.x_mm, fixture.y_mm}, {}, false};
    const auto [known, is_new] = runs.try_emplace(fixture.run, std::move(run), at);
    RectMm& all = known->second.second;
    if (!is_new) all = bounds_of(all, at);
    if (std::ranges::find(places, fixture.id, &plan::Override::fixture) != places.end())
      known->second.first.pinned = true;
  }
  std::vector<EditRun> rows;
  for (auto& [id, run] : runs) {
    const RectMm& r = run.second;
    run.first.rect_mm = {r.x0, r.y0, r.x1, r.y1};
    rows.push_back(std::move(run.first));
  }
  return rows;
}

std::vector<EditZone> zones_of(const store::Store& store, const catalog::Catalog& catalog) {
  std::vector<EditZone> zones;
  for (const plan::Zone& zone : store.plan.zones) {
    EditZone row{zone.id,
                 zone.type,
                 zone.label,
                 zone.fixture.kind,
                 zone.fixture.levels,
                 zone.fixture.aisle_mm};
    row.fill = zone.stock.fill;
    row.facings = zone.stock.facings;
    if (const catalog::FixtureKind* kind = catalog.fixture_kind(zone.fixture.kind)) {
      row.usual_levels = kind->levels;
      row.level_range = kind->level_range;
    }
    zones.push_back(std::move(row));
  }
  const auto row_of = [&](std::uint32_t fixture) {
    return std::ranges::find(zones, store.scene.layout.fixtures[fixture].zone, &EditZone::id);
  };
  for (std::uint32_t i = 0; i < store.scene.fixtures.size(); ++i)
    if (const auto row = row_of(i); row != zones.end()) ++row->fixtures;
  for (const scene::Facing& facing : store.scene.facings) {
    const auto row = row_of(store.scene.shelves[facing.shelf].fixture);
    if (row != zones.end()) row->products += facing.product_count;
  }
  return zones;
}

std::vector<std::string> kinds_of(const catalog::Catalog& catalog) {
  std::vector<std::string> kinds;
  for (const catalog::FixtureKind& kind : catalog.fixture_kinds)
    if (kind.levels > 0) kinds.push_back(kind.kind);
  return kinds;
}

}  // namespace

bool is_refused_edit(const Error& error) {
  constexpr std::array<std::string_view, 8> of_the_edit{
      "layout.", "plan.", "planogram.", "brief.", "scene.", "catalog.", "assets.", "usage."};
  return std::ranges::any_of(
      of_the_edit, [&](std::string_view module) { return error.code.starts_with(module); });
}

Result<EditSession*> Editor::session() {
  const std::scoped_lock lock(mutex_);
  if (!session_) {
    MARKETGEN_TRY(session_, EditSession::open(base_, catalog_));
    delta_ = std::make_unique<DeltaBase>(base_->scene);
  }
  return session_.get();
}

EditSession::Now Editor::now() {
  const std::scoped_lock lock(mutex_);
  return session_ ? session_->snapshot().now : nullptr;
}

Result<void> Editor::require_lease(const std::string& token) {
  const std::scoped_lock lock(mutex_);
  if (!lease_.holds(token, web::EditLease::Clock::now())) return taken_error();
  return {};
}

Result<web::HttpReply> Editor::status() {
  const std::scoped_lock lock(mutex_);
  const EditorStatus status{lease_.is_taken(web::EditLease::Clock::now()),
                            session_ ? session_->snapshot().state.revision : 0};
  return web::json_reply(io::write_json_line(status));
}

// The head says what a person is told and can do, the tables what the picture becomes.
web::HttpReply Editor::picture(EditSnapshot at) const {
  const scene::Scene& scene = at.now->store.scene;
  EditState& state = at.state;
  PackedSections sections;
  state.new_sku_rows = delta_->describe(scene, sections);
  state.new_skus = skus_of(scene, state.new_sku_rows, grasps_, catalog_->frictions);
  state.counts = scene::count(scene);
  state.floors = scene.layout.zones;
  state.aisles = scene.layout.aisles;
  state.violations = at.now->report.rules;
  state.fixtures = fixtures_of(scene, *catalog_);
  state.cuts = cuts_of(at.now->store.plan);
  state.places = layout::pinned_places(at.now->store.plan);
  state.runs = runs_of(scene.layout, state.places);
  state.zones = zones_of(at.now->store, *catalog_);
  state.kinds = kinds_of(*catalog_);
  sections.note_members(io::write_json_line(state));
  return {.body = web::make_body("application/octet-stream", sections.file())};
}

Result<web::HttpReply> Editor::begin(const web::HttpAsk& ask) {
  MARKETGEN_TRY(const web::EditorAsk body, body_of<web::EditorAsk>(ask));
  std::optional<std::string> token;
  {
    const std::scoped_lock lock(mutex_);
    token = lease_.take(body.token, web::EditLease::Clock::now());
  }
  if (!token) return taken_error();
  MARKETGEN_TRY(const EditSession* now, session());
  EditSnapshot at = now->snapshot();
  at.state.token = *token;
  return picture(std::move(at));
}

Result<web::HttpReply> Editor::save(const web::HttpAsk& ask) {
  MARKETGEN_TRY(const web::SaveAsk body, body_of<web::SaveAsk>(ask));
  MARKETGEN_CHECK(require_lease(body.token));
  MARKETGEN_TRY(const EditSession* now, session());
  const EditSession::Now saved = now->snapshot().now;
  MARKETGEN_TRY(const std::filesystem::path folder, now->save(body.name, saved));
  EditSaved said;
  said.folder = folder.filename().string();
  said.scene_hash = saved->store.manifest.scene_hash;
  said.seed = saved->store.manifest.seed;
  MARKETGEN_TRY(said.follows_from_plan, store::follows_from_plan(saved->store, *catalog_));
  MARKETGEN_TRY(said.store, show_(folder));
  return web::json_reply(io::write_json_line(said));
}

Result<web::HttpReply> Editor::change(const std::string& verb, const web::HttpAsk& ask) {
  MARKETGEN_TRY(EditSession* const session, this->session());
  store::SaidPatches said;
  if (verb == "patches") {
    MARKETGEN_TRY(const web::PatchesAsk body, body_of<web::PatchesAsk>(ask));
    MARKETGEN_CHECK(require_lease(body.token));
    MARKETGEN_CHECK(session->apply(body.patches));
  } else if (verb == "say") {
    MARKETGEN_TRY(const web::WordsAsk body, body_of<web::WordsAsk>(ask));
    MARKETGEN_CHECK(require_lease(body.token));
    MARKETGEN_TRY(said, session->say(body.words));
  } else {
    MARKETGEN_TRY(const web::EditorAsk body, body_of<web::EditorAsk>(ask));
    MARKETGEN_CHECK(require_lease(body.token));
    MARKETGEN_CHECK(verb == "undo" ? session->undo() : session->redo());
  }
  EditSnapshot at = session->snapshot();
  for (const intake::UnparsedWord& word : said.unparsed)
    at.state.unparsed.push_back(word.text);
  at.state.so_already = std::move(said.so_already);
  at.state.given_up = std::move(said.conflicts);
  return picture(std::move(at));
}

Result<web::HttpReply> Editor::post(const std::string& verb, const web::HttpAsk& ask) {
  if (verb == "begin") return begin(ask);
  if (verb == "save") return save(ask);
  constexpr std::array<std::string_view, 4> changes{"patches", "say", "undo", "redo"};
  if (std::ranges::find(changes, verb) != changes.end()) return change(verb, ask);
  if (verb == "preview") {
    MARKETGEN_TRY(const web::PatchesAsk body, body_of<web::PatchesAsk>(ask));
    MARKETGEN_CHECK(require_lease(body.token));
    MARKETGEN_TRY(const EditSession* now, session());
    MARKETGEN_TRY(const EditPreview preview, now->preview(body.patches));
    return web::json_reply(io::write_json_line(preview));
  }
  if (verb != "beat" && verb != "end")
    return Error{
        "server.not_found", ask.path, "there is nothing at this address; see docs/viewer.md"};
  MARKETGEN_TRY(const web::EditorAsk body, body_of<web::EditorAsk>(ask));
  MARKETGEN_CHECK(require_lease(body.token));
  if (verb == "end") {
    const std::scoped_lock lock(mutex_);
    lease_.give_back(body.token);
  }
  return status();
}

}  // namespace marketgen::server
