#include "render/sensor/color_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/print/color.h"
#include "base/parallel.h"
#include "base/seed.h"
#include "geometry/srgb.h"
#include "render/cameras/view.h"

namespace marketgen::render {
namespace {

std::uint8_t srgb_code(double linear) {
  const double l = std::clamp(linear, 0.0, 1.0);
  return static_cast<std::uint8_t>(srgb_encoded(l) * 255 + 0.5);
}

std::array<double, 256> linear_of_codes() {
  std::array<double, 256> table{};
  for (std::size_t code = 0; code < table.size(); ++code)
    table[code] = static_cast<double>(assets::linear_from_srgb(static_cast<std::uint8_t>(code)));
  return table;
}

}  // namespace

Image noisy_color(const Image& picture,
                  const Camera& camera,
                  const ColorSensor& sensor,
                  const NoiseSource& source) {
  const Seed noise = Seed(source.seed).child("color noise", source.frame);
  const raytrace::View view(camera);
  const std::array<double, 256> linear = linear_of_codes();
  Image result(picture.width, picture.height);
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    Stream draw = noise.child("row", row).stream();
    const int y = static_cast<int>(row);
    for (int x = 0; x < picture.width; ++x) {
      const raytrace::Ray ray =
          view.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      const double cosine = static_cast<double>(view.depth_of(ray, 1));
      const double gain = 1 - sensor.vignette * (1 - cosine * cosine * cosine * cosine);
      for (int c = 0; c < 3; ++c) {
        const double electrons = gain * linear[picture.at(x, y)[c]] * sensor.full_well_e;
        const double sigma = std::sqrt(electrons + sensor.read_noise_e * sensor.read_noise_e);
        result.at(x, y)[c] = srgb_code((electrons + sigma * draw.normal()) / sensor.full_well_e);
      }
    }
  });
  return result;
}

}  // namespace marketgen::render
