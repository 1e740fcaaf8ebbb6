// The pictures that every store comes with: top, entrance, aisle, checkout.
#pragma once
#include <filesystem>

#include "base/progress.h"
#include "base/result.h"
#include "scene/scene.h"

namespace marketgen::store {

constexpr int preview_width_px = 960, preview_height_px = 540;

// Writes <name>.png into `folder` for each standard view.
Result<void> draw_previews(const scene::Scene& scene,
                           const std::filesystem::path& folder,
                           Progress& progress);

}  // namespace marketgen::store
