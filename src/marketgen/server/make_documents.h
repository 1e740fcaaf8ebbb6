// What a page that makes stores sends and is told: docs/viewer.md, "Making stores".
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "layout/layout.h"
#include "server/store_summary.h"
#include "store/store.h"

namespace marketgen::server {

constexpr int max_tried_stores = 6;  // of one brief; each is kept in memory

// A picture or a drawing that somebody dropped on the page.
struct DroppedFile {
  std::string name, base64;
  static constexpr auto fields =
      field_list(field("name",
                       &DroppedFile::name,
                       "of the file; its ending says what it is",
                       required(),
                       at_most_bytes(100)),
                 field("base64", &DroppedFile::base64, "its bytes", required()));
};

// try: the words are those of `marketgen generate`, and so are the flags.
struct TryAsk {
  std::string words, size, profile, style, floor_plan_scale, country, time, skin, planner;
  std::optional<DroppedFile> floor_plan;
  std::vector<DroppedFile> images, catalogs;
  std::vector<std::string> vary;
  std::uint64_t seed = 1;
  int count = 1;
  static constexpr auto fields = field_list(
      field("words", &TryAsk::words, "what the store should be", at_most_bytes(20000)),
      field("size", &TryAsk::size, "of the room, \"24x15m\"", at_most_bytes(100)),
      field("profile", &TryAsk::profile, "kind of shop", at_most_bytes(100)),
      field("style", &TryAsk::style, "look", at_most_bytes(100)),
      field("floor_plan", &TryAsk::floor_plan, "SVG, DXF, PNG or JPEG of the room"),
      field("floor_plan_scale", &TryAsk::floor_plan_scale, "\"1 px = 2 cm\"", at_most_bytes(100)),
      field("images",
            &TryAsk::images,
            "photos of shops, or one drawing of zones with names on them",
            at_most_items(4)),
      field("country", &TryAsk::country, "whose money price tags have", at_most_bytes(100)),
      field("time", &TryAsk::time, "that the shelves show, \"Sat 17:30\"", at_most_bytes(100)),
      field("vary", &TryAsk::vary, "\"fill=3\": an axis' own seed", at_most_items(10)),
      field("skin", &TryAsk::skin, "a style's materials, colours and light", at_most_bytes(100)),
      field(
          "planner", &TryAsk::planner, "one of those offered; empty: offline", at_most_bytes(200)),
      field("catalogs", &TryAsk::catalogs, "own products: CSV or JSON", at_most_items(4)),
      field("seed", &TryAsk::seed, "of the first store"),
      field(
          "count", &TryAsk::count, "stores, each with the next seed", range(1, max_tried_stores)));
};

// keep
struct KeepAsk {
  int batch = 0;
  std::uint64_t seed = 0;
  std::string name;
  static constexpr auto fields = field_list(
      field("batch", &KeepAsk::batch, "number of the brief", required()),
      field("seed", &KeepAsk::seed, "of the store that is kept", required()),
      field("name", &KeepAsk::name, "of its new folder", required(), at_most_bytes(100)));
};

struct KeptStore {
  int store = 0;
  std::string folder, scene_hash;
  static constexpr auto fields =
      field_list(field("store", &KeptStore::store, "its number in addresses"),
                 field("folder", &KeptStore::folder, "last part of its folder's path"),
                 field("scene_hash", &KeptStore::scene_hash, "over SKU, geometry and pose"));
};

// What may be asked for: what GET /api/make answers.
struct MakeOptions {
  std::string folder;
  int max_count = max_tried_stores;
  std::vector<std::string> profiles, styles, countries, vary, planners;
  static constexpr auto fields =
      field_list(field("folder", &MakeOptions::folder, "in which stores are kept"),
                 field("max_count", &MakeOptions::max_count, "stores of one brief"),
                 field("profiles", &MakeOptions::profiles, "kinds of shops"),
                 field("styles", &MakeOptions::styles, "looks"),
                 field("countries", &MakeOptions::countries, "whose money there is"),
                 field("vary", &MakeOptions::vary, "axes that may have a seed of their own"),
                 field("planners", &MakeOptions::planners, "who may plan, offline first"));
};

enum class TryState { waiting, working, ready, failed };
constexpr std::array<std::string_view, 4> names_of(TryState) {
  return {"waiting", "working", "ready", "failed"};
}

struct SaidError {
  std::string code, where, message;
  static constexpr auto fields = field_list(field("code", &SaidError::code, "error code"),
                                            field("where", &SaidError::where, "what it is about"),
                                            field("message", &SaidError::message, "for a person"));
};

// A fixture seen from above, east and north of the floor's south-west corner.
struct TriedFixture {
  std::string zone;
  std::array<int, 4> rect_mm{};
  static constexpr auto fields =
      field_list(field("zone", &TriedFixture::zone, "zone id"),
                 field("rect_mm", &TriedFixture::rect_mm, "x0, y0, x1, y1"));
};

// A store that was made: what a person compares.
struct TriedStore {
  std::string name, save_as, scene_hash;
  scene::SceneCounts counts;
  store::StoreReport report;
  PolygonMm outline_mm;
  std::vector<ViewOpening> openings;
  std::vector<layout::LayoutZone> zones;
  std::vector<TriedFixture> fixtures;
  static constexpr auto fields =
      field_list(field("name", &TriedStore::name, "its name"),
                 field("save_as", &TriedStore::save_as, "a name for its folder that is free"),
                 field("scene_hash", &TriedStore::scene_hash, "over SKU, geometry and pose"),
                 field("counts", &TriedStore::counts, "how much there is"),
                 field("report", &TriedStore::report, "market-report/1"),
                 field("outline_mm", &TriedStore::outline_mm, "of the floor"),
                 field("openings", &TriedStore::openings, "doors and windows"),
                 field("zones", &TriedStore::zones, "zones"),
                 field("fixtures", &TriedStore::fixtures, "one row a module"));
};

struct TryLine {
  std::uint64_t seed = 0;
  TryState state = TryState::waiting;
  std::optional<SaidError> error;
  std::optional<TriedStore> store;
  static constexpr auto fields =
      field_list(field("seed", &TryLine::seed, "with which it is made"),
                 field("state", &TryLine::state, "waiting, working, ready, failed"),
                 field("error", &TryLine::error, "why it failed"),
                 field("store", &TryLine::store, "once it is ready"));
};

// What GET /api/make/tries answers.
struct TriesState {
  int batch = 0;
  bool working = false;
  std::vector<std::string> warnings;
  std::optional<SaidError> error;
  std::vector<TryLine> tries;
  static constexpr auto fields =
      field_list(field("batch", &TriesState::batch, "number of the brief; 0: there was none"),
                 field("working", &TriesState::working, "stores of it are still to come"),
                 field("warnings", &TriesState::warnings, "of what was read of pictures"),
                 field("error", &TriesState::error, "why none of them can be made"),
                 field("tries", &TriesState::tries, "by seed"));
};

}  // namespace marketgen::server
