#include "export/label_picture.h"

#include <fmt/format.h>

#include "io/json.h"
#include "render/picture_cache.h"

namespace marketgen::exporters {

Result<Image> exported_label(const catalog::Product& product, int height_px) {
  return render::raytrace::cached_picture(
      fmt::format("label {} {}", height_px, io::write_json_line(product)),
      [&] { return assets::draw_label(product, height_px); });
}

Result<Image> exported_price_tag(const catalog::Product& product, bool promotion, int height_px) {
  return render::raytrace::cached_picture(
      fmt::format(
          "tag {} {}{}", height_px, promotion ? "promotion " : "", io::write_json_line(product)),
      [&] { return assets::draw_price_tag(product, promotion, height_px); });
}

}  // namespace marketgen::exporters
