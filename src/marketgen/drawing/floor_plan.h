// Floor plans: a drawing of a shop's walls, columns and doors becomes the shell of a plan.
//
// SVG, DXF, PNG and JPEG, told by what is in the file. Layers, classes, ids and blocks that are
// named for walls, doors, windows and columns (English, German, Chinese) say what their lines are;
// where nothing is named, shapes say it: the outermost lines that close, gaps of 0.5 to 8 m in
// them, swings of doors, small closed shapes on the floor.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "plan/plan.h"

namespace marketgen::drawing {

// How large a drawing is: millimetres of floor in one of its units, or 1 : `of_paper`.
struct Scale {
  double mm_per_unit = 0;
  double of_paper = 0;
};
// "10 mm", "1 unit = 10 mm", "1 px = 0.02 m", "1:100". Error: usage.bad_flag at `where`.
Result<Scale> parse_scale(std::string_view text, const std::string& where);

struct ReadOptions {
  std::optional<Scale> scale;  // beats what the file says
  // The inner size of the shop, where neither says it; 0: not known. One of them is enough.
  double width_mm = 0, depth_mm = 0;
  double usual_area_m2 = 0;  // of a shop like this, for drawings that say no scale; 0: an error
};

// Where the shop is open, in the shell's frame, whether or not a plan can say it.
struct DrawnOpening {
  PointMm from{}, to{};
  plan::OpeningKind kind = plan::OpeningKind::entrance;
  bool in_shell = false;
};

struct FloorPlan {
  plan::Shell shell;
  std::vector<DrawnOpening> openings;
  double mm_per_unit = 1;
  std::string scale_from;  // what said so
  double turned_deg = 0;   // of the drawing, clockwise, so that its walls run along x and y
  // 0 to 1: 1 where layers are named or files say units, less where shapes or pictures had to.
  double outline_confidence = 1, openings_confidence = 1, columns_confidence = 1;
  std::vector<std::string> warnings;
};

constexpr std::uint64_t max_drawing_bytes = 64U << 20;

// Errors: input.not_found, input.too_large, io.cannot_read and those below.
Result<FloorPlan> read_floor_plan(const std::filesystem::path& path, const ReadOptions& options);
// The same of a file's bytes. Errors: drawing.bad_file, drawing.no_scale, drawing.no_outline,
// drawing.bad_outline, image.bad_file, input.too_large.
Result<FloorPlan> read_floor_plan_bytes(std::string_view bytes,
                                        const std::string& where,
                                        const ReadOptions& options);

}  // namespace marketgen::drawing
