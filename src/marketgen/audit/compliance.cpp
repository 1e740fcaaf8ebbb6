#include "audit/compliance.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "catalog/country.h"
#include "scene/placements.h"
#include "scene/price_tags.h"
#include "scene/shelf_fill.h"

namespace marketgen::audit {
namespace {

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 1 : static_cast<double>(part) / static_cast<double>(whole);
}

// A pack as it stands on its shelf: its middle from the shelf's left end and front edge.
struct Standing {
  double x_m = 0, y_m = 0;
  const catalog::Product* product = nullptr;
};
using StandingByShelf = std::map<std::uint32_t, std::vector<Standing>>;

StandingByShelf standing_on(const scene::Scene& scene, const std::set<std::uint32_t>& shelves) {
  StandingByShelf standing;
  std::map<std::uint32_t, Pose> shelf_from_world;
  for (const std::uint32_t shelf : shelves)
    shelf_from_world[shelf] = inverse(scene::world_from_shelf(scene, shelf));
  for (const scene::SceneProduct& item : scene.products) {
    if (item.facing == scene::no_facing) continue;
    const std::uint32_t shelf = scene.facings[item.facing].shelf;
    const auto frame = shelf_from_world.find(shelf);
    if (frame == shelf_from_world.end()) continue;
    const Vec3 at = frame->second * scene::world_from_product(item).position;
    standing[shelf].push_back(
        {at.x + scene.shelves[shelf].width_m / 2.0, at.y, &scene.catalog[item.sku]});
  }
  return standing;
}

struct Span {
  double from_m = 0, to_m = 0;
  bool holds(double x_m) const { return x_m >= from_m && x_m < to_m; }
};

std::vector<Standing> within(const std::vector<Standing>& packs, const Span& span) {
  std::vector<Standing> found;
  std::ranges::copy_if(
      packs, std::back_inserter(found), [&](const Standing& p) { return span.holds(p.x_m); });
  return found;
}

// The packs at the foremost place and those on them.
std::vector<Standing> front_stack(const std::vector<Standing>& packs) {
  double front_m = std::numeric_limits<double>::infinity();
  for (const Standing& pack : packs)
    front_m = std::min(front_m, pack.y_m);
  std::vector<Standing> stack;
  std::ranges::copy_if(packs, std::back_inserter(stack), [&](const Standing& p) {
    return p.y_m < front_m + p.product->depth_m() / 2;
  });
  return stack;
}

class ComplianceCount {
 public:
  ComplianceCount(const scene::Scene& scene,
                  const scene::PlanogramFile& planogram,
                  const catalog::Catalog& catalog)
      : scene_(scene), planogram_(planogram), catalog_(catalog) {
    std::set<std::uint32_t> shelves;
    for (const scene::PlanogramShelf& shelf : planogram.shelves) {
      shelves.insert(shelf.shelf);
      for (const scene::PlanogramBlock& block : shelf.blocks)
        planned_.insert(catalog.products[block.product].sku);
    }
    standing_ = standing_on(scene, shelves);
    for (const scene::PriceLabel& tag : scene.price_labels)
      tags_[tag.shelf].push_back(&tag);
  }

  Compliance count() {
    for (const scene::PlanogramShelf& shelf : planogram_.shelves)
      add_shelf(shelf);
    for (const auto& [category, counts] : categories_)
      sum_.categories.push_back({category, share(counts.met, counts.planned), counts});
    sum_.score = share(sum_.facings.met, sum_.facings.planned);
    sum_.tag_score = share(sum_.tags.right, sum_.tags.planned);
    return std::move(sum_);
  }

 private:
  void add_shelf(const scene::PlanogramShelf& shelf) {
    const std::vector<double> starts =
        scene::block_starts(shelf.planned, shelf.place.room, catalog_);
    ShelfCompliance row{shelf.fixture, shelf.side, shelf.number, 1, {}, 0};
    std::vector<Span> spans;
    for (std::size_t i = 0; i < shelf.blocks.size(); ++i) {
      spans.push_back({starts[i], starts[i] + scene::block_width_m(shelf.planned[i], catalog_)});
      add_block(shelf, shelf.blocks[i], spans.back(), row.facings);
      if (scene_.shelves[shelf.shelf].price_rail != 0)
        add_tag(shelf, catalog_.products[shelf.blocks[i].product], spans.back());
    }
    for (const Standing& pack : standing_[shelf.shelf]) {
      const auto there = [&](const Span& span) { return span.holds(pack.x_m); };
      row.extra += std::ranges::none_of(spans, there) ? 1 : 0;
    }
    row.score = share(row.facings.met, row.facings.planned);
    sum_.extra += row.extra;
    sum_.shelves.push_back(std::move(row));
  }

  void add_block(const scene::PlanogramShelf& shelf,
                 const scene::PlanogramBlock& block,
                 const Span& span,
                 FacingCounts& counts) {
    const catalog::Product& product = catalog_.products[block.product];
    const std::vector<Standing> packs = within(standing_[shelf.shelf], span);
    UnmetFacing place{block.line,
                      shelf.fixture,
                      shelf.side,
                      shelf.number,
                      static_cast<int>(&block - shelf.blocks.data()) + 1,
                      1,
                      product.sku,
                      FacingFault::missing,
                      {}};
    const auto facings = static_cast<std::uint64_t>(block.facings);
    if (scene::lies_in_a_heap(product)) {
      add_facings(place, facings, product, seen_in_heap(packs, product), counts);
      return;
    }
    const double pitch_m = (span.to_m - span.from_m) / block.facings;
    for (int i = 0; i < block.facings; ++i) {
      const double left_m = span.from_m + i * pitch_m;
      place.column = i + 1;
      const std::vector<Standing> front = front_stack(within(packs, {left_m, left_m + pitch_m}));
      add_facings(place, 1, product, seen_in_front(front, product), counts);
    }
  }

  // The stranger that is seen in front, or else the planned product, or nothing.
  static std::string seen_in_front(const std::vector<Standing>& front,
                                   const catalog::Product& planned) {
    for (const Standing& pack : front) {
      if (pack.product->sku != planned.sku) return pack.product->sku;
    }
    return front.empty() ? std::string() : planned.sku;
  }
  static std::string seen_in_heap(const std::vector<Standing>& pieces,
                                  const catalog::Product& planned) {
    for (const Standing& piece : pieces) {
      if (piece.product->sku == planned.sku) return planned.sku;
    }
    return pieces.empty() ? std::string() : pieces.front().product->sku;
  }

  void add_facings(UnmetFacing place,
                   std::uint64_t facings,
                   const catalog::Product& product,
                   std::string seen,
                   FacingCounts& shelf) {
    const bool met = seen == product.sku;
    if (!seen.empty() && !met)
      place.fault = planned_.contains(seen) ? FacingFault::misplaced : FacingFault::wrong_product;
    for (FacingCounts* counts : {&shelf, &categories_[product.category], &sum_.facings}) {
      counts->planned += facings;
      (met ? counts->met : fault_count(*counts, place.fault)) += facings;
    }
    place.stands = std::move(seen);
    if (!met) sum_.unmet.push_back(std::move(place));
  }

  static std::uint64_t& fault_count(FacingCounts& counts, FacingFault fault) {
    if (fault == FacingFault::missing) return counts.missing;
    return fault == FacingFault::misplaced ? counts.misplaced : counts.wrong_product;
  }

  void add_tag(const scene::PlanogramShelf& shelf,
               const catalog::Product& product,
               const Span& span) {
    int right = 0, of_product = 0, all = 0;
    for (const scene::PriceLabel* tag : tags_[shelf.shelf]) {
      if (!span.holds(tag->x_m)) continue;
      ++all;
      if (scene_.catalog[tag->sku].sku != product.sku) continue;
      ++of_product;
      right += tag->price_cents == scene::price_cents(product) ? 1 : 0;
    }
    TagCounts& counts = sum_.tags;
    ++counts.planned;
    if (all == 0)
      ++counts.missing;
    else if (right > 0)
      ++(all == 1 ? counts.right : counts.doubled);
    else
      ++(of_product > 0 ? counts.wrong_price : counts.wrong_product);
  }

  const scene::Scene& scene_;
  const scene::PlanogramFile& planogram_;
  const catalog::Catalog& catalog_;
  std::set<std::string> planned_;
  StandingByShelf standing_;
  std::map<std::uint32_t, std::vector<const scene::PriceLabel*>> tags_;
  std::map<std::string, FacingCounts> categories_;
  Compliance sum_;
};

}  // namespace

Compliance compliance_of(const scene::Scene& scene,
                         const scene::PlanogramFile& planogram,
                         const catalog::Catalog& catalog) {
  const catalog::LocalCatalog local(
      catalog, scene.catalog.empty() ? std::nullopt : scene.catalog.front().country);
  return ComplianceCount(scene, planogram, local.get()).count();
}

}  // namespace marketgen::audit
