// MJCF: the scene for MuJoCo. Fixtures and products are static geoms on the world body; what has a
// joint (see export/mjcf_fixtures.h) and products in
// a free region are bodies.
#pragma once
#include <string>

#include "base/result.h"
#include "export/export.h"

namespace marketgen {

// The XML text. Geom names are fixture and product ids. Contact parameters:
// physics/contact_shape.h.
Result<std::string> write_mjcf(const Scene& scene, const ExportOptions& options);

}  // namespace marketgen
