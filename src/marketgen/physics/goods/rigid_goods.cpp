#include "physics/goods/rigid_goods.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/shared_objects.h"
#include "io/json.h"
#include "physics/goods/product_bodies.h"
#include "physics/goods/slot.h"

namespace marketgen::physics {
namespace {

using SharedRigidGoods = std::shared_ptr<const RigidGoods>;

Vec3 vec3_at(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

Box3 bounds_of_geoms(const mjModel& m) {
  Box3 all{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  for (int geom = 0; geom < m.ngeom; ++geom) {
    mjtNum turned[9];
    mju_quat2Mat(turned, m.geom_quat + 4 * geom);
    const mjtNum *box = m.geom_aabb + 6 * geom, *at = m.geom_pos + 3 * geom;
    for (int i = 0; i < 3; ++i) {
      double middle = at[i], half = 0;
      for (int j = 0; j < 3; ++j)
        middle += turned[3 * i + j] * box[j], half += std::abs(turned[3 * i + j]) * box[3 + j];
      double& low = i == 0 ? all.low.x : i == 1 ? all.low.y : all.low.z;
      double& high = i == 0 ? all.high.x : i == 1 ? all.high.y : all.high.z;
      low = std::min(low, middle - half), high = std::max(high, middle + half);
    }
  }
  return all;
}

Result<SharedRigidGoods> compiled_alone(const catalog::Product& product, GoodsUse use) {
  MARKETGEN_TRY(const SharedGoodsBody body, goods_body(product, use));
  const MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
  spec->compiler.balanceinertia = true;  // of flat packs the floats miss it by their last digit
  mjsBody* made = ProductBodies(*spec).add("goods", *body, {});
  mjs_asJoint(mjs_firstChild(made, mjOBJ_JOINT, 0))->align = mjALIGNFREE_TRUE;
  auto goods = std::make_shared<RigidGoods>();
  MARKETGEN_TRY(goods->model, compile(*spec, product.sku));
  // The compiler leaves turns of length 1 + 1e-15. With an axis so long a cylinder that stands on a
  // plane does not touch it (mjc_PlaneCylinder normalises what is left of it across the plane).
  for (int geom = 0; geom < goods->model->ngeom; ++geom)
    mju_normalize4(goods->model->geom_quat + 4 * geom);
  mju_normalize4(goods->model->body_quat + 4);  // of the only body behind the world
  const mjModel& m = *goods->model;
  const mjtNum* q = m.body_quat + 4;
  goods->product_from_body = {vec3_at(m.body_pos + 3), {q[0], q[1], q[2], q[3]}};
  goods->bounds = bounds_of_geoms(m);
  const std::vector<assets::ContactPiece>& pieces = body->body.pieces;
  goods->hollow = pieces.size() > 1 || pieces[0].shape == assets::PieceShape::hull;
  return SharedRigidGoods(std::move(goods));
}

}  // namespace

Result<SharedRigidGoods> rigid_goods(const catalog::Product& product, GoodsUse use) {
  static SharedObjects made;
  return made.get<const RigidGoods>(
      fmt::format("{} {}", static_cast<int>(use), io::write_json_line(product)),
      [&] { return compiled_alone(product, use); });
}

Result<SharedRigidGoods> with_mass(const RigidGoods& goods, double factor) {
  auto other = std::make_shared<RigidGoods>();
  const mjModel* const from = goods.model.get();
  mjModel* made = nullptr;
  MARKETGEN_CHECK(guarded("goods", [&made, from] { made = mj_copyModel(nullptr, from); }));
  other->model.reset(made);
  scale_mass(*made, factor);
  other->product_from_body = goods.product_from_body;
  other->bounds = goods.bounds;
  other->hollow = goods.hollow;
  return SharedRigidGoods(std::move(other));
}

}  // namespace marketgen::physics
