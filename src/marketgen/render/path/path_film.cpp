#include "render/path/path_film.h"

#include <algorithm>

#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float min_albedo = 2e-3F;  // darker surfaces have no irradiance to speak of

Vec3f over_albedo(Vec3f light, Vec3f albedo) {
  const auto divided = [](float a, float b) { return b > min_albedo ? a / b : 0; };
  return {divided(light.x, albedo.x), divided(light.y, albedo.y), divided(light.z, albedo.z)};
}

// Of the mean of `count` values, from their sum and the sum of their squares.
float variance_of_mean(float sum, float squares, float count) {
  if (count < 2) return sum * sum;
  return std::max(0.0F, squares - sum * sum / count) / (count * (count - 1));
}

}  // namespace

void PathSums::add(const PathLight& path) {
  light.albedo += path.albedo;
  light.paint += path.paint;
  light.diffuse += path.diffuse;
  light.gloss += path.gloss;
  light.glow += path.glow;
  light.beyond += path.beyond;
  const float lit = luminance(over_albedo(path.diffuse, path.albedo));
  irradiance += lit;
  irradiance2 += lit * lit;
  const float mirrored = luminance(path.gloss);
  gloss += mirrored;
  gloss2 += mirrored * mirrored;
}

PathFilm::PathFilm(int w, int h, const std::vector<PathSums>& sums, int paths)
    : width(w),
      height(h),
      albedo(sums.size()),
      paint(sums.size()),
      irradiance(sums.size()),
      gloss(sums.size()),
      glow(sums.size()),
      beyond(sums.size()),
      irradiance_variance(sums.size()),
      gloss_variance(sums.size()) {
  const auto n = static_cast<float>(paths);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const PathSums& s = sums[i];
    const Vec3f color = s.light.albedo / n, diffuse = s.light.diffuse / n;
    albedo.set(i, color);
    paint.set(i, s.light.paint / n);
    irradiance.set(i, over_albedo(diffuse, color));
    gloss.set(i, s.light.gloss / n);
    // What is too dark to divide by is kept as it is.
    glow.set(i, s.light.glow / n + diffuse - color * irradiance.at(i));
    beyond.set(i, s.light.beyond / n);
    irradiance_variance[i] = variance_of_mean(s.irradiance, s.irradiance2, n);
    gloss_variance[i] = variance_of_mean(s.gloss, s.gloss2, n);
  }
}

}  // namespace marketgen::render::raytrace
