#include "physics/goods/product_bodies.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "physics/goods/spec_geoms.h"
#include "physics/soft/soft_body.h"
#include "physics/soft/soft_pieces.h"

namespace marketgen {

Result<void> check_has_body(const Product& product, const ProductBody& body) {
  const auto& [width, depth, height] = product.size_mm;
  const bool sized = width > 0 && depth > 0 && height > 0;
  if (product.mass_kg > 0 && std::isfinite(product.mass_kg) && sized && !body.pieces.empty())
    return {};
  return Error{"catalog.bad_row",
               product.sku,
               fmt::format("a product to be held needs a mass and a size greater than 0; it has {} "
                           "kg and {} x {} x {} mm",
                           product.mass_kg,
                           width,
                           depth,
                           height)};
}

mjsBody* ProductBodies::add(const std::string& name,
                            const Product& product,
                            const ProductBody& body,
                            const Pose& world_from_product,
                            const ProductGeoms& geoms) {
  mjsBody* made = mjs_addBody(mjs_findBody(&spec_, "world"), nullptr);
  mjs_setName(made->element, name.c_str());
  set_pose(made->pos, made->quat, world_from_product);
  mjs_addFreeJoint(made)->align = mjALIGNFREE_FALSE;
  made->mass = product.mass_kg;
  const Vec3f& middle = body.center_of_mass;
  made->ipos[0] = middle.x, made->ipos[1] = middle.y, made->ipos[2] = middle.z;
  for (std::size_t i = 0; i < 6; ++i)
    made->fullinertia[i] = static_cast<double>(body.inertia_kg_m2[i]);
  made->explicitinertial = true;
  for (std::size_t i = 0; i < body.pieces.size(); ++i) {
    mjsGeom* geom = add_piece(made, body, i);
    set_goods_contact(geom, geoms.contact);
    geom->group = geoms.group;
    geom->contype = geoms.own_bit;
    geom->conaffinity = geoms.meets;
  }
  return made;
}

mjsGeom* ProductBodies::add_piece(mjsBody* made, const ProductBody& body, std::size_t index) {
  const ContactPiece& piece = body.pieces[index];
  if (piece.shape != PieceShape::hull) return add_shape(made, contact_shape_of(piece));
  mjsGeom* geom = mjs_addGeom(made, nullptr);
  geom->type = mjGEOM_MESH;
  mjs_setString(geom->meshname, mesh_of(body, index).c_str());
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

std::string ProductBodies::mesh_of(const ProductBody& body, std::size_t index) {
  const auto [found, is_new] = meshes_.try_emplace({&body, index});
  if (is_new) {
    std::vector<float> corners;
    for (const Vec3f& p : body.pieces[index].points)
      corners.insert(corners.end(), {p.x, p.y, p.z});
    found->second = add_hull(corners);
  }
  return found->second;
}

void ProductBodies::add_soft(const std::string& name,
                             const SoftPack& pack,
                             const ProductBody& body,
                             const Pose& world_from_product,
                             Vec3 middle,
                             const ProductGeoms& geoms) {
  const SoftElements made = add_soft_body(mjs_findBody(&spec_, "world"), pack, name);
  set_pose(made.bodies[0]->pos, made.bodies[0]->quat, world_from_product * Pose{middle, {}});
  const auto meet = [&](mjsGeom* geom) {
    set_goods_contact(geom, geoms.contact);
    geom->group = geoms.group;
    geom->contype = geoms.own_bit;
    geom->conaffinity = geoms.meets;
  };
  const auto parts = cut_at_hinges(body, pack, middle);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].empty()) {
      meet(made.geoms[part]);
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
      meet(geom);
    }
  }
}

}  // namespace marketgen
