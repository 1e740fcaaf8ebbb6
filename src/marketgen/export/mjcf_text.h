// The text of an MJCF file: lines, and numbers, poses, sizes and colours as its attributes take
// them.
//
// Numbers are single precision in their shortest form that reads back the same.
#pragma once
#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

#include "geometry/pose.h"
#include "physics/goods/contact_shape.h"

namespace marketgen::exporters {

// Groups 0 to 2 are shown by MuJoCo's viewer at once; 0, 1 and 2 on its keyboard hide them, 3 shows
// what things touch with where that is not what they look like.
enum GeomGroup { group_shell, group_fixture, group_product, group_solid };

constexpr double mjcf_glass_alpha = 0.3;

// Appends to one growing text.
class MjcfText {
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

std::string mjcf_vector(const Vec3& v);
// ` pos="..." quat="..."`; the identity rotation is left out.
std::string mjcf_pose(const Pose& pose);
// As many numbers as the shape's geom type takes.
std::string mjcf_size(const assets::ContactShape& shape);
// The inverse of linear_from_srgb (IEC 61966-2-1), to three decimals.
double srgb_from_linear(float linear);
// sRGB and opacity of a linear colour.
std::string mjcf_color(Vec3f linear, double alpha);

}  // namespace marketgen::exporters
