// Looks of products kept on disk between runs, so that the next run need not take their pictures
// again (a tenth of a second a product).
//
// Entries (io/cache_entry.h) lie under $MARKETGEN_CACHE/looks by content, some 50 KB each.
#pragma once
#include <optional>
#include <string>

#include "perception/product_look.h"

namespace marketgen::perception {

// Over everything that decides a look: a product's row as text, what decides its pictures
// (agent::KnownProducts::pictures_key), and the sources that make looks of pictures.
std::string look_key(const std::string& row, const std::string& pictures_key);

// Nothing when there is none under this key.
std::optional<ProductLook> kept_look(const std::string& key, const std::string& sku);
void keep_look(const std::string& key, const ProductLook& look);

}  // namespace marketgen::perception
