#include "policy/shelf_finds.h"

#include <algorithm>
#include <cmath>

namespace marketgen::policy {
namespace {

constexpr double worth_off_per_m = 0.02;  // of a find's score, off the category's place
constexpr double about_as_good = 0.04;    // of worths: the nearer one is taken
constexpr double same_find_m = 0.04;

}  // namespace

std::optional<double> ShelfFinds::remember(const ShelfFind& find, Vec2 hint) {
  const Vec3 at = find.store_from_product.position;
  const auto is_same = [&](const ShelfFind& other) {
    return other.goal == find.goal && length(other.store_from_product.position - at) < same_find_m;
  };
  if (std::ranges::any_of(refused_, is_same)) return std::nullopt;
  const double worth = find.score - worth_off_per_m * distance({at.x, at.y}, hint);
  const auto known = std::ranges::find_if(finds_, is_same, &KnownFind::place);
  if (known == finds_.end())
    finds_.push_back({find, worth});
  else if (find.score > known->place.score)
    known->place = find, known->worth = worth;
  return worth;
}

std::optional<std::size_t> ShelfFinds::next(const std::vector<ShelfGoal>& goals,
                                            const robots::BasePlace& from,
                                            double min_worth) const {
  std::vector<double> best_of(goals.size(), min_worth);
  for (const KnownFind& find : finds_)
    best_of[find.place.goal] = std::max(best_of[find.place.goal], find.worth);
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t i = 0; i < finds_.size(); ++i) {
    const ShelfFind& find = finds_[i].place;
    const bool good = finds_[i].worth >= std::max(min_worth, best_of[find.goal] - about_as_good);
    if (!good || !goals[find.goal].is_due()) continue;
    const Vec3 at = find.store_from_product.position;
    const double off = distance({at.x, at.y}, {from.x_m, from.y_m});
    if (best && off >= least) continue;
    best = i;
    least = off;
  }
  return best;
}

void ShelfFinds::refuse(std::size_t number) {
  refused_.push_back(finds_[number].place);
  finds_.erase(finds_.begin() + static_cast<std::ptrdiff_t>(number));
}

}  // namespace marketgen::policy
