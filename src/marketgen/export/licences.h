// Whose work lies in the folder beside an export.
#pragma once
#include <string>

#include "scene/scene.h"

namespace marketgen::exporters {

// The text of its LICENCES.md. Models of imported products are not ours.
std::string export_licences(const scene::Scene& scene);

}  // namespace marketgen::exporters
