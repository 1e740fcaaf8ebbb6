#include "perception/served_masks.h"

#include <algorithm>

#include "io/png.h"
#include "perception/mask_answer.h"
#include "perception/picture_part.h"

namespace marketgen::perception {
namespace {

constexpr int margin_px = 24;
constexpr std::size_t max_masks = 200, min_mask_pixels = 30;  // of one picture; of a mask

PicturePart part_with(const ViewCloud& cloud, const std::vector<std::uint8_t>& wanted) {
  PicturePart part;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] != 0)
      part.add(static_cast<int>(i) % cloud.width(), static_cast<int>(i) / cloud.width());
  return part.empty() ? part : part.with_margin(margin_px, cloud.width(), cloud.height());
}

// In the whole picture, of what is wanted; empty when it shows too little of it.
Mask of_picture(const Mask& mask,
                const PicturePart& part,
                const ViewCloud& cloud,
                const std::vector<std::uint8_t>& wanted) {
  Mask whole;
  for (const std::uint32_t pixel : mask.pixels) {
    const int x = static_cast<int>(pixel) % part.width(),
              y = static_cast<int>(pixel) / part.width();
    const std::size_t at = cloud.index(part.left + x, part.top + y);
    if (wanted[at] != 0) whole.pixels.push_back(static_cast<std::uint32_t>(at));
  }
  if (whole.pixels.size() < min_mask_pixels) whole.pixels.clear();
  return whole;
}

}  // namespace

std::vector<Mask> ServedMasks::masks(const ViewCloud& cloud,
                                     const std::vector<std::uint8_t>& wanted) const {
  const PicturePart part = part_with(cloud, wanted);
  if (part.empty()) return offline_->masks(cloud, wanted);
  std::vector<Mask> masks;
  const auto png = io::encode_png(part.cut(cloud.view().color));
  const bool served =
      png.ok() &&
      server_->ask(form_with_png(*png, "format", "coco_rle"),
                   [&](const std::string& answer) -> Result<void> {
                     MARKETGEN_TRY(masks, read_masks(answer, part.width(), part.height()));
                     return {};
                   });
  if (!served) return offline_->masks(cloud, wanted);
  for (Mask& mask : masks)
    mask = of_picture(mask, part, cloud, wanted);
  std::erase_if(masks, [](const Mask& mask) { return mask.pixels.empty(); });
  sort_by_size(masks);
  if (masks.size() > max_masks) masks.resize(max_masks);
  std::vector<std::uint8_t> left = wanted;
  for (const Mask& mask : masks)
    for (const std::uint32_t pixel : mask.pixels)
      left[pixel] = 0;
  for (Mask& mask : offline_->masks(cloud, left))
    masks.push_back(std::move(mask));
  sort_by_size(masks);
  return masks;
}

}  // namespace marketgen::perception
