// Prices in type, as tags and cards of the shelf edge show them.
#pragma once
#include <string>

#include "assets/print/canvas.h"
#include "catalog/product.h"

namespace marketgen::assets {

// The product's price: large whole units with raised small coins, and the sign before them or
// below the coins, as the country has it. catalog::price_text() says the same in one line.
void draw_price(Canvas& canvas,
                const catalog::Product& product,
                const Area& area,
                const Color& color);
// "Brand Name" and "variant, net quantity".
std::string title_text(const catalog::Product& product);
std::string detail_text(const catalog::Product& product);

}  // namespace marketgen::assets
