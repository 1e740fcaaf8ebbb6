// Goods as free bodies of a MuJoCo specification: the only writer of them (MJCF files say the same
// in words, export/mjcf_goods.h).
#pragma once
#include <map>
#include <string>
#include <utility>

#include "physics/goods/goods_body.h"
#include "physics/mujoco_guard.h"
#include "physics/soft/soft_pack.h"

namespace marketgen::physics {

// Who the geoms of a product look for contact with, and their group.
struct ProductGeoms {
  int group = 0;
  int own_bit = 1, meets = 1;  // MuJoCo's contype and conaffinity
};

class ProductBodies {
 public:
  explicit ProductBodies(mjSpec& spec) : spec_(spec) {}

  // A free body with the name; its frame is the product's. Those of the same `goods` share its
  // meshes: it must live as long as this.
  mjsBody* add(const std::string& name,
               const GoodsBody& goods,
               const Pose& world_from_product,
               const ProductGeoms& geoms = {});
  // The same as a soft pack, straight: NAME is its base, then come NAME-top and NAME-flap. Each is
  // the contact pieces that it has, cut where the pack bends, or else the pack's box. `middle`: of
  // the row's box, where the base has its origin.
  void add_soft(const std::string& name,
                const SoftPack& pack,
                const GoodsBody& goods,
                const Pose& world_from_product,
                Vec3 middle,
                const ProductGeoms& geoms = {});

 private:
  std::string add_hull(const std::vector<float>& corners);
  mjsGeom* add_piece(mjsBody* made, const GoodsBody& goods, std::size_t index);
  std::string mesh_of(const GoodsBody& goods, std::size_t index);

  mjSpec& spec_;
  std::map<std::pair<const GoodsBody*, std::size_t>, std::string> meshes_;
  int hulls_ = 0;
};

}  // namespace marketgen::physics
