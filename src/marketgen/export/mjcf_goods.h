// Goods in an MJCF file: what stands is a geom of the world, what is free a body; the same that a
// World has of them (physics/goods).
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "export/mjcf_text.h"
#include "physics/goods/goods_body.h"
#include "physics/goods/standing_goods.h"
#include "scene/scene.h"

namespace marketgen::exporters {

class MjcfGoods {
 public:
  // `free`: by row of the scene's products. Errors: those of standing_goods, goods_body and
  // linear_from_hex.
  static Result<MjcfGoods> make(const scene::Scene& scene, const std::vector<bool>& free);

  // A material per SKU, whose name says what an item is and whose colour is the pack's ground, and
  // the hulls of what is free.
  void write_assets(XmlText& out) const;
  void write_defaults(XmlText& out) const;
  // The geom of an item that stands, in the world.
  void write_standing(XmlText& out, std::uint32_t row) const;
  // Joint, inertia and geoms of a free item, inside of its body, whose frame is the product's.
  void write_free(XmlText& out, std::uint32_t row) const;

 private:
  explicit MjcfGoods(const scene::Scene& scene) : scene_(&scene) {}
  const std::string& sku_of(std::uint32_t row) const;
  void write_piece(XmlText& out,
                   const std::string& name,
                   const std::string& sku,
                   const assets::ContactPiece& piece,
                   std::size_t index) const;

  const scene::Scene* scene_;
  std::vector<physics::StandingGoods> standing_;            // by SKU
  std::vector<Vec3f> colors_;                               // the same, linear
  std::map<std::uint32_t, physics::SharedGoodsBody> free_;  // by SKU, as needed
};

}  // namespace marketgen::exporters
