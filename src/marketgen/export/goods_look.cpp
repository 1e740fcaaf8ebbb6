#include "export/goods_look.h"

#include <algorithm>

#include "base/parallel.h"
#include "export/label_picture.h"
#include "io/png.h"

namespace marketgen::exporters {
namespace {

GoodsLook goods_look(const catalog::Product& product, assets::Detail detail) {
  Result<assets::ProductModel> model = assets::make_product_model(product, detail);
  if (!model.ok()) return {{}, {}, model.error()};
  GoodsLook look{std::move(model).value(), {}, {}};
  if (std::ranges::none_of(look.model.surfaces,
                           [](const assets::Surface& s) { return s.texture == "label"; }))
    return look;
  const Result<Image> label = exported_label(product);
  Result<std::string> png = label.ok() ? io::encode_png(*label) : label.error();
  if (!png.ok())
    look.error = png.error();
  else
    look.label_png = std::move(png).value();
  return look;
}

}  // namespace

std::vector<GoodsLook> goods_looks(const scene::Scene& scene, assets::Detail detail) {
  std::vector<bool> stands(scene.catalog.size(), false);
  for (const scene::SceneProduct& item : scene.products)
    stands[item.sku] = true;
  return parallel_map(scene.catalog.size(), [&](std::size_t sku) {
    return stands[sku] ? goods_look(scene.catalog[sku], detail) : GoodsLook{};
  });
}

}  // namespace marketgen::exporters
