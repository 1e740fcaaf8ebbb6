#include "physics/settle/settle_model.h"

#include <algorithm>
#include <array>

#include "physics/goods/product_bodies.h"
#include "physics/goods/spec_geoms.h"
#include "physics/goods/standing_goods.h"
#include "physics/world/shell_pieces.h"
#include "scene/placements.h"

namespace marketgen::physics {
namespace {

constexpr char settle_where[] = "settle";
constexpr mjtSize memory_base_bytes = 64 << 20,
                  memory_per_body_bytes = 1 << 20;  // address space, touched as needed

// What rests is put to sleep, which makes the simulation 20 times as fast. A creep slower than this
// many metres (radians) a second counts as rest: at most 0.4 mm in the four seconds that are
// watched.
constexpr double sleep_below_m_s = 1e-4;

// The floor area that the model covers.
struct Extent {
  double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
  void include(Vec3 p, double by) {
    x0 = std::min(x0, p.x - by), y0 = std::min(y0, p.y - by);
    x1 = std::max(x1, p.x + by), y1 = std::max(y1, p.y + by);
  }
  bool touches(Vec3 center, Vec3 half) const {
    return center.x + half.x >= x0 && center.x - half.x <= x1 && center.y + half.y >= y0 &&
           center.y - half.y <= y1;
  }
};

bool hangs(const scene::Scene& scene, const scene::SceneProduct& item) {
  return item.facing != scene::no_facing &&
         scene.shelves[scene.facings[item.facing].shelf].use == assets::ShelfUse::hang;
}

class Builder {
 public:
  Builder(const scene::Scene& scene, const std::vector<StandingGoods>& standing)
      : scene_(scene),
        standing_(standing),
        spec_(mj_makeSpec(), mj_deleteSpec),
        world_(mjs_findBody(spec_.get(), "world")),
        bodies_(*spec_) {}

  void set_options(std::size_t bodies) {
    set_contact_options(*spec_, sleep_below_m_s);
    spec_->compiler.balanceinertia = true;  // of flat packs the floats miss it by their last digit
    spec_->memory = memory_base_bytes + memory_per_body_bytes * static_cast<mjtSize>(bodies);
  }

  void add_room(const Extent& extent) {
    add_floor(world_);
    for (const ShellPiece& piece : shell_pieces(scene_.layout.shell)) {
      add_if_near({assets::CollisionShape::box, piece.pose, piece.half_size}, extent);
    }
    for (const scene::ScenePart& part : scene_.parts) {
      add_if_near(scene::world_from_fixture(scene_, part.fixture) * contact_shape_of(part), extent);
    }
  }

  void add_still(std::uint32_t row, const Extent& extent) {
    const scene::SceneProduct& item = scene_.products[row];
    const StandingGoods& goods = standing_[item.sku];
    if (mjsGeom* geom = add_if_near(scene::world_from_product(item) * goods.shape, extent))
      set_goods_contact(geom, goods.contact);
  }

  Result<void> add_free(std::uint32_t row) {
    const scene::SceneProduct& item = scene_.products[row];
    const catalog::Product& product = scene_.catalog[item.sku];
    MARKETGEN_TRY(const SharedGoodsBody goods, goods_body(product, GoodsUse::stocked));
    const std::string name = scene::product_id(scene_, row);
    bodies_.add(name, *goods, scene::world_from_product(item));
    if (hangs(scene_, item)) hang(name, product.height_m());
    return {};
  }

  Result<MujocoModel> finish() { return compile(*spec_, settle_where); }

 private:
  mjsGeom* add_if_near(const assets::ContactShape& shape, const Extent& extent) {
    return extent.touches(shape.pose.position, assets::half_extents(shape))
               ? add_shape(world_, shape)
               : nullptr;
  }

  void hang(const std::string& name, double height_m) {
    mjsEquality* hook = mjs_addEquality(spec_.get(), nullptr);
    hook->type = mjEQ_CONNECT;
    hook->objtype = mjOBJ_BODY;
    mjs_setString(hook->name1, name.c_str());
    const double anchor[3] = {
        0, 0, height_m};  // in the body's frame; MuJoCo's defaults are those of a joint coupling
    std::copy(anchor, anchor + 3, hook->data);
  }

  const scene::Scene& scene_;
  const std::vector<StandingGoods>& standing_;  // by row of the catalog
  MujocoSpec spec_;
  mjsBody* world_;
  ProductBodies bodies_;
};

}  // namespace

Result<SettleModel> settle_model(const scene::Scene& scene,
                                 const std::vector<std::uint32_t>& free,
                                 double margin_m) {
  std::vector<StandingGoods> standing;
  for (const catalog::Product& product : scene.catalog) {
    MARKETGEN_TRY(standing.emplace_back(), standing_goods(product));
  }
  Extent extent;
  std::vector<bool> is_free(scene.products.size(), false);
  for (const std::uint32_t row : free) {
    is_free[row] = true;
    extent.include(scene::world_from_product(scene.products[row]).position, margin_m);
  }
  Builder builder(scene, standing);
  builder.set_options(free.size());
  builder.add_room(extent);
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    if (!is_free[row]) builder.add_still(row, extent);
  }
  for (const std::uint32_t row : free)
    MARKETGEN_CHECK(builder.add_free(row));
  SettleModel built;
  MARKETGEN_TRY(built.model, builder.finish());
  built.products = free;
  return built;
}

}  // namespace marketgen::physics
