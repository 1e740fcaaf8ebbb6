#include "drawing/recognise.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace marketgen::drawing {
namespace {

constexpr double min_floor_mm2 = 12e6;  // of a plan's outline
constexpr double frame_share = 0.08;    // a sheet's frame holds at least that much of floors

// The outlines of shops that are drawn as one line must not cross themselves.
Result<void> check_crossings(const Sketch& sketch, const Walls& walls, const std::string& where) {
  constexpr std::size_t most = 2000;
  for (const Stroke& stroke : sketch.strokes) {
    const bool wall = walls.named ? stroke.role == Role::wall || stroke.role == Role::outline
                                  : stroke.role == Role::unknown;
    const bool one_line = stroke.closed && stroke.points.size() > 3 && stroke.points.size() < most;
    if (!wall || !one_line || is_small_shape(stroke)) continue;
    if (const Vec2* at = crossing_of(stroke.points))
      return Error{
          "drawing.bad_outline",
          where,
          fmt::format("the line from x {:.0f}, y {:.0f} mm crosses another one of the same "
                      "outline; draw the walls so that they meet at corners only",
                      at->x,
                      at->y)};
  }
  return {};
}

// The floor: of all that lines enclose the largest, but for what encloses such floors itself: the
// space within walls, and the frame of a sheet.
const Face* floor_of(const std::vector<Face>& faces, bool named) {
  const Face* best = nullptr;
  for (const Face& face : faces) {
    if (face.area_mm2 < min_floor_mm2) continue;
    const double share = named ? 1 : frame_share;
    if (face.inner_mm2 >= min_floor_mm2 && face.inner_mm2 >= share * face.area_mm2) continue;
    if (best == nullptr || face.area_mm2 > best->area_mm2) best = &face;
  }
  return best;
}

void note_rooms(const std::vector<Face>& faces,
                const Face& floor,
                std::vector<std::string>& warnings) {
  int rooms = 0;
  for (const Face& face : faces) {
    const bool room =
        &face != &floor && face.area_mm2 >= min_floor_mm2 && face.inner_mm2 < min_floor_mm2;
    rooms += room ? 1 : 0;
  }
  if (rooms > 0)
    warnings.push_back(
        fmt::format("{} further rooms are left out: the shop is the largest one, {:.0f} m2",
                    rooms,
                    floor.area_mm2 * 1e-6));
}

Polygon clean(const Polygon& outline, double line_mm, std::vector<std::string>& warnings) {
  constexpr std::size_t max_corners = 200;
  constexpr double slit_mm = 3;
  Polygon polygon = closed_slits(outline, slit_mm);
  polygon = sharpened(simplified(polygon, line_mm), 4 * line_mm);
  double within = line_mm;
  while (polygon.size() > max_corners) {
    within *= 2;
    polygon = simplified(polygon, within);
  }
  if (within > line_mm)
    warnings.push_back(fmt::format(
        "the outline has more than {} corners; those less than {:.0f} mm off a line are left out",
        max_corners,
        within));
  return polygon;
}

Error no_outline(const Sketch& sketch, const Walls& walls, const std::string& where) {
  if (sketch.picture)
    return {"drawing.no_outline",
            where,
            "its dark lines enclose no floor of 12 m2 or more; draw the walls all round the shop "
            "(gaps of "
            "doors may be 0.5 to 8 m wide), and check --floor-plan-scale"};
  const std::string seen =
      walls.segments.empty()
          ? "there are no lines of walls in it"
          : fmt::format(
                "its {} lines of {} enclose no floor of 12 m2 or more",
                walls.segments.size(),
                walls.named ? "layers, classes and ids that are named for walls" : "any kind");
  return {"drawing.no_outline",
          where,
          seen +
              "; close the walls all round the shop (gaps of doors may be 0.5 to 8 m wide), put "
              "them on "
              "a layer named WALL, and check --floor-plan-scale"};
}

Error too_many(const Sketch& sketch, const Walls& walls, const std::string& where) {
  return {"drawing.no_outline",
          where,
          fmt::format("{} lines might be walls; at most {} are looked at: {}",
                      walls.segments.size(),
                      max_wall_segments,
                      sketch.picture
                          ? "is this the picture of a floor plan? Draw walls as dark lines on "
                            "light ground"
                          : "put the walls on a layer (or in a group) named WALL")};
}

}  // namespace

Result<Found> recognise(const Sketch& sketch,
                        const Tolerance& tolerance,
                        const std::string& where) {
  Walls walls = walls_of(sketch, tolerance);
  if (walls.segments.size() > max_wall_segments) return too_many(sketch, walls, where);
  if (!sketch.picture) MARKETGEN_CHECK(check_crossings(sketch, walls, where));
  bridge_gaps(walls, tolerance);
  std::vector<Polygon> lines;
  for (const Segment& segment : walls.segments)
    lines.push_back({segment.from, segment.to});
  for (const Bridge& bridge : walls.bridges)
    lines.push_back({bridge.from, bridge.to});
  const std::vector<Face> faces = faces_of(lines);
  const Face* floor = floor_of(faces, walls.named);
  if (floor == nullptr) return no_outline(sketch, walls, where);
  Found found;
  found.walls_named = walls.named;
  found.outline = clean(floor->outline, tolerance.line_mm, found.warnings);
  if (found.outline.size() < 3) return no_outline(sketch, walls, where);
  if (sketch.picture) found.outline = without_swings(found.outline, tolerance, walls.bridges);
  found.outline = simplified(without_recesses(found.outline, walls.bridges), tolerance.line_mm);
  note_rooms(faces, *floor, found.warnings);
  found.openings = openings_of(sketch, walls, found.outline, tolerance);
  found.columns = columns_of(sketch, found.outline, found.warnings);
  return found;
}

}  // namespace marketgen::drawing
