#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "base/text.h"
#include "plan/validation.h"

namespace marketgen::plan {
namespace {

constexpr double min_outline_m2 = 12;  // an entrance, a till and one shelf

std::string mm(int value) {
  return with_thousands(value) + " mm";
}

Error shell_fault(const PlanCheck& check, const std::string& pointer, std::string message) {
  return {"plan.bad_shell", check.at("/shell/" + pointer), std::move(message)};
}

// Twice the signed area of the triangle a, b, c: positive when it turns left.
std::int64_t turn(PointMm a, PointMm b, PointMm c) {
  return std::int64_t{b[0] - a[0]} * (c[1] - a[1]) - std::int64_t{b[1] - a[1]} * (c[0] - a[0]);
}

// c lies on the segment a-b, which it is in line with.
bool within_span(PointMm a, PointMm b, PointMm c) {
  return std::min(a[0], b[0]) <= c[0] && c[0] <= std::max(a[0], b[0]) &&
         std::min(a[1], b[1]) <= c[1] && c[1] <= std::max(a[1], b[1]);
}

int sign(std::int64_t value) {
  return static_cast<int>(value > 0) - static_cast<int>(value < 0);
}

bool segments_meet(PointMm a, PointMm b, PointMm c, PointMm d) {
  const int c_side = sign(turn(a, b, c));
  const int d_side = sign(turn(a, b, d));
  const int a_side = sign(turn(c, d, a));
  const int b_side = sign(turn(c, d, b));
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && within_span(a, b, c)) || (d_side == 0 && within_span(a, b, d)) ||
         (a_side == 0 && within_span(c, d, a)) || (b_side == 0 && within_span(c, d, b));
}

Result<void> check_corners(const PlanCheck& check, const PolygonMm& outline) {
  const Shell& shell = check.plan.shell;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PointMm corner = outline[i];
    const std::string pointer = "outline_mm/" + std::to_string(i);
    if (corner[0] < 0 || corner[0] > shell.width_mm || corner[1] < 0 ||
        corner[1] > shell.depth_mm) {
      return shell_fault(check,
                         pointer,
                         "the corner lies outside width_mm x depth_mm (" + mm(shell.width_mm) +
                             " x " + mm(shell.depth_mm) + ")");
    }
    if (corner == outline[(i + 1) % outline.size()]) {
      return shell_fault(check, pointer, "two corners in a row are the same point");
    }
  }
  return {};
}

// Edges that share a corner may touch only there; all others not at all.
Result<void> check_crossings(const PlanCheck& check, const PolygonMm& outline) {
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const PointMm a = outline[i];
    const PointMm b = outline[(i + 1) % count];
    const PointMm after = outline[(i + 2) % count];
    const bool folds_back =
        turn(a, b, after) == 0 && (within_span(a, b, after) || within_span(b, after, a));
    bool meets = folds_back;
    for (std::size_t k = i + 2; k < count && !meets; ++k) {
      const bool neighbours = (k + 1) % count == i;
      meets = !neighbours && segments_meet(a, b, outline[k], outline[(k + 1) % count]);
    }
    if (meets) {
      return shell_fault(check,
                         "outline_mm/" + std::to_string(i),
                         "the wall from this corner to the next meets another wall; an outline "
                         "does not cross or touch itself");
    }
  }
  return {};
}

Result<void> check_outline(const PlanCheck& check, const PolygonMm& outline) {
  if (outline.size() < 4) {
    return shell_fault(
        check,
        "outline_mm",
        "an outline needs at least 4 corners, not " + std::to_string(outline.size()));
  }
  MARKETGEN_CHECK(check_corners(check, outline));
  MARKETGEN_CHECK(check_crossings(check, outline));
  const double area = area_m2(outline);
  if (area < 0) {
    return shell_fault(check,
                       "outline_mm",
                       "the corners run clockwise; list them "
                       "counter-clockwise, seen from above");
  }
  if (area < min_outline_m2) {
    return shell_fault(check, "outline_mm", "the outline holds less than 12 m2");
  }
  return {};
}

Result<void> check_columns(const PlanCheck& check) {
  const Shell& shell = check.plan.shell;
  for (std::size_t i = 0; i < shell.columns.size(); ++i) {
    const Column& column = shell.columns[i];
    const int half = column.size_mm / 2;
    const bool inside =
        column.x_mm >= half && column.x_mm + half <= shell.width_mm && column.y_mm >= half &&
        column.y_mm + half <= shell.depth_mm &&
        (!shell.outline_mm || contains(*shell.outline_mm, PointMm{column.x_mm, column.y_mm}));
    if (inside) continue;
    return shell_fault(check,
                       "columns/" + std::to_string(i),
                       "the column at " + mm(column.x_mm) + ", " + mm(column.y_mm) +
                           " does not stand inside the shop");
  }
  return {};
}

}  // namespace

Result<void> check_shell(const PlanCheck& check) {
  const Shell& shell = check.plan.shell;
  if (shell.outline_mm) MARKETGEN_CHECK(check_outline(check, *shell.outline_mm));
  return check_columns(check);
}

}  // namespace marketgen::plan
