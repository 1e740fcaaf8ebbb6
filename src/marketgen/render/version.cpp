#include <fmt/format.h>

#include "base/build_info.h"
#include "render/art_fingerprint.h"
#include "render/catalogue_renderer.h"
#include "render/embree_handle.h"
#include "render/render.h"
#include "render/render_fingerprint.h"

namespace marketgen::render {

std::string renderer_version() {
  return RTC_VERSION_STRING;
}

std::string drawing_key() {
  return fmt::format("{} {} {}", program_version, art_fingerprint, render_fingerprint);
}

}  // namespace marketgen::render
