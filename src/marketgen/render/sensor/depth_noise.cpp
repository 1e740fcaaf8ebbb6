#include "render/sensor/depth_noise.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/seed.h"
#include "render/cameras/view.h"

namespace marketgen::render {
namespace {

constexpr double edge_step_px = 0.5;  // of disparity between neighbours: an edge of something
constexpr int patches_across = 106;   // holes are about 8 pixels of an 848-pixel picture wide

// Smooth random numbers over the picture, about even between 0 and 1.
class Patches {
 public:
  Patches(const Seed& seed, int width, int height)
      : pitch_(std::max(1.0, double(width) / patches_across)),
        columns_(static_cast<int>(width / pitch_) + 2) {
    const int rows = static_cast<int>(height / pitch_) + 2;
    Stream draw = seed.child("patches").stream();
    for (int i = 0; i < columns_ * rows; ++i)
      nodes_.push_back(draw.uniform());
  }

  double at(int x, int y) const {
    const double u = x / pitch_, v = y / pitch_;
    const auto column = static_cast<int>(u), row = static_cast<int>(v);
    const double fu = u - column, fv = v - row;
    const auto node = [&](int r, int c) {
      return nodes_[static_cast<std::size_t>(r * columns_ + c)];
    };
    return (node(row, column) * (1 - fu) + node(row, column + 1) * fu) * (1 - fv) +
           (node(row + 1, column) * (1 - fu) + node(row + 1, column + 1) * fu) * fv;
  }

 private:
  double pitch_;
  int columns_;
  std::vector<double> nodes_;
};

// Numbers of mean 0 and variance 1 over the picture, those of neighbours alike as far as their
// windows overlap: sums of even random numbers over the window of each pixel, 49 of them, whose
// distribution is normal to 1 % out to three sigma.
class MatchNoise {
 public:
  MatchNoise(const Seed& seed, int window, int width, int height)
      : window_(window),
        width_(static_cast<std::size_t>(width)),
        scale_(std::sqrt(3.0F) / static_cast<float>(window)),
        row_sums_(width_ * static_cast<std::size_t>(height + window - 1)) {
    parallel_for(static_cast<std::size_t>(height + window - 1), [&](std::size_t row) {
      add_row(seed.child("row", row).stream(), &row_sums_[row * width_]);
    });
  }

  // Of the whole row `y`.
  void read_row(int y, std::vector<float>& noise) const {
    noise.assign(width_, 0);
    for (int k = 0; k < window_; ++k) {
      const float* const sums = &row_sums_[static_cast<std::size_t>(y + k) * width_];
      for (std::size_t x = 0; x < width_; ++x)
        noise[x] += sums[x];
    }
    for (float& value : noise)
      value *= scale_;
  }

 private:
  void add_row(Stream draw, float* sums) const {
    const auto window = static_cast<std::size_t>(window_);
    std::vector<float> numbers(width_ + window - 1);
    for (float& number : numbers)
      number = static_cast<float>(draw.uniform(-1, 1));
    for (std::size_t k = 0; k < window; ++k)
      for (std::size_t x = 0; x < width_; ++x)
        sums[x] += numbers[x + k];
  }

  int window_;
  std::size_t width_;
  float scale_;  // the variance of an even number from -1 to 1 is 1/3
  std::vector<float> row_sums_;
};

class StereoPicture {
 public:
  StereoPicture(const Frame& frame,
                const Camera& camera,
                const StereoCamera& stereo,
                const NoiseSource& source)
      : frame_(frame),
        stereo_(stereo),
        view_(camera),
        scale_(intrinsics_of(camera).fx * stereo.baseline_m),
        patches_(Seed(source.seed).child("depth holes"), camera.width, camera.height),
        noise_(Seed(source.seed).child("depth noise", source.frame)),
        match_noise_(noise_.child("match"), stereo.match_window_px, camera.width, camera.height),
        disparity_(frame.depth_m.size()) {
    for (std::size_t i = 0; i < disparity_.size(); ++i)
      disparity_[i] = frame.depth_m[i] > 0 ? scale_ / static_cast<double>(frame.depth_m[i]) : 0;
  }

  void measure_row(int y, std::vector<float>& depth_m) const {
    Stream draw = noise_.child("row", static_cast<std::uint64_t>(y)).stream();
    double nearest_right = 1e30;  // leftmost place in the right picture of what lies further right
    std::vector<bool> seen_twice(static_cast<std::size_t>(view_.width()));
    for (int x = view_.width() - 1; x >= 0; --x) {
      const double right_x = x - disparity_[at(x, y)];
      seen_twice[static_cast<std::size_t>(x)] = right_x < nearest_right && right_x >= 0;
      nearest_right = std::min(nearest_right, right_x);
    }
    std::vector<float> match_noise;
    match_noise_.read_row(y, match_noise);
    for (int x = 0; x < view_.width(); ++x) {
      const double error = double(match_noise[static_cast<std::size_t>(x)]);
      const double measured = measured_disparity(x, y, error, draw);
      const bool hole = !seen_twice[static_cast<std::size_t>(x)] || has_no_match(x, y);
      depth_m[at(x, y)] = hole ? 0 : depth_of(measured);
    }
  }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width()) +
           static_cast<std::size_t>(x);
  }
  Matter matter(int x, int y) const { return static_cast<Matter>(frame_.matter[at(x, y)]); }
  double clamped(int x, int y) const {
    return disparity_[at(std::clamp(x, 0, view_.width() - 1),
                         std::clamp(y, 0, view_.height() - 1))];
  }

  // Of a pixel and its eight neighbours.
  struct Range {
    double low = 1e30, high = 0;
  };
  Range around(int x, int y) const {
    Range range;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const double d = clamped(x + dx, y + dy);
        range.low = std::min(range.low, d), range.high = std::max(range.high, d);
      }
    }
    return range;
  }
  bool is_edge(int x, int y) const {
    const Range range = around(x, y);
    return range.high - range.low > edge_step_px;
  }

  // Near things, a pixel larger all round than they are.
  double grown_between_pixels(double x, double y) const {
    const auto column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const double fx = x - column, fy = y - row;
    const auto grown = [&](int dx, int dy) { return around(column + dx, row + dy).high; };
    return (grown(0, 0) * (1 - fx) + grown(1, 0) * fx) * (1 - fy) +
           (grown(0, 1) * (1 - fx) + grown(1, 1) * fx) * fy;
  }

  // `error`: of matching, in sigmas.
  double measured_disparity(int x, int y, double error, Stream& draw) const {
    double disparity = disparity_[at(x, y)];
    if (is_edge(x, y)) {
      const double aside = stereo_.edge_shift_px * draw.normal();
      disparity = grown_between_pixels(x + aside, y + stereo_.edge_shift_px * draw.normal());
    }
    const double factor = matter(x, y) == Matter::clear ? stereo_.clear_noise_factor : 1;
    disparity += factor * stereo_.disparity_noise_px * error;
    return std::round(disparity / stereo_.disparity_step_px) * stereo_.disparity_step_px;
  }

  bool is_overexposed(std::size_t pixel) const {
    const std::uint8_t* rgb = &frame_.color.pixels[3 * pixel];
    return std::min({rgb[0], rgb[1], rgb[2]}) >= stereo_.overexposed;
  }

  bool has_no_match(int x, int y) const {
    const std::size_t pixel = at(x, y);
    switch (matter(x, y)) {
      case Matter::none:
        return true;
      case Matter::glass:
        return patches_.at(x, y) < stereo_.glass_holes;
      case Matter::clear:
        return patches_.at(x, y) < stereo_.clear_holes || is_overexposed(pixel);
      case Matter::metal: {
        const Vec3f normal{frame_.normals[3 * pixel],
                           frame_.normals[3 * pixel + 1],
                           frame_.normals[3 * pixel + 2]};
        const raytrace::Ray ray =
            view_.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
        return -dot(normal, ray.direction) < stereo_.min_metal_facing || is_overexposed(pixel);
      }
      case Matter::solid:
        break;
    }
    return is_overexposed(pixel);
  }

  float depth_of(double disparity) const {
    if (disparity <= 0 || disparity > stereo_.largest_disparity_px) return 0;
    const double depth = scale_ / disparity;
    return depth > stereo_.farthest_m ? 0 : static_cast<float>(depth);
  }

  const Frame& frame_;
  const StereoCamera& stereo_;
  raytrace::View view_;
  double scale_;  // disparity * depth, pixel metres
  Patches patches_;
  Seed noise_;
  MatchNoise match_noise_;
  std::vector<double> disparity_;  // 0 = nothing there
};

}  // namespace

double min_depth_m(const StereoCamera& stereo, const Intrinsics& intrinsics) {
  return intrinsics.fx * stereo.baseline_m / stereo.largest_disparity_px;
}

Result<std::vector<float>> noisy_depth(const Frame& frame,
                                       const Camera& camera,
                                       const StereoCamera& stereo,
                                       const NoiseSource& source) {
  if (camera.ortho_height_m > 0)
    return Error{"camera.degenerate",
                 camera.name.empty() ? "camera" : camera.name,
                 "an orthographic view has no pair of eyes to measure depth with; take a pinhole"};
  const StereoPicture picture(frame, camera, stereo, source);
  std::vector<float> depth_m(frame.depth_m.size());
  parallel_for(static_cast<std::size_t>(camera.height),
               [&](std::size_t y) { picture.measure_row(static_cast<int>(y), depth_m); });
  return depth_m;
}

}  // namespace marketgen::render
