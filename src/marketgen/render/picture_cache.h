// Drawn pictures (labels, price tags, signs, materials) kept on disk between runs, by content.
//
// A file holds raw RGB under $MARKETGEN_CACHE/labels; files that are damaged or cannot be written
// are ignored. Any number of processes may share the folder.
#pragma once
#include <functional>
#include <string>

#include "base/result.h"
#include "geometry/image.h"

namespace marketgen::raytrace {

// The picture for `content` (everything that decides its pixels, as text): read when it is there,
// else drawn and kept.
Result<Image> cached_picture(const std::string& content,
                             const std::function<Result<Image>()>& draw);

}  // namespace marketgen::raytrace
