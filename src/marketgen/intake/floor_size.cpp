#include "intake/floor_size.h"

#include <algorithm>
#include <cmath>

#include "intake/store_size.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

std::string where_of(const plan::Requirement& wish) {
  return "prompt:bytes " + std::to_string(wish.span[0]) + "-" + std::to_string(wish.span[1]);
}

// The floor that was asked for in m2: between "at least" and "at most" where both were said.
const plan::Requirement* area_wish(const Understanding& found, double& area_m2) {
  const plan::Requirement* first = nullptr;
  double low = 0, high = HUGE_VAL;
  for (const plan::Requirement& wish : found.requirements) {
    if (wish.kind != Kind::area || !wish.subject.empty()) continue;
    if (first == nullptr) first = &wish;
    if (wish.comparison != plan::Comparison::at_most) low = std::max(low, wish.value);
    if (wish.comparison != plan::Comparison::at_least) high = std::min(high, wish.value);
  }
  area_m2 = low > 0 && high < HUGE_VAL ? (low + high) / 2 : (low > 0 ? low : high);
  return first;
}

// The store that zones of the areas that were asked for leave room in for others.
double floor_for_zones(const Understanding& found) {
  constexpr double share_of_asked =
      0.36;  // the usual zones beside them want theirs, aisles and tills too
  double sum = 0;
  for (const plan::Requirement& wish : found.requirements)
    if (wish.kind == Kind::area && !wish.subject.empty() &&
        wish.comparison != plan::Comparison::at_most)
      sum += wish.value;
  return sum / share_of_asked;
}

}  // namespace

int rounded_mm(double mm) {
  constexpr double longest_mm = 1e9;
  return static_cast<int>(std::lround(std::min(mm, longest_mm) / 100)) * 100;
}

std::array<int, 2> size_with_area(const catalog::ProfileRow& profile, double area_m2) {
  const double usual = 1e-6 * profile.default_size_mm[0] * profile.default_size_mm[1];
  const double scale = std::sqrt(area_m2 / usual);
  double width = profile.default_size_mm[0] * scale, depth = profile.default_size_mm[1] * scale;
  const auto buildable = [](double side) {
    return std::clamp(side, min_store_side_mm, max_store_side_mm);
  };
  if (buildable(width) != width) depth = 1e6 * area_m2 / (width = buildable(width));
  if (buildable(depth) != depth) width = 1e6 * area_m2 / (depth = buildable(depth));
  return {rounded_mm(width), rounded_mm(depth)};
}

Result<std::array<int, 2>> floor_size_of(const Brief& brief,
                                         const Understanding& found,
                                         const catalog::ProfileRow& profile) {
  if (brief.shell) return std::array{brief.shell->width_mm, brief.shell->depth_mm};
  if (brief.size_mm) return *brief.size_mm;
  const double usual_m2 = 1e-6 * profile.default_size_mm[0] * profile.default_size_mm[1];
  double area_m2 = 0;
  const plan::Requirement* area = area_wish(found, area_m2);
  if (area == nullptr) area_m2 = std::max(usual_m2 * found.size_factor, floor_for_zones(found));
  if (const plan::Requirement* size = found.find(Kind::size)) {
    // One side that was not said is what the area leaves.
    const auto other = [&](double side_mm) {
      return std::clamp<double>(
          rounded_mm(1e6 * area_m2 / side_mm), min_store_side_mm, max_store_side_mm);
    };
    const double width = size->value > 0 ? size->value : other(size->second_value);
    const double depth = size->second_value > 0 ? size->second_value : other(size->value);
    MARKETGEN_CHECK(check_store_size(width, depth, where_of(*size)));
    return std::array{static_cast<int>(std::lround(width)), static_cast<int>(std::lround(depth))};
  }
  const std::array<int, 2> size = size_with_area(profile, area_m2);
  if (area != nullptr) MARKETGEN_CHECK(check_store_size(size[0], size[1], where_of(*area)));
  const auto built = [](int side) {
    return std::clamp(
        side, static_cast<int>(min_store_side_mm), static_cast<int>(max_store_side_mm));
  };
  return std::array{built(size[0]), built(size[1])};
}

bool floor_size_is_said(const Brief& brief, const Understanding& found) {
  double area_m2 = 0;
  return brief.shell || brief.size_mm || found.find(Kind::size) != nullptr ||
         area_wish(found, area_m2) != nullptr;
}

}  // namespace marketgen::intake
