// Which products a zone sells, in the order in which a shopper meets them.
#pragma once
#include <cstdint>
#include <vector>

#include "catalog/catalog.h"
#include "plan/plan.h"

namespace marketgen::scene {

// Rows of catalog.products for `zone` on fixtures that keep `temperature`, ordered by category,
// subcategory, brand, family and size (larger to the right). Goods may stand warmer than they need
// never, colder than they need only when chilled.
std::vector<std::uint32_t> assortment_of(const plan::Zone& zone,
                                         catalog::Storage temperature,
                                         const catalog::Catalog& catalog);

// True when the zone's lists have the product's category and subcategory: its own list, or else its
// type's. What its stock leaves out, and what its fixtures keep, is asked apart.
bool sells(const plan::Zone& zone,
           const catalog::Product& product,
           const catalog::Catalog& catalog);

// True when one of the words names the product: its name, variant, brand, subcategory, category or
// a keyword, or name and variant together ("basmati rice").
bool named_by(const catalog::Product& product, const std::vector<std::string>& words);

// Rows of catalog.products that `zone` sells and the word names best: the word is their name, or
// else its end (or that and the variant: "basmati rice"), or else in it, or else in their variant,
// or else a keyword, or else it names them otherwise. "ham" is cooked ham rather than crisps with
// the taste of it, and "olive oil" that rather than truffle oil, which is made with it.
std::vector<std::uint32_t> best_named(const plan::Zone& zone,
                                      const std::string& word,
                                      const catalog::Catalog& catalog);

}  // namespace marketgen::scene
