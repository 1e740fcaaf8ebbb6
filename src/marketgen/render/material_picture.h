// Materials of the library by themselves: a ball of what fixtures and fruit are made of, a leaning
// slab of what floors, walls and ceilings are laid with.
#pragma once
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalog/rows.h"
#include "geometry/image.h"

namespace marketgen::render {

// `size_px` a side, lit as a shop is. Balls and slabs show about one repeat of a coarse material
// and true size of a fine one. Errors: image.*, io.out_of_memory.
Result<Image> draw_material_picture(const catalog::MaterialRow& material, int size_px);
// All of them in rows, each `size_px` a side, in the given order.
Result<Image> draw_material_sheet(const std::vector<catalog::MaterialRow>& materials,
                                  int size_px,
                                  Progress& progress = silent_progress());

}  // namespace marketgen::render
