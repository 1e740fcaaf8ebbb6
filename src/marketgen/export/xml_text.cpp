#include "export/xml_text.h"

#include <algorithm>
#include <cmath>

#include "geometry/srgb.h"
#include "robots/rotation.h"

namespace marketgen::exporters {

std::string xml_numbers(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) {
    const float shown = static_cast<float>(number) + 0.0F;  // no -0
    text += fmt::format("{}{}", text.empty() ? "" : " ", shown);
  }
  return text;
}

std::string xml_vector(const Vec3& v) {
  return xml_numbers({v.x, v.y, v.z});
}

std::string xml_rpy(const Quaternion& rotation) {
  return xml_vector(robots::rpy_from_rotation(rotation));
}

double srgb_from_linear(float linear) {
  const double l = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  return std::round(srgb_encoded(l) * 1000) / 1000;
}

std::string xml_color(Vec3f linear, double alpha) {
  return fmt::format("{} {} {} {}",
                     srgb_from_linear(linear.x),
                     srgb_from_linear(linear.y),
                     srgb_from_linear(linear.z),
                     alpha);
}

}  // namespace marketgen::exporters
