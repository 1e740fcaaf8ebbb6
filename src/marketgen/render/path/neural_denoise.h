// The neural denoiser Open Image Denoise 2 (https://www.openimagedenoise.org), where somebody has
// installed it: looked up and loaded at run time, never needed.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "base/result.h"
#include "render/path/path_film.h"

namespace marketgen::render::raytrace {

// libOpenImageDenoise.so.2: the file $MARKETGEN_OIDN (nowhere when that is empty), else in the
// `pyoidn` package of the environment this is installed into, or of the source tree's .venv.
// Nothing when there is none.
std::optional<std::filesystem::path> neural_denoiser_library();

// The film's radiance without noise: what surfaces get of light and what they mirror are denoised
// each by itself, so that neither print nor lamps are touched. `exposure` times the light is what
// the network gets, so that its level suits it. Errors: usage.unavailable when the library cannot
// be loaded, lacks a function or fails. Pixels are not promised to be the same on another
// processor.
Result<ColorPlanes> neural_denoise(const std::filesystem::path& library,
                                   const PathFilm& film,
                                   const PictureGuides& guides,
                                   float exposure);

}  // namespace marketgen::render::raytrace
