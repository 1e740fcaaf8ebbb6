#include "policy/checkout_pictures.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "perception/camera_correction.h"
#include "perception/seen_basket.h"

namespace marketgen::policy {
namespace {

// How far the basket may stand from where it is said to; from where it was last seen.
constexpr double first_off_m = 0.056, first_off_rad = 0.22;
constexpr double later_off_m = 0.016, later_off_rad = 0.045;

}  // namespace

Result<std::optional<std::vector<perception::ViewCloud>>> CheckoutPictures::take(
    agent::Eyes& eyes, agent::Workplace& place) {
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    MARKETGEN_TRY(agent::View view, eyes.look(cameras[c]));
    taken_[c].add(std::move(view));
  }
  if (std::ranges::any_of(taken_, &perception::SteadyView::wants_more))
    return std::optional<std::vector<perception::ViewCloud>>{};
  std::vector<perception::ViewCloud> clouds;
  for (perception::SteadyView& views : taken_)
    clouds.emplace_back(views.take());
  perception::correct_cameras(clouds, place);
  const auto basket = perception::seen_basket(clouds,
                                              place,
                                              found_basket_ ? later_off_m : first_off_m,
                                              found_basket_ ? later_off_rad : first_off_rad);
  if (basket) {
    place.base_from_basket = *basket;
    found_basket_ = true;
  }
  return std::optional(std::move(clouds));
}

}  // namespace marketgen::policy
