#include "assets/materials/texture_field.h"

#include <algorithm>
#include <cmath>

namespace marketgen::assets {
namespace {

// Where each texel of an axis falls into the lattice: cell before it and smooth weight of the cell
// after it.
struct LatticeAxis {
  std::vector<int> cell, next;
  std::vector<float> weight;

  LatticeAxis(int length, int cells) {
    const auto count = static_cast<std::size_t>(length);
    cell.reserve(count);
    next.reserve(count);
    weight.reserve(count);
    for (int i = 0; i < length; ++i) {
      const float at =
          (static_cast<float>(i) + 0.5F) * static_cast<float>(cells) / static_cast<float>(length);
      const int low = static_cast<int>(at);
      cell.push_back(low % cells);
      next.push_back((low + 1) % cells);
      weight.push_back(smooth_step(0, 1, at - static_cast<float>(low)));
    }
  }
};

void add_octave(TextureField& field, int cells_x, int cells_y, float amplitude, const Seed& seed) {
  cells_x = std::min(cells_x, field.width);
  cells_y = std::min(cells_y, field.height);
  const auto columns = static_cast<std::size_t>(cells_x);
  std::vector<float> lattice(columns * static_cast<std::size_t>(cells_y));
  Stream draw = seed.stream();
  for (float& knot : lattice)
    knot = static_cast<float>(draw.uniform()) * amplitude;
  const LatticeAxis along(field.width, cells_x);
  const LatticeAxis down(field.height, cells_y);
  std::vector<float> knots(columns);
  for (int y = 0; y < field.height; ++y) {
    const auto at_y = static_cast<std::size_t>(y);
    const float* upper = &lattice[static_cast<std::size_t>(down.cell[at_y]) * columns];
    const float* lower = &lattice[static_cast<std::size_t>(down.next[at_y]) * columns];
    for (std::size_t i = 0; i < knots.size(); ++i)
      knots[i] = upper[i] + (lower[i] - upper[i]) * down.weight[at_y];
    float* to = field.row(y);
    for (std::size_t x = 0; x < static_cast<std::size_t>(field.width); ++x) {
      const float left = knots[static_cast<std::size_t>(along.cell[x])];
      const float right = knots[static_cast<std::size_t>(along.next[x])];
      to[x] += left + (right - left) * along.weight[x];
    }
  }
}

int wrapped(int i, int length) {
  return ((i % length) + length) % length;
}

// One bump, in pixels; the texture wraps round.
struct Bump {
  float x, y, radius_x, radius_y;
};

void stamp(TextureField& field, const Bump& bump) {
  const int y0 = static_cast<int>(std::floor(bump.y - bump.radius_y));
  const int y1 = static_cast<int>(std::ceil(bump.y + bump.radius_y));
  const int x0 = static_cast<int>(std::floor(bump.x - bump.radius_x));
  const int x1 = static_cast<int>(std::ceil(bump.x + bump.radius_x));
  for (int y = y0; y <= y1; ++y) {
    const float dy = (static_cast<float>(y) + 0.5F - bump.y) / bump.radius_y;
    float* row = field.row(wrapped(y, field.height));
    for (int x = x0; x <= x1; ++x) {
      const float dx = (static_cast<float>(x) + 0.5F - bump.x) / bump.radius_x;
      float& value = row[wrapped(x, field.width)];
      value = std::max(value, 1 - dx * dx - dy * dy);
    }
  }
}

}  // namespace

float TextureField::wrapped_at(float x, float y) const {
  const float x0 = std::floor(x), y0 = std::floor(y);
  const float fx = x - x0, fy = y - y0;
  const int left = wrapped(static_cast<int>(x0), width), right = left + 1 < width ? left + 1 : 0;
  const float* upper = row(wrapped(static_cast<int>(y0), height));
  const float* lower = row(wrapped(static_cast<int>(y0) + 1, height));
  const float top = upper[left] + (upper[right] - upper[left]) * fx;
  const float bottom = lower[left] + (lower[right] - lower[left]) * fx;
  return top + (bottom - top) * fy;
}

TextureField noise_field(int width, int height, const NoiseShape& shape, const Seed& seed) {
  TextureField field(width, height);
  float total = 0;
  float amplitude = 1;
  for (int octave = 0; octave < shape.octaves; ++octave, amplitude *= shape.roughness)
    total += amplitude;
  amplitude = 1 / total;
  for (int octave = 0; octave < shape.octaves; ++octave, amplitude *= shape.roughness) {
    add_octave(field,
               shape.cells_x << octave,
               shape.cells_y << octave,
               amplitude,
               seed.child("octave", static_cast<std::uint64_t>(octave)));
  }
  return field;
}

TextureField bump_field(int width, int height, const BumpShape& shape, const Seed& seed) {
  TextureField field(width, height);
  Stream draw = seed.stream();
  const float step_x = static_cast<float>(width) / static_cast<float>(shape.columns);
  const float step_y = static_cast<float>(height) / static_cast<float>(shape.rows);
  const auto jitter = [&] { return shape.jitter * static_cast<float>(draw.uniform(-0.5, 0.5)); };
  for (int row = 0; row < shape.rows; ++row) {
    for (int column = 0; column < shape.columns; ++column) {
      const float shift = row % 2 == 0 ? 0.25F : 0.75F;
      const float x = (static_cast<float>(column) + shift + jitter()) * step_x;
      const float y = (static_cast<float>(row) + 0.5F + jitter()) * step_y;
      const float size =
          shape.radius * (1 - shape.radius_spread * static_cast<float>(draw.uniform()));
      if (draw.chance(shape.share)) stamp(field, {x, y, size * step_x, size * step_y});
    }
  }
  return field;
}

}  // namespace marketgen::assets
