#include "perception/target_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "base/progress.h"

namespace marketgen::perception {
namespace {

constexpr std::size_t patch_points = 160;
// Measured on 10 baskets: of 23 found rightly the lowest fit was 0.97 and the lowest score 0.51; of
// 4 found wrongly three had a fit of 0.94 and less.
constexpr double min_score = 0.4, min_fit = 0.92;
constexpr float same_size = 0.2F;  // of products that may be taken for one another
constexpr std::size_t max_rivals = 4;
constexpr std::size_t max_checked = 3;  // places, for products that may be meant instead
constexpr double clearly_better = 1.02;
constexpr std::size_t max_masks = 8;   // of a product, that are looked at closely
constexpr double same_place_m = 0.03;  // two products cannot have their middles nearer

constexpr int hues = 6, brightnesses = 4;
constexpr std::size_t bins = hues * hues * brightnesses;

// By the shares of red and green and by brightness: light changes the latter alone, and it counts
// coarsely.
std::size_t bin_of(Vec3f color) {
  const float sum = std::max(0.05F, color.x + color.y + color.z);
  const auto share = [&](float part) {
    // Shares of a third are grey; what is beyond 0.1..0.7 is rare.
    return static_cast<std::size_t>(
        std::clamp((part / sum - 0.1F) / 0.6F * hues, 0.0F, hues - 0.5F));
  };
  const auto bright =
      static_cast<std::size_t>(std::clamp(sum / 3 * brightnesses, 0.0F, brightnesses - 0.5F));
  return (share(color.x) * hues + share(color.y)) * brightnesses + bright;
}

using Histogram = std::array<float, bins>;

double shared(const Histogram& a, const Histogram& b) {
  float sum = 0;
  for (std::size_t i = 0; i < bins; ++i)
    sum += std::min(a[i], b[i]);
  return sum;
}

}  // namespace

double color_likeness(const std::vector<Vec3f>& colors, const ProductLook& look) {
  Histogram seen{}, known{};
  for (const Vec3f& color : colors)
    seen[bin_of(color)] += 1.0F / static_cast<float>(colors.size());
  for (const Surfel& surfel : look.surfels())
    known[bin_of(surfel.color)] += 1.0F / static_cast<float>(look.surfels().size());
  return shared(seen, known);
}

std::vector<FoundProduct> CatalogueMatching::places_of(
    std::size_t number,
    const WantedProduct& wanted,
    const std::vector<ViewCloud>& views,
    const std::vector<MaskedView>& masked) const {
  const ProductLook& look = *wanted.look;
  struct Candidate {
    double likeness;
    std::size_t view, mask;
    SurfacePatch patch;
  };
  std::vector<Candidate> candidates;
  for (const MaskedView& of_view : masked) {
    const ViewCloud& cloud = views[of_view.view];
    for (std::size_t m = 0; m < of_view.masks.size(); ++m) {
      SurfacePatch patch = patch_of(cloud, of_view.masks[m], patch_points);
      if (!is_of_size(patch, look)) continue;
      const double likeness = color_likeness(patch.colors, look);
      candidates.push_back({likeness, of_view.view, m, std::move(patch)});
    }
  }
  std::ranges::stable_sort(candidates, std::greater<>{}, &Candidate::likeness);
  std::vector<FoundProduct> places;
  for (std::size_t i = 0; i < std::min(max_masks, candidates.size()); ++i) {
    const FittedPose pose = poses_.pose(look, candidates[i].patch, views);
    log_debug(fmt::format("{} at a mask of view {}: likeness {:.2f}, score {:.2f}, fit {:.2f}",
                          look.sku(),
                          candidates[i].view,
                          candidates[i].likeness,
                          pose.evidence.score,
                          pose.evidence.fit));
    if (is_likely(look, pose))
      places.push_back({number, candidates[i].view, candidates[i].mask, pose});
  }
  std::ranges::stable_sort(
      places, std::greater<>{}, [](const FoundProduct& f) { return f.pose.evidence.score; });
  drop_mistaken(wanted, views, masked, places);
  return places;
}

bool CatalogueMatching::is_likely(const ProductLook& look, const FittedPose& pose) const {
  if (pose.evidence.score < min_score || pose.evidence.fit < min_fit) return false;
  return std::ranges::all_of(look.surfels(), [&](const Surfel& surfel) {
    return (pose.base_from_product * to_double(surfel.point)).z > lowest_m_;
  });
}

void CatalogueMatching::drop_mistaken(const WantedProduct& wanted,
                                      const std::vector<ViewCloud>& views,
                                      const std::vector<MaskedView>& masked,
                                      std::vector<FoundProduct>& places) const {
  for (std::size_t checked = 0; checked < max_checked && !places.empty(); ++checked) {
    const FoundProduct& best = places.front();
    const auto of_view = std::ranges::find(masked, best.view, &MaskedView::view);
    const SurfacePatch patch = patch_of(views[best.view], of_view->masks[best.mask], patch_points);
    const bool mistaken = std::ranges::any_of(wanted.rivals, [&](const ProductLook* rival) {
      const double score = poses_.pose(*rival, patch, views).evidence.score;
      const bool better = score > best.pose.evidence.score * clearly_better;
      if (better)
        log_debug(fmt::format("{} explains {:.2f} better ({:.2f}) than {}",
                              rival->sku(),
                              best.pose.evidence.score,
                              score,
                              wanted.look->sku()));
      return better;
    });
    if (!mistaken) return;
    places.erase(places.begin());
  }
}

std::vector<FoundProduct> CatalogueMatching::find(const std::vector<WantedProduct>& wanted,
                                                  const std::vector<ViewCloud>& views,
                                                  const std::vector<MaskedView>& masked) const {
  std::vector<FoundProduct> all;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    std::ranges::copy(places_of(i, wanted[i], views, masked), std::back_inserter(all));
  return one_at_a_place(wanted, std::move(all));
}

std::vector<FoundProduct> one_at_a_place(const std::vector<WantedProduct>& wanted,
                                         std::vector<FoundProduct> all) {
  std::vector<FoundProduct> found;
  std::ranges::stable_sort(
      all, std::greater<>{}, [](const FoundProduct& f) { return f.pose.evidence.score; });
  // The surest first: where one product lies, no other does.
  for (const FoundProduct& product : all) {
    if (std::ranges::count(found, product.look, &FoundProduct::look) >= wanted[product.look].count)
      continue;
    const Vec3 at = middle_of(*wanted[product.look].look, product.pose.base_from_product);
    const bool taken = std::ranges::any_of(found, [&](const FoundProduct& other) {
      return length(middle_of(*wanted[other.look].look, other.pose.base_from_product) - at) <
             same_place_m;
    });
    if (!taken) found.push_back(product);
  }
  return found;
}

std::vector<const ProductLook*> rivals_of(const ProductLook& look,
                                          const std::vector<const ProductLook*>& catalogue) {
  std::vector<Vec3f> colors;
  for (const Surfel& surfel : look.surfels())
    colors.push_back(surfel.color);
  std::vector<std::pair<double, const ProductLook*>> alike;
  for (const ProductLook* other : catalogue) {
    const Vec3f a = look.high() - look.low(), b = other->high() - other->low();
    if (other->sku() == look.sku() || length(a - b) > same_size * length(a)) continue;
    alike.emplace_back(color_likeness(colors, *other), other);
  }
  std::ranges::stable_sort(alike, std::greater<>{}, [](const auto& entry) { return entry.first; });
  std::vector<const ProductLook*> rivals;
  for (std::size_t i = 0; i < std::min(max_rivals, alike.size()); ++i)
    rivals.push_back(alike[i].second);
  return rivals;
}

}  // namespace marketgen::perception
