#include "physics/goods/product_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "physics/goods/spec_geoms.h"
#include "physics/soft/soft_body.h"
#include "physics/soft/soft_pieces.h"

namespace marketgen::physics {

namespace {

void set_meeting(mjsGeom* geom, const GoodsBody& goods, const ProductGeoms& geoms) {
  set_goods_contact(geom, goods.contact);
  geom->group = geoms.group;
  geom->contype = geoms.own_bit;
  geom->conaffinity = geoms.meets;
}

void set_inertia(mjsBody* made, const GoodsBody& goods) {
  made->mass = goods.product.mass_kg;
  const Vec3f& middle = goods.body.center_of_mass;
  made->ipos[0] = middle.x, made->ipos[1] = middle.y, made->ipos[2] = middle.z;
  std::copy(goods.body.inertia_kg_m2.begin(), goods.body.inertia_kg_m2.end(), made->fullinertia);
  made->explicitinertial = true;
}

}  // namespace

mjsBody* ProductBodies::add(const std::string& name,
                            const GoodsBody& goods,
                            const Pose& world_from_product,
                            const ProductGeoms& geoms) {
  mjsBody* made = mjs_addBody(mjs_findBody(&spec_, "world"), nullptr);
  mjs_setName(made->element, name.c_str());
  set_pose(made->pos, made->quat, world_from_product);
  mjs_addFreeJoint(made)->align = mjALIGNFREE_FALSE;
  for (std::size_t i = 0; i < goods.body.pieces.size(); ++i) {
    mjsGeom* geom = add_piece(made, goods, i);
    set_meeting(geom, goods, geoms);
    if (goods.form == GoodsForm::ball) geom->mass = goods.product.mass_kg;
  }
  if (goods.form != GoodsForm::ball) set_inertia(made, goods);  // a ball's is that of its geom
  return made;
}

mjsGeom* ProductBodies::add_piece(mjsBody* made, const GoodsBody& goods, std::size_t index) {
  const assets::ContactPiece& piece = goods.body.pieces[index];
  if (piece.shape != assets::PieceShape::hull)
    return add_shape(made, assets::contact_shape_of(piece));
  mjsGeom* geom = mjs_addGeom(made, nullptr);
  geom->type = mjGEOM_MESH;
  mjs_setString(geom->meshname, mesh_of(goods, index).c_str());
  geom->solref[0] = contact_time_s;
  return geom;
}

std::string ProductBodies::add_hull(const std::vector<float>& corners) {
  std::string name = fmt::format("piece{}", hulls_++);
  mjsMesh* mesh = mjs_addMesh(&spec_, nullptr);
  mjs_setName(mesh->element, name.c_str());
  mjs_setFloat(mesh->uservert, corners.data(), static_cast<int>(corners.size()));
  mesh->inertia = mjMESH_INERTIA_CONVEX;
  return name;
}

std::string ProductBodies::mesh_of(const GoodsBody& goods, std::size_t index) {
  const auto [found, is_new] = meshes_.try_emplace({&goods, index});
  if (is_new) {
    std::vector<float> corners;
    for (const Vec3f& p : goods.body.pieces[index].points)
      corners.insert(corners.end(), {p.x, p.y, p.z});
    found->second = add_hull(corners);
  }
  return found->second;
}

void ProductBodies::add_soft(const std::string& name,
                             const SoftPack& pack,
                             const GoodsBody& goods,
                             const Pose& world_from_product,
                             Vec3 middle,
                             const ProductGeoms& geoms) {
  const SoftElements made = add_soft_body(mjs_findBody(&spec_, "world"), pack, name);
  set_pose(made.bodies[0]->pos, made.bodies[0]->quat, world_from_product * Pose{middle, {}});
  const auto parts = cut_at_hinges(goods.body, pack, middle);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].empty()) {
      set_meeting(made.geoms[part], goods, geoms);
      continue;
    }
    made.geoms[part]->contype = made.geoms[part]->conaffinity = 0;  // the box is only its mass
    const Vec3 frame = part == 0 ? Vec3{} : pack.hinges[part - 1].at;
    for (const PieceCorners& piece : parts[part]) {
      std::vector<float> corners;
      for (const Vec3& p : piece)
        for (const double x : {p.x - frame.x, p.y - frame.y, p.z - frame.z})
          corners.push_back(static_cast<float>(x));
      mjsGeom* geom = mjs_addGeom(made.bodies[part], nullptr);
      geom->type = mjGEOM_MESH;
      mjs_setString(geom->meshname, add_hull(corners).c_str());
      geom->solref[0] = contact_time_s;
      geom->mass = 0;
      set_meeting(geom, goods, geoms);
    }
  }
}

}  // namespace marketgen::physics
