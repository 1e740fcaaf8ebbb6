#include "drawing/floor_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/safe_line.h"
#include "base/text.h"
#include "drawing/recognise.h"
#include "drawing/shell_of.h"
#include "drawing/svg_path.h"
#include "io/file.h"
#include "io/png.h"

namespace marketgen::drawing {
namespace {

constexpr Tolerance exact{.join_mm = 20, .line_mm = 10};

// Of a drawing's beginning: blanks and a byte order mark left out.
std::string_view head_of(std::string_view bytes) {
  std::string_view head = bytes.substr(0, 4096);
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  while (!head.empty() && (head.front() == ' ' || head.front() == '\n' || head.front() == '\r' ||
                           head.front() == '\t'))
    head.remove_prefix(1);
  return head;
}

Result<Sketch> read_sketch(std::string_view bytes, const std::string& where) {
  const std::string_view head = head_of(bytes);
  if (head.empty()) return Error{"drawing.bad_file", where, "the file is empty"};
  if (io::is_png(head) || head.starts_with("\xFF\xD8\xFF")) return read_picture(bytes, where);
  if (head.starts_with('<')) return read_svg(bytes, where);
  const bool dxf = head.starts_with("AutoCAD Binary DXF") || head.starts_with("AC10") ||
                   head.starts_with('0') || head.starts_with("999");
  if (dxf) return read_dxf(bytes, where);
  return Error{"drawing.bad_file",
               where,
               "this is no SVG, DXF, PNG or JPEG; save the floor plan as one of these"};
}

void rescale(Sketch& sketch, double by) {
  for (Stroke& stroke : sketch.strokes) {
    for (Vec2& p : stroke.points)
      p = p * by;
    stroke.line_width *= by;
    if (!stroke.arc) continue;
    stroke.arc->centre = stroke.arc->centre * by;
    stroke.arc->radius *= by;
  }
  sketch.precision *= by;
}

// In the picture's or drawing's middle, so that numbers stay small.
void centre(Sketch& sketch) {
  Vec2 low{1e18, 1e18}, high{-1e18, -1e18};
  for (const Stroke& stroke : sketch.strokes) {
    for (const Vec2& p : stroke.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const Vec2 middle = (low + high) * 0.5;
  for (Stroke& stroke : sketch.strokes) {
    for (Vec2& p : stroke.points)
      p = p - middle;
    if (stroke.arc) stroke.arc->centre = stroke.arc->centre - middle;
  }
}

Tolerance tolerance_of(const Sketch& sketch) {
  if (!sketch.picture) return exact;
  return {std::max(exact.join_mm, 2 * sketch.precision),
          std::max(exact.line_mm, 1.5 * sketch.precision)};
}

Result<FloorPlan> plan_of(Sketch sketch, double mm_per_unit, const std::string& where) {
  constexpr double widest_mm = 1e6;  // beyond it no line is one of a shop
  rescale(sketch, mm_per_unit);
  for (const Stroke& stroke : sketch.strokes) {
    for (const Vec2& p : stroke.points) {
      if (std::abs(p.x) < widest_mm && std::abs(p.y) < widest_mm) continue;
      return Error{
          "drawing.no_scale",
          where,
          "the drawing is more than a kilometre wide at this scale; say the right one with "
          "--floor-plan-scale, and leave out lines that are far away"};
    }
  }
  const Tolerance tolerance = tolerance_of(sketch);
  MARKETGEN_TRY(const Found found, recognise(sketch, tolerance, where));
  MARKETGEN_TRY(FloorPlan plan, shell_of(found, tolerance, where));
  plan.mm_per_unit = mm_per_unit;
  plan.warnings.insert(plan.warnings.begin(), sketch.warnings.begin(), sketch.warnings.end());
  constexpr double named = 1, by_shape = 0.8, by_pixels = 0.7;
  plan.outline_confidence = sketch.picture ? by_pixels : (found.walls_named ? named : by_shape);
  plan.openings_confidence = plan.outline_confidence;
  plan.columns_confidence = plan.outline_confidence;
  if (plan.shell.openings.empty())
    plan.warnings.emplace_back(
        "no door was found in the outer walls; doors are put where they suit the shop");
  return plan;
}

struct KnownScale {
  double mm_per_unit = 0;
  std::string from;
};

// The scale that a flag or the file itself says; 0 when neither does.
Result<KnownScale> scale_of(const Sketch& sketch,
                            const ReadOptions& options,
                            const std::string& where) {
  if (options.scale && options.scale->of_paper > 0) {
    if (sketch.paper_mm_per_unit <= 0)
      return Error{
          "drawing.no_scale",
          where,
          "1:N needs a drawing on paper, whose width is in mm, cm or in; say how long one of "
          "its units is: --floor-plan-scale \"1 unit = 10 mm\""};
    return KnownScale{sketch.paper_mm_per_unit * options.scale->of_paper, "--floor-plan-scale"};
  }
  if (options.scale) return KnownScale{options.scale->mm_per_unit, "--floor-plan-scale"};
  if (sketch.mm_per_unit) return KnownScale{*sketch.mm_per_unit, sketch.units};
  return KnownScale{};
}

// Of all lines, in drawing units.
double extent_of(const Sketch& sketch) {
  Vec2 low{1e18, 1e18}, high{-1e18, -1e18};
  for (const Stroke& stroke : sketch.strokes) {
    if (stroke.role == Role::ignored) continue;
    for (const Vec2& p : stroke.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return std::max(high.x - low.x, high.y - low.y);
}

// By the inner size that is known: the floor is found at a guess, measured, and found again.
Result<FloorPlan> plan_by_size(const Sketch& sketch,
                               const ReadOptions& options,
                               const std::string& where) {
  const double known = std::max(options.width_mm, options.depth_mm);
  double mm_per_unit = known / extent_of(sketch);
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    MARKETGEN_TRY(const FloorPlan guess, plan_of(sketch, mm_per_unit, where));
    const double by_width = options.width_mm > 0 ? options.width_mm / guess.shell.width_mm : 0;
    const double by_depth = options.depth_mm > 0 ? options.depth_mm / guess.shell.depth_mm : 0;
    mm_per_unit *= by_width > 0 && by_depth > 0 ? (by_width + by_depth) / 2 : by_width + by_depth;
  }
  return plan_of(sketch, mm_per_unit, where);
}

Error no_scale(const Sketch& sketch, const std::string& where) {
  return {
      "drawing.no_scale",
      where,
      sketch.picture
          ? "a picture does not say how large a pixel is on the floor: say --floor-plan-scale \"1 "
            "px "
            "= 10 mm\", or the inner size of the shop in words or with --size"
          : "the drawing says no unit of length ($INSUNITS of a DXF, width in mm of an SVG): say "
            "--floor-plan-scale \"1 unit = 10 mm\", or the inner size of the shop in words or with "
            "--size"};
}

}  // namespace

Result<Scale> parse_scale(std::string_view text, const std::string& where) {
  const Error bad{
      "usage.bad_flag",
      where,
      fmt::format("\"{}\" is no scale; say how long one unit or pixel of the drawing is, as "
                  "in \"1 unit = 10 mm\" or \"0.01 m\", or \"1:100\"",
                  safe_line(text, 60))};
  const std::string lower = lower_ascii(text);
  if (const std::size_t colon = lower.find(':'); colon != std::string::npos) {
    const auto one = read_length(lower.substr(0, colon));
    const auto many = read_length(lower.substr(colon + 1));
    if (!one || !many || one->unit_mm > 0 || many->unit_mm > 0) return bad;
    return Scale{0, many->value / one->value};
  }
  double units = 1;
  std::string length = lower;
  if (const std::size_t equals = lower.find('='); equals != std::string::npos) {
    std::string left = lower.substr(0, equals);
    for (const std::string_view word : {"units", "unit", "pixels", "pixel", "px"}) {
      const std::size_t at = left.find(word);
      if (at == std::string::npos) continue;
      left.erase(at);
      break;
    }
    const auto count = read_length(left);
    if (!count || count->unit_mm > 0) return bad;
    units = count->value;
    length = lower.substr(equals + 1);
  }
  std::erase(length, ' ');
  const bool feet = length.ends_with("ft");
  if (feet) length.erase(length.size() - 2);
  const auto read = read_length(length);
  const double unit_mm = feet ? 304.8 : (read ? read->unit_mm : 0);
  if (!read || unit_mm <= 0) return bad;
  return Scale{read->value * unit_mm / units, 0};
}

Result<FloorPlan> read_floor_plan_bytes(std::string_view bytes,
                                        const std::string& where,
                                        const ReadOptions& options) {
  MARKETGEN_TRY(Sketch sketch, read_sketch(bytes, where));
  if (sketch.strokes.empty() || extent_of(sketch) <= 0)
    return Error{"drawing.no_outline",
                 where,
                 "there are no lines in the drawing; draw the walls of the shop"};
  centre(sketch);
  MARKETGEN_TRY(const KnownScale scale, scale_of(sketch, options, where));
  if (scale.mm_per_unit > 0) {
    MARKETGEN_TRY(FloorPlan plan, plan_of(sketch, scale.mm_per_unit, where));
    plan.scale_from = scale.from;
    return plan;
  }
  if (options.width_mm <= 0 && options.depth_mm <= 0) return no_scale(sketch, where);
  MARKETGEN_TRY(FloorPlan plan, plan_by_size(sketch, options, where));
  plan.scale_from = "the size of the shop";
  return plan;
}

Result<FloorPlan> read_floor_plan(const std::filesystem::path& path, const ReadOptions& options) {
  MARKETGEN_TRY(const std::string bytes, io::read_file(path, max_drawing_bytes));
  return read_floor_plan_bytes(bytes, path.string(), options);
}

}  // namespace marketgen::drawing
