// Which packs keep their shape in a hand although their row says soft: what a film is drawn or
// wound tightly round is as firm as what is in it.
#pragma once
#include <string_view>

#include "catalog/product.h"

namespace marketgen::catalog {

// Why a pack of a soft row keeps its shape, as in "a casing filled tight"; empty where it does not,
// and of rows that are not soft.
std::string_view firm_because(const Product& product);

// Whether it is squeezed out of its shape by a hand that holds it: soft, and not firm.
inline bool gives_way(const Product& product) {
  return product.rigidity == Rigidity::soft && firm_because(product).empty();
}

}  // namespace marketgen::catalog
