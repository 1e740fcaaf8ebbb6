#include "episodes/aisle/perturbed_aisle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scene/placements.h"

namespace marketgen::episodes {
namespace {

constexpr std::array shares{1.0, 0.5, 0.25, 0.125};
constexpr double min_upright = 0.9999;

// Upright boxes on a board: from above, in its frame.
struct Footprint {
  double x = 0, y = 0, half_x = 0, half_y = 0;
};

Footprint footprint_of(const Pose& shelf_from_product, const catalog::Product& goods) {
  const Vec3 across = rotate(shelf_from_product.rotation, {1, 0, 0});
  const double cosine = std::abs(across.x), sine = std::abs(across.y);
  const double w = goods.width_m() / 2, d = goods.depth_m() / 2;
  return {shelf_from_product.position.x,
          shelf_from_product.position.y,
          w * cosine + d * sine,
          w * sine + d * cosine};
}

// How deep they are in one another; less than 0 when they are apart.
double overlap_m(const Footprint& a, const Footprint& b) {
  return std::min(a.half_x + b.half_x - std::abs(a.x - b.x),
                  a.half_y + b.half_y - std::abs(a.y - b.y));
}

// How far it stands out over the board's edges.
double overhang_m(const Footprint& a, const scene::SceneShelf& board) {
  return std::max({std::abs(a.x) + a.half_x - board.width_m / 2,
                   a.half_y - a.y,
                   a.y + a.half_y - board.depth_m});
}

// The goods of one board.
class BoardShift {
 public:
  BoardShift(scene::Scene& scene, std::uint32_t board, const std::vector<std::uint32_t>& rows)
      : scene_(scene),
        board_(scene.shelves[board]),
        shelf_from_world_(inverse(scene::world_from_shelf(scene, board))),
        rows_(rows) {
    for (const std::uint32_t row : rows_)
      stands_.push_back(footprint(row, scene::world_from_product(scene_.products[row])));
  }

  void move(const Perturbation& perturbation) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      scene::SceneProduct& product = scene_.products[rows_[i]];
      const Pose stood = scene::world_from_product(product);
      if (scene_.facings[product.facing].stack > 1 ||
          rotate(stood.rotation, {0, 0, 1}).z < min_upright)
        continue;
      const std::string name = scene::product_id(scene_, rows_[i]);
      for (const double share : shares) {
        const Pose there = perturbation.moved(stood, name, share);
        const Footprint now = footprint(rows_[i], there);
        if (!has_room(i, now)) continue;
        stands_[i] = now;
        scene::place(product, there);
        break;
      }
    }
  }

 private:
  Footprint footprint(std::uint32_t row, const Pose& world_from_product) const {
    return footprint_of(shelf_from_world_ * world_from_product,
                        scene_.catalog[scene_.products[row].sku]);
  }

  // No deeper in anything, nor farther out, than where it stood.
  bool has_room(std::size_t i, const Footprint& now) const {
    const Footprint& stood = stands_[i];
    if (overhang_m(now, board_) > std::max(0.0, overhang_m(stood, board_))) return false;
    for (std::size_t other = 0; other < stands_.size(); ++other)
      if (other != i &&
          overlap_m(now, stands_[other]) > std::max(0.0, overlap_m(stood, stands_[other])))
        return false;
    return true;
  }

  scene::Scene& scene_;
  const scene::SceneShelf& board_;
  Pose shelf_from_world_;
  const std::vector<std::uint32_t>& rows_;
  std::vector<Footprint> stands_;
};

}  // namespace

std::shared_ptr<const AisleStore> perturbed_store(const AisleStore& store,
                                                  const Perturbation& perturbation) {
  auto made = std::make_shared<AisleStore>(store);
  scene::Scene& scene = made->scene;
  std::vector<std::vector<std::uint32_t>> on_board(scene.shelves.size());
  for (std::uint32_t row = 0; row < scene.products.size(); ++row)
    if (scene.products[row].facing != scene::no_facing)
      on_board[scene.facings[scene.products[row].facing].shelf].push_back(row);
  for (std::uint32_t board = 0; board < scene.shelves.size(); ++board) {
    const scene::SceneShelf& shelf = scene.shelves[board];
    if (shelf.use != assets::ShelfUse::stand || has_doors(scene, shelf.fixture)) continue;
    BoardShift(scene, board, on_board[board]).move(perturbation);
  }
  return made;
}

}  // namespace marketgen::episodes
