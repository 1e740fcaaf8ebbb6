// What things of a USD export touch with: colliders, which viewers hide (purpose "guide").
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "assets/contact_shape.h"
#include "export/usd_geometry.h"
#include "export/usd_text.h"

namespace marketgen::exporters {

// A box is a cube, a cylinder a cylinder, an ellipsoid (of which USD has none) a convex hull.
// `material`: path of its contact material.
void write_usd_collider(UsdText& out,
                        UsdGeometry& geometry,
                        std::string_view name,
                        const assets::ContactShape& shape,
                        std::string_view material);
void write_usd_collider(UsdText& out,
                        UsdGeometry& geometry,
                        std::string_view name,
                        const assets::ContactPiece& piece,
                        std::string_view material);

}  // namespace marketgen::exporters
