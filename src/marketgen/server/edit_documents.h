// What a page that edits a store is told (what it sends: web/edit_asks.h): docs/viewer.md,
// "Editing".
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "intake/brief.h"
#include "layout/layout.h"
#include "plan/bsp.h"
#include "plan/patch.h"
#include "scene/scene.h"
#include "server/store_summary.h"
#include "store/edit.h"
#include "store/edit_words.h"

namespace marketgen::server {

// Whether anyone edits: what GET answers.
struct EditorStatus {
  bool taken = false;
  int revision = 0;
  static constexpr auto fields =
      field_list(field("taken", &EditorStatus::taken, "a page edits the store"),
                 field("revision", &EditorStatus::revision, "counts the changes; 0 = as opened"));
};

// One step of the edit, done or undone.
struct EditLine {
  std::string words;
  std::vector<plan::Patch> patches;
  store::SceneChanges changes;
  std::vector<std::string> lost;
  static constexpr auto fields = field_list(
      field("words", &EditLine::words, "as they were said; empty when patches were given"),
      field("patches", &EditLine::patches, "what was done"),
      field("changes", &EditLine::changes, "what differs from the step before"),
      field("lost", &EditLine::lost, "wishes of the prompt that it no longer meets"));
};

// A cut of the floor: what a page draws a handle for.
struct EditCut {
  std::string node;
  plan::Axis split = plan::Axis::x;
  double ratio = plan::default_split_ratio;
  int gap_mm = 0;
  std::array<int, 4> rect_mm{};
  static constexpr auto fields = field_list(
      field("node", &EditCut::node, "inner node of the plan"),
      field("split", &EditCut::split, "y: first child south, x: first child west"),
      field("ratio", &EditCut::ratio, "first child's share after the gap is taken off"),
      field("gap_mm", &EditCut::gap_mm, "between the children"),
      field("rect_mm", &EditCut::rect_mm, "floor of the node: west, south, east, north"));
};

// A run of shelves: what a page lets move.
struct EditRun {
  std::string id, zone, fixture;
  std::array<int, 2> at_mm{};
  std::array<int, 4> rect_mm{};
  bool pinned = false;
  static constexpr auto fields =
      field_list(field("id", &EditRun::id, "the line"),
                 field("zone", &EditRun::zone, "its zone"),
                 field("fixture", &EditRun::fixture, "one of its modules: pin its x_mm and y_mm"),
                 field("at_mm", &EditRun::at_mm, "where that module's middle is"),
                 field("rect_mm", &EditRun::rect_mm, "its floor: west, south, east, north"),
                 field("pinned", &EditRun::pinned, "the plan says its place"));
};

// What a page lets change of a zone.
struct EditZone {
  std::string id, type, label, kind;
  std::optional<int> levels, aisle_mm;  // as the plan says; absent: as usual
  int usual_levels = 0;
  std::array<int, 2> level_range{};
  double fill = 0;
  IntRange facings{};
  std::uint64_t fixtures = 0, products = 0;
  static constexpr auto fields =
      field_list(field("id", &EditZone::id, "zone"),
                 field("type", &EditZone::type, "zone type"),
                 field("label", &EditZone::label, "sign over it"),
                 field("kind", &EditZone::kind, "fixture kind"),
                 field("levels", &EditZone::levels, "stocked levels; absent = as usual"),
                 field("usual_levels", &EditZone::usual_levels, "of the kind"),
                 field("level_range", &EditZone::level_range, "fewest and most of the kind"),
                 field("fill", &EditZone::fill, "occupied share of the shelf front"),
                 field("facings", &EditZone::facings, "fewest and most facings of one SKU"),
                 field("aisle_mm", &EditZone::aisle_mm, "between runs; absent = as usual"),
                 field("fixtures", &EditZone::fixtures, "modules in it"),
                 field("products", &EditZone::products, "items in it"));
};

// The head of edit.bin beside the picture's tables.
struct EditState {
  std::string token;
  int revision = 0;
  std::vector<EditLine> lines;  // the oldest first
  std::uint64_t done = 0;       // of the lines; the others can be done again
  scene::SceneCounts counts;
  std::vector<layout::LayoutZone> floors;
  std::vector<layout::Aisle> aisles;
  std::vector<layout::Violation> violations;
  std::vector<ViewFixture> fixtures;
  std::vector<ViewSku> new_skus;            // that the opened store does not have
  std::vector<std::uint32_t> new_sku_rows;  // their rows below /edit/skus/
  std::vector<EditCut> cuts;
  std::vector<EditRun> runs;
  std::vector<plan::Override> places;
  std::vector<EditZone> zones;
  std::vector<std::string> kinds;
  std::vector<std::string> unparsed, so_already;
  std::vector<intake::Conflict> given_up;
  std::string save_as;
  static constexpr auto fields = field_list(
      field("token", &EditState::token, "of who edits"),
      field("revision", &EditState::revision, "counts the changes; 0 = as opened"),
      field("lines", &EditState::lines, "steps, the oldest first"),
      field("done", &EditState::done, "of the lines; those after can be done again"),
      field("counts", &EditState::counts, "how much there is"),
      field("floors", &EditState::floors, "zones with their floor"),
      field("aisles", &EditState::aisles, "aisles"),
      field("violations", &EditState::violations, "broken rules"),
      field("fixtures", &EditState::fixtures, "one row a module"),
      field("new_skus", &EditState::new_skus, "SKUs that the opened store does not have"),
      field("new_sku_rows", &EditState::new_sku_rows, "their rows in edit/skus"),
      field("cuts", &EditState::cuts, "cuts of the floor"),
      field("runs", &EditState::runs, "runs that can be moved"),
      field("places", &EditState::places, "pinned places, as overrides of the plan"),
      field("zones", &EditState::zones, "zones with what can be changed"),
      field("kinds", &EditState::kinds, "fixture kinds with shelves"),
      field("unparsed", &EditState::unparsed, "words that were not understood"),
      field("so_already", &EditState::so_already, "wishes that were met as it was"),
      field("given_up", &EditState::given_up, "words that others stood against"),
      field("save_as", &EditState::save_as, "a folder's name that is free"));
};

// A fixture's footprint.
struct EditFootprint {
  std::string run;
  std::array<int, 4> rect_mm{};
  static constexpr auto fields =
      field_list(field("run", &EditFootprint::run, "the line it stands in"),
                 field("rect_mm", &EditFootprint::rect_mm, "west, south, east, north"));
};

// preview
struct EditPreview {
  std::vector<layout::LayoutZone> zones;
  std::vector<layout::Violation> offences, violations;
  std::vector<EditFootprint> fixtures;
  static constexpr auto fields =
      field_list(field("zones", &EditPreview::zones, "floors after the patches"),
                 field("offences", &EditPreview::offences, "hard rules that would newly be broken"),
                 field("violations", &EditPreview::violations, "all broken rules"),
                 field("fixtures", &EditPreview::fixtures, "where modules would stand"));
};

struct EditSaved {
  std::string folder, scene_hash;
  int store = 0;
  bool follows_from_plan = false;
  std::uint64_t seed = 0;
  static constexpr auto fields =
      field_list(field("folder", &EditSaved::folder, "name of the new folder"),
                 field("scene_hash", &EditSaved::scene_hash, "over SKU, geometry and pose"),
                 field("store", &EditSaved::store, "its number in addresses"),
                 field("follows_from_plan",
                       &EditSaved::follows_from_plan,
                       "generate --plan makes the same scene"),
                 field("seed", &EditSaved::seed, "that generate is to be given"));
};

}  // namespace marketgen::server
