// Draws the episodes of a track from stores, whatever the track.
#pragma once
#include <memory>
#include <vector>

#include "base/seed.h"
#include "catalog/product.h"
#include "episodes/episode_journal.h"
#include "episodes/episode_origin.h"
#include "episodes/goal_chance.h"

namespace marketgen::environments {

// From one store. Any number of threads may draw at once.
class StoreSampler {
 public:
  virtual ~StoreSampler() = default;
  // Episode `index` of a seed, which depends on these only. Errors: episode.impossible with what
  // was missing; those of the track's world.
  virtual Result<episodes::EpisodeSpec> sample(Seed seed, int index) = 0;
  // Rows of what its episodes may be about.
  virtual const std::vector<catalog::Product>& products() const = 0;
  // What of the store's offer no task asks for, as far as it is known by now.
  virtual episodes::EpisodeExclusions exclusions() const = 0;
  // Whether a task may ask for a product of the store's offer. Errors: of trying its grasps.
  virtual Result<episodes::GoalChance> goal_chance(const catalog::Product& product) = 0;
  // Products that were looked at while episodes were drawn; and more, which another process looked
  // at while it drew from the same store. Only tracks that find out while they draw have any.
  virtual std::vector<episodes::ConsideredProduct> considered() const { return {}; }
  virtual void consider(const std::vector<episodes::ConsideredProduct>&) {}
};

// What the samplers of all stores share.
class EpisodeSampler {
 public:
  virtual ~EpisodeSampler() = default;
  // A store that the arena has, which must outlive it. Errors: those of Arena::scene;
  // episode.impossible when nothing can be asked for in it.
  virtual Result<std::unique_ptr<StoreSampler>> of_store(const episodes::EpisodeOrigin& origin) = 0;
  // Keeps on disk what was found out while drawing, so that it need not be found out again.
  virtual Result<void> keep() { return {}; }
};

}  // namespace marketgen::environments
