// A heap of loose goods cut to a block's room.
#pragma once
#include <vector>

#include "base/seed.h"
#include "catalog/heap.h"
#include "catalog/product.h"
#include "scene/planogram.h"

namespace marketgen::scene {

// A piece in the frame of the room: X from its left edge, Y from its front edge, Z from its board.
struct HeapItem {
  Pose pose;
  bool on_board = false;
  int layer = 0;  // 0 on the board; one more than the highest of those that it lies on
};

// The settled heap `row`, laid as often as the room is wide and deep, every other time turned
// round. Only pieces that lie wholly in the room, with all that they lie on, are left; of those
// that carry nothing some are missing (`taken`, a share). Empty when the row is damaged.
std::vector<HeapItem> laid_heap(const catalog::HeapRow& row,
                                const catalog::Product& product,
                                const ShelfRoom& room,
                                double taken,
                                Stream& draw);

}  // namespace marketgen::scene
