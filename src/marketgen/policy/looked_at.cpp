#include "policy/looked_at.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace marketgen::policy {
namespace {

// Mean of two by two pixels; a last odd row or column is left out.
Image halved(const Image& picture) {
  Image half(picture.width / 2, picture.height / 2, 3);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int sum = picture.at(2 * x, 2 * y)[c] + picture.at(2 * x + 1, 2 * y)[c] +
                        picture.at(2 * x, 2 * y + 1)[c] + picture.at(2 * x + 1, 2 * y + 1)[c];
        half.at(x, y)[c] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return half;
}

// About pixels of one picture, in shares of its sides.
class PixelBox {
 public:
  explicit PixelBox(const perception::ViewCloud& view) : view_(view) {}

  void add(std::size_t pixel) {
    const auto width = static_cast<std::size_t>(view_.width());
    const auto x = static_cast<double>(pixel % width), y = static_cast<double>(pixel / width);
    left_ = std::min(left_, x), right_ = std::max(right_, x + 1);
    top_ = std::min(top_, y), bottom_ = std::max(bottom_, y + 1);
  }
  std::optional<std::array<double, 4>> shares() const {
    if (right_ < left_) return std::nullopt;
    const double w = view_.width(), h = view_.height();
    return std::array{left_ / w, top_ / h, right_ / w, bottom_ / h};
  }

 private:
  const perception::ViewCloud& view_;
  double left_ = std::numeric_limits<double>::max(), top_ = left_, right_ = -1, bottom_ = -1;
};

std::optional<std::array<double, 4>> box_of(const perception::ViewCloud& view,
                                            const FoundShape& found) {
  const Vec3f low = found.look->low(), high = found.look->high();
  PixelBox box(view);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at{(corner & 1) != 0 ? high.x : low.x,
                  (corner & 2) != 0 ? high.y : low.y,
                  (corner & 4) != 0 ? high.z : low.z};
    if (const auto seen = view.project(to_float(found.base_from_product * at)))
      box.add(seen->pixel);
  }
  return box.shares();
}

}  // namespace

std::vector<agent::LookedAt> looked_at(const std::vector<perception::ViewCloud>& views,
                                       const std::vector<perception::MaskedView>& masked,
                                       const std::vector<FoundShape>& found) {
  std::vector<agent::LookedAt> all;
  for (const perception::ViewCloud& view : views)
    all.push_back({view.view().camera, halved(view.view().color), {}});
  for (const perception::MaskedView& of_view : masked) {
    for (const perception::Mask& mask : of_view.masks) {
      PixelBox box(views[of_view.view]);
      for (const std::uint32_t pixel : mask.pixels)
        if (pixel < views[of_view.view].size()) box.add(pixel);
      if (const auto shares = box.shares()) all[of_view.view].marks.push_back({*shares, -1});
    }
  }
  for (const FoundShape& each : found)
    for (std::size_t v = 0; v < views.size(); ++v)
      if (const auto shares = box_of(views[v], each)) all[v].marks.push_back({*shares, each.goal});
  return all;
}

}  // namespace marketgen::policy
