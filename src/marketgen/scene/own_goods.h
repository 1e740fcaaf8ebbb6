// Products of the user's own catalogue (Catalog::own): each stands on a shelf wherever one sells
// and holds it, and of every other it is said why not. So does one product of each of the words
// that a zone must stock (StockSpec::must_stock), in that zone.
#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/fields.h"
#include "scene/bays.h"

namespace marketgen::scene {

// Gives out bays to goods that must stand somewhere, in rounds: bays are planned again after each.
class OwnGoods {
 public:
  OwnGoods(const plan::Plan& plan, const catalog::Catalog& catalog, Stocks& stocks);

  // Whether anything must stand somewhere.
  bool empty() const { return wanted_.empty(); }
  // Puts all of them that no bay has into the `certain` of one that sells and holds it and
  // has not been tried: of those for offers last, else of those with the fewest others of them.
  // False when there was nothing to do.
  bool give_out(std::vector<BayRef>& bays);
  // Whether the last round gave the bay another product.
  bool changed(std::size_t bay) const { return changed_.contains(bay); }

 private:
  // One of these products must stand, in the zone that is named.
  struct Wanted {
    std::vector<std::uint32_t> rows;  // of catalog.products, those that are liked best first
    std::string zone;                 // id; "" for any
    std::set<std::pair<std::uint32_t, std::size_t>> tried;  // product and bay
  };

  std::size_t best_bay(const std::vector<BayRef>& bays,
                       const Wanted& wanted,
                       std::uint32_t row) const;
  bool stands(std::vector<BayRef>& bays, const Wanted& wanted) const;
  void put_somewhere(std::vector<BayRef>& bays, Wanted& wanted);
  double room_left_m(const BayRef& bay) const;

  const catalog::Catalog& catalog_;
  Stocks& stocks_;
  std::vector<Wanted> wanted_;
  std::vector<double> left_m_;  // by bay: width that none of them was promised
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
