// Whose work lies in the folder beside an export.
#pragma once
#include "export/exporter.h"

namespace marketgen::exporters {

// Its LICENCES.md: one beside every export that has looks of the store's things. Models of imported
// products are not ours.
BesideFile licences_file(const scene::Scene& scene);

}  // namespace marketgen::exporters
