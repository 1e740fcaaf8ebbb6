#include "render/filter.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace marketgen::raytrace {
namespace {

constexpr int reach = 2;                                  // taps each way: 5 x 5
constexpr float spline[reach + 1] = {0.375F, 0.25F, 0.0625F};  // cubic B-spline
constexpr float plane_tolerance_m = 0.006F;               // off the tangent plane
constexpr float plane_tolerance_per_m = 0.004F;           // times the distance from the eye
constexpr float least_deviation = 1e-3F;                  // of the mean light: keeps flat areas from dividing by zero
constexpr std::size_t rows_per_task = 8;

float luminance_at(const Planes3& c, std::size_t i) {
  return 0.2126F * c.axis[0][i] + 0.7152F * c.axis[1][i] + 0.0722F * c.axis[2][i];
}

// Sums of one row, one entry a pixel.
struct RowSums {
  Plane weight, red, green, blue, second;
  explicit RowSums(std::size_t width) : weight(width), red(width), green(width), blue(width), second(width) {}
  void clear() {
    for (Plane* plane : {&weight, &red, &green, &blue, &second}) std::fill(plane->begin(), plane->end(), 0.0F);
  }
};

class Smoother {
 public:
  Smoother(const Film& film, const FilterSettings& settings)
      : film_(film), settings_(settings), luminance_(film.count()), variance_(film.count()), plane_scale_(film.count()) {
    for (std::size_t i = 0; i < film.count(); ++i) {
      plane_scale_[i] = 1 / (plane_tolerance_m + plane_tolerance_per_m * film.depth[i]);
    }
  }

  void run(Planes3& light) {
    Planes3 next(film_.count());
    Plane next_variance(film_.count());
    measure_noise(light, next_variance);
    variance_.swap(next_variance);
    for (int pass = 0; pass < settings_.passes; ++pass) {
      for (std::size_t i = 0; i < film_.count(); ++i) luminance_[i] = luminance_at(light, i);
      for_rows([&](int y, RowSums& sums) { smooth_row(light, y, 1 << pass, sums, next, next_variance); });
      std::swap(light, next);
      variance_.swap(next_variance);
    }
  }

 private:
  template <class Body>
  void for_rows(const Body& body) const {
    const auto tasks = (static_cast<std::size_t>(film_.height) + rows_per_task - 1) / rows_per_task;
    parallel_for(tasks, [&](std::size_t task) {
      RowSums sums(static_cast<std::size_t>(film_.width));
      const int first = static_cast<int>(task * rows_per_task);
      const int last = std::min(film_.height, first + static_cast<int>(rows_per_task));
      for (int y = first; y < last; ++y) body(y, sums);
    });
  }

  // Variance of luminance among neighbours of the same surface, before any smoothing.
  void measure_noise(const Planes3& light, Plane& variance) {
    for (std::size_t i = 0; i < film_.count(); ++i) luminance_[i] = luminance_at(light, i);
    for_rows([&](int y, RowSums& sums) {
      sums.clear();
      for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) add_moments(y, dx, dy, sums);
      }
      for (int x = 0; x < film_.width; ++x) {
        const auto k = static_cast<std::size_t>(x);
        const float mean = sums.red[k] / sums.weight[k];
        variance[film_.index(x, y)] = std::max(0.0F, sums.second[k] / sums.weight[k] - mean * mean);
      }
    });
  }

  struct Tap {
    int first = 0, last = 0;         // columns whose neighbour is inside
    std::ptrdiff_t offset = 0;       // from the picture's row start to the neighbour of column 0
  };
  Tap tap(int y, int dx, int dy) const {
    const int row = std::clamp(y + dy, 0, film_.height - 1);
    return {std::max(0, -dx), std::min(film_.width, film_.width - dx), static_cast<std::ptrdiff_t>(row) * film_.width + dx};
  }

  // How much neighbour q looks like the same surface as p, 0..1.
  float alike(std::size_t p, std::size_t q) const {
    const auto& n = film_.normal.axis;
    const auto& at = film_.position.axis;
    const float turned = std::max(0.0F, n[0][p] * n[0][q] + n[1][p] * n[1][q] + n[2][p] * n[2][q]);
    const float t2 = turned * turned, t4 = t2 * t2, t8 = t4 * t4;
    const float off_plane = std::fabs(n[0][p] * (at[0][q] - at[0][p]) + n[1][p] * (at[1][q] - at[1][p]) +
                                      n[2][p] * (at[2][q] - at[2][p])) * plane_scale_[p];
    return t8 * t8 * bell(off_plane);
  }
  // Like exp(-x), but ends at 4 and needs no library call.
  static float bell(float x) {
    const float left = std::max(0.0F, 1 - 0.25F * x);
    return left * left * left * left;
  }

  void add_moments(int y, int dx, int dy, RowSums& sums) const {
    const Tap t = tap(y, dx, dy);
    const std::size_t row = film_.index(0, y);
    for (int x = t.first; x < t.last; ++x) {
      const auto k = static_cast<std::size_t>(x);
      const auto q = static_cast<std::size_t>(t.offset + x);
      const float weight = alike(row + k, q) + 1e-6F;
      sums.weight[k] += weight;
      sums.red[k] += weight * luminance_[q];
      sums.second[k] += weight * luminance_[q] * luminance_[q];
    }
  }

  void add_tap(const Planes3& light, int y, int dx, int dy, float kernel, RowSums& sums) const {
    const Tap t = tap(y, dx, dy);
    const std::size_t row = film_.index(0, y);
    for (int x = t.first; x < t.last; ++x) {
      const auto k = static_cast<std::size_t>(x);
      const std::size_t p = row + k;
      const auto q = static_cast<std::size_t>(t.offset + x);
      const float deviation = settings_.noise_tolerance * std::sqrt(variance_[p]) + least_deviation * luminance_[p] + 1e-6F;
      float weight = kernel * alike(p, q) * bell(std::fabs(luminance_[p] - luminance_[q]) / deviation);
      if (settings_.same_material_only && film_.material[p] != film_.material[q]) weight = 0;
      sums.weight[k] += weight;
      sums.red[k] += weight * light.axis[0][q];
      sums.green[k] += weight * light.axis[1][q];
      sums.blue[k] += weight * light.axis[2][q];
      sums.second[k] += weight * weight * variance_[q];
    }
  }

  void smooth_row(const Planes3& light, int y, int step, RowSums& sums, Planes3& next, Plane& next_variance) const {
    sums.clear();
    for (int j = -reach; j <= reach; ++j) {
      if (y + j * step < 0 || y + j * step >= film_.height) continue;
      for (int i = -reach; i <= reach; ++i) {
        add_tap(light, y, i * step, j * step, spline[std::abs(i)] * spline[std::abs(j)], sums);
      }
    }
    for (int x = 0; x < film_.width; ++x) {
      const auto k = static_cast<std::size_t>(x);
      const std::size_t p = film_.index(x, y);
      const float scale = 1 / std::max(sums.weight[k], 1e-12F);
      next.set(p, {sums.red[k] * scale, sums.green[k] * scale, sums.blue[k] * scale});
      next_variance[p] = sums.second[k] * scale * scale;
    }
  }

  const Film& film_;
  const FilterSettings& settings_;
  Plane luminance_, variance_, plane_scale_;
};

}  // namespace

void smooth(const Film& film, Planes3& light, const FilterSettings& settings) { Smoother(film, settings).run(light); }

}  // namespace marketgen::raytrace
