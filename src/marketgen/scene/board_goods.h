// A bay's range dealt out to its boards: goods of one height share a board, heavy ones stand low.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "catalog/catalog.h"
#include "scene/planogram.h"
#include "scene/zone_range.h"

namespace marketgen::scene {

// Facings of one product on one board.
struct BoardPiece {
  std::size_t turn = 0;  // in the range: what comes from left to right
  std::uint32_t product = 0;
  int facings = 1;
  bool certain = false;
};
using BoardGoods = std::vector<BoardPiece>;  // of one board

// The range as pieces in the order in which boards take them, the lowest board first: heavy goods,
// then the others, the tallest first. Their facings are scaled so that together they take
// `front_m`.
std::vector<BoardPiece> in_board_order(const BayRange& range,
                                       double front_m,
                                       const catalog::Catalog& catalog);

// Board after board as wide as `board_m`; what is too much is left out.
std::vector<BoardGoods> deal_out(const std::vector<BoardPiece>& pieces,
                                 std::size_t boards,
                                 double board_m,
                                 const catalog::Catalog& catalog);

// Goods from here on stand on the lowest boards.
bool stands_low(const catalog::Product& product);

// As plan_bay(): the range on the bay's boards, `certain` first. What is left of a board is filled
// with more facings, with others of the range, with others of its kinds of the zone's assortment.
std::vector<PlannedShelf> plan_range(const Bay& bay,
                                     const BayRange& range,
                                     const std::vector<std::uint32_t>& assortment,
                                     const plan::StockSpec& stock,
                                     const catalog::Catalog& catalog,
                                     const std::vector<std::uint32_t>& certain);

}  // namespace marketgen::scene
