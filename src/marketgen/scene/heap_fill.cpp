#include "scene/heap_fill.h"

#include <algorithm>
#include <cmath>

#include "assets/product_model.h"

namespace marketgen::scene {
namespace {

// Where the row's footprint lies in the room; `turned`: by half a turn about its middle.
struct Tile {
  double x = 0, y = 0;
  bool turned = false;
};

class Cutter {
 public:
  Cutter(const catalog::HeapRow& row, const catalog::Product& product, const ShelfRoom& room)
      : pieces_(catalog::pieces_of(row)),
        room_(room),
        width_m_(row.width_mm * 1e-3),
        depth_m_(row.depth_mm * 1e-3) {
    const Result<assets::CollisionPrimitive> primitive = assets::collision_of(product);
    if (!primitive.ok()) {
      pieces_.clear();
      return;
    }
    const auto& h = primitive->half_size;
    half_ = {h.x, h.y, h.z};
    middle_m_ = primitive->center.z;
  }

  void lay(const Tile& tile, double taken, Stream& draw, std::vector<HeapItem>& items) const {
    std::vector<bool> kept(pieces_.size()), carries(pieces_.size());
    std::vector<Pose> poses(pieces_.size());
    std::vector<int> layers(pieces_.size(), 0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      poses[i] = placed(pieces_[i].pose, tile);
      kept[i] =
          inside(poses[i]) &&
          std::ranges::all_of(pieces_[i].lies_on, [&](std::uint32_t below) { return kept[below]; });
      if (!kept[i]) continue;
      for (const std::uint32_t below : pieces_[i].lies_on) {
        carries[below] = true;
        layers[i] = std::max(layers[i], layers[below] + 1);
      }
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const bool on_board = pieces_[i].lies_on.empty();
      if (!kept[i] || (!on_board && !carries[i] && draw.chance(taken))) continue;
      items.push_back({poses[i], on_board, layers[i]});
    }
  }

 private:
  Pose placed(const Pose& pose, const Tile& tile) const {
    Pose at = pose;
    if (tile.turned) {
      at.position = {width_m_ - pose.position.x, depth_m_ - pose.position.y, pose.position.z};
      at.rotation = yaw_from_quarter_turns(2) * pose.rotation;
    }
    at.position = at.position + Vec3{tile.x, tile.y, 0};
    return at;
  }

  bool inside(const Pose& pose) const {
    constexpr double margin_m = 0.001;
    const Vec3 middle = pose * Vec3{0, 0, middle_m_};
    const Vec3 reach = ellipsoid_half_extents(pose.rotation, half_);
    return middle.x - reach.x >= margin_m && middle.x + reach.x <= room_.width_m - margin_m &&
           middle.y - reach.y >= margin_m && middle.y + reach.y <= room_.depth_m - margin_m &&
           middle.z + reach.z <= room_.clearance_m;
  }

  std::vector<catalog::HeapPiece> pieces_;
  ShelfRoom room_;
  double width_m_, depth_m_;
  Vec3 half_;
  double middle_m_ = 0;
};

}  // namespace

std::vector<HeapItem> laid_heap(const catalog::HeapRow& row,
                                const catalog::Product& product,
                                const ShelfRoom& room,
                                double taken,
                                Stream& draw) {
  const Cutter cutter(row, product, room);
  const double width = row.width_mm * 1e-3, depth = row.depth_mm * 1e-3;
  const int across = static_cast<int>(std::ceil(room.width_m / width)),
            deep = static_cast<int>(std::ceil(room.depth_m / depth));
  // One that is larger than the room shows another part of itself every time.
  const double spare_x = across * width - room.width_m, spare_y = deep * depth - room.depth_m;
  const double from_x = -spare_x * draw.uniform(), from_y = -spare_y * draw.uniform();
  std::vector<HeapItem> items;
  for (int j = 0; j < deep; ++j) {
    for (int i = 0; i < across; ++i) {
      const bool turned = draw.chance(0.5);
      cutter.lay({from_x + i * width, from_y + j * depth, turned}, taken, draw, items);
    }
  }
  return items;
}

}  // namespace marketgen::scene
