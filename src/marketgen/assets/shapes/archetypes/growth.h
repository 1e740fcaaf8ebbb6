// What every grown or baked shape draws from: the row's own seed, its words, its placements.
#pragma once
#include <string_view>

#include "assets/shapes/archetypes/pack_builder.h"
#include "base/seed.h"
#include "catalog/product.h"

namespace marketgen::assets {

// Each SKU grows in its own way, and always in the same.
Seed growth_seed(const catalog::Product& product);

// Whether the product's name or variant contains one of `words`, parted by '|', in small letters.
// Empty words are in every name.
bool has_word(const catalog::Product& product, std::string_view words);

// From a body about Z, 0..length, to one that lies along X with its upper end at the left; what
// faced the front (-Y) faces up, +X points to the back.
Placement lying_along_x(float length);

// How a plant is built: about Z from root to leaves in shares of these sizes, then laid down.
struct PlantFrame {
  float across = 0, thick = 0, length = 0;  // along X, Y and Z while it is built, metres
  Placement place;
};
PlantFrame plant_frame(const PackBuilder& pack, bool lying);

// The side that faces the front while a plant is built: up, once it lies.
inline constexpr Vec3f plant_front{0, -1, 0};

// A point of the unit circle.
Vec2 draw_on_circle(Stream& draw);

}  // namespace marketgen::assets
