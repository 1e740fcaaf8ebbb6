// What a drawing's file holds, whatever its format: lines, and what they are said to be.
//
// Drawing units, X right, Y up.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/vector.h"

namespace marketgen::drawing {

// What a layer, class, id or block is named for.
enum class Role { unknown, wall, outline, door, window, column, ignored };

// The role that a name says in English, German or Chinese; unknown when it says none. AIA layers
// (A-WALL, A-DOOR, A-GLAZ, S-COLS) are among them.
Role role_of(std::string_view name);

struct Arc {
  Vec2 centre;
  double radius = 0;
  double sweep = 0;  // radians, without its sign
};

struct Stroke {
  std::vector<Vec2> points;
  bool closed = false;
  double line_width = 0;  // as drawn on the floor; 0: a hairline
  Role role = Role::unknown;
  std::optional<Arc> arc;  // the points are a flattened arc
  int symbol = -1;         // strokes of one inserted block or group have the same number
  std::string name;        // layer, class, id and block
};

struct Sketch {
  std::vector<Stroke> strokes;
  std::optional<double> mm_per_unit;  // absent: the file does not say
  double paper_mm_per_unit = 0;       // of a drawing on paper; 0: it is on none
  std::string units;                  // how the file says it, for messages
  double precision = 0;               // drawing units within which a line may be off; 0: exact
  bool picture = false;
  std::vector<std::string> warnings;
};

// More than these is no floor plan.
constexpr std::size_t max_strokes = 200'000;
constexpr std::size_t max_points = 2'000'000;
inline Error too_many_lines(const std::string& where) {
  return {
      "drawing.bad_file",
      where,
      "the drawing has too many lines for a floor plan; leave walls, doors, windows and columns "
      "only"};
}

// `where` names the text in errors: drawing.bad_file. Nothing outside the text is ever read.
Result<Sketch> read_svg(std::string_view text, const std::string& where);
Result<Sketch> read_dxf(std::string_view text, const std::string& where);
// A PNG or JPEG. Errors: also image.bad_file, input.too_large.
Result<Sketch> read_picture(std::string_view bytes, const std::string& where);

}  // namespace marketgen::drawing
