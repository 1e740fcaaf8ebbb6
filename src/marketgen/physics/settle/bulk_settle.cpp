#include "physics/settle/bulk_settle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/goods/product_bodies.h"
#include "physics/goods/spec_geoms.h"
#include "physics/settle/bulk_model.h"
#include "physics/settle/pour.h"

namespace marketgen::physics {
namespace {

constexpr char bulk_where[] = "bulk settling";
constexpr mjtSize bulk_arena_bytes = 256U << 20;
constexpr double fall_m = 0.02;  // from above the rim, and above what lies highest
// Rotations drawn until the pack would fall between the walls and not on them.
constexpr int max_draws = 20;
// Where packs wait for their turn, and are taken to when they spill: beyond anything's reach.
constexpr double waiting_x_m = 10, waiting_apart_m = 4, waiting_z_m = 3;

constexpr PourRules bulk_rules{.min_pause_s = 0.25,
                               .max_pause_s = max_pour_s,
                               .settle_s = 0.5,
                               .rest_m_s = 0.01,
                               .rest_steps = 50};

class BulkSettling {
 public:
  BulkSettling(const OpenContainer& container, const std::vector<SharedGoodsBody>& items, Seed seed)
      : container_(container), items_(items), seed_(seed) {}

  Result<SettledBulk> settle() {
    MARKETGEN_TRY(const MujocoModel model, make_model());
    MARKETGEN_TRY(const MujocoData data, make_data(*model, bulk_where));
    PourRules rules = bulk_rules;
    rules.longest_s = max_pour_s * static_cast<double>(items_.size()) + max_rest_s;
    Pour pour(*model, *data, poured_bodies(), rules);
    hang(*model, *data, 0);
    while (!pour.over()) {
      const int turn = pour.turn();
      MARKETGEN_CHECK(pour.step(bulk_where));
      if (pour.turn() != turn) hang(*model, *data, pour.turn());
      take_away_spilled(*data, pour);
    }
    MARKETGEN_CHECK(guarded(bulk_where, [&] { mj_kinematics(model.get(), data.get()); }));
    return result_of(*model, *data, pour);
  }

 private:
  Result<MujocoModel> make_model() const {
    const MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
    set_contact_options(*spec, 0);
    spec->option.enableflags &= ~mjENBL_SLEEP;
    spec->option.disableflags |= mjDSBL_AUTORESET;  // which would pour anew for ever
    spec->memory = bulk_arena_bytes;
    spec->compiler.balanceinertia = true;
    add_container(mjs_findBody(spec.get(), "world"), container_);
    ProductBodies bodies(*spec);
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const double x = waiting_x_m + waiting_apart_m * static_cast<double>(i);
      bodies.add(fmt::format("product{}", i), *items_[i], {{x, 0, waiting_z_m}, {}});
    }
    return compile(*spec, bulk_where);
  }

  std::vector<PouredBody> poured_bodies() const {
    std::vector<PouredBody> bodies;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const catalog::Product& p = items_[i]->product;
      bodies.push_back(
          {static_cast<int>(i), length(Vec3{p.width_m(), p.depth_m(), p.height_m()}) / 2});
    }
    return bodies;
  }

  // Over the rim and what lies highest, somewhere between the walls, any way round.
  void hang(const mjModel& model, mjData& data, int turn) const {
    const auto index = static_cast<std::size_t>(turn);
    const catalog::Product& product = items_[index]->product;
    Stream draw = seed_.child("bulk", index).stream();
    Quaternion turned;
    Vec3 half, room;
    for (int i = 0; i < max_draws; ++i) {
      turned = any_rotation(draw);
      half = turned_half_extents(product, turned);
      room = {container_.top_x_m / 2 - half.x, container_.top_y_m / 2 - half.y, 0};
      if (room.x >= 0 && room.y >= 0) break;
    }
    const auto anywhere = [&](double most) { return most > 0 ? draw.uniform(-most, most) : 0.0; };
    const double under = std::max(container_.height_m, top_of_pile(model, data, turn)) + fall_m;
    const double x = anywhere(room.x), y = anywhere(room.y);
    const Vec3 at = Vec3{x, y, under + half.z} - rotate(turned, {0, 0, product.height_m() / 2});
    const double q[7] = {at.x, at.y, at.z, turned.w, turned.x, turned.y, turned.z};
    std::copy(q, q + 7, data.qpos + model.jnt_qposadr[turn]);
    std::fill_n(data.qvel + model.jnt_dofadr[turn], 6, 0.0);
  }

  // Of what was poured before the turn and not taken away.
  double top_of_pile(const mjModel& model, const mjData& data, int turn) const {
    double top = 0;
    for (int geom = 0; geom < model.ngeom; ++geom) {
      const int body = model.geom_bodyid[geom];
      if (body == 0 || body > turn || data.xipos[3 * body] > waiting_x_m / 2) continue;
      const mjtNum *box = model.geom_aabb + 6 * geom, *m = data.geom_xmat + 9 * geom + 6;
      double high = data.geom_xpos[3 * geom + 2];
      for (int axis = 0; axis < 3; ++axis)
        high += m[axis] * box[axis] + std::abs(m[axis]) * box[3 + axis];
      top = std::max(top, high);
    }
    return top;
  }

  // Beyond the walls' outer faces, or through the floor.
  void take_away_spilled(const mjData& data, Pour& pour) const {
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const mjtNum* middle = data.xipos + 3 * (i + 1);
      const bool spilled = !over_floor(middle, container_.wall_m) || middle[2] < 0;
      if (pour.poured(i) && spilled && middle[0] < waiting_x_m / 2) pour.take_away(i);
    }
  }

  bool over_floor(const mjtNum* at, double beyond_m) const {
    return std::abs(at[0]) <= container_.top_x_m / 2 + beyond_m &&
           std::abs(at[1]) <= container_.top_y_m / 2 + beyond_m;
  }

  SettledBulk result_of(const mjModel& model, const mjData& data, const Pour& pour) const {
    SettledBulk result;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const mjtNum* q = data.qpos + model.jnt_qposadr[i];
      SettledItem item{{{q[0], q[1], q[2]}, {q[3], q[4], q[5], q[6]}}, false};
      item.inside = pour.poured(i) && over_floor(data.xipos + 3 * (i + 1), 0);
      result.spilled += item.inside ? 0 : 1;
      result.items.push_back(item);
    }
    result.rests = pour.rests();
    result.simulated_s = pour.time();
    return result;
  }

  const OpenContainer& container_;
  const std::vector<SharedGoodsBody>& items_;
  Seed seed_;
};

}  // namespace

Result<SettledBulk> settle_bulk(const OpenContainer& container,
                                const std::vector<SharedGoodsBody>& items,
                                Seed seed) {
  MARKETGEN_CHECK(check_container(container));
  if (items.size() > max_bulk_items)
    return Error{
        "physics.bad_command",
        "items",
        fmt::format("{} items; at most {} are poured at a time", items.size(), max_bulk_items)};
  for (const SharedGoodsBody& item : items)
    MARKETGEN_CHECK(check_has_body(item->product, item->body));
  if (items.empty()) return SettledBulk{.items = {}, .rests = true};
  return BulkSettling(container, items, seed).settle();
}

}  // namespace marketgen::physics
