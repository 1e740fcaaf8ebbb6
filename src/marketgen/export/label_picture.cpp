#include "export/label_picture.h"

#include <fmt/format.h>

#include "io/json.h"
#include "render/picture_cache.h"

namespace marketgen::exporters {

Result<Image> exported_label(const catalog::Product& product) {
  return render::raytrace::cached_picture(
      fmt::format("label {} {}", exported_label_px, io::write_json_line(product)),
      [&] { return assets::draw_label(product, exported_label_px); });
}

}  // namespace marketgen::exporters
