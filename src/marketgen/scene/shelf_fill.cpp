#include "scene/shelf_fill.h"

#include <algorithm>
#include <cmath>

#include "assets/product_model.h"
#include "scene/heap_fill.h"
#include "scene/scene.h"

namespace marketgen::scene {
namespace {

constexpr double kept_gap_m = 0.001;         // never less than this between neighbours
constexpr double block_gap_limit_m = 0.020;  // between blocks, when a shelf is not full
constexpr double max_yaw_tangent = 0.035;    // tan(half angle): 4 degrees either way
constexpr double pushed_back_m =
    0.012;  // a column's front item stands up to this far behind the edge
constexpr double shopped_share = 0.12;    // of columns have lost their front item, at jitter 1
constexpr double pile_taken_share = 0.4;  // of piles have lost the top one, at jitter 1
constexpr double sold_depth_share =
    0.8;  // a column has sold up to this share of its rows; the rest was pulled forward

// Whether it takes no more room however it is turned about its upright axis.
bool is_round(const catalog::Product& product) {
  const Result<assets::CollisionPrimitive> primitive = assets::collision_of(product);
  return primitive.ok() && primitive->shape == assets::CollisionShape::cylinder &&
         !primitive->lying && product.size_mm[0] == product.size_mm[1];
}

// Largest tan(half yaw) that keeps neighbours `kept_gap_m` apart: a turned box of depth d is d *
// yaw wider.
double yaw_limit(const catalog::Product& product, double jitter) {
  if (is_round(product)) return 0.12 * jitter;  // 14 degrees: a turned can takes no more room
  const double side = (pack_gap_m - kept_gap_m) / product.depth_m();
  const double back = (depth_gap_m - kept_gap_m) / product.width_m();
  return jitter * std::min({max_yaw_tangent, side / 2, back / 2});
}

// Rows that a column still has: those at the back are sold first, because staff pull the goods
// forward.
int rows_left(int rows, Stream& draw) {
  return std::max(
      1,
      static_cast<int>(static_cast<double>(rows) * (1 - sold_depth_share * draw.uniform()) + 0.5));
}

Quaternion turned(Stream& draw, double limit) {
  return rotation_from_half_tangent({0, 0, 1}, draw.uniform(-limit, limit));
}

// Bunches that are piled (StoreCatalog): what is bought is missing on top, not behind.
bool lies_in_a_pile(const catalog::Product& product) {
  return product.category == "produce" && product.material == "skin" && product.stack_max > 1 &&
         product.orientation == catalog::Orientation::flat;
}

// One column of a block of bunches: rows as far apart as if they filled the whole depth.
void pile_column(FilledBlock& block,
                 const catalog::Product& product,
                 double center_x,
                 const ShelfRoom& room,
                 const plan::StockSpec& stock,
                 Stream& draw) {
  const double pitch =
      room.depth_m / std::max(block.rows_deep, rows_that_fit(product, room, /*depth_fill=*/1));
  const double limit = yaw_limit(product, stock.jitter);
  for (int row = 0; row < block.rows_deep; ++row) {
    const double y = pitch * (row + 0.5);
    const bool taken = block.stack > 1 && draw.chance(pile_taken_share * stock.jitter);
    for (int level = 0; level < (taken ? block.stack - 1 : block.stack); ++level) {
      block.items.push_back({block.product,
                             {center_x, y, level * product.height_m()},
                             turned(draw, limit),
                             row == 0 ? product_front_row : 0});
    }
  }
}

// One column of a facing block: rows from front to back, each a stack.
void add_column(FilledBlock& block,
                const catalog::Product& product,
                double center_x,
                const ShelfRoom& room,
                const plan::StockSpec& stock,
                Stream& draw) {
  const double pitch = product.depth_m() + depth_gap_m;
  const double spare = room.depth_m - (static_cast<double>(block.rows_deep) * pitch - depth_gap_m);
  const double shift = std::min(spare, pushed_back_m) * stock.jitter * draw.uniform();
  const double limit = yaw_limit(product, stock.jitter);
  const int last_row = rows_left(block.rows_deep, draw);
  const int first_row = last_row > 1 && draw.chance(shopped_share * stock.jitter) ? 1 : 0;
  for (int row = first_row; row < last_row; ++row) {
    const double y = shift + product.depth_m() / 2 + static_cast<double>(row) * pitch;
    for (int level = 0; level < block.stack; ++level) {
      const double z = static_cast<double>(level) * product.height_m();
      block.items.push_back({block.product,
                             {center_x, y, z},
                             turned(draw, limit),
                             row == first_row ? product_front_row : 0});
    }
  }
}

void stand_items(FilledBlock& block,
                 const PlannedBlock& planned,
                 const catalog::Product& product,
                 const ShelfRoom& room,
                 const plan::StockSpec& stock,
                 Stream& draw) {
  block.stack = planned.stack.value_or(std::max(1, stack_height(product, room)));
  block.rows_deep = planned.rows_deep.value_or(rows_that_fit(product, room, stock.depth_fill));
  const double pitch = facing_pitch_m(product);
  const double left = block.x_m - room.width_m / 2;
  const auto& add = lies_in_a_pile(product) ? pile_column : add_column;
  for (int i = 0; i < block.facings; ++i) {
    add(block,
        product,
        left + pack_gap_m / 2 + product.width_m() / 2 + static_cast<double>(i) * pitch,
        room,
        stock,
        draw);
  }
}

constexpr int max_heap_layers = 3;         // of pieces that roll
constexpr double heap_taken_share = 0.25;  // of the topmost pieces, where stock is untidiest

// How loose pieces lie on one another: balls in the pockets of four, logs (along X) between two,
// blocks one on another.
enum class HeapKind { balls, logs, blocks };

HeapKind heap_kind_of(const catalog::Product& product) {
  const Result<assets::CollisionPrimitive> primitive = assets::collision_of(product);
  if (!primitive.ok()) return HeapKind::blocks;
  if (primitive->shape == assets::CollisionShape::ellipsoid) return HeapKind::balls;
  return primitive->lying ? HeapKind::logs : HeapKind::blocks;
}

// Of one layer over the next, in heights of a piece.
double layer_rise(HeapKind kind) {
  if (kind == HeapKind::balls) return std::sqrt(0.5);      // a ball among four
  return kind == HeapKind::logs ? std::sqrt(3.0) / 2 : 1;  // a cylinder between two
}

// A piece that lies any way round.
double across_m(const catalog::Product& product) {
  return std::max(product.width_m(), product.depth_m());
}

// From one column of a heap to the next.
double piece_pitch_m(const catalog::Product& product, HeapKind kind) {
  return (kind == HeapKind::balls ? across_m(product) : product.width_m()) + kept_gap_m;
}

int columns_of_heap(const catalog::Product& product, HeapKind kind, double width_m) {
  return std::max(1, static_cast<int>(width_m / piece_pitch_m(product, kind)));
}

// A settled heap, cut to the block.
void lay_heap(FilledBlock& block,
              const catalog::HeapRow& row,
              const catalog::Product& product,
              const ShelfRoom& room,
              const plan::StockSpec& stock,
              Stream& draw) {
  const double left = block.x_m - room.width_m / 2;
  const ShelfRoom own{block.width_m, room.depth_m, room.clearance_m, room.use, room.board_m};
  const double piece_m = across_m(product);
  double highest_m = 0;
  for (const HeapItem& item : laid_heap(row, product, own, heap_taken_share * stock.jitter, draw)) {
    const Vec3 at = item.pose.position;
    highest_m = std::max(highest_m, at.z);
    block.items.push_back({block.product,
                           {left + at.x, at.y, at.z},
                           item.pose.rotation,
                           at.y < piece_m ? product_front_row : 0,
                           item.layer});
  }
  block.rows_deep = std::max(1, static_cast<int>(room.depth_m / piece_m));
  block.stack = 1 + static_cast<int>(highest_m / (piece_m * layer_rise(HeapKind::balls)));
}

// Layers of a heap, each in the pockets of the one below.
void heap_items(FilledBlock& block,
                const catalog::Product& product,
                const ShelfRoom& room,
                const plan::StockSpec& stock,
                Stream& draw) {
  const HeapKind kind = heap_kind_of(product);
  const bool balls = kind == HeapKind::balls;
  const double w = piece_pitch_m(product, kind),
               d = (balls ? across_m(product) : product.depth_m()) + kept_gap_m;
  const double h = product.height_m();
  const double limit = balls ? 1.0 : 0.0;  // tan(half angle): 90 degrees either way
  const double rise = h * layer_rise(kind);
  const int max_layers = kind == HeapKind::blocks ? product.stack_max : max_heap_layers;
  const int columns = columns_of_heap(product, kind, block.width_m);
  const int rows = std::max(1, static_cast<int>(room.depth_m / d));
  const int layers = std::clamp(1 + static_cast<int>((room.clearance_m - h) / rise), 1, max_layers);
  const double left =
      block.x_m - room.width_m / 2 + (block.width_m - static_cast<double>(columns) * w) / 2;
  block.rows_deep = rows;
  block.stack = layers;
  block.facings = columns;
  for (int layer = 0; layer < layers; ++layer) {
    const int across = balls ? columns - layer : columns;
    const int deep = kind == HeapKind::blocks ? rows : rows - layer;
    const double shift_x = balls ? w / 2 * layer : 0;
    const double shift_y = kind == HeapKind::blocks ? 0 : d / 2 * layer;
    for (int row = 0; row < deep; ++row) {
      for (int column = 0; column < across; ++column) {
        if (layer == layers - 1 && layer > 0 && draw.chance(heap_taken_share * stock.jitter))
          continue;  // shoppers take from the top
        const Vec3 at{left + shift_x + w * (column + 0.5), shift_y + d * (row + 0.5), rise * layer};
        // balls lie any way round
        block.items.push_back(
            {block.product, at, turned(draw, limit), row == 0 ? product_front_row : 0, layer});
      }
    }
  }
}

// Gap to put before each block so that the shelf looks evenly filled.
double spread_gap(const PlannedShelf& plan,
                  const ShelfRoom& room,
                  const catalog::Catalog& catalog) {
  double used = 0;
  for (const PlannedBlock& block : plan) {
    used += block_width_m(block, catalog);
  }
  const double spare = std::max(0.0, room.width_m - used);
  return std::min(spare / static_cast<double>(plan.size() + 1), block_gap_limit_m);
}

}  // namespace

int rows_that_fit(const catalog::Product& product, const ShelfRoom& room, double depth_fill) {
  const double pitch = product.depth_m() + depth_gap_m;
  const int most = static_cast<int>((room.depth_m + depth_gap_m + 1e-9) / pitch);
  return std::max(1, static_cast<int>(static_cast<double>(most) * depth_fill + 0.5));
}

double block_width_m(const PlannedBlock& block, const catalog::Catalog& catalog) {
  return block.facings * facing_pitch_m(catalog.products[block.product]);
}

int facings_as_wide(const catalog::Product& product, const catalog::Catalog& catalog, int columns) {
  if (!lies_in_a_heap(product) || catalog.heap(product) != nullptr) return columns;
  const HeapKind kind = heap_kind_of(product);
  int facings = 1;
  while (columns_of_heap(product, kind, facings * facing_pitch_m(product)) < columns)
    ++facings;
  return facings;
}

std::vector<double> block_starts(const PlannedShelf& plan,
                                 const ShelfRoom& room,
                                 const catalog::Catalog& catalog) {
  std::vector<double> starts;
  if (plan.empty()) return starts;
  const double gap = spread_gap(plan, room, catalog);
  double x = gap;
  for (const PlannedBlock& block : plan) {
    starts.push_back(block.x_m.value_or(x));
    x = starts.back() + (block_width_m(block, catalog) + gap);
  }
  return starts;
}

bool lies_in_a_heap(const catalog::Product& product) {
  const bool loose = product.orientation == catalog::Orientation::any && product.material == "skin";
  return loose || product.archetype == "round_produce" ||
         product.archetype == "elongated_produce" || product.archetype == "leafy_produce";
}

bool lies_as_balls(const catalog::Product& product) {
  return lies_in_a_heap(product) && heap_kind_of(product) == HeapKind::balls;
}

std::uint64_t max_items(const PlannedBlock& block,
                        const ShelfRoom& room,
                        const plan::StockSpec& stock,
                        const catalog::Catalog& catalog) {
  const catalog::Product& product = catalog.products[block.product];
  const int rows = block.rows_deep.value_or(
      rows_that_fit(product, room, lies_in_a_heap(product) ? 1 : stock.depth_fill));
  const int high = std::max(max_heap_layers, stack_height(product, room));
  return static_cast<std::uint64_t>(block.facings) * static_cast<std::uint64_t>(rows) *
         static_cast<std::uint64_t>(lies_in_a_heap(product) ? high : stack_height(product, room));
}

std::vector<FilledBlock> fill_shelf(const PlannedShelf& plan,
                                    const ShelfRoom& room,
                                    const plan::StockSpec& stock,
                                    const catalog::Catalog& catalog,
                                    Stream draw) {
  std::vector<FilledBlock> blocks;
  if (plan.empty()) return blocks;
  const std::vector<double> starts = block_starts(plan, room, catalog);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const PlannedBlock& planned = plan[i];
    const catalog::Product& product = catalog.products[planned.product];
    FilledBlock block;
    block.product = planned.product;
    block.facings = planned.facings;
    block.x_m = starts[i];
    block.width_m = block_width_m(planned, catalog);
    const bool heaped = lies_in_a_heap(product);
    if (const catalog::HeapRow* heap = heaped ? catalog.heap(product) : nullptr)
      lay_heap(block, *heap, product, room, stock, draw);
    if (heaped && block.items.empty())  // no settled heap, or none of it has room
      heap_items(block, product, room, stock, draw);
    if (!heaped) stand_items(block, planned, product, room, stock, draw);
    if (draw.chance(stock.out_of_stock) && !planned.certain) block.items.clear();
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace marketgen::scene
