#include "photo/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace marketgen::photo {
namespace {

constexpr std::size_t max_colors = 6;
constexpr int bucket = 24;        // of OpenCV's Lab: what is counted as one colour
constexpr double min_apart = 18;  // Lab distance of two colours of the palette
constexpr double min_share = 0.02;

struct Heap {
  cv::Vec3d lab{}, rgb{};  // sums
  double pixels = 0;
};

double apart(const Heap& a, const Heap& b) {
  return cv::norm(a.lab / a.pixels - b.lab / b.pixels);
}

// Pixels by their bucket of Lab, fullest first.
std::vector<Heap> heaps_of(const Looked& photo) {
  std::map<int, Heap> by_bucket;
  for (int y = 0; y < photo.lab.rows; ++y) {
    for (int x = 0; x < photo.lab.cols; ++x) {
      const auto lab = photo.lab.at<cv::Vec3b>(y, x);
      Heap& heap = by_bucket[(lab[0] / bucket * 256 + lab[1] / bucket) * 256 + lab[2] / bucket];
      heap.lab += cv::Vec3d(lab);
      heap.rgb += cv::Vec3d(photo.rgb.at<cv::Vec3b>(y, x));
      heap.pixels += 1;
    }
  }
  std::vector<Heap> heaps;
  for (const auto& [key, heap] : by_bucket)
    heaps.push_back(heap);
  std::ranges::stable_sort(heaps, std::ranges::greater{}, &Heap::pixels);
  return heaps;
}

}  // namespace

std::vector<PaletteColor> palette_of(const Looked& photo) {
  std::vector<Heap> colors;
  for (const Heap& heap : heaps_of(photo)) {
    const auto near = std::ranges::find_if(
        colors, [&](const Heap& color) { return apart(color, heap) < min_apart; });
    if (near == colors.end()) {
      colors.push_back(heap);
      continue;
    }
    near->lab += heap.lab;
    near->rgb += heap.rgb;
    near->pixels += heap.pixels;
  }
  std::ranges::stable_sort(colors, std::ranges::greater{}, &Heap::pixels);
  if (colors.size() > max_colors) colors.resize(max_colors);
  std::vector<PaletteColor> palette;
  for (const Heap& color : colors) {
    const double share = color.pixels / static_cast<double>(photo.lab.total());
    if (share < min_share) break;
    const cv::Vec3d rgb = color.rgb / color.pixels;
    palette.push_back(
        {fmt::format("#{:02x}{:02x}{:02x}", cvRound(rgb[0]), cvRound(rgb[1]), cvRound(rgb[2])),
         share});
  }
  return palette;
}

}  // namespace marketgen::photo
