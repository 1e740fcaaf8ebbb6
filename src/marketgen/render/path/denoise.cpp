#include "render/path/denoise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr int tap_reach = 2;                                           // 5 x 5 taps
constexpr float tap_spline[tap_reach + 1] = {0.375F, 0.25F, 0.0625F};  // cubic B-spline
constexpr float off_plane_m = 0.006F, off_plane_per_m = 0.005F;        // per metre from the eye
constexpr float edgeless_share = 1e-3F;  // relative difference that is never an edge
constexpr std::size_t denoise_rows = 8;
constexpr float sparkle_factor = 3;  // over the third brightest neighbour

// How one layer of light is smoothed.
struct LayerSettings {
  int passes;             // reach: 2 * (2^passes - 1) pixels
  float tolerance;        // differences of this many standard deviations are edges
  float paint_tolerance;  // difference in colour that is an edge; 0 = colour does not matter
  float rough_blur;       // how much less edges count on the roughest surfaces, 0..1
};
constexpr LayerSettings irradiance_settings{5, 0.9F, 0, 0}, gloss_settings{4, 1, 0.3F, 0.9F};
// Between these, what a surface mirrors loses its edges: those that are left in it are noise, which
// few bright paths make look like edges.
constexpr float sharp_gloss = 0.1F, soft_gloss = 0.3F;

// Cuts every pixel to a little over the third brightest around it: lone bright samples go, lines
// and areas stay. Their variance goes with them.
void cut_sparkles(int width, int height, ColorPlanes& light, FloatPlane& variance) {
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(std::clamp(y, 0, height - 1)) *
               static_cast<std::size_t>(width) +
           static_cast<std::size_t>(std::clamp(x, 0, width - 1));
  };
  FloatPlane level(variance.size());
  for (std::size_t i = 0; i < level.size(); ++i)
    level[i] = luminance(light.at(i));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::array<float, 3> top{};  // brightest neighbours, falling
      for (int k = 0; k < 9; ++k) {
        if (k == 4) continue;
        float value = level[at(x + k % 3 - 1, y + k / 3 - 1)];
        for (float& place : top) {
          if (value > place) std::swap(value, place);
        }
      }
      const std::size_t i = at(x, y);
      const float limit = sparkle_factor * top[2];
      if (level[i] <= limit) continue;
      const float scale = limit / level[i];
      light.set(i, light.at(i) * scale);
      variance[i] *= scale * scale;
    }
  }
}

// Sums of one row, one entry a pixel.
struct TapSums {
  FloatPlane weight, red, green, blue, second;
  FloatPlane apart, patch;  // of one tap: differences of pixels, from column -1 on, and of patches
  explicit TapSums(std::size_t width)
      : weight(width),
        red(width),
        green(width),
        blue(width),
        second(width),
        apart(width + 2),
        patch(width) {}
  void clear() {
    for (FloatPlane* plane : {&weight, &red, &green, &blue, &second})
      std::fill(plane->begin(), plane->end(), 0.0F);
  }
};

// Smooths one layer of light of a film.
class LayerFilter {
 public:
  LayerFilter(const PathFilm& film, const PictureGuides& guides, const LayerSettings& settings)
      : film_(film),
        guides_(guides),
        settings_(settings),
        plane_scale_(film.count()),
        edge_scale_(film.count()),
        level_(film.count()),
        noise_(film.count()) {
    for (std::size_t i = 0; i < film.count(); ++i) {
      plane_scale_[i] = 1 / (off_plane_m + off_plane_per_m * guides.depth_m[i]);
      const float soft = (guides.roughness[i] - sharp_gloss) / (soft_gloss - sharp_gloss);
      edge_scale_[i] = 1 - settings.rough_blur * std::clamp(soft, 0.0F, 1.0F);
    }
  }

  void run(ColorPlanes& light, FloatPlane& variance) {
    ColorPlanes next(film_.count());
    FloatPlane next_variance(film_.count());
    for (int pass = 0; pass < settings_.passes; ++pass) {
      measure_noise(light, variance);
      for_rows([&](int y, TapSums& sums) {
        smooth_row(light, variance, y, 1 << pass, sums, next, next_variance);
      });
      std::swap(light, next);
      variance.swap(next_variance);
    }
  }

 private:
  template <class Body>
  void for_rows(const Body& body) const {
    const auto tasks = (static_cast<std::size_t>(film_.height) + denoise_rows - 1) / denoise_rows;
    parallel_for(tasks, [&](std::size_t task) {
      TapSums sums(static_cast<std::size_t>(film_.width));
      const int first = static_cast<int>(task * denoise_rows);
      const int last = std::min(film_.height, first + static_cast<int>(denoise_rows));
      for (int y = first; y < last; ++y)
        body(y, sums);
    });
  }

  // Where a row's neighbours start, and the columns whose neighbour is inside.
  struct Tap {
    int first = 0, last = 0;
    std::ptrdiff_t row = 0, neighbours = 0;
  };
  Tap tap(int y, int dx, int dy) const {
    return {std::max(0, -dx),
            std::min(film_.width, film_.width - dx),
            static_cast<std::ptrdiff_t>(y) * film_.width,
            static_cast<std::ptrdiff_t>(y + dy) * film_.width + dx};
  }

  // Guides at the start of a row, and at the neighbours of its pixels.
  struct RowGuides {
    const float *nx, *ny, *nz, *x, *y, *z, *red, *green, *blue;
    RowGuides(const PathFilm& film, const PictureGuides& guides, std::ptrdiff_t start)
        : nx(guides.normal.axis[0].data() + start),
          ny(guides.normal.axis[1].data() + start),
          nz(guides.normal.axis[2].data() + start),
          x(guides.position.axis[0].data() + start),
          y(guides.position.axis[1].data() + start),
          z(guides.position.axis[2].data() + start),
          red(film.paint.axis[0].data() + start),
          green(film.paint.axis[1].data() + start),
          blue(film.paint.axis[2].data() + start) {}
  };

  // Like exp(-x), but ends at 4 and needs no library call.
  static float bell(float x) {
    const float left = std::max(0.0F, 1 - 0.25F * x);
    return left * left * left * left;
  }
  // How much pixel i of row q looks like the same surface as pixel i of row p, 0..1.
  static float alike(
      const RowGuides& p, const RowGuides& q, float plane_scale, float paint_scale, int i) {
    const float turned = std::max(0.0F, p.nx[i] * q.nx[i] + p.ny[i] * q.ny[i] + p.nz[i] * q.nz[i]);
    const float t2 = turned * turned, t4 = t2 * t2, t8 = t4 * t4;
    const float off_plane = std::fabs(p.nx[i] * (q.x[i] - p.x[i]) + p.ny[i] * (q.y[i] - p.y[i]) +
                                      p.nz[i] * (q.z[i] - p.z[i]));
    const float repaint = std::fabs(p.red[i] - q.red[i]) + std::fabs(p.green[i] - q.green[i]) +
                          std::fabs(p.blue[i] - q.blue[i]);
    return t8 * t8 * bell(off_plane * plane_scale + repaint * paint_scale);
  }

  float paint_scale() const {
    return settings_.paint_tolerance > 0 ? 1 / settings_.paint_tolerance : 0;
  }

  // Luminance, and its variance as a mean over 3 x 3 pixels of the same surface: that of a few
  // paths alone is too uncertain.
  void measure_noise(const ColorPlanes& light, const FloatPlane& variance) {
    for (std::size_t i = 0; i < film_.count(); ++i)
      level_[i] = luminance(light.at(i));
    for_rows([&](int y, TapSums& sums) {
      sums.clear();
      for (int dy = -1; dy <= 1; ++dy) {
        if (y + dy < 0 || y + dy >= film_.height) continue;
        for (int dx = -1; dx <= 1; ++dx)
          add_noise(variance, tap(y, dx, dy), sums);
      }
      for (int x = 0; x < film_.width; ++x) {
        const auto k = static_cast<std::size_t>(x);
        noise_[film_.index(x, y)] = sums.second[k] / sums.weight[k];
      }
    });
  }

  // The loops below run over plain arrays that never overlap, so that the compiler may take eight
  // pixels at a time.
  void add_noise(const FloatPlane& variance, const Tap& t, TapSums& sums) const {
    const RowGuides p(film_, guides_, t.row), q(film_, guides_, t.neighbours);
    const float* const noise = variance.data() + t.neighbours;
    const float* const plane_scale = plane_scale_.data() + t.row;
    float *const weights = sums.weight.data(), *const second = sums.second.data();
    const float paint = paint_scale();
#pragma GCC ivdep
    for (int x = t.first; x < t.last; ++x) {
      const float weight = alike(p, q, plane_scale[x], paint, x) + 1e-4F;
      weights[x] += weight;
      second[x] += weight * noise[x];
    }
  }

  // Adds to sums.apart how much one row of pixels and of their neighbours differ beyond what noise
  // alone would do, in units of its variance.
  void add_difference(const Tap& t, TapSums& sums) const {
    const float* const own = level_.data() + t.row;
    const float* const other = level_.data() + t.neighbours;
    const float* const own_noise = noise_.data() + t.row;
    const float* const other_noise = noise_.data() + t.neighbours;
    float* const apart = sums.apart.data() + 1;
    const float edge = 1 / (settings_.tolerance * settings_.tolerance);
#pragma GCC ivdep
    for (int x = t.first; x < t.last; ++x) {
      const float difference = own[x] - other[x];
      const float expected = own_noise[x] + std::min(own_noise[x], other_noise[x]);
      const float flat = edgeless_share * own[x];
      apart[x] += (difference * difference - expected) * edge /
                  (own_noise[x] + other_noise[x] + flat * flat + 1e-12F);
    }
  }

  // Fills sums.patch with the mean of that over 3 x 3 pixels.
  void compare_patches(int y, int dx, int dy, TapSums& sums) const {
    std::fill(sums.apart.begin(), sums.apart.end(), 0.0F);
    float rows = 0;
    for (int j = -1; j <= 1; ++j) {
      const int top = std::min(y + j, y + j + dy), bottom = std::max(y + j, y + j + dy);
      if (top < 0 || bottom >= film_.height) continue;
      add_difference(tap(y + j, dx, dy), sums);
      ++rows;
    }
    const Tap t = tap(y, dx, dy);
    float* const apart = sums.apart.data() + 1;
    apart[t.first - 1] = apart[t.first];
    apart[t.last] = apart[t.last - 1];
    float* const mean = sums.patch.data();
    const float scale = 1 / (3 * rows);
#pragma GCC ivdep
    for (int x = t.first; x < t.last; ++x)
      mean[x] = (apart[x - 1] + apart[x] + apart[x + 1]) * scale;
  }

  void add_tap(const ColorPlanes& light,
               const FloatPlane& variance,
               const Tap& t,
               float kernel,
               TapSums& sums) const {
    const RowGuides p(film_, guides_, t.row), q(film_, guides_, t.neighbours);
    const float* const plane_scale = plane_scale_.data() + t.row;
    const float* const edge_scale = edge_scale_.data() + t.row;
    const float* const apart = sums.patch.data();
    const float* const r = light.axis[0].data() + t.neighbours;
    const float* const g = light.axis[1].data() + t.neighbours;
    const float* const b = light.axis[2].data() + t.neighbours;
    const float* const noise = variance.data() + t.neighbours;
    float *const weights = sums.weight.data(), *const red = sums.red.data(),
                 *const green = sums.green.data(), *const blue = sums.blue.data(),
                 *const second = sums.second.data();
    const float paint = paint_scale();
#pragma GCC ivdep
    for (int x = t.first; x < t.last; ++x) {
      const float weight = kernel * alike(p, q, plane_scale[x], paint, x) *
                           bell(std::max(0.0F, apart[x] * edge_scale[x]));
      weights[x] += weight;
      red[x] += weight * r[x];
      green[x] += weight * g[x];
      blue[x] += weight * b[x];
      second[x] += weight * weight * noise[x];
    }
  }

  void smooth_row(const ColorPlanes& light,
                  const FloatPlane& variance,
                  int y,
                  int step,
                  TapSums& sums,
                  ColorPlanes& next,
                  FloatPlane& next_variance) const {
    sums.clear();
    for (int j = -tap_reach; j <= tap_reach; ++j) {
      if (y + j * step < 0 || y + j * step >= film_.height) continue;
      for (int i = -tap_reach; i <= tap_reach; ++i) {
        if (std::abs(i * step) >= film_.width) continue;
        compare_patches(y, i * step, j * step, sums);
        add_tap(light,
                variance,
                tap(y, i * step, j * step),
                tap_spline[std::abs(i)] * tap_spline[std::abs(j)],
                sums);
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

  const PathFilm& film_;
  const PictureGuides& guides_;
  const LayerSettings settings_;
  FloatPlane plane_scale_, edge_scale_, level_, noise_;
};

}  // namespace

void denoise(PathFilm& film, const PictureGuides& guides) {
  cut_sparkles(film.width, film.height, film.irradiance, film.irradiance_variance);
  LayerFilter(film, guides, irradiance_settings).run(film.irradiance, film.irradiance_variance);
  cut_sparkles(film.width, film.height, film.gloss, film.gloss_variance);
  LayerFilter(film, guides, gloss_settings).run(film.gloss, film.gloss_variance);
}

}  // namespace marketgen::render::raytrace
