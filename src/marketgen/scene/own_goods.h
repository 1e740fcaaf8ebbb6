// Products of the user's own catalogue (Catalog::own): each stands on a shelf wherever one sells
// and holds it, and of every other it is said why not.
#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "base/fields.h"
#include "scene/bays.h"

namespace marketgen::scene {

// Gives out bays to own products, in rounds: bays are planned again after each.
class OwnGoods {
 public:
  OwnGoods(const catalog::Catalog& catalog, Stocks& stocks);

  // Puts every own product that no bay has into the `certain` of one that sells and holds it and
  // has not been tried: of those for offers last, else of those with the fewest others of his.
  // False when there was nothing to do.
  bool give_out(std::vector<BayRef>& bays);
  // Whether the last round gave the bay another product.
  bool changed(std::size_t bay) const { return changed_.contains(bay); }

 private:
  std::size_t best_bay(const std::vector<BayRef>& bays, std::size_t own) const;
  bool stands(std::vector<BayRef>& bays, std::uint32_t row) const;
  double room_left_m(const BayRef& bay) const;

  const catalog::Catalog& catalog_;
  Stocks& stocks_;
  std::vector<std::uint32_t> rows_;           // of catalog.products
  std::vector<std::set<std::size_t>> tried_;  // by own product: bays
  std::vector<double> left_m_;                // by bay: width that no product of his was promised
  std::set<std::size_t> changed_;
};

// One of the user's own products that stands nowhere.
struct Unstocked {
  std::string sku, why;
  static constexpr auto fields =
      field_list(field("sku", &Unstocked::sku, "SKU of a product of the user's own"),
                 field("why", &Unstocked::why, "what it did not fit"));
};

// By SKU.
std::vector<Unstocked> unstocked_products(const Scene& scene,
                                          const plan::Plan& plan,
                                          const catalog::Catalog& catalog);

}  // namespace marketgen::scene
