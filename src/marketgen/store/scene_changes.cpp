#include "store/scene_changes.h"

#include <unordered_map>

#include "io/json.h"
#include "scene/placements.h"

namespace marketgen::store {
namespace {

// A thing with an id, by what it is called, where it stands and what it is.
struct Thing {
  std::string zone;   // "" for products that the plan places
  std::string what;   // of another kind it is another thing
  std::string shape;  // how it stands
};
using Things = std::unordered_map<std::string, Thing>;

Things zones_of(const scene::Scene& scene) {
  Things things;
  for (const layout::LayoutZone& zone : scene.layout.zones)
    things[zone.id] = {zone.id, zone.type, io::write_json_line(zone)};
  return things;
}

Things fixtures_of(const scene::Scene& scene) {
  Things things;
  for (layout::Fixture fixture : scene.layout.fixtures) {
    fixture.material.clear();
    fixture.color.clear();
    things[fixture.id] = {fixture.zone, fixture.kind, io::write_json_line(fixture)};
  }
  return things;
}

template <std::size_t Count>
void add_bits(std::string& bits, const std::array<float, Count>& values) {
  bits.append(reinterpret_cast<const char*>(values.data()), sizeof(values));
}

Things products_of(const scene::Scene& scene) {
  Things things;
  things.reserve(scene.products.size());
  for (std::uint32_t i = 0; i < scene.products.size(); ++i) {
    const scene::SceneProduct& item = scene.products[i];
    Thing thing;
    thing.what = scene.catalog[item.sku].sku;
    add_bits(thing.shape, item.position_m);
    add_bits(thing.shape, item.rotation_wxyz);
    thing.shape += std::to_string(item.flags);
    if (item.facing != scene::no_facing) {
      const scene::SceneShelf& shelf = scene.shelves[scene.facings[item.facing].shelf];
      thing.zone = scene.layout.fixtures[shelf.fixture].zone;
    }
    things[scene::product_id(scene, i)] = std::move(thing);
  }
  return things;
}

ChangeCount compare(const Things& before, const Things& after, std::set<std::string>& touched) {
  ChangeCount count;
  for (const auto& [id, thing] : after) {
    const auto old = before.find(id);
    const bool is_new = old == before.end() || old->second.what != thing.what;
    if (!is_new && old->second.shape == thing.shape) {
      ++count.kept;
      continue;
    }
    ++(is_new ? count.added : count.moved);
    touched.insert(thing.zone);
  }
  for (const auto& [id, thing] : before) {
    const auto now = after.find(id);
    if (now != after.end() && now->second.what == thing.what) continue;
    ++count.gone;
    touched.insert(thing.zone);
  }
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
