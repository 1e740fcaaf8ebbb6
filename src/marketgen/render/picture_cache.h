// Drawn pictures (labels, price tags, signs, materials) kept on disk between runs, by content.
//
// Entries (io/cache_entry.h) under $MARKETGEN_CACHE/labels hold raw channels (.pic) or, of print,
// BC1 blocks (.bc1).
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "assets/print/label.h"
#include "base/result.h"
#include "geometry/image.h"
#include "render/stage/block_mips.h"

namespace marketgen::render::raytrace {

// The picture for `content` (everything that decides its pixels, as text): read when it is there,
// else drawn and kept.
Result<Image> cached_picture(const std::string& content,
                             const std::function<Result<Image>()>& draw);

// Print as the renderer keeps it: compressed, the bars of its code beside it.
struct Print {
  BlockMips blocks;
  std::optional<assets::LabelBars> bars;
  bool drawn = false;           // now, not read from the cache
  std::optional<Error> unkept;  // why it could not be put there
};

// The same for print.
Result<Print> cached_print(const std::string& content,
                           const std::function<Result<assets::PrintedPicture>()>& draw);

}  // namespace marketgen::render::raytrace
