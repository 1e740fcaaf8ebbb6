// Where the centre of a round base may stand: the floor, less everything nearer than its radius.
//
// Every obstacle is grown by the regular octagon around the base's circle: straight faces keep
// exactly `clearance_mm`, corners up to 8.2 % of it more (1 / cos 22.5 degrees). All coordinates
// are whole millimetres and every test is in integers, so there is no tolerance anywhere. A grown
// obstacle is open: a passage of exactly twice the clearance lets the base through.
#pragma once
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "geometry/rectangle.h"

namespace marketgen::navigation {

// Minkowski sum of the hull of `points` and the octagon of `clearance_mm`; counter-clockwise,
// without collinear corners.
PolygonMm grown_hull(const PolygonMm& points, int clearance_mm);

// Fewer rectangles that cover the same floor: neighbours with a common side become one. Sorted.
std::vector<RectMm> merged(std::vector<RectMm> rectangles);

// Thread-safe: every method is const.
class FreeSpace {
 public:
  // `obstacles` are merged first; `convex` are further convex obstacles in any orientation.
  // Errors: motion.bad_floor for a floor of fewer than three corners, coordinates beyond 1 km, a
  // rectangle that is turned inside out, or a clearance below 1 mm.
  static Result<FreeSpace> make(const PolygonMm& floor,
                                const std::vector<RectMm>& obstacles,
                                int clearance_mm,
                                const std::vector<PolygonMm>& convex = {});

  bool free(PointMm p) const;                 // on the floor and in no grown obstacle
  bool on_floor(PointMm p) const;             // walls and obstacles not looked at
  bool sees(PointMm from, PointMm to) const;  // the straight way between two free points is free
  const std::vector<PolygonMm>& grown() const { return grown_; }
  int clearance_mm() const { return clearance_mm_; }
  // The nearest free place, no farther off than so much; without one, `p` itself.
  PointMm nearest_free(PointMm p, int max_off_mm) const;

 private:
  struct Cell {
    int column, row;
  };
  Cell cell_of(PointMm p) const;
  void index_obstacles();

  PolygonMm floor_;
  int clearance_mm_ = 0;
  std::vector<PolygonMm> grown_;  // obstacles and walls
  std::vector<RectMm> bounds_;    // of each of them
  RectMm area_;                   // of the cells
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;    // of each cell in members_, and one past the last
  std::vector<std::uint32_t> members_;  // grown obstacles whose bounds meet the cell
};

}  // namespace marketgen::navigation
