#include "audit/scene_rules.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "catalog/zone_goods.h"
#include "scene/planogram.h"
#include "scene/price_tags.h"

namespace marketgen::audit {

layout::Violation violation_of(const SceneRule& rule,
                               std::string where,
                               double value,
                               std::string message) {
  return {std::string(rule.code),
          rule.severity,
          std::move(where),
          value,
          rule.limit,
          std::move(message),
          std::nullopt};
}

std::vector<layout::Violation> check_ITEM_COLLISION(const SceneFacts& facts,
                                                    const SceneRule& rule) {
  const CollisionCount& found = facts.collisions;
  if (!found.deepest) return {};
  const auto [first, second] = found.deepest->items;
  return {violation_of(rule,
                       scene::product_id(facts.scene, first),
                       static_cast<double>(found.colliding_pairs),
                       fmt::format("{} pairs of items are more than 1 mm inside one another; the "
                                   "deepest is it and {}, by {:.2f} mm",
                                   found.colliding_pairs,
                                   scene::product_id(facts.scene, second),
                                   1000 * found.deepest->depth_m))};
}

std::vector<layout::Violation> check_ITEM_OUTSIDE_SHELF(const SceneFacts& facts,
                                                        const SceneRule& rule) {
  if (facts.out_of_place.empty()) return {};
  return {violation_of(
      rule,
      scene::product_id(facts.scene, facts.out_of_place.front()),
      static_cast<double>(facts.out_of_place.size()),
      fmt::format("{} items reach out of their shelf or the room", facts.out_of_place.size()))};
}

std::vector<layout::Violation> check_SHELF_EMPTY(const SceneFacts& facts, const SceneRule& rule) {
  if (facts.scene.shelves.empty()) return {};
  std::vector<std::uint8_t> stocked(facts.scene.shelves.size(), 0);
  for (const scene::Facing& f : facts.scene.facings)
    stocked[f.shelf] = 1;
  const auto empty = std::count(stocked.begin(), stocked.end(), 0);
  const double share = static_cast<double>(empty) / static_cast<double>(stocked.size());
  if (share <= rule.limit) return {};
  const auto first =
      static_cast<std::size_t>(std::find(stocked.begin(), stocked.end(), 0) - stocked.begin());
  return {violation_of(
      rule,
      facts.scene.layout.fixtures[facts.scene.shelves[first].fixture].id,
      share,
      fmt::format("{} of {} shelves hold nothing that the zone sells", empty, stocked.size()))};
}

std::vector<layout::Violation> check_LOAD_HEAVY_HIGH(const SceneFacts& facts,
                                                     const SceneRule& rule) {
  std::uint64_t number = 0;
  std::string where;
  for (std::uint32_t i = 0; i < facts.scene.products.size(); ++i) {
    const scene::SceneProduct& item = facts.scene.products[i];
    const double mass_kg = facts.scene.catalog[item.sku].mass_kg;
    if (item.position_m[2] < scene::highest_rest_m(mass_kg)) continue;
    if (number++ == 0) where = scene::product_id(facts.scene, i);
  }
  if (number == 0) return {};
  return {violation_of(
      rule,
      where,
      static_cast<double>(number),
      fmt::format("{} items of {} kg and more stand above {} m, or of more than {} kg above {} m",
                  number,
                  scene::stretch_kg,
                  rule.limit,
                  scene::heavy_lift_kg,
                  scene::heavy_board_m))};
}

std::vector<layout::Violation> check_STORAGE_WRONG(const SceneFacts& facts, const SceneRule& rule) {
  std::size_t number = 0;
  std::string where;
  for (const scene::Facing& f : facts.scene.facings) {
    const layout::Fixture& fixture =
        facts.scene.layout.fixtures[facts.scene.shelves[f.shelf].fixture];
    const catalog::FixtureKind* kind = facts.catalog.fixture_kind(fixture.kind);
    if (f.product_count == 0 || kind == nullptr ||
        catalog::keeps(kind->temperature, facts.scene.catalog[f.sku].storage))
      continue;
    if (number++ == 0) where = scene::product_id(facts.scene, f.first_product);
  }
  if (number == 0) return {};
  return {violation_of(
      rule,
      where,
      static_cast<double>(number),
      fmt::format("{} facings of chilled or frozen goods stand where they are not kept cold",
                  number))};
}

std::vector<layout::Violation> check_PRICE_MISSING(const SceneFacts& facts, const SceneRule& rule) {
  std::vector<std::uint8_t> priced(facts.scene.facings.size(), 0);
  for (const scene::PriceLabel& label : facts.scene.price_labels)
    if (scene::fault_of(facts.scene, label) == scene::TagFault::none) priced[label.facing] = 1;
  std::size_t number = 0;
  std::string where;
  for (std::size_t i = 0; i < priced.size(); ++i) {
    const scene::Facing& f = facts.scene.facings[i];
    if (priced[i] != 0 || facts.scene.shelves[f.shelf].price_rail == 0) continue;
    if (number++ == 0) where = facts.scene.layout.fixtures[facts.scene.shelves[f.shelf].fixture].id;
  }
  if (number == 0) return {};
  return {violation_of(
      rule,
      where,
      static_cast<double>(number),
      fmt::format("{} facings do not have their price on the edge of their shelf", number))};
}

std::vector<layout::Violation> check_DENSITY_LOW(const SceneFacts& facts, const SceneRule& rule) {
  if (facts.metrics.DENS >= rule.limit) return {};
  return {violation_of(
      rule,
      "store",
      facts.metrics.DENS,
      fmt::format("{:.0f} items per m2 of selling area; real shops have {:.0f} and more",
                  facts.metrics.DENS,
                  rule.limit))};
}

std::vector<layout::Violation> check_SHELF_UNREACHABLE(const SceneFacts& facts,
                                                       const SceneRule& rule) {
  if (facts.traffic.unreachable.empty()) return {};
  const scene::SceneShelf& shelf = facts.scene.shelves[facts.traffic.unreachable.front()];
  return {violation_of(rule,
                       facts.scene.layout.fixtures[shelf.fixture].id,
                       static_cast<double>(facts.traffic.unreachable.size()),
                       fmt::format("a robot finds no free floor before {} shelves",
                                   facts.traffic.unreachable.size()))};
}

const std::vector<SceneRule>& scene_rules() {
  static const std::vector<SceneRule> rules = {
#define SCENE_RULE(code, severity, limit, source, remedy) \
  {#code, layout::Severity::severity, limit, source, remedy, check_##code},
#include "audit/scene_rules.inc"
#undef SCENE_RULE
  };
  return rules;
}

std::string_view remedy_of(std::string_view code) {
  const auto rule = std::ranges::find(scene_rules(), code, &SceneRule::code);
  return rule != scene_rules().end() ? rule->remedy : std::string_view();
}

std::vector<layout::Violation> check_scene(const SceneFacts& facts) {
  std::vector<layout::Violation> found;
  for (const SceneRule& rule : scene_rules()) {
    for (layout::Violation& v : rule.check(facts, rule))
      found.push_back(std::move(v));
  }
  return found;
}

}  // namespace marketgen::audit
