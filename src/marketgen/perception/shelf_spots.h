// Where on the boards of a shelf something of a size may stand: what masks are to a heap of goods.
//
// Goods on a shelf stand upright with their fronts to the aisle, so what is left open is which
// stretch of which board, and how far behind its edge. The one source here sweeps along every
// board; another (facings cut out by a network) takes its place behind the same interface. Base
// frame, metres.
#pragma once
#include <cstddef>
#include <vector>

#include "perception/view_cloud.h"

namespace marketgen::perception {

// As agent/aisle_map.h has it, in the frame of the pictures.
struct BoardAhead {
  Pose base_from_board;  // middle of its front edge: X right, Y into the shelf, Z up
  double width_m = 0, depth_m = 0, clearance_m = 0;
};

// Of the front of what stands there, in the board's frame.
struct ShelfSpot {
  std::size_t board = 0;  // in the boards that were given
  double x_m = 0;         // its middle
  double front_m = 0;     // behind the board's edge
};

class SpotSource {
 public:
  virtual ~SpotSource() = default;
  // For a product of this size: x along the board, z up.
  virtual std::vector<ShelfSpot> spots(const std::vector<ViewCloud>& views,
                                       const std::vector<BoardAhead>& boards,
                                       Vec3f size) const = 0;
};

// Every 4 mm of each board that the pictures show, at the distance that was measured there.
class SweptSpots : public SpotSource {
 public:
  std::vector<ShelfSpot> spots(const std::vector<ViewCloud>& views,
                               const std::vector<BoardAhead>& boards,
                               Vec3f size) const override;
};

}  // namespace marketgen::perception
