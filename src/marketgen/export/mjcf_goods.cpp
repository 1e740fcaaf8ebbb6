#include "export/mjcf_goods.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "assets/print/color.h"
#include "scene/placements.h"

namespace marketgen::exporters {
namespace {

std::string hull_name(const std::string& sku, std::size_t piece) {
  return fmt::format("hull/{}/{}", sku, piece);
}

}  // namespace

Result<MjcfGoods> MjcfGoods::make(const scene::Scene& scene, const std::vector<bool>& free) {
  MjcfGoods goods(scene);
  for (const catalog::Product& product : scene.catalog) {
    MARKETGEN_TRY(goods.standing_.emplace_back(), physics::standing_goods(product));
    MARKETGEN_TRY(goods.colors_.emplace_back(), assets::linear_from_hex(product.label.primary));
  }
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    const std::uint32_t sku = scene.products[row].sku;
    if (!free[row] || goods.free_.contains(sku)) continue;
    MARKETGEN_TRY(goods.free_[sku],
                  physics::goods_body(scene.catalog[sku], physics::GoodsUse::stocked));
  }
  return goods;
}

const std::string& MjcfGoods::sku_of(std::uint32_t row) const {
  return scene_->catalog[scene_->products[row].sku].sku;
}

void MjcfGoods::write_assets(XmlText& out) const {
  for (std::size_t sku = 0; sku < colors_.size(); ++sku)
    out.line(2,
             "<material name=\"{}\" rgba=\"{}\"/>",
             scene_->catalog[sku].sku,
             xml_color(colors_[sku], 1));
  for (const auto& [sku, goods] : free_) {
    for (std::size_t i = 0; i < goods->body.pieces.size(); ++i) {
      const assets::ContactPiece& piece = goods->body.pieces[i];
      if (piece.shape != assets::PieceShape::hull) continue;
      std::vector<float> corners;
      for (const Vec3f& p : piece.points)
        corners.insert(corners.end(), {p.x, p.y, p.z});
      out.line(2,
               "<mesh name=\"{}\" inertia=\"convex\" vertex=\"{}\"/>",
               hull_name(goods->product.sku, i),
               fmt::join(corners, " "));
    }
  }
}

void MjcfGoods::write_defaults(XmlText& out) const {
  for (std::size_t sku = 0; sku < standing_.size(); ++sku) {
    const physics::StandingGoods& goods = standing_[sku];
    out.line(
        3,
        "<default class=\"sku/{0}\"><geom type=\"{1}\" size=\"{2}\" mass=\"{3}\" condim=\"{4}\" "
        "friction=\"{5} {6} {7}\" material=\"{0}\"/></default>",
        scene_->catalog[sku].sku,
        name_of(goods.shape.shape),
        mjcf_size(goods.shape),
        goods.mass_kg,
        goods.contact.dimensions,
        goods.contact.sliding,
        goods.contact.torsional_m,
        static_cast<float>(goods.contact.rolling_m));
  }
}

void MjcfGoods::write_standing(XmlText& out, std::uint32_t row) const {
  const scene::SceneProduct& item = scene_->products[row];
  const Pose pose = scene::world_from_product(item) * standing_[item.sku].shape.pose;
  out.line(2,
           "<geom name=\"{}\" class=\"sku/{}\"{}/>",
           scene::product_id(*scene_, row),
           sku_of(row),
           mjcf_pose(pose));
}

// A ball has the inertia of its geom.
void MjcfGoods::write_free(XmlText& out, std::uint32_t row) const {
  const physics::GoodsBody& goods = *free_.at(scene_->products[row].sku);
  out.line(3, "<freejoint/>");
  const Vec3f& middle = goods.body.center_of_mass;
  if (goods.form != physics::GoodsForm::ball)
    out.line(3,
             "<inertial pos=\"{} {} {}\" mass=\"{}\" fullinertia=\"{}\"/>",
             middle.x,
             middle.y,
             middle.z,
             goods.product.mass_kg,
             fmt::join(goods.body.inertia_kg_m2, " "));
  const std::string id = scene::product_id(*scene_, row);
  for (std::size_t i = 0; i < goods.body.pieces.size(); ++i)
    write_piece(out,
                i == 0 ? fmt::format(" name=\"{}\"", id) : "",
                goods.product.sku,
                goods.body.pieces[i],
                i);
}

void MjcfGoods::write_piece(XmlText& out,
                            const std::string& name,
                            const std::string& sku,
                            const assets::ContactPiece& piece,
                            std::size_t index) const {
  if (piece.shape == assets::PieceShape::hull) {
    out.line(3,
             "<geom{} class=\"sku/{}\" type=\"mesh\" mesh=\"{}\"/>",
             name,
             sku,
             hull_name(sku, index));
    return;
  }
  const assets::ContactShape shape = assets::contact_shape_of(piece);
  out.line(3,
           "<geom{} class=\"sku/{}\" type=\"{}\" size=\"{}\"{}/>",
           name,
           sku,
           name_of(shape.shape),
           mjcf_size(shape),
           mjcf_pose(shape.pose));
}

}  // namespace marketgen::exporters
