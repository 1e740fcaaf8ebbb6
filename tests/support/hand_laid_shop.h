// A shop laid out by hand, one module a zone in a long hall, stocked from the committed rows: for
// tests that need build_scene but no planner and no layout.
#pragma once
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "layout/layout.h"
#include "plan/plan.h"

namespace marketgen {

// The rows under data/, read once.
inline const Catalog& committed_catalog() {
  static const Catalog catalog = [] {
    auto loaded = load_catalog(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data");
    if (!loaded.ok()) fatal(to_string(loaded.error()).c_str());
    return std::move(loaded).value();
  }();
  return catalog;
}

// One module of `kind` with its row's own measures.
inline Fixture module_of(const FixtureKind& kind,
                         const std::string& zone,
                         int x_mm,
                         int number = 1) {
  Fixture f;
  f.run = zone + "/run-1";
  f.id = f.run + "/module-" + std::to_string(number);
  f.kind = kind.kind;
  f.zone = zone;
  f.x_mm = x_mm;
  f.y_mm = 5000;
  f.width_mm = kind.module_widths_mm.front();
  f.depth_mm = kind.depth_mm;
  f.height_mm = kind.height_mm;
  f.levels = kind.levels;
  f.base_mm = kind.base_mm;
  f.spacing_mm = kind.levels > 0 ? (kind.height_mm - kind.base_mm) / kind.levels : 0;
  f.sides = kind.double_sided ? 2 : 1;
  f.run_start = f.run_end = true;
  f.material = kind.material;
  f.color = kind.color;
  return f;
}

struct HandLaidShop {
  Plan plan;
  Layout layout;
};

// Zones of the given types side by side, each with one module of `kind`, or of the type's own kind
// when that is empty.
inline HandLaidShop shop_of(const std::vector<std::string>& types, const std::string& kind = "") {
  HandLaidShop shop;
  Layout& layout = shop.layout;
  layout.name = "Hand made";
  layout.profile = "supermarket-eu";
  layout.shell.width_mm = 60000;
  layout.shell.depth_mm = 10000;
  layout.shell.outline_mm = PolygonMm{{0, 0}, {60000, 0}, {60000, 10000}, {0, 10000}};
  int x_mm = 2000;
  for (const std::string& type : types) {
    const Catalog& catalog = committed_catalog();
    const FixtureKind* row =
        catalog.fixture_kind(kind.empty() ? catalog.zone_type(type)->fixture : kind);
    layout.zones.push_back(
        {type,
         type,
         type,
         {{x_mm - 1500, 3000}, {x_mm + 1500, 3000}, {x_mm + 1500, 7000}, {x_mm - 1500, 7000}},
         12});
    layout.fixtures.push_back(module_of(*row, type, x_mm));
    Zone zone;
    zone.id = zone.type = type;
    shop.plan.zones.push_back(zone);
    x_mm += 3500;
  }
  std::sort(layout.fixtures.begin(), layout.fixtures.end(), [](const Fixture& a, const Fixture& b) {
    return a.id < b.id;
  });
  shop.plan.shell = layout.shell;
  return shop;
}

// Every zone type that sells goods of its own.
inline const std::vector<std::string>& selling_types() {
  static const std::vector<std::string> types = {"produce",
                                                 "bakery",
                                                 "dairy",
                                                 "chilled",
                                                 "meat_fish",
                                                 "frozen",
                                                 "deli",
                                                 "dry_goods",
                                                 "canned",
                                                 "snacks",
                                                 "beverages",
                                                 "alcohol",
                                                 "household",
                                                 "personal_care"};
  return types;
}

}  // namespace marketgen
