#include "scene/sold_goods.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <ranges>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace marketgen::scene {
namespace {

// Packs one behind another, each a stack: rows from the front, each from the board up.
struct Column {
  std::vector<std::vector<ShelfItem>> rows;
  int packs = 0;                      // that stand in it
  int from_front = 0, from_back = 0;  // of them, taken

  int left() const { return packs - from_front - from_back; }
};

// A block lists its items column by column, each from the front, stacks from the board up.
std::vector<Column> columns_of(const FilledBlock& block) {
  std::vector<Column> columns;
  const ShelfItem* last = nullptr;
  for (const ShelfItem& item : block.items) {
    const bool same_column = last != nullptr && last->position.x == item.position.x;
    if (!same_column) columns.emplace_back();
    if (!same_column || last->position.y != item.position.y) columns.back().rows.emplace_back();
    columns.back().rows.back().push_back(item);
    ++columns.back().packs;
    last = &item;
  }
  return columns;
}

// Each time from a column that still has something, whichever shoppers come to.
void take_at_random(std::vector<Column>& columns, UnitsWanted wanted, int sold, Stream& draw) {
  std::vector<Column*> stocked;
  for (Column& column : columns)
    stocked.push_back(&column);
  for (int i = 0; i < sold; ++i) {
    const auto which = draw.integer(0, static_cast<int>(stocked.size()) - 1);
    Column& column = *stocked[static_cast<std::size_t>(which)];
    ++(i < wanted.before_facing_up ? column.from_back : column.from_front);
    if (column.left() == 0) stocked.erase(stocked.begin() + which);
  }
}

// Takes the upper ones of a stack, as many as are there of `count`.
void take_from(std::vector<ShelfItem>& stack, int& count) {
  const int taken = std::min(count, static_cast<int>(stack.size()));
  stack.resize(stack.size() - static_cast<std::size_t>(taken));
  count -= taken;
}

void add_left(const Column& column, std::vector<ShelfItem>& items) {
  auto rows = column.rows;
  int front = column.from_front, back = column.from_back;
  for (auto& stack : rows)
    take_from(stack, front);
  for (auto& stack : std::ranges::reverse_view(rows))
    take_from(stack, back);
  bool is_front = true;
  for (const auto& stack : rows) {
    for (ShelfItem item : stack) {
      item.flags = is_front ? product_front_row : 0;
      items.push_back(item);
    }
    is_front = is_front && stack.empty();
  }
}

TakenInFront take_from_rows(FilledBlock& block, UnitsWanted wanted, int sold, Stream& draw) {
  std::vector<Column> columns = columns_of(block);
  take_at_random(columns, wanted, sold, draw);
  block.items.clear();
  TakenInFront taken;
  for (const Column& column : columns) {
    add_left(column, block.items);
    if (column.left() > 0) taken.push_back(column.from_front);
  }
  return taken;
}

// A piece lies on such of lower layers: those of the highest carry nothing. Of a layer shoppers
// take what is in front, but for what is within their reach.
void take_from_heap(FilledBlock& block, int sold, Stream& draw) {
  constexpr double reach_m = 0.3;
  std::vector<std::size_t> order(block.items.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::pair<int, double>> turn;  // the least goes first
  for (const ShelfItem& item : block.items)
    turn.emplace_back(-item.layer, item.position.y + reach_m * draw.uniform());
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return turn[i]; });
  std::vector<bool> gone(block.items.size(), false);
  for (int i = 0; i < sold; ++i)
    gone[order[static_cast<std::size_t>(i)]] = true;
  std::vector<ShelfItem> kept;
  for (std::size_t i = 0; i < block.items.size(); ++i)
    if (!gone[i]) kept.push_back(block.items[i]);
  block.items = std::move(kept);
}

}  // namespace

int capacity_of(const FilledBlock& block, bool heaped) {
  return heaped ? static_cast<int>(block.items.size())
                : block.facings * block.rows_deep * block.stack;
}

TakenInFront take_sold(
    FilledBlock& block, UnitsWanted wanted, bool heaped, bool leaves_one, Stream draw) {
  if (block.items.empty()) return {};
  const int most = static_cast<int>(block.items.size()) - (leaves_one ? 1 : 0);
  const int sold = std::min(wanted.all(), most);
  if (!heaped) return take_from_rows(block, wanted, sold, draw);
  take_from_heap(block, sold, draw);
  return {};
}

}  // namespace marketgen::scene
