// The price tags of shelf edges: what they say, and what is wrong with them.
#pragma once
#include <array>
#include <string_view>

#include "base/seed.h"
#include "catalog/product.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace marketgen::scene {

// The price as tags say it, in cents.
std::uint32_t price_cents(const catalog::Product& product);

// The tag of a block from x_m, metres from the shelf's left end, width_m wide: its place and size.
PriceLabel tag_before_block(std::uint32_t shelf, double x_m, double width_m);

// The tag's product as the tag says it: with the price that is printed there.
catalog::Product product_on_tag(const Scene& scene, const PriceLabel& label);

enum class TagFault { none, wrong_price, wrong_product };
constexpr std::array<std::string_view, 3> names_of(TagFault) {
  return {"none", "wrong_price", "wrong_product"};
}

// By the facing that the tag hangs at.
TagFault fault_of(const Scene& scene, const PriceLabel& label);

// Takes tags away, and makes others wrong or hangs an outdated one beside them, by
// stock.price_tags of each zone. `label.facing` stays the facing that the tag hangs at. Each tag
// has a stream of its own, by fixture, shelf and facing.
void fault_price_tags(Scene& scene, const plan::Plan& plan, Seed seed);

}  // namespace marketgen::scene
