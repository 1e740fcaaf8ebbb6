// A shop laid out by hand, one module a zone in a long hall, stocked from the committed rows: for
// tests that need build_scene but no planner and no layout.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "layout/layout.h"
#include "layout/module_spec.h"
#include "plan/plan.h"
#include "support/committed_catalog.h"

namespace marketgen {

// One module of `kind` with its row's own measures.
inline layout::Fixture module_of(const catalog::FixtureKind& kind,
                                 const std::string& zone,
                                 int x_mm,
                                 int number = 1) {
  layout::Fixture f = layout::lone_module(kind);
  f.run = zone + "/run-1";
  f.id = f.run + "/module-" + std::to_string(number);
  f.zone = zone;
  f.x_mm = x_mm;
  f.y_mm = 5000;
  return f;
}

struct HandLaidShop {
  plan::Plan plan;
  layout::Layout layout;
};

// Zones of the given types side by side, each with one module of `kind`, or of the type's own kind
// when that is empty.
inline HandLaidShop shop_of(const std::vector<std::string>& types, const std::string& kind = "") {
  HandLaidShop shop;
  layout::Layout& layout = shop.layout;
  layout.name = "Hand made";
  layout.profile = "supermarket-eu";
  layout.shell.width_mm = 60000;
  layout.shell.depth_mm = 10000;
  layout.shell.outline_mm = PolygonMm{{0, 0}, {60000, 0}, {60000, 10000}, {0, 10000}};
  int x_mm = 2000;
  for (const std::string& type : types) {
    const catalog::Catalog& catalog = committed_catalog();
    const catalog::FixtureKind* row =
        catalog.fixture_kind(kind.empty() ? catalog.zone_type(type)->fixture : kind);
    layout.zones.push_back(
        {type,
         type,
         type,
         {{x_mm - 1500, 3000}, {x_mm + 1500, 3000}, {x_mm + 1500, 7000}, {x_mm - 1500, 7000}},
         12});
    layout.fixtures.push_back(module_of(*row, type, x_mm));
    plan::Zone zone;
    zone.id = zone.type = type;
    shop.plan.zones.push_back(zone);
    x_mm += 3500;
  }
  std::sort(layout.fixtures.begin(),
            layout.fixtures.end(),
            [](const layout::Fixture& a, const layout::Fixture& b) { return a.id < b.id; });
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
