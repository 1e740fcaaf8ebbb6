// What a product is to physics while it stands still in a store: one solid round the whole pack.
// That a bottle has a neck matters to nobody until somebody comes near; what moves is a GoodsBody.
#pragma once
#include "physics/goods/contact_shape.h"

namespace marketgen::physics {

struct StandingGoods {
  assets::ContactShape shape;  // product_from_shape
  GoodsContact contact{};
  double mass_kg = 0;
  double stands_share = 0;   // of its weight: a lesser push sideways neither slides nor tips it
  bool may_be_soft = false;  // see may_be_soft_pack()
};

// Errors: catalog.bad_row for a product without mass or size; those of collision_of.
Result<StandingGoods> standing_goods(const catalog::Product& product);

}  // namespace marketgen::physics
