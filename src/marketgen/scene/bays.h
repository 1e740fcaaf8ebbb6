// The bays of a store, and which goods stand in each.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/seed.h"
#include "catalog/catalog.h"
#include "plan/plan.h"
#include "scene/planogram.h"
#include "scene/scene.h"
#include "scene/zone_range.h"

namespace marketgen::scene {

// One side of one module, with its shelves from the lowest up.
struct BayRef {
  std::string zone, run;
  int side = 0;
  int along = 0;  // place along the run, left to right for a shopper
  std::uint32_t fixture = 0;
  std::vector<std::uint32_t> shelves;  // rows of scene.shelves
  Bay bay;
  std::vector<PlannedShelf> plan;
  std::vector<std::uint32_t> certain;  // rows of catalog.products that stand here for certain
};

// The plan's zone of that id; one as usual where the plan has none.
const plan::Zone& zone_or_usual(const plan::Plan& plan, std::string_view id);

// In the order in which shoppers meet them: zone by zone, run by run.
std::vector<BayRef> bays_of(const Scene& scene);

// What stands in which bay, by fixture id and side.
using BayRanges = std::map<std::pair<std::string, int>, BayRange>;

// Plans every bay; one that has a range has goods of that and no others. Slices of the assortment
// run on from bay to bay, separately for each zone and temperature. The user's own products, and
// what zones must stock, come into bays that sell and hold them where no slice has them
// (scene/own_goods.h); without such goods nothing is other than it was.
void plan_bays(std::vector<BayRef>& bays,
               const Scene& scene,
               const plan::Plan& plan,
               const catalog::Catalog& catalog,
               Seed seed,
               const BayRanges& ranges = {});

// What a zone sells on fixtures of one temperature, and how far its bays have come in it.
struct Stock {
  std::vector<std::uint32_t> assortment;  // rows of catalog.products
  std::vector<bool> sells;                // by row of catalog.products
  AssortmentCursor cursor;
};

class Stocks {
 public:
  Stocks(const Scene& scene, const plan::Plan& plan, const catalog::Catalog& catalog)
      : scene_(scene), plan_(plan), catalog_(catalog) {}

  Stock& of(const BayRef& bay);
  const plan::Zone& zone_of(const BayRef& bay) const;
  catalog::Storage temperature_of(const BayRef& bay) const;

 private:
  const Scene& scene_;
  const plan::Plan& plan_;
  const catalog::Catalog& catalog_;
  std::map<std::pair<std::string, catalog::Storage>, Stock> stocks_;
};

}  // namespace marketgen::scene
