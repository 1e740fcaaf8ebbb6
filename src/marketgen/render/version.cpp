#include <fmt/format.h>

#include "render/embree_handle.h"
#include "render/render.h"

namespace marketgen::render {

std::string renderer_version() {
  return RTC_VERSION_STRING;
}

}  // namespace marketgen::render
