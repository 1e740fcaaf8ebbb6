// A product with what judges and oracles need of it.
#pragma once
#include <memory>
#include <vector>

#include "catalog/rows.h"
#include "physics/goods/goods_body.h"

namespace marketgen::episodes {

struct EpisodeGoods {
  physics::SharedGoodsBody made;  // of GoodsUse::bulk
  const catalog::Product& product;
  const assets::ProductBody& body;
  std::vector<Vec3> volume;   // points spread evenly through it, product frame
  double pad_friction = 0.5;  // of rubber on it
};

// Made once in a process: cutting packs into convex pieces takes longer than all the rest of a
// reset. Thread-safe. Errors: assets.*, catalog.bad_row.
using SharedEpisodeGoods = std::shared_ptr<const EpisodeGoods>;
Result<SharedEpisodeGoods> episode_goods(const catalog::Product& product,
                                         const std::vector<catalog::FrictionRow>& frictions);

}  // namespace marketgen::episodes
