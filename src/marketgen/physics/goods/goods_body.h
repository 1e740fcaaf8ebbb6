// What a product is to physics while it can move: mass, centre of mass, inertia, friction and
// contact pieces. Every model that a product moves in is written from this value: into a
// specification by ProductBodies, into a running World by rigid_goods().
#pragma once
#include <array>
#include <memory>
#include <string_view>

#include "assets/product_model.h"
#include "physics/goods/contact_shape.h"

namespace marketgen::physics {

// Where it moves.
enum class GoodsUse {
  stocked,  // in a store: Worlds, settling of shelves, heaps, the MJCF file, grasps off a shelf
  single,   // by itself on a table, or in a hand over it
  bulk      // any way round among others in a basket or bin
};

// Which solids it meets others with, and why.
enum class GoodsForm {
  pieces,  // those of make_product_body(): a bottle has its neck
  // One ellipsoid of even density: loose round produce, whose heaps were poured so
  // (data/heaps.json).
  ball,
  // What follows is the one solid of collision_of(), by which stores are stocked, with the pack's
  // own centre of mass and inertia. Only in a store:
  produce,   // heaped by that solid: pieces would begin inside one another
  stacked,   // MuJoCo holds a hull under a stack by one contact, and of 1,111 stacks of two 203
             // fell; a box or cylinder it holds by several
  unsteady,  // its pieces' foot hardly bears it (cards on pegs, baguettes): it stands as it was put
  many_pieces,  // a mesh of one's own in more pieces than a body of a World's pool has geoms
};
constexpr std::array<std::string_view, 6> names_of(GoodsForm) {
  return {"pieces", "ball", "produce", "stacked", "unsteady", "many_pieces"};
}

struct GoodsBody {
  catalog::Product product;
  GoodsForm form = GoodsForm::pieces;
  assets::ProductBody body;  // what `form` makes of it; product frame
  GoodsContact contact{};
};
using SharedGoodsBody = std::shared_ptr<const GoodsBody>;

// Made once in a process (30 ms a row). Thread-safe. Errors: catalog.bad_row for a product without
// mass, size or contact pieces; those of make_product_body and collision_of.
Result<SharedGoodsBody> goods_body(const catalog::Product& product, GoodsUse use);

// Error catalog.bad_row: see there.
Result<void> check_has_body(const catalog::Product& product, const assets::ProductBody& body);

}  // namespace marketgen::physics
