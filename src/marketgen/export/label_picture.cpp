#include "export/label_picture.h"

#include <fmt/format.h>

#include "io/json.h"
#include "render/picture_cache.h"

namespace marketgen {

Result<Image> exported_label(const Product& product) {
  return raytrace::cached_picture(
      fmt::format("label {} {}", exported_label_px, write_json_line(product)),
      [&] { return draw_label(product, exported_label_px); });
}

}  // namespace marketgen
