#include "perception/shelf_spots.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace marketgen::perception {
namespace {

constexpr double bin_m = 0.005, sweep_m = 0.004;
constexpr int pixel_step = 2;
// Of a pack, what heights say where its front is: below them lies its label's rail, over them what
// leans on it.
constexpr double from_height = 0.15, to_height = 0.9;
constexpr double before_edge_m = 0.06;  // goods that overhang
constexpr double front_share = 0.1;     // of what is measured in a bin, what counts as stray
constexpr double row_share = 0.15;      // the same of the bins over a pack's width
constexpr double min_filled = 0.4;      // of the bins over a pack's width
constexpr double core = 0.45;           // of the width, to each side, where bins are looked at

float quantile(std::vector<float>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

// How far behind the board's edge things begin, bin by bin along it.
class FrontProfile {
 public:
  FrontProfile(const BoardAhead& board, double height_m)
      : board_(board), bins_(static_cast<std::size_t>(board.width_m / bin_m) + 1) {
    const double height = std::min(height_m, board.clearance_m);
    low_z_ = static_cast<float>(from_height * height);
    high_z_ = static_cast<float>(to_height * height);
    const Pose back = inverse(board.base_from_board);
    right_ = to_float(rotate(board.base_from_board.rotation, {1, 0, 0}));
    in_ = to_float(rotate(board.base_from_board.rotation, {0, 1, 0}));
    up_ = to_float(rotate(board.base_from_board.rotation, {0, 0, 1}));
    origin_ = to_float(board.base_from_board.position);
    eye_side_ = back;
  }

  bool faces(const ViewCloud& view) const { return (eye_side_ * to_double(view.eye())).y < 0; }

  void add(const ViewCloud& view) {
    for (int y = 0; y < view.height(); y += pixel_step)
      for (int x = 0; x < view.width(); x += pixel_step)
        if (const std::size_t pixel = view.index(x, y); view.has(pixel)) add(view.point(pixel));
  }

  void close() {
    for (std::vector<float>& bin : bins_)
      fronts_.push_back(bin.empty() ? std::nullopt : std::optional(quantile(bin, front_share)));
  }

  // Of something so wide with its middle there.
  std::optional<double> front_at(double x, double width_m) const {
    const int first = std::max(0, bin_of(x - core * width_m));
    const int last = std::min(static_cast<int>(fronts_.size()) - 1, bin_of(x + core * width_m));
    std::vector<float> seen;
    for (int i = first; i <= last; ++i)
      if (const auto& front = fronts_[static_cast<std::size_t>(i)]) seen.push_back(*front);
    const double bins = 2 * core * width_m / bin_m;
    if (static_cast<double>(seen.size()) < min_filled * bins || seen.empty()) return std::nullopt;
    return static_cast<double>(quantile(seen, row_share));
  }

 private:
  int bin_of(double x) const {
    return static_cast<int>(std::floor((x + board_.width_m / 2) / bin_m));
  }

  void add(Vec3f point) {
    const Vec3f off = point - origin_;
    const float z = dot(off, up_);
    if (z < low_z_ || z > high_z_) return;
    const float y = dot(off, in_);
    if (y < -before_edge_m || static_cast<double>(y) > board_.depth_m) return;
    const int bin = bin_of(static_cast<double>(dot(off, right_)));
    if (bin >= 0 && bin < static_cast<int>(bins_.size()))
      bins_[static_cast<std::size_t>(bin)].push_back(y);
  }

  const BoardAhead& board_;
  std::vector<std::vector<float>> bins_;
  std::vector<std::optional<float>> fronts_;
  float low_z_ = 0, high_z_ = 0;
  Vec3f right_, in_, up_, origin_;
  Pose eye_side_;
};

}  // namespace

std::vector<ShelfSpot> SweptSpots::spots(const std::vector<ViewCloud>& views,
                                         const std::vector<BoardAhead>& boards,
                                         Vec3f size) const {
  std::vector<ShelfSpot> found;
  const auto width = static_cast<double>(size.x), height = static_cast<double>(size.z);
  for (std::size_t b = 0; b < boards.size(); ++b) {
    if (height > boards[b].clearance_m || width > boards[b].width_m) continue;
    FrontProfile profile(boards[b], height);
    for (const ViewCloud& view : views)
      if (profile.faces(view)) profile.add(view);
    profile.close();
    const double most = (boards[b].width_m - width) / 2;
    for (double x = -most; x <= most; x += sweep_m)
      if (const auto front = profile.front_at(x, width)) found.push_back({b, x, *front});
  }
  return found;
}

}  // namespace marketgen::perception
