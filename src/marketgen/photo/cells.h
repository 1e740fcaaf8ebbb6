// A photo as squares, each with numbers for its colours, edges and grain.
#pragma once
#include <array>
#include <vector>

#include "photo/looked.h"

namespace marketgen::photo {

constexpr int cell_px = 16;
constexpr double chroma_unit = 64;  // of OpenCV's a and b
constexpr int hue_bins = 8, lightness_bins = 6, orientation_bins = 4, grain_scales = 3;
constexpr int pattern_bins = 10, pattern_scales = 2;

// Places of the numbers in a cell's row.
namespace number {
constexpr int mean = 0;            // L, a, b; see below for their units
constexpr int spread = mean + 3;   // standard deviations of L, a, b
constexpr int grain = spread + 3;  // |dL/dx| and |dL/dy|, at full, half and quarter size
constexpr int orientation = grain + 2 * grain_scales;  // shares of the edges, by direction
constexpr int hue = orientation + orientation_bins;    // chroma by hue
constexpr int lightness = hue + hue_bins;              // shares of the pixels
constexpr int chroma = lightness + lightness_bins;
constexpr int white = chroma + 1, dark = white + 1;  // shares of nearly white, nearly black pixels
// Shares of the pixels by their local binary pattern, turned alike, uniform ones apart (Ojala,
// Pietikainen and Maenpaa 2002, "riu2"), at full and half size.
constexpr int pattern = dark + 1;
constexpr int count = pattern + pattern_scales * pattern_bins;
}  // namespace number

using CellNumbers = std::array<double, number::count>;

// Row by row from the top left. Lightness is 1 for white; a, b and chroma are in 64ths of OpenCV's.
struct Cells {
  int columns = 0, rows = 0;
  std::vector<CellNumbers> numbers;
  CellNumbers whole{};  // mean over the photo

  const CellNumbers& at(int column, int row) const {
    return numbers[static_cast<std::size_t>(row) * columns + column];
  }
};

// Squares of cell_px; those at the right and lower edge are what is left of one.
Cells cells_of(const Looked& photo);

}  // namespace marketgen::photo
