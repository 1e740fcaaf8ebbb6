#include "physics/settle/heap.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/seed.h"
#include "physics/goods/product_bodies.h"
#include "physics/goods/spec_geoms.h"
#include "physics/settle/pour.h"

namespace marketgen::physics {
namespace {

constexpr double widest_m = 1.0;  // of the footprint
constexpr int max_across = 7, max_deep = 9, layers = 3;
constexpr double spread = 1.04;  // of a piece: room that it takes in the tray
constexpr double wall_half_m = 0.02;
// Pieces press into the walls by less than this. The footprint is so much wider on every side, for
// heaps are laid side by side.
constexpr int wall_gives_mm = 1;
constexpr PourRules heap_rules{.min_pause_s = 0.5, .max_pause_s = 0.5, .settle_s = 1};
constexpr char heap_where[] = "heap";

struct Tray {
  double piece_m;  // across
  int across, deep;
  double width_m() const { return across * piece_m * spread; }
  double depth_m() const { return deep * piece_m * spread; }
};

Tray tray_for(const catalog::Product& product) {
  const double piece = std::max({product.width_m(), product.depth_m(), product.height_m()});
  const int fit = std::max(2, static_cast<int>(widest_m / (piece * spread)));
  return {piece, std::min(max_across, fit), std::min(max_deep, fit)};
}

class HeapBuilder {
 public:
  explicit HeapBuilder(const GoodsBody& goods)
      : goods_(goods),
        product_(goods.product),
        tray_(tray_for(product_)),
        spec_(mj_makeSpec(), mj_deleteSpec),
        world_(mjs_findBody(spec_.get(), "world")) {}

  Result<catalog::HeapRow> settle() {
    set_contact_options(*spec_, 0);
    spec_->option.enableflags &= ~mjENBL_SLEEP;
    spec_->option.disableflags |= mjDSBL_AUTORESET;  // which would pour anew for ever
    spec_->memory = 512U << 20;
    add_tray();
    add_pieces();
    MARKETGEN_TRY(const MujocoModel model, compile(*spec_, heap_where));
    MARKETGEN_TRY(const MujocoData data, make_data(*model, heap_where));
    MARKETGEN_CHECK(pour(*model, *data));
    return row_of(*model, *data);
  }

 private:
  void add_tray() {
    add_floor(world_);
    const double w = tray_.width_m(), d = tray_.depth_m(), high = 2;
    for (const auto& [x, y, along, deep] : {std::array{-wall_half_m, d / 2, wall_half_m, d},
                                            std::array{w + wall_half_m, d / 2, wall_half_m, d},
                                            std::array{w / 2, -wall_half_m, w, wall_half_m},
                                            std::array{w / 2, d + wall_half_m, w, wall_half_m}}) {
      add_shape(world_, {assets::CollisionShape::box, {{x, y, high}, {}}, {along, deep, high}});
    }
  }

  // Each layer hangs above the one before it, and falls when the one before it lies.
  void add_pieces() {
    Stream draw = Seed(1).child("heap", product_.archetype).stream();
    const double pitch = tray_.piece_m * spread;
    const double diameter = 1.1 * tray_.piece_m;
    const Vec3 middle = to_double(goods_.body.pieces[0].center);
    ProductBodies bodies(*spec_);
    for (int layer = 0; layer < layers; ++layer) {
      const int fewer = layer;  // the heap narrows
      for (int row = 0; row < tray_.deep - fewer; ++row) {
        for (int column = 0; column < tray_.across - fewer; ++column) {
          const double shift = 0.5 * fewer;
          const Vec3 at{(column + 0.5 + shift) * pitch,
                        (row + 0.5 + shift) * pitch,
                        (0.6 + 1.3 * layer) * diameter + 0.1 * tray_.piece_m * draw.uniform()};
          const Quaternion turn = any_rotation(draw);
          // The middle of the piece, not its foot, is at the place.
          bodies.add(fmt::format("piece{}", count()), goods_, {at - rotate(turn, middle), turn});
          layer_of_.push_back(layer);
        }
      }
    }
  }

  std::size_t count() const { return layer_of_.size(); }

  // Layers that are not yet poured are held where they hang.
  Result<void> pour(const mjModel& model, mjData& data) const {
    std::vector<PouredBody> bodies;
    for (const int layer : layer_of_)
      bodies.push_back({layer, tray_.piece_m / 2});
    Pour pour(model, data, bodies, heap_rules);
    while (!pour.over())
      MARKETGEN_CHECK(pour.step(product_.sku));
    MARKETGEN_CHECK(guarded(heap_where, [&] { mj_forward(&model, &data); }));
    if (pour.fastest() < 15 * heap_rules.rest_m_s) return {};
    return Error{"physics.failed",
                 product_.sku,
                 fmt::format("a heap of it still moves after {} s", heap_rules.longest_s)};
  }

  // Which pieces each one lies on, and which lean on a wall.
  struct Leaning {
    std::vector<std::set<std::size_t>> on;
    std::vector<bool> wall, board;
  };
  Leaning leaning(const mjModel& model, const mjData& data) const {
    Leaning l{std::vector<std::set<std::size_t>>(count()),
              std::vector<bool>(count()),
              std::vector<bool>(count())};
    for (int c = 0; c < data.ncon; ++c) {
      const mjContact& contact = data.contact[c];
      const int a = model.geom_bodyid[contact.geom[0]], b = model.geom_bodyid[contact.geom[1]];
      if (a == 0 || b == 0) {
        const int still = a == 0 ? contact.geom[0] : contact.geom[1];
        auto& touches = model.geom_type[still] == mjGEOM_PLANE ? l.board : l.wall;
        touches[static_cast<std::size_t>(std::max(a, b) - 1)] = true;
        continue;
      }
      const bool a_above = data.xipos[3 * a + 2] > data.xipos[3 * b + 2];
      l.on[static_cast<std::size_t>((a_above ? a : b) - 1)].insert(
          static_cast<std::size_t>((a_above ? b : a) - 1));
    }
    return l;
  }

  catalog::HeapRow row_of(const mjModel& model, const mjData& data) const {
    const Leaning l = leaning(model, data);
    std::vector<std::size_t> order(count());
    for (std::size_t i = 0; i < count(); ++i)
      order[i] = i;
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
      return data.xipos[3 * (a + 1) + 2] < data.xipos[3 * (b + 1) + 2];
    });
    std::vector<int> number(count(), -1);  // among those kept
    std::vector<catalog::HeapPiece> pieces;
    for (const std::size_t i : order) {
      catalog::HeapPiece piece;
      bool stands = l.board[i] || (!l.wall[i] && l.on[i].size() >= 2);
      if (!l.board[i]) {
        for (const std::size_t below : l.on[i]) {
          if (number[below] < 0)
            stands = false;
          else
            piece.lies_on.push_back(static_cast<std::uint32_t>(number[below]));
        }
      }
      if (!stands) continue;
      const mjtNum* q = data.qpos + model.jnt_qposadr[i];
      constexpr double give_m = wall_gives_mm * 1e-3;
      piece.pose = {{q[0] + give_m, q[1] + give_m, q[2]}, {q[3], q[4], q[5], q[6]}};
      number[i] = static_cast<int>(pieces.size());
      pieces.push_back(std::move(piece));
    }
    return catalog::heap_row(
        product_.archetype,
        product_.size_mm,
        {static_cast<int>(std::lround(tray_.width_m() * 1e3)) + 2 * wall_gives_mm,
         static_cast<int>(std::lround(tray_.depth_m() * 1e3)) + 2 * wall_gives_mm},
        pieces);
  }

  const GoodsBody& goods_;
  const catalog::Product& product_;
  Tray tray_;
  MujocoSpec spec_;
  mjsBody* world_;
  std::vector<int> layer_of_;  // per body
};

}  // namespace

Result<catalog::HeapRow> settle_heap(const catalog::Product& product) {
  MARKETGEN_TRY(const SharedGoodsBody goods, goods_body(product, GoodsUse::stocked));
  return HeapBuilder(*goods).settle();
}

}  // namespace marketgen::physics
