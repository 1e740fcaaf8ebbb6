// Boards, goods and where they stand in the shop of support/hand_made_scene.h.
#pragma once
#include "support/hand_made_scene.h"

namespace marketgen {

constexpr float lower = HandMadeScene::lower_board_m, upper = HandMadeScene::upper_board_m;
constexpr float on_shelf_y = HandMadeScene::shelf_y_m - 0.1F;
constexpr std::uint32_t cereal = 0, can = 1, apple = 2;

}  // namespace marketgen
