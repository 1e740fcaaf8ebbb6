// Products as free bodies of a MuJoCo specification, each of its contact pieces, with mass, centre
// of mass and inertia: what grasp trials and bulk settling share.
#pragma once
#include <map>
#include <string>

#include "physics/goods/contact_shape.h"
#include "physics/mujoco_guard.h"
#include "physics/soft/soft_pack.h"

namespace marketgen {

// How the geoms of a product meet others.
struct ProductGeoms {
  GoodsContact contact;
  int group = 0;
  int own_bit = 1, meets = 1;  // MuJoCo's contype and conaffinity
};

// Errors: catalog.bad_row for a product without mass, size or contact pieces.
Result<void> check_has_body(const Product& product, const ProductBody& body);

class ProductBodies {
 public:
  explicit ProductBodies(mjSpec& spec) : spec_(spec) {}

  // A free body with the name. Products with the same `body` share its meshes.
  mjsBody* add(const std::string& name,
               const Product& product,
               const ProductBody& body,
               const Pose& world_from_product,
               const ProductGeoms& geoms);
  // The same as a soft pack, straight: NAME is its base, then come NAME-top and NAME-flap. Each is
  // the contact pieces that it has, cut where the pack bends, or else the pack's box. `middle`: of
  // the row's box, where the base has its origin.
  void add_soft(const std::string& name,
                const SoftPack& pack,
                const ProductBody& body,
                const Pose& world_from_product,
                Vec3 middle,
                const ProductGeoms& geoms);

 private:
  std::string add_hull(const std::vector<float>& corners);
  mjsGeom* add_piece(mjsBody* made, const ProductBody& body, std::size_t index);
  std::string mesh_of(const ProductBody& body, std::size_t index);

  mjSpec& spec_;
  std::map<std::pair<const ProductBody*, std::size_t>, std::string> meshes_;
  int hulls_ = 0;
};

}  // namespace marketgen
