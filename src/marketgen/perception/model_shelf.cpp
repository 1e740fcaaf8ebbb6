#include "perception/model_shelf.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace marketgen::perception {
namespace {

constexpr std::size_t max_shelf_marks = 24;  // narrow packs side by side: more cannot be read
constexpr double before_front_m = 0.03;      // what is measured, off what a spot says

// Whether a point belongs to what stands on the spot.
bool is_on(const ShelfSpot& spot, Vec3 board_point, Vec3f size) {
  const Vec3 s = to_double(size);
  return std::abs(board_point.x - spot.x_m) < s.x / 2 && board_point.z > 0 && board_point.z < s.z &&
         board_point.y > spot.front_m - before_front_m && board_point.y < spot.front_m + s.y;
}

std::vector<Mask> masks_in(const ViewCloud& view,
                           const std::vector<BoardAhead>& boards,
                           const std::vector<ShelfSpot>& spots,
                           Vec3f size) {
  std::vector<Mask> masks(spots.size());
  std::vector<Pose> board_from_base;
  for (const BoardAhead& board : boards)
    board_from_base.push_back(inverse(board.base_from_board));
  for (std::size_t pixel = 0; pixel < view.size(); ++pixel) {
    if (!view.has(pixel)) continue;
    const Vec3 point = to_double(view.point(pixel));
    for (std::size_t i = 0; i < spots.size(); ++i)
      if (is_on(spots[i], board_from_base[spots[i].board] * point, size))
        masks[i].pixels.push_back(static_cast<std::uint32_t>(pixel));
  }
  return masks;
}

}  // namespace

std::vector<MaskedView> masks_of_spots(const std::vector<ViewCloud>& views,
                                       const std::vector<BoardAhead>& boards,
                                       const std::vector<ShelfSpot>& spots,
                                       Vec3f size) {
  std::vector<MaskedView> masked;
  for (std::size_t view = 0; view < views.size(); ++view)
    masked.push_back({view, masks_in(views[view], boards, spots, size)});
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const auto pixels = [&](const MaskedView& of_view) { return of_view.masks[i].pixels.size(); };
    const auto best = std::ranges::max_element(masked, {}, pixels);
    for (auto of_view = masked.begin(); of_view != masked.end(); ++of_view)
      if (of_view != best) of_view->masks[i].pixels.clear();
  }
  return masked;
}

std::optional<FoundOnShelf> ModelShelfChoice::stood_at(const ShelfSpot& spot,
                                                       const WantedProduct& wanted,
                                                       const std::vector<ViewCloud>& views,
                                                       const std::vector<BoardAhead>& boards,
                                                       const std::vector<ShelfSpot>& spots) const {
  const double apart = apart_on_shelf(*wanted.look);
  std::vector<ShelfSpot> near;
  std::ranges::copy_if(spots, std::back_inserter(near), [&](const ShelfSpot& other) {
    return other.board == spot.board && std::abs(other.x_m - spot.x_m) < apart;
  });
  const auto found = offline_->find({wanted.look}, views, boards, near);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::optional<std::vector<FoundOnShelf>> ModelShelfChoice::chosen(
    const WantedProduct& wanted,
    const std::vector<ViewCloud>& views,
    const std::vector<BoardAhead>& boards,
    const std::vector<ShelfSpot>& spots) const {
  const ProductLook& look = *wanted.look;
  const std::vector<ShelfSpot> likely = likely_spots(look, views, boards, spots, max_shelf_marks);
  std::vector<MaskedView> masked = masks_of_spots(views, boards, likely, look.high() - look.low());
  std::vector<FoundOnShelf> found;
  while (std::cmp_less(found.size(), wanted.count)) {
    const MarkedPictures marked = marked_pictures(views, masked);
    const MarkChoice choice = questioner_->which(words_of(wanted, by_sku_), marked, views, masked);
    if (choice.outcome == MarkOutcome::absent) return found;
    std::optional<FoundOnShelf> place;
    std::size_t spot = 0;
    if (has_answered(choice.outcome)) {
      spot = marked.marks[choice.mark].mask;
      place = stood_at(likely[spot], wanted, views, boards, spots);
      if (!place) questioner_->count_no_pose(choice);
    }
    if (!place) return found.empty() ? std::nullopt : std::optional(found);
    found.push_back(*place);
    for (MaskedView& of_view : masked)
      of_view.masks[spot].pixels.clear();
  }
  return found;
}

std::vector<FoundOnShelf> ModelShelfChoice::find(const WantedProduct& wanted,
                                                 const std::vector<ViewCloud>& views,
                                                 const std::vector<BoardAhead>& boards,
                                                 const std::vector<ShelfSpot>& spots) const {
  if (const auto found = chosen(wanted, views, boards, spots)) return *found;
  questioner_->count_offline();
  return offline_->find(wanted, views, boards, spots);
}

}  // namespace marketgen::perception
