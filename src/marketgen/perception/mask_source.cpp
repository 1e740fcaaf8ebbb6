#include "perception/mask_source.h"

#include <algorithm>
#include <cmath>

namespace marketgen::perception {
namespace {

constexpr float max_step_px = 4;      // sides of a pixel, between two neighbours
constexpr float max_concave = 0.08F;  // sine of the fold between two neighbours
constexpr float min_area_m2 = 2.5e-4F;
constexpr double off_basket_m = 0.005;  // nearer to walls and floor than this is no goods
constexpr double over_rim_m = 0.25, min_over_counter_m = 0.012;

// Whether two neighbours are one smooth or outward folded surface.
bool belong_together(const ViewCloud& cloud, std::size_t a, std::size_t b) {
  const Vec3f way = cloud.point(b) - cloud.point(a);
  const float apart = length(way);
  if (apart > max_step_px * cloud.pixel_m(cloud.view().depth_m[a])) return false;
  return dot(cloud.normal(b) - cloud.normal(a), way) > -max_concave * apart;
}

bool has_normal(const ViewCloud& cloud, std::size_t pixel) {
  const Vec3f n = cloud.normal(pixel);
  return dot(n, n) > 0;
}

float area_of(const ViewCloud& cloud, const Mask& mask) {
  float area = 0;
  for (const std::uint32_t pixel : mask.pixels) {
    const float side = cloud.pixel_m(cloud.view().depth_m[pixel]);
    area += side * side;
  }
  return area;
}

}  // namespace

void sort_by_size(std::vector<Mask>& masks) {
  std::ranges::stable_sort(
      masks, std::greater<>{}, [](const Mask& mask) { return mask.pixels.size(); });
}

std::vector<Mask> GeometricMasks::masks(const ViewCloud& cloud,
                                        const std::vector<std::uint8_t>& wanted) const {
  std::vector<std::uint8_t> open(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    open[i] = wanted[i] != 0 && has_normal(cloud, i) ? 1 : 0;
  std::vector<Mask> masks;
  const auto width = static_cast<std::uint32_t>(cloud.width());
  for (std::uint32_t first = 0; first < open.size(); ++first) {
    if (open[first] == 0) continue;
    open[first] = 0;
    Mask mask{{first}};
    for (std::size_t next = 0; next < mask.pixels.size(); ++next) {
      const std::uint32_t here = mask.pixels[next];
      // Pixels at the border have no normals, so all four neighbours exist.
      for (const std::uint32_t near : {here - 1, here + 1, here - width, here + width}) {
        if (open[near] == 0 || !belong_together(cloud, here, near)) continue;
        open[near] = 0;
        mask.pixels.push_back(near);
      }
    }
    if (area_of(cloud, mask) < min_area_m2) continue;
    std::ranges::sort(mask.pixels);
    masks.push_back(std::move(mask));
  }
  sort_by_size(masks);
  return masks;
}

std::vector<std::uint8_t> goods_in_basket(const ViewCloud& cloud,
                                          const agent::Workplace& place,
                                          const Pose& base_from_basket) {
  const Pose basket_from_base = inverse(base_from_basket);
  std::vector<agent::WorkBox> solid = place.walls;
  solid.insert(solid.end(), place.ledges.begin(), place.ledges.end());
  std::vector<Pose> box_from_base;
  for (const agent::WorkBox& box : solid)
    box_from_base.push_back(inverse(box.pose) * basket_from_base);
  const auto is_basket = [&](Vec3 point) {
    for (std::size_t i = 0; i < solid.size(); ++i) {
      const Vec3 at = box_from_base[i] * point, half = solid[i].half_size;
      if (std::abs(at.x) < half.x + off_basket_m && std::abs(at.y) < half.y + off_basket_m &&
          std::abs(at.z) < half.z + off_basket_m)
        return true;
    }
    return false;
  };
  std::vector<std::uint8_t> wanted(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.has(i)) continue;
    const Vec3 point = to_double(cloud.point(i)), at = basket_from_base * point;
    const bool inside = std::abs(at.x) < place.inner_half.x && at.z > off_basket_m &&
                        std::abs(at.y) < place.inner_half.y && at.z < place.rim_m + over_rim_m;
    wanted[i] = inside && !is_basket(point) ? 1 : 0;
  }
  return wanted;
}

std::vector<std::uint8_t> goods_over(const ViewCloud& cloud, const agent::WorkArea& area) {
  std::vector<std::uint8_t> wanted(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.has(i)) continue;
    const Vec3f p = cloud.point(i);
    const bool over = area.holds(p.x, p.y) && p.z > min_over_counter_m && p.z < over_rim_m;
    wanted[i] = over ? 1 : 0;
  }
  return wanted;
}

}  // namespace marketgen::perception
