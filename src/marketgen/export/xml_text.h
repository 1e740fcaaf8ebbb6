// The text of an XML file: lines, and numbers and colours as its attributes take them.
#pragma once
#include <fmt/format.h>

#include <initializer_list>
#include <iterator>
#include <string>
#include <utility>

#include "geometry/pose.h"

namespace marketgen::exporters {

// Appends to one growing text.
class XmlText {
 public:
  template <class... Args>
  void line(int depth, fmt::format_string<Args...> format, Args&&... args) {
    text_.append(static_cast<std::size_t>(2 * depth), ' ');
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

// With blanks between them; single precision in their shortest form that reads back the same.
std::string xml_numbers(std::initializer_list<double> numbers);
std::string xml_vector(const Vec3& v);
// Roll, pitch and yaw about fixed axes, radians.
std::string xml_rpy(const Quaternion& rotation);

// The inverse of linear_from_srgb (IEC 61966-2-1), to three decimals.
double srgb_from_linear(float linear);
// sRGB and opacity of a linear colour.
std::string xml_color(Vec3f linear, double alpha);

}  // namespace marketgen::exporters
