// Which goods of a store tasks in its aisles ask for, and why not for the others.
#include <algorithm>
#include <set>

#include "episodes/aisle/look_alikes_beside.h"
#include "episodes/aisle/sample_aisle.h"

namespace marketgen::episodes {

std::size_t AisleSampler::count_of(const Shapes& shapes) {
  std::size_t products = 0;
  for (const auto& [shape, of_shape] : shapes)
    products += of_shape.size();
  return products;
}

void AisleSampler::add_drawn_from() {
  const scene::Scene& scene = store_->scene;
  const std::set<std::string> alike = skus_with_look_alikes_beside(scene);
  std::set<std::uint32_t> seen;
  for (const scene::SceneProduct& product : scene.products) {
    if (!seen.insert(product.sku).second) continue;
    const catalog::Product& goods = scene.catalog[product.sku];
    if (!is_drawn_from(goods)) continue;
    shapes_[goods.archetype].push_back(&goods);
    (alike.contains(goods.sku) ? alike_ : unlike_)[goods.archetype].push_back(&goods);
  }
}

// A task with look-alikes has them of its first goal at least, one without of none, as far as the
// store has goods for that.
const AisleSampler::Shapes& AisleSampler::shapes_for_next(const EpisodeSpec& spec,
                                                          bool look_alikes) const {
  if (!look_alikes)
    return count_of(unlike_) > static_cast<std::size_t>(rules_.difficulty.goals.max) ? unlike_
                                                                                     : shapes_;
  return spec.goals.empty() && !alike_.empty() ? alike_ : shapes_;
}

bool AisleSampler::has_look_alike(const EpisodeSpec& spec) const {
  return std::ranges::any_of(spec.goals, [&](const EpisodeGoal& goal) {
    return std::ranges::any_of(alike_, [&](const auto& shape) {
      return std::ranges::find(shape.second, goal.sku, &catalog::Product::sku) !=
             shape.second.end();
    });
  });
}

// All that can be had of it from the front: whoever fetches it takes any.
bool AisleSampler::stands_on_levels(const std::string& sku) const {
  if (rules_.difficulty.levels.empty()) return true;
  return std::ranges::all_of(store_->front_items(sku), [&](std::uint32_t row) {
    return rules_.difficulty.has_level(store_->scene.products[row].position_m[2]);
  });
}

// In the front row of a shelf within reach; where a robot can stand before it; rigid; unseen.
bool AisleSampler::is_drawn_from(const catalog::Product& product) const {
  if (rules_.trained_on.has(product) || !stands_on_levels(product.sku)) return false;
  if (rules_.split == Split::all) return !store_->front_items(product.sku).empty();
  return (rules_.split == Split::paper || product.rigidity != catalog::Rigidity::soft) &&
         !store_->standing_places(product.sku).empty();
}

// What is_drawn_from misses: of where its items stand what came nearest to it.
std::string AisleSampler::why_not_drawn(const catalog::Product& product) const {
  if (rules_.trained_on.has(product)) return std::string(seen_in_training);
  if (!stands_on_levels(product.sku)) return "other_level";
  if (!store_->front_items(product.sku).empty())
    return store_->standing_places(product.sku).empty() ? "no_room_before" : "soft";
  ShelfRefusal nearest = ShelfRefusal::behind_another;
  for (const std::uint32_t row : store_->items_of(product.sku))
    nearest = std::max(nearest, store_->shelf_refusal(row));
  return std::string(name_of(nearest));
}

Result<GoalChance> AisleSampler::goal_chance(const catalog::Product& product) {
  if (!is_drawn_from(product)) return GoalChance{why_not_drawn(product)};
  MARKETGEN_TRY(const StudiedProduct studied, book_->study(product));
  if (!studied.why_not.empty()) return GoalChance{studied.why_not};
  const scene::Scene& scene = store_->scene;
  std::set<std::uint32_t> fixtures;
  for (const std::uint32_t row : store_->front_items(product.sku)) {
    if (!store_->standing_place(row)) continue;
    MARKETGEN_TRY(const OpenDoor door, doors_->before(row));
    if (door.why_not.empty())
      fixtures.insert(scene.shelves[scene.facings[scene.products[row].facing].shelf].fixture);
  }
  return GoalChance{fixtures.empty() ? std::string(door_stays_shut) : "", std::move(fixtures)};
}

}  // namespace marketgen::episodes
