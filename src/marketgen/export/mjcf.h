// MJCF: the scene for MuJoCo. Fixtures and products are static geoms on the world body; what has a
// joint (see export/mjcf_fixtures.h) and products in
// a free region are bodies.
#pragma once
#include <string>

#include "base/result.h"
#include "export/exporter.h"

namespace marketgen::exporters {

// The XML text, and the files that it names. Over the primitives that things touch with, in geom
// group 3, lie the meshes of the goods, which touch nothing (options.looks). A robot is attached by
// its first body, with its row's id in front of all names; the key "start" drives it to where it
// stands. Geom names are fixture and product ids. Contact parameters:
// physics/goods/contact_shape.h.
Result<ExportFiles> write_mjcf(const scene::Scene& scene, const ExportOptions& options);

}  // namespace marketgen::exporters
