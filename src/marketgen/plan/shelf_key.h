// By what a plan's planogram knows a shelf.
#pragma once
#include <string>
#include <tuple>

#include "plan/planogram.h"

namespace marketgen::plan {

using ShelfKey =
    std::tuple<std::string, ShelfSide, int>;  // fixture, side, number from the floor up

// Of a scene's number: 0 is the front.
constexpr ShelfSide shelf_side(int side) {
  return side == 0 ? ShelfSide::front : ShelfSide::back;
}

// Of a StockedShelf, a ShelfChange or a BlockPlace.
template <class Shelf>
ShelfKey key_of(const Shelf& shelf) {
  return {shelf.fixture, shelf.side, shelf.shelf};
}

}  // namespace marketgen::plan
