// Which part of a shop each square of a photo shows.
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "photo/bank.h"
#include "photo/cells.h"

namespace marketgen::photo {

constexpr std::array<std::string_view, 5> part_names = {
    "floor", "wall", "ceiling", "fixture", "goods"};
constexpr std::size_t part_count = part_names.size();

using PartShares = std::array<double, part_count>;  // add up to 1

// Numbers of the first model for each cell: its own, what it differs by from its neighbours and
// from the whole photo, and where it is. A row per cell.
std::vector<std::vector<double>> first_numbers(const Cells& cells);
// Numbers of the second model: those of the first, and what the first said of the cell, of those
// around it, above, below and beside it, and of the whole photo.
std::vector<std::vector<double>> second_numbers(const Cells& cells,
                                                const std::vector<std::vector<double>>& first,
                                                const std::vector<PartShares>& said);

// What a model makes of rows of numbers. Precondition: sizes fit (load_bank checks them).
std::vector<PartShares> parts_by(const PartModel& model,
                                 const std::vector<std::vector<double>>& numbers);

// Both models. A row per cell.
std::vector<PartShares> parts_of(const Cells& cells, const Bank& bank);

// How many numbers the two models take.
std::size_t first_number_count();
std::size_t second_number_count();

}  // namespace marketgen::photo
