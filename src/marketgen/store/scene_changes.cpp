#include "store/scene_changes.h"

#include <array>
#include <bit>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/json.h"
#include "scene/placements.h"

namespace marketgen::store {
namespace {

// A thing with an id, by what it is called, where it stands and what it is. The scene has its
// texts.
template <class Shape>
struct Thing {
  std::string id;
  std::string_view zone;  // "" for products that the plan places
  std::string_view what;  // of another kind it is another thing
  Shape shape;            // how it stands
};
template <class Shape>
using Things = std::vector<Thing<Shape>>;
// The bits of a product's position, rotation and flags.
using ProductShape = std::array<std::uint32_t, 8>;

Things<std::string> zones_of(const scene::Scene& scene) {
  Things<std::string> things;
  for (const layout::LayoutZone& zone : scene.layout.zones)
    things.push_back({zone.id, zone.id, zone.type, io::write_json_line(zone)});
  return things;
}

Things<std::string> fixtures_of(const scene::Scene& scene) {
  Things<std::string> things;
  for (const layout::Fixture& fixture : scene.layout.fixtures) {
    layout::Fixture bare = fixture;
    bare.material.clear();
    bare.color.clear();
    things.push_back({fixture.id, fixture.zone, fixture.kind, io::write_json_line(bare)});
  }
  return things;
}

ProductShape shape_of(const scene::SceneProduct& item) {
  ProductShape shape{};
  std::size_t at = 0;
  for (const float value : item.position_m)
    shape[at++] = std::bit_cast<std::uint32_t>(value);
  for (const float value : item.rotation_wxyz)
    shape[at++] = std::bit_cast<std::uint32_t>(value);
  shape[at] = item.flags;
  return shape;
}

Things<ProductShape> products_of(const scene::Scene& scene) {
  Things<ProductShape> things;
  things.reserve(scene.products.size());
  for (std::uint32_t i = 0; i < scene.products.size(); ++i) {
    const scene::SceneProduct& item = scene.products[i];
    Thing<ProductShape> thing{
        scene::product_id(scene, i), {}, scene.catalog[item.sku].sku, shape_of(item)};
    if (item.facing != scene::no_facing) {
      const scene::SceneShelf& shelf = scene.shelves[scene.facings[item.facing].shelf];
      thing.zone = scene.layout.fixtures[shelf.fixture].zone;
    }
    things.push_back(std::move(thing));
  }
  return things;
}

template <class Shape>
ChangeCount compare(const Things<Shape>& before,
                    const Things<Shape>& after,
                    std::set<std::string>& touched) {
  std::unordered_map<std::string_view, std::size_t> rows;
  rows.reserve(before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    rows.emplace(before[i].id, i);
  ChangeCount count;
  std::set<std::string_view> zones;
  std::vector<bool> goes_on(before.size(), false);
  for (const Thing<Shape>& thing : after) {
    const auto row = rows.find(thing.id);
    const bool is_new = row == rows.end() || before[row->second].what != thing.what;
    if (!is_new) goes_on[row->second] = true;
    if (!is_new && before[row->second].shape == thing.shape) {
      ++count.kept;
      continue;
    }
    ++(is_new ? count.added : count.moved);
    zones.insert(thing.zone);
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (goes_on[i]) continue;
    ++count.gone;
    zones.insert(before[i].zone);
  }
  touched.insert(zones.begin(), zones.end());
  return count;
}

}  // namespace

SceneChanges changes_between(const scene::Scene& before, const scene::Scene& after) {
  SceneChanges changes;
  std::set<std::string> floors;  // a sign over a zone is not what stands in it
  changes.zones = compare(zones_of(before), zones_of(after), floors);
  changes.fixtures = compare(fixtures_of(before), fixtures_of(after), changes.zones_touched);
  changes.products = compare(products_of(before), products_of(after), changes.zones_touched);
  return changes;
}

}  // namespace marketgen::store
