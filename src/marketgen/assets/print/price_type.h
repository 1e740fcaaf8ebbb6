// Prices in type, as tags and cards of the shelf edge show them.
#pragma once
#include <string>

#include "assets/print/canvas.h"
#include "catalog/product.h"

namespace marketgen::assets {

// Large euros with raised cents and the sign below them.
void draw_price(Canvas& canvas, double price, const Area& area, const Color& color);
// What draw_price() shows, in one line: "2.38 €".
std::string price_text(double price);
// "€ 2.38 / kg" (directive 98/6/EC asks for the unit price on every tag).
std::string unit_price_text(const catalog::Product& product);
// "Brand Name" and "variant, net quantity".
std::string title_text(const catalog::Product& product);
std::string detail_text(const catalog::Product& product);

}  // namespace marketgen::assets
