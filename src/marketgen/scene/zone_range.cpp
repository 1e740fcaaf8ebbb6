#include "scene/zone_range.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string_view>
#include <utility>

#include "scene/shelf_shares.h"

namespace marketgen::scene {
namespace {

// A product has up to so many times the front that it is usually given, where its kind has few
// others.
constexpr double max_stretch = 4;
// Of what a shop would choose by demand alone, its buyer thinks between half and one and a half.
constexpr double min_taste = 0.5, max_taste = 1.5;
// Up to the first, goods have the zone's fewest facings; from so much more on, its most.
constexpr double medium_liked = 0.8, much_liked = 4;
// From here on a pack is bulk, which boards have less of than it is asked for.
constexpr double bulk_kg = 4, bulk_on_boards = 0.4, bulk_in_small_shops = 0.05;
// A heap of loose goods is no narrower, and has no fewer pieces across, but for what is long.
constexpr double min_heap_m = 0.36, min_heap_of_long_m = 0.6;
constexpr int min_heap_pieces = 3;
constexpr double max_heap_m = 1.2;

struct Ranged {
  std::size_t place = 0;  // in the assortment
  double liked = 0;       // asked for, by the buyer's taste
  double front_m = 0;
};

struct Kind {
  double share = 0;
  std::vector<Ranged> goods;  // in the assortment's order
  double usual_m = 0;         // front of all of them as usual
  double front_m = 0;         // what it is given
};

class ZoneRange {
 public:
  ZoneRange(const std::vector<const Bay*>& bays,
            const RangeWish& wish,
            const catalog::Catalog& catalog,
            Seed seed)
      : bays_(bays),
        wish_(wish),
        catalog_(catalog),
        draw_(seed.stream()),
        heaps_(std::ranges::any_of(bays, [](const Bay* bay) {
          return bay->shelves.front().use == assets::ShelfUse::heap;
        })) {
    collect_kinds();
  }

  // All goods in the assortment's order, their fronts summing up to `front_m` or to less where
  // there are too few of them.
  std::vector<Ranged> share_out(double front_m) {
    give_fronts(front_m);
    std::vector<Ranged> all;
    for (Kind& kind : kinds_) {
      choose(kind);
      all.insert(all.end(), kind.goods.begin(), kind.goods.end());
    }
    return all;
  }

 private:
  const catalog::Product& product(std::size_t place) const {
    return catalog_.products[wish_.assortment[place]];
  }

  bool is_certain(std::size_t place) const {
    return wish_.certain.contains(wish_.assortment[place]);
  }

  bool some_bay_holds(const catalog::Product& product) const {
    return std::ranges::any_of(bays_, [&](const Bay* bay) {
      return std::ranges::any_of(bay->shelves,
                                 [&](const ShelfRoom& room) { return fits(product, room); });
    });
  }

  // From the zone's fewest facings for what is hardly asked for to its most.
  double usual_front_m(const catalog::Product& product, double liked) const {
    if (heaps_) return std::clamp(0.25 * liked, min_heap_front_m(product), max_heap_m);
    const double pitch_m = facing_pitch_m(product);
    const int fewest = wish_.stock.facings[0];
    const int most = std::max(fewest, wish_.stock.facings[1]);
    const double share = std::clamp((liked - medium_liked) / much_liked, 0.0, 1.0);
    return pitch_m * (fewest + static_cast<int>(std::lround(share * (most - fewest))));
  }

  // Crates and other bulk stand on pallets rather than on boards, and in small shops hardly at all.
  double share_of_bulk(const catalog::Product& product) const {
    if (heaps_ || product.mass_kg < bulk_kg) return 1;
    return wish_.small_shop ? bulk_in_small_shops : bulk_on_boards;
  }

  void collect_kinds() {
    std::map<std::pair<std::string_view, std::string_view>, std::size_t> known;
    std::map<std::pair<std::string_view, std::string_view>, int> namesakes;
    for (const std::uint32_t row : wish_.assortment)
      ++namesakes[{catalog_.products[row].subcategory, catalog_.products[row].name}];
    for (std::size_t place = 0; place < wish_.assortment.size(); ++place) {
      const catalog::Product& p = product(place);
      const double taste = draw_.uniform(min_taste, max_taste);
      if (!some_bay_holds(p)) continue;
      const auto [entry, is_new] = known.try_emplace({p.category, p.subcategory}, kinds_.size());
      if (is_new) kinds_.push_back({shelf_share_of(p, wish_.small_shop), {}, 0, 0});
      Kind& kind = kinds_[entry->second];
      const double among = heaps_ ? std::sqrt(namesakes[{p.subcategory, p.name}]) : 1;
      const double liked = asked_for(p) * taste / among * share_of_bulk(p);
      kind.goods.push_back({place, liked, usual_front_m(p, liked)});
      kind.usual_m += kind.goods.back().front_m;
    }
  }

  // By share; what a kind has too few goods for goes to the others.
  void give_fronts(double front_m) {
    std::vector<Kind*> open;
    for (Kind& kind : kinds_)
      open.push_back(&kind);
    while (!open.empty()) {
      double shares = 0;
      for (const Kind* kind : open)
        shares += kind->share;
      const auto full = std::ranges::find_if(open, [&](const Kind* kind) {
        return front_m * kind->share / shares > max_stretch * kind->usual_m;
      });
      if (full == open.end()) {
        for (Kind* kind : open)
          kind->front_m = front_m * kind->share / shares;
        return;
      }
      (*full)->front_m = max_stretch * (*full)->usual_m;
      front_m -= (*full)->front_m;
      open.erase(full);
    }
  }

  // What is liked most, until the kind's front is taken; all of them then share it.
  void choose(Kind& kind) const {
    std::vector<Ranged> by_liking = kind.goods;
    std::ranges::stable_sort(by_liking, {}, [&](const Ranged& goods) {
      return std::pair(!is_certain(goods.place), -goods.liked);
    });
    double taken_m = 0;
    std::size_t count = 0;
    while (count < by_liking.size() && (count == 0 || is_certain(by_liking[count].place) ||
                                        taken_m + by_liking[count].front_m / 2 < kind.front_m))
      taken_m += by_liking[count++].front_m;
    by_liking.resize(count);
    std::ranges::sort(by_liking, {}, &Ranged::place);
    for (Ranged& goods : by_liking)
      goods.front_m *= kind.front_m / taken_m;
    kind.goods = std::move(by_liking);
  }

  const std::vector<const Bay*>& bays_;
  const RangeWish& wish_;
  const catalog::Catalog& catalog_;
  Stream draw_;
  bool heaps_ = false;
  std::vector<Kind> kinds_;
};

// Less of a product is no reason to stand in one bay more.
double min_front_m(const catalog::Product& product, const Bay& bay) {
  return bay.shelves.front().use == assets::ShelfUse::heap ? min_heap_front_m(product)
                                                           : facing_pitch_m(product) / 2;
}

}  // namespace

double min_heap_front_m(const catalog::Product& product) {
  return std::clamp(min_heap_pieces * facing_pitch_m(product), min_heap_m, min_heap_of_long_m);
}

std::vector<BayRange> ranges_of(const std::vector<const Bay*>& bays,
                                const std::vector<double>& fronts_m,
                                const RangeWish& wish,
                                const catalog::Catalog& catalog,
                                Seed seed) {
  std::vector<BayRange> ranges(bays.size());
  if (bays.empty() || wish.assortment.empty()) return ranges;
  const double front_m = std::accumulate(fronts_m.begin(), fronts_m.end(), 0.0);
  const std::vector<Ranged> all = ZoneRange(bays, wish, catalog, seed).share_out(front_m);
  double shared_m = 0;
  for (const Ranged& goods : all)
    shared_m += goods.front_m;
  std::size_t bay = 0;
  double left_m = fronts_m[0];
  for (const Ranged& goods : all) {
    const std::uint32_t row = wish.assortment[goods.place];
    const double min_m = min_front_m(catalog.products[row], *bays[bay]);
    double rest_m = goods.front_m * front_m / shared_m;  // no bay is left without
    while (bay + 1 < bays.size() && rest_m > left_m + min_m) {
      if (left_m >= min_m) {
        ranges[bay].push_back({row, left_m});
        rest_m -= left_m;
      }
      left_m = fronts_m[++bay] + std::min(0.0, left_m);
    }
    ranges[bay].push_back({row, rest_m});
    left_m -= rest_m;
  }
  return ranges;
}

}  // namespace marketgen::scene
