#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <numbers>

#include "base/text.h"
#include "catalog/standing_box.h"
#include "geometry/box_tree.h"
#include "plan/floor_places.h"
#include "plan/shelf_key.h"
#include "plan/validation.h"

namespace marketgen::plan {
namespace {

constexpr std::array<std::string_view, 7> override_fields = {
    "levels", "height_mm", "color", "material", "kind", "x_mm", "y_mm"};

std::vector<std::string_view> places_of(const Plan& plan) {
  std::vector<std::string_view> places(fixed_places.begin(), fixed_places.end());
  for (const Zone& zone : plan.zones) {
    places.push_back(zone.id);
    places.push_back(zone.type);
  }
  for (const Opening& opening : plan.shell.openings) {
    places.push_back(opening.id);
    places.push_back(name_of(opening.kind));
  }
  std::ranges::sort(places);
  const auto repeated = std::ranges::unique(places);
  places.erase(repeated.begin(), repeated.end());
  return places;
}

Result<void> check_place(const PlanCheck& check,
                         const std::vector<std::string_view>& places,
                         const std::string& name,
                         const std::string& pointer) {
  if (std::ranges::binary_search(places, name)) return {};
  return catalog::unknown_name(
      "plan.unknown_reference", check.at(pointer), "zone, opening or wall", name, places);
}

Result<void> check_relations(const PlanCheck& check) {
  const std::vector<std::string_view> places = places_of(check.plan);
  for (std::size_t i = 0; i < check.plan.relations.size(); ++i) {
    const Relation& relation = check.plan.relations[i];
    const auto at = [&](std::string_view field) { return element_pointer("relations", i, field); };
    MARKETGEN_CHECK(check_place(check, places, relation.a, at("a")));
    MARKETGEN_CHECK(check_place(check, places, relation.b, at("b")));
    if (relation.c) MARKETGEN_CHECK(check_place(check, places, *relation.c, at("c")));
    if (relation.c.has_value() == (relation.kind == RelationKind::between)) continue;
    return Error{"plan.bad_value",
                 check.at(at("c")),
                 "c is the second reference of `between`, and of no other relation"};
  }
  return {};
}

Result<void> check_whole_number(const PlanCheck& check,
                                const std::string& text,
                                const std::string& pointer) {
  int number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault == std::errc{} && end == text.data() + text.size() && number > 0) return {};
  return Error{
      "plan.bad_value", check.at(pointer), "\"" + text + "\" is not a positive whole number"};
}

Result<void> check_override_value(const PlanCheck& check, std::size_t i) {
  const Override& change = check.plan.overrides[i];
  const std::string pointer = element_pointer("overrides", i, "value");
  if (change.field_name == "color") return check_color(change.value, check.at(pointer));
  if (change.field_name == "material") {
    return check_name(check.catalog.materials,
                      &catalog::MaterialRow::id,
                      "material",
                      change.value,
                      check.at(pointer));
  }
  if (change.field_name == "kind") {
    return check_name(check.catalog.fixture_kinds,
                      &catalog::FixtureKind::kind,
                      "fixture kind",
                      change.value,
                      check.at(pointer));
  }
  return check_whole_number(check, change.value, pointer);
}

Result<void> check_overrides(const PlanCheck& check) {
  for (std::size_t i = 0; i < check.plan.overrides.size(); ++i) {
    const Override& change = check.plan.overrides[i];
    if (std::ranges::find(override_fields, change.field_name) == override_fields.end()) {
      return catalog::unknown_name("plan.unknown_reference",
                                   check.at(element_pointer("overrides", i, "field")),
                                   "field",
                                   change.field_name,
                                   {override_fields.begin(), override_fields.end()});
    }
    MARKETGEN_CHECK(check_override_value(check, i));
  }
  return {};
}

Error unknown_sku(const PlanCheck& check, const std::string& pointer, const std::string& sku) {
  std::vector<std::string_view> known;
  for (const catalog::Product& product : check.catalog.products)
    known.push_back(product.sku);
  return catalog::unknown_name("catalog.unknown_sku", check.at(pointer), "product", sku, known);
}

Result<void> check_placements(const PlanCheck& check) {
  const Shell& shell = check.plan.shell;
  for (std::size_t i = 0; i < check.plan.placements.size(); ++i) {
    const Placement& placement = check.plan.placements[i];
    if (check.catalog.product(placement.sku) == nullptr)
      return unknown_sku(check, element_pointer("placements", i, "sku"), placement.sku);
    const std::array<double, 3>& p = placement.position_m;
    const bool inside = p[0] >= 0 && p[0] <= shell.width_mm * 1e-3 && p[1] >= 0 &&
                        p[1] <= shell.depth_mm * 1e-3 && p[2] <= shell.ceiling_mm * 1e-3;
    if (inside) continue;
    return Error{"plan.bad_value",
                 check.at(element_pointer("placements", i, "position_m")),
                 "the product would stand outside the shop"};
  }
  return {};
}

Result<void> check_planogram(const PlanCheck& check) {
  if (!check.plan.planogram) return {};
  std::map<ShelfKey, std::size_t> places;
  for (std::size_t i = 0; i < check.plan.planogram->size(); ++i) {
    const StockedShelf& shelf = (*check.plan.planogram)[i];
    const auto [first, is_new] = places.emplace(key_of(shelf), i);
    if (!is_new)
      return Error{"plan.duplicate_id",
                   check.at(element_pointer("planogram", i, "shelf")),
                   "/planogram/" + std::to_string(first->second) +
                       " stocks that shelf, too; keep one of them"};
    for (std::size_t k = 0; k < shelf.blocks.size(); ++k) {
      const std::string& sku = shelf.blocks[k].sku;
      if (check.catalog.product(sku) != nullptr) continue;
      return unknown_sku(
          check, element_pointer("planogram", i, "blocks/" + std::to_string(k) + "/sku"), sku);
    }
  }
  return {};
}

std::vector<Bounds3> boxes_of(const PlanCheck& check) {
  std::vector<Bounds3> boxes;
  for (const Placement& placement : check.plan.placements) {
    const auto& [x, y, z] = placement.position_m;
    const Quaternion turn = rotation_about({0, 0, 1}, placement.yaw_deg * std::numbers::pi / 180);
    boxes.push_back(catalog::bounds_of(
        catalog::standing_box(*check.catalog.product(placement.sku), {x, y, z}, turn)));
  }
  return boxes;
}

// Products in one another are a fault that the audit measures pair by pair, and their pairs grow
// with the square of their number. Precondition: every product is known.
Result<void> check_crowding(const PlanCheck& check) {
  constexpr float deep_m = 0.001F;
  const std::vector<Bounds3> boxes = boxes_of(check);
  const BoxTree tree(boxes);
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    std::uint32_t other = i;
    tree.each_near(boxes[i], deep_m, [&](std::uint32_t k) {
      if (k >= i) return;
      other = k;
      ++pairs;
    });
    if (pairs <= max_crowded_pairs) continue;
    return Error{"plan.too_crowded",
                 check.at(element_pointer("placements", i, "position_m")),
                 "with this product, more than " +
                     with_thousands(static_cast<std::int64_t>(max_crowded_pairs)) +
                     " pairs of placed products stand in one another (it and /placements/" +
                     std::to_string(other) + " do); spread them out"};
  }
  return {};
}

}  // namespace

Result<void> check_references(const PlanCheck& check) {
  MARKETGEN_CHECK(check_relations(check));
  MARKETGEN_CHECK(check_overrides(check));
  MARKETGEN_CHECK(check_placements(check));
  MARKETGEN_CHECK(check_planogram(check));
  return check_crowding(check);
}

}  // namespace marketgen::plan
