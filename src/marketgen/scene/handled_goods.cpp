#include "scene/handled_goods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "assets/product_model.h"
#include "scene/placements.h"
#include "scene/scene.h"

namespace marketgen::scene {
namespace {

constexpr double strange_share = 0.03, fallen_share = 0.08, leaning_share = 0.25;
constexpr double falls_from = 2.2, leans_from = 3.3;     // times as high as deep
constexpr double min_pull = 0.3;                         // of the room in front
constexpr double max_box_yaw = 0.22, max_round_yaw = 1;  // tan(half angle): 25 and 90 degrees
constexpr double apart_m = 0.001, edge_m = 0.002, touching_gap_m = 0.0005;

// Upright packs of which a turn shows nothing but the label.
bool is_upright_cylinder(const assets::CollisionPrimitive& primitive) {
  return primitive.shape == assets::CollisionShape::cylinder && !primitive.lying;
}

// What a pack takes of the board: a rectangle turned by an angle, or a disc.
struct Footprint {
  double x = 0, y = 0;            // middle, shelf frame
  double half_x = 0, half_y = 0;  // of a disc its radius
  double cos = 1, sin = 0;
  bool disc = false;

  double reach_x() const { return disc ? half_x : std::abs(half_x * cos) + std::abs(half_y * sin); }
  double reach_y() const { return disc ? half_x : std::abs(half_x * sin) + std::abs(half_y * cos); }
};

// Of a rotation about Z or X alone, from its quaternion: no function whose bits differ by machine.
Footprint print_of(const catalog::Product& product, Vec3 position, const Quaternion& rotation) {
  Footprint print{position.x, position.y, product.width_m() / 2, product.depth_m() / 2};
  const auto primitive = assets::collision_of(product);
  print.disc =
      primitive.ok() && is_upright_cylinder(*primitive) && product.size_mm[0] == product.size_mm[1];
  print.cos = rotation.w * rotation.w - rotation.z * rotation.z;
  print.sin = 2 * rotation.w * rotation.z;
  return print;
}

// A piece of a heap, any way round.
Footprint ball_of(const catalog::Product& product, Vec3 position) {
  const double radius = std::max({product.width_m(), product.depth_m(), product.height_m()}) / 2;
  return {position.x, position.y, radius, radius, 1, 0, true};
}

// From a disc's middle to the rectangle.
double distance_to(const Footprint& rectangle, double x, double y) {
  const double dx = x - rectangle.x, dy = y - rectangle.y;
  const double along =
      std::max(0.0, std::abs(dx * rectangle.cos + dy * rectangle.sin) - rectangle.half_x);
  const double across =
      std::max(0.0, std::abs(dy * rectangle.cos - dx * rectangle.sin) - rectangle.half_y);
  return std::sqrt(along * along + across * across);
}

// Whether a side of `a` parts the two by the gap.
bool side_parts(const Footprint& a, const Footprint& b, double gap_m) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double cos = std::abs(a.cos * b.cos + a.sin * b.sin),
               sin = std::abs(a.cos * b.sin - a.sin * b.cos);
  return std::abs(dx * a.cos + dy * a.sin) >= a.half_x + b.half_x * cos + b.half_y * sin + gap_m ||
         std::abs(dy * a.cos - dx * a.sin) >= a.half_y + b.half_x * sin + b.half_y * cos + gap_m;
}

bool are_apart(const Footprint& a, const Footprint& b, double gap_m) {
  if (std::abs(a.x - b.x) >= a.reach_x() + b.reach_x() + gap_m) return true;
  if (std::abs(a.y - b.y) >= a.reach_y() + b.reach_y() + gap_m) return true;
  if (a.disc && b.disc) {
    const double dx = a.x - b.x, dy = a.y - b.y, reach = a.half_x + b.half_x + gap_m;
    return dx * dx + dy * dy >= reach * reach;
  }
  if (a.disc) return distance_to(b, a.x, a.y) >= a.half_x + gap_m;
  if (b.disc) return distance_to(a, b.x, b.y) >= b.half_x + gap_m;
  return side_parts(a, b, gap_m) || side_parts(b, a, gap_m);
}

// The foremost stack of a column: items of a block from `first` on; those behind it follow.
struct Front {
  std::size_t block = 0, first = 0, count = 0;
  std::optional<std::size_t> behind;  // the lowest item of the next row
  int taken = 0;
};

std::vector<Front> fronts_of(const FilledBlock& block,
                             std::size_t index,
                             const TakenInFront& taken) {
  std::vector<Front> fronts;
  for (std::size_t i = 0; i < block.items.size(); ++i) {
    const Vec3 at = block.items[i].position;
    const bool new_column = i == 0 || block.items[i - 1].position.x != at.x;
    if (new_column) fronts.push_back({index, i, 0, std::nullopt, 0});
    Front& front = fronts.back();
    if (block.items[front.first].position.y == at.y)
      ++front.count;
    else if (!front.behind)
      front.behind = i;
  }
  for (std::size_t i = 0; i < fronts.size() && i < taken.size(); ++i)
    fronts[i].taken = taken[i];
  return fronts;
}

// Of columns of which so many packs were taken.
double share_in_line(double jitter, int taken) {
  double in_line = 1;
  for (int i = 0; i < taken; ++i)
    in_line *= 1 - jitter;
  return in_line;
}

class HandledShelf {
 public:
  HandledShelf(std::vector<FilledBlock>& blocks,
               const PlannedShelf& planned,
               const ShelfRoom& room,
               const catalog::Catalog& catalog)
      : blocks_(blocks), planned_(planned), room_(room), catalog_(catalog) {
    for (const FilledBlock& block : blocks) {
      const bool heaped = lies_in_a_heap(product_of(block));
      std::vector<Footprint>& prints = prints_.emplace_back();
      for (const ShelfItem& item : block.items)
        prints.push_back(heaped ? ball_of(product_of(block), item.position)
                                : print_of(product_of(block), item.position, item.rotation));
    }
  }

  void handle(const Front& front, Stream draw, Stream strange) {
    const ShelfItem& lowest = blocks_[front.block].items[front.first];
    const catalog::Product& product = catalog_.products[lowest.product];
    if (strange.chance(strange_share) && put_down(front, strange)) return;
    const double fallen = draw.uniform(), leaning = draw.uniform();
    if (fallen < fallen_share && lies_down(front, product, draw)) return;
    if (leaning < leaning_share && leans(front, product, draw)) return;
    pull(front, product, draw);
  }

 private:
  const catalog::Product& product_of(const FilledBlock& block) const {
    return catalog_.products[block.product];
  }

  static bool is_box(const catalog::Product& product) {
    const auto primitive = assets::collision_of(product);
    return primitive.ok() && primitive->shape == assets::CollisionShape::box;
  }

  // Whether the foremost stack of the column may stand so. What leans touches the row behind it.
  bool has_room(const Front& front, const Footprint& print, bool leans_on_it = false) const {
    const double half_m = room_.width_m / 2;
    if (std::abs(print.x) + print.reach_x() > half_m - apart_m ||
        print.y - print.reach_y() < edge_m || print.y + print.reach_y() > room_.depth_m)
      return false;
    for (std::size_t b = 0; b < prints_.size(); ++b) {
      for (std::size_t i = 0; i < prints_[b].size(); ++i) {
        const bool own = b == front.block && i >= front.first && i < front.first + front.count;
        const bool behind = leans_on_it && b == front.block && is_behind(front, i);
        if (!own && !behind && !are_apart(print, prints_[b][i], apart_m)) return false;
      }
    }
    return true;
  }

  // Of the row behind the foremost of the same column.
  bool is_behind(const Front& front, std::size_t item) const {
    if (!front.behind) return false;
    const std::vector<ShelfItem>& items = blocks_[front.block].items;
    return items[item].position.x == items[*front.behind].position.x &&
           items[item].position.y == items[*front.behind].position.y;
  }

  void stand(const Front& front,
             const Footprint& print,
             Vec3 position,
             const Quaternion& rotation) {
    for (std::size_t i = front.first; i < front.first + front.count; ++i) {
      ShelfItem& item = blocks_[front.block].items[i];
      item.position = {position.x, position.y, item.position.z + position.z};
      item.rotation = rotation;
      item.flags |= product_out_of_line;
      prints_[front.block][i] = print;
    }
  }

  // A product of another shelf where the top one stood.
  bool put_down(const Front& front, Stream& draw) {
    if (planned_[front.block].certain) return false;
    ShelfItem& top = blocks_[front.block].items[front.first + front.count - 1];
    const std::uint32_t stranger = stranger_for(top.product, catalog_, draw);
    if (stranger == top.product) return false;
    top.product = stranger;
    top.rotation = {};
    top.flags |= product_misplaced;
    return true;
  }

  // On its face, its bottom to the back.
  bool lies_down(const Front& front, const catalog::Product& product, Stream& draw) {
    const double high = product.height_m(), deep = product.depth_m();
    const Vec3 stood = blocks_[front.block].items[front.first].position;
    const double least = high + edge_m, most = stood.y + deep / 2;
    if (front.count != 1 || high < falls_from * deep || !is_box(product) || most < least)
      return false;
    const double bottom_y = least + (most - least) * draw.uniform();
    const Footprint print{stood.x, bottom_y - high / 2, product.width_m() / 2, high / 2};
    if (!has_room(front, print)) return false;
    stand(front, print, {stood.x, bottom_y, deep / 2}, rotation_from_half_tangent({1, 0, 0}, 1));
    return true;
  }

  // Its back edge on the board and the upper end of its back against the pack behind: so far over
  // that it does not fall back onto its bottom.
  bool leans(const Front& front, const catalog::Product& product, Stream& draw) {
    const double high = product.height_m(), deep = product.depth_m();
    if (front.count != 1 || !front.behind || high < leans_from * deep || !is_box(product))
      return false;
    constexpr double min_over = 1.3, max_over = 1.8;  // of the slope at which it would fall back
    const double slope = deep / high * draw.uniform(min_over, max_over);
    const double secant = std::sqrt(1 + slope * slope), cos = 1 / secant, sin = slope / secant;
    const Footprint& back = prints_[front.block][*front.behind];
    const double wall_y = back.y - back.reach_y() - touching_gap_m;
    const double foot_y = wall_y - high * sin;
    const Vec3 stood = blocks_[front.block].items[front.first].position;
    const Footprint print{stood.x,
                          (wall_y + foot_y - deep * cos) / 2,
                          product.width_m() / 2,
                          (wall_y - foot_y + deep * cos) / 2};
    if (high * cos + deep * sin > room_.clearance_m - edge_m || !has_room(front, print, true))
      return false;
    stand(front,
          print,
          {stood.x, foot_y - deep / 2 * cos, deep / 2 * sin},
          rotation_from_half_tangent({1, 0, 0}, -slope / (1 + secant)));
    return true;
  }

  void pull(const Front& front, const catalog::Product& product, Stream& draw) {
    const Vec3 stood = blocks_[front.block].items[front.first].position;
    const Footprint straight = print_of(product, stood, {});
    const double free_m = std::max(0.0, stood.y - straight.reach_y() - edge_m);
    const double pull = draw.uniform(min_pull, 1) * free_m;
    const double most = straight.disc ? max_round_yaw : max_box_yaw;
    const double yaw = draw.uniform(-most, most);
    for (const double share : {1.0, 0.6, 0.3}) {
      const Quaternion rotation = rotation_from_half_tangent({0, 0, 1}, share * yaw);
      const Vec3 position{stood.x, stood.y - share * pull, 0};
      const Footprint print = print_of(product, position, rotation);
      if (!has_room(front, print)) continue;
      stand(front, print, position, rotation);
      return;
    }
  }

  std::vector<FilledBlock>& blocks_;
  const PlannedShelf& planned_;
  const ShelfRoom& room_;
  const catalog::Catalog& catalog_;
  std::vector<std::vector<Footprint>> prints_;  // by block and item
};

}  // namespace

void handle_goods(std::vector<FilledBlock>& blocks,
                  const SoldOfShelf& sold,
                  const PlannedShelf& planned,
                  const ShelfRoom& room,
                  double jitter,
                  const catalog::Catalog& catalog,
                  Seed handled,
                  Seed strange) {
  if (jitter == 0) return;
  std::optional<HandledShelf> shelf;  // only where there is something to do
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const catalog::Product& product = catalog.products[blocks[b].product];
    if (lies_in_a_heap(product)) continue;
    for (const Front& front : fronts_of(blocks[b], b, sold[b])) {
      const double from_left_m = blocks[b].items[front.first].position.x + room.width_m / 2;
      const auto column = static_cast<std::uint64_t>(
          std::max(0.0, (from_left_m - blocks[b].x_m) / facing_pitch_m(product)));
      Stream draw = handled.child("block", b).child("column", column).stream();
      if (draw.uniform() < share_in_line(jitter, front.taken)) continue;
      if (!shelf) shelf.emplace(blocks, planned, room, catalog);
      shelf->handle(front, draw, strange.child("block", b).child("column", column).stream());
    }
  }
}

}  // namespace marketgen::scene
