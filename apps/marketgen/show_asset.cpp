#include "show_asset.h"

#include <fmt/format.h>

#include "assets/asset_detail.h"
#include "assets/print/label.h"
#include "io/json.h"
#include "io/output.h"
#include "io/picture_file.h"
#include "render/contact_sheet.h"
#include "render/material_picture.h"
#include "show_fixture.h"

namespace marketgen::app {
namespace {

constexpr int label_px = 1024;

Result<void> put_picture(io::Outputs& outputs, const std::string& name, const Image& picture) {
  return outputs.put(name, [&](const auto& file) { return io::write_picture(file, picture); });
}

Result<void> show_product(const catalog::Product& product,
                          const catalog::Catalog& catalog,
                          const ShownAsset& asset,
                          io::Outputs& outputs) {
  if (!asset.picture.empty()) {
    MARKETGEN_TRY(const Image picture, render::draw_product(product, asset.size_px));
    MARKETGEN_CHECK(put_picture(outputs, asset.picture, picture));
  }
  if (!asset.label.empty()) {
    MARKETGEN_TRY(const Image label, assets::draw_label(product, label_px));
    MARKETGEN_CHECK(put_picture(outputs, asset.label, label));
  }
  MARKETGEN_TRY(const assets::ProductDetail detail, assets::detail_of(product, catalog));
  fmt::print("{}", io::write_json(detail));
  return {};
}

Result<void> show_material(const catalog::MaterialRow& material,
                           const ShownAsset& asset,
                           io::Outputs& outputs) {
  if (!asset.picture.empty()) {
    MARKETGEN_TRY(const Image picture, render::draw_material_picture(material, asset.size_px));
    MARKETGEN_CHECK(put_picture(outputs, asset.picture, picture));
  }
  fmt::print("{}", io::write_json(material));
  return {};
}

Error unknown_asset(const catalog::Catalog& catalog, const std::string& id) {
  std::vector<std::string_view> names;
  for (const catalog::Product& p : catalog.products)
    names.push_back(p.sku);
  for (const catalog::FixtureKind& k : catalog.fixture_kinds)
    names.push_back(k.kind);
  for (const catalog::MaterialRow& m : catalog.materials)
    names.push_back(m.id);
  return catalog::unknown_name("catalog.unknown_sku", id, "asset", id, names);
}

}  // namespace

Result<void> show_asset(const catalog::Catalog& catalog, const ShownAsset& asset) {
  MARKETGEN_CHECK(io::check_picture_ending(asset.picture, "--picture"));
  MARKETGEN_CHECK(io::check_picture_ending(asset.label, "--label"));
  const catalog::Product* product = catalog.product(asset.id);
  const catalog::FixtureKind* kind = catalog.fixture_kind(asset.id);
  const catalog::MaterialRow* material = catalog.material(asset.id);
  if (product == nullptr && !asset.label.empty())
    return Error{"usage.bad_flag", "--label", "only products have a printed label"};
  if (kind == nullptr && !asset.joints.empty())
    return Error{"usage.bad_flag", "--joint", "only facilities have joints"};
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--picture", asset.picture}, {"--label", asset.label}}));
  const auto show = [&]() -> Result<void> {
    if (product != nullptr) return show_product(*product, catalog, asset, outputs);
    if (kind != nullptr)
      return show_fixture(*kind, catalog, {asset.joints, asset.picture, asset.size_px}, outputs);
    if (material != nullptr) return show_material(*material, asset, outputs);
    return unknown_asset(catalog, asset.id);
  };
  MARKETGEN_CHECK(show());
  return outputs.commit();
}

}  // namespace marketgen::app
