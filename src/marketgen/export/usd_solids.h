// What things of a USD export touch with: colliders, which viewers hide (purpose "guide").
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/contact_shape.h"
#include "export/usd_geometry.h"
#include "export/usd_text.h"

namespace marketgen::exporters {

// Its contact material's path, and its mass where that is not its body's.
struct UsdContact {
  std::string material;
  std::optional<double> mass_kg = {};
};

// A box is a cube, a cylinder a cylinder, an ellipsoid (of which USD has none) a convex hull.
void write_usd_collider(UsdText& out,
                        UsdGeometry& geometry,
                        std::string_view name,
                        const assets::ContactShape& shape,
                        const UsdContact& contact);
void write_usd_collider(UsdText& out,
                        UsdGeometry& geometry,
                        std::string_view name,
                        const assets::ContactPiece& piece,
                        const UsdContact& contact);

}  // namespace marketgen::exporters
