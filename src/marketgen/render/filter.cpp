#include "render/filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"

namespace marketgen::raytrace {
namespace {

constexpr int reach = 2;                                       // taps each way: 5 x 5
constexpr float spline[reach + 1] = {0.375F, 0.25F, 0.0625F};  // cubic B-spline
constexpr float plane_tolerance_m = 0.006F;                    // off the tangent plane
constexpr float plane_tolerance_per_m = 0.004F;                // times the distance from the eye
constexpr float least_deviation =
    1e-3F;  // of the mean light: keeps flat areas from dividing by zero
constexpr std::size_t rows_per_task = 8;

float luminance_at(const Planes3& c, std::size_t i) {
  return 0.2126F * c.axis[0][i] + 0.7152F * c.axis[1][i] + 0.0722F * c.axis[2][i];
}

// Sums of one row, one entry a pixel.
struct RowSums {
  Plane weight, red, green, blue, second;
  explicit RowSums(std::size_t width)
      : weight(width), red(width), green(width), blue(width), second(width) {}
  void clear() {
    for (Plane* plane : {&weight, &red, &green, &blue, &second})
      std::fill(plane->begin(), plane->end(), 0.0F);
  }
};

class Smoother {
 public:
  Smoother(const Film& film, const FilterSettings& settings)
      : film_(film),
        settings_(settings),
        luminance_(film.count()),
        variance_(film.count()),
        edge_scale_(film.count()),
        plane_scale_(film.count()),
        material_(film.count()) {
    for (std::size_t i = 0; i < film.count(); ++i) {
      plane_scale_[i] = 1 / (plane_tolerance_m + plane_tolerance_per_m * film.depth[i]);
      material_[i] = settings.same_material_only ? static_cast<float>(film.material[i]) : 0;
    }
  }

  void run(Planes3& light) {
    Planes3 next(film_.count());
    Plane next_variance(film_.count());
    measure_noise(light, next_variance);
    variance_.swap(next_variance);
    for (int pass = 0; pass < settings_.passes; ++pass) {
      for (std::size_t i = 0; i < film_.count(); ++i) {
        luminance_[i] = luminance_at(light, i);
        edge_scale_[i] = 1 / (settings_.noise_tolerance * std::sqrt(variance_[i]) +
                              least_deviation * luminance_[i] + 1e-6F);
      }
      for_rows([&](int y, RowSums& sums) {
        smooth_row(light, y, 1 << pass, sums, next, next_variance);
      });
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
      for (int y = first; y < last; ++y)
        body(y, sums);
    });
  }

  // Variance of luminance among neighbours of the same surface, before any smoothing.
  void measure_noise(const Planes3& light, Plane& variance) {
    for (std::size_t i = 0; i < film_.count(); ++i)
      luminance_[i] = luminance_at(light, i);
    for_rows([&](int y, RowSums& sums) {
      sums.clear();
      for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx)
          add_moments(y, dx, dy, sums);
      }
      for (int x = 0; x < film_.width; ++x) {
        const auto k = static_cast<std::size_t>(x);
        const float mean = sums.red[k] / sums.weight[k];
        variance[film_.index(x, y)] = std::max(0.0F, sums.second[k] / sums.weight[k] - mean * mean);
      }
    });
  }

  struct Tap {
    int first = 0, last = 0;    // columns whose neighbour is inside
    std::ptrdiff_t offset = 0;  // from the picture's row start to the neighbour of column 0
  };
  Tap tap(int y, int dx, int dy) const {
    const int row = std::clamp(y + dy, 0, film_.height - 1);
    return {std::max(0, -dx),
            std::min(film_.width, film_.width - dx),
            static_cast<std::ptrdiff_t>(row) * film_.width + dx};
  }

  // Planes at the start of a row, and at the neighbours of its pixels.
  struct Guides {
    const float *nx, *ny, *nz, *x, *y, *z;
    Guides(const Film& film, std::ptrdiff_t start)
        : nx(film.normal.axis[0].data() + start),
          ny(film.normal.axis[1].data() + start),
          nz(film.normal.axis[2].data() + start),
          x(film.position.axis[0].data() + start),
          y(film.position.axis[1].data() + start),
          z(film.position.axis[2].data() + start) {}
  };

  // How much pixel i of row q looks like the same surface as pixel i of row p, 0..1.
  static float alike(const Guides& p, const Guides& q, float plane_scale, int i) {
    const float turned = std::max(0.0F, p.nx[i] * q.nx[i] + p.ny[i] * q.ny[i] + p.nz[i] * q.nz[i]);
    const float t2 = turned * turned, t4 = t2 * t2, t8 = t4 * t4;
    const float off_plane = std::fabs(p.nx[i] * (q.x[i] - p.x[i]) + p.ny[i] * (q.y[i] - p.y[i]) +
                                      p.nz[i] * (q.z[i] - p.z[i]));
    return t8 * t8 * bell(off_plane * plane_scale);
  }
  // Like exp(-x), but ends at 4 and needs no library call.
  static float bell(float x) {
    const float left = std::max(0.0F, 1 - 0.25F * x);
    return left * left * left * left;
  }

  // The loops below run over plain arrays that never overlap, so that the compiler may take eight
  // pixels at a time.
  void add_moments(int y, int dx, int dy, RowSums& sums) const {
    const Tap t = tap(y, dx, dy);
    const auto row = static_cast<std::ptrdiff_t>(film_.index(0, y));
    const Guides p(film_, row), q(film_, t.offset);
    const float* const plane_scale = plane_scale_.data() + row;
    const float* const light = luminance_.data() + t.offset;
    float *const weights = sums.weight.data(), *const first = sums.red.data(),
                 *const second = sums.second.data();
#pragma GCC ivdep
    for (int x = t.first; x < t.last; ++x) {
      const float weight = alike(p, q, plane_scale[x], x) + 1e-6F;
      weights[x] += weight;
      first[x] += weight * light[x];
      second[x] += weight * light[x] * light[x];
    }
  }

  void add_tap(const Planes3& light, int y, int dx, int dy, float kernel, RowSums& sums) const {
    const Tap t = tap(y, dx, dy);
    const auto row = static_cast<std::ptrdiff_t>(film_.index(0, y));
    const Guides p(film_, row), q(film_, t.offset);
    const float *const plane_scale = plane_scale_.data() + row, *const edge_scale =
                                                                    edge_scale_.data() + row;
    const float *const own_light = luminance_.data() + row, *const light_q =
                                                                luminance_.data() + t.offset;
    const float *const material = material_.data() + row, *const material_q =
                                                              material_.data() + t.offset;
    const float* const variance = variance_.data() + t.offset;
    const float *const r = light.axis[0].data() + t.offset,
                       *const g = light.axis[1].data() + t.offset,
                       *const b = light.axis[2].data() + t.offset;
    float *const weights = sums.weight.data(), *const red = sums.red.data(),
                 *const green = sums.green.data(), *const blue = sums.blue.data(),
                 *const second = sums.second.data();
#pragma GCC ivdep
    for (int x = t.first; x < t.last; ++x) {
      const float same = material[x] == material_q[x] ? kernel : 0.0F;
      const float weight = same * alike(p, q, plane_scale[x], x) *
                           bell(std::fabs(own_light[x] - light_q[x]) * edge_scale[x]);
      weights[x] += weight;
      red[x] += weight * r[x];
      green[x] += weight * g[x];
      blue[x] += weight * b[x];
      second[x] += weight * weight * variance[x];
    }
  }

  void smooth_row(const Planes3& light,
                  int y,
                  int step,
                  RowSums& sums,
                  Planes3& next,
                  Plane& next_variance) const {
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
  Plane luminance_, variance_, edge_scale_, plane_scale_, material_;
};

}  // namespace

void remove_sparkles(const Film& film, Planes3& light) {
  Plane luminance(film.count());
  for (std::size_t i = 0; i < film.count(); ++i)
    luminance[i] = luminance_at(light, i);
  parallel_for(
      static_cast<std::size_t>(film.height),
      [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < film.width; ++x) {
          const std::size_t i = film.index(x, y);
          std::array<float, 3> top{};  // brightest neighbours, falling
          for (int k = 0; k < 9; ++k) {
            if (k == 4) continue;
            const int u = std::clamp(x + k % 3 - 1, 0, film.width - 1),
                      v = std::clamp(y + k / 3 - 1, 0, film.height - 1);
            float value = luminance[film.index(u, v)];
            for (float& place : top) {
              if (value > place) std::swap(value, place);
            }
          }
          if (luminance[i] > top[2]) light.set(i, light.at(i) * (top[2] / luminance[i]));
        }
      },
      rows_per_task);
}

void smooth(const Film& film, Planes3& light, const FilterSettings& settings) {
  Smoother(film, settings).run(light);
}

}  // namespace marketgen::raytrace
