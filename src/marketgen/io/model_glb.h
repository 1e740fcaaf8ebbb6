// Outside models made fit for keeping: one picture, one GLB file with everything in it.
#pragma once
#include <string>

#include "io/model_file.h"

namespace marketgen::io {

// Puts all pictures that a surface shows into one, stacked, and moves the UVs along; factors on a
// picture's colour are painted into it, and pictures that nothing shows are dropped. A picture
// that repeats within a triangle is cut at its border, with a remark, unless it is the only one.
void merge_pictures(OutsideModel& model);

// The model as GLB: its contact pieces are the meshes of a second scene called "contact".
// parse_glb() gives the model back. Same model, same bytes.
Result<std::string> encode_glb(const OutsideModel& model, const std::string& name);

}  // namespace marketgen::io
