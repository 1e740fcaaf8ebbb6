#include "export/goods_look.h"

#include <algorithm>

#include "base/parallel.h"
#include "export/label_picture.h"
#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen::exporters {
namespace {

GoodsLook goods_look(const catalog::Product& product, assets::Detail detail, LabelCoding coding) {
  Result<assets::ProductModel> model = assets::make_product_model(product, detail);
  if (!model.ok()) return {{}, {}, model.error()};
  GoodsLook look{std::move(model).value(), {}, {}};
  if (std::ranges::none_of(look.model.surfaces,
                           [](const assets::Surface& s) { return s.texture == "label"; }))
    return look;
  const Result<Image> label = exported_label(product);
  Result<std::string> bytes = !label.ok() ? label.error()
                              : coding == LabelCoding::jpeg
                                  ? io::encode_jpeg(*label, io::JpegUse::texture)
                                  : io::encode_png(*label);
  if (!bytes.ok())
    look.error = bytes.error();
  else
    look.label = std::move(bytes).value();
  return look;
}

}  // namespace

std::vector<GoodsLook> goods_looks(const scene::Scene& scene,
                                   assets::Detail detail,
                                   LabelCoding coding) {
  std::vector<bool> stands(scene.catalog.size(), false);
  for (const scene::SceneProduct& item : scene.products)
    stands[item.sku] = true;
  return parallel_map(scene.catalog.size(), [&](std::size_t sku) {
    return stands[sku] ? goods_look(scene.catalog[sku], detail, coding) : GoodsLook{};
  });
}

}  // namespace marketgen::exporters
