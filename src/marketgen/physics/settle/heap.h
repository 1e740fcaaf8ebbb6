// Loose goods poured into a walled tray in MuJoCo until they rest: how the rows of data/heaps.json
// are made.
#pragma once
#include "base/result.h"
#include "catalog/heap.h"
#include "catalog/product.h"

namespace marketgen::physics {

// Up to three layers of pieces, dropped in turn, any way round; the same heap every time. Pieces
// that lean on the tray's wall and lie on others are left out, as their wall will be gone. Errors:
// physics.failed, also when the heap does not come to rest; assets.*.
Result<catalog::HeapRow> settle_heap(const catalog::Product& product);

}  // namespace marketgen::physics
