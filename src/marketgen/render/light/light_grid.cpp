#include "render/light/light_grid.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr std::size_t max_choices = 40;  // per cell; in a store the rest add up to a few percent
constexpr float cell_width_m = 0.8F, cell_height_m = 0.6F;
constexpr float max_cells = 40'000;

// What a light gives unblocked at `point`, however a surface there is turned. Distances are kept
// off zero by the cell's size.
float strength(const AreaLight& light, Vec3f point) {
  const Vec3f to_light = light.middle() - point;
  const float distance2 = std::max(dot(to_light, to_light), 0.15F);
  const float facing = -dot(to_light, light.normal) / std::sqrt(distance2);
  // A cell straddles the light's plane: what is behind its middle may be before its edge.
  const float soft_facing = std::max(facing, 0.05F);
  return luminance(light.radiance) * light.area * soft_facing / distance2;
}

std::vector<LightChoice> strongest(const std::vector<AreaLight>& lights, Vec3f point) {
  std::vector<LightChoice> all(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    all[i] = {static_cast<std::uint32_t>(i), strength(lights[i], point)};
  }
  const auto stronger = [](const LightChoice& a, const LightChoice& b) {
    return a.cumulative != b.cumulative ? a.cumulative > b.cumulative : a.light < b.light;
  };
  const std::size_t kept = std::min(max_choices, all.size());
  std::partial_sort(
      all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end(), stronger);
  all.resize(kept);
  float sum = 0;
  for (const LightChoice& choice : all)
    sum += choice.cumulative;
  float reached = 0;
  for (LightChoice& choice : all) {
    reached += choice.cumulative / sum;
    choice.cumulative = reached;
  }
  if (!all.empty()) all.back().cumulative = 1;
  return all;
}

}  // namespace

LightGrid::LightGrid(const World& world) : world_(world), low_(world.room.low) {
  const Vec3f size = world.room.empty() ? Vec3f{1, 1, 1} : world.room.size();
  if (world.room.empty()) low_ = {0, 0, 0};
  const auto cells = [](float extent, float width) {
    return std::max(1.0F, std::ceil(extent / width));
  };
  const float layers = cells(size.z, cell_height_m);
  const float full = cells(size.x, cell_width_m) * cells(size.y, cell_width_m) * layers;
  const float width = cell_width_m * std::sqrt(std::max(1.0F, full / max_cells));
  columns_ = static_cast<int>(cells(size.x, width));
  rows_ = static_cast<int>(cells(size.y, width));
  layers_ = static_cast<int>(layers);
  cells_per_m_ = {static_cast<float>(columns_) / std::max(size.x, 1e-3F),
                  static_cast<float>(rows_) / std::max(size.y, 1e-3F),
                  static_cast<float>(layers_) / std::max(size.z, 1e-3F)};
  const auto count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) *
                     static_cast<std::size_t>(layers_);
  const auto lists = parallel_map(
      count,
      [&](std::size_t i) {
        const int cell = static_cast<int>(i);
        const Vec3f middle{(static_cast<float>(cell % columns_) + 0.5F) / cells_per_m_.x,
                           (static_cast<float>(cell / columns_ % rows_) + 0.5F) / cells_per_m_.y,
                           (static_cast<float>(cell / (columns_ * rows_)) + 0.5F) / cells_per_m_.z};
        return strongest(world.lights, low_ + middle);
      },
      16);
  for (const auto& list : lists) {
    first_.push_back(static_cast<std::uint32_t>(choices_.size()));
    choices_.insert(choices_.end(), list.begin(), list.end());
  }
  first_.push_back(static_cast<std::uint32_t>(choices_.size()));
}

std::size_t LightGrid::cell_of(Vec3f point) const {
  const Vec3f at = (point - low_) * cells_per_m_;
  const int x = std::clamp(static_cast<int>(at.x), 0, columns_ - 1);
  const int y = std::clamp(static_cast<int>(at.y), 0, rows_ - 1);
  const int z = std::clamp(static_cast<int>(at.z), 0, layers_ - 1);
  return static_cast<std::size_t>((z * rows_ + y) * columns_ + x);
}

std::span<const LightChoice> LightGrid::choices(Vec3f point) const {
  const std::size_t cell = cell_of(point);
  return std::span(choices_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
}

LightSample LightGrid::sample(Vec3f point, float pick, float u, float v) const {
  const std::span<const LightChoice> list = choices(point);
  if (list.empty()) return {};
  const auto below = [](float value, const LightChoice& choice) {
    return value < choice.cumulative;
  };
  auto found = std::upper_bound(list.begin(), list.end(), pick, below);
  if (found == list.end()) --found;
  const float start = found == list.begin() ? 0 : std::prev(found)->cumulative;
  const float probability = found->cumulative - start;
  const float leftover = (pick - start) / probability;
  u = u + leftover - std::floor(u + leftover);
  const AreaLight& light = world_.lights[found->light];
  const Vec3f to_light = light.corner + light.edge_u * u + light.edge_v * v - point;
  const float distance2 = std::max(dot(to_light, to_light), 1e-8F);
  LightSample sample;
  sample.light = found->light;
  sample.distance = std::sqrt(distance2);
  sample.direction = to_light / sample.distance;
  const float facing = -dot(sample.direction, light.normal);
  if (facing <= 1e-4F) return sample;
  sample.pdf = probability * distance2 / (facing * light.area);
  sample.irradiance_scale = light.radiance / sample.pdf;
  return sample;
}

float LightGrid::pdf(Vec3f point, std::int32_t light, Vec3f direction, float distance) const {
  float start = 0;
  for (const LightChoice& choice : choices(point)) {
    if (choice.light == static_cast<std::uint32_t>(light)) {
      const AreaLight& a = world_.lights[choice.light];
      const float facing = -dot(direction, a.normal);
      return facing <= 1e-4F
                 ? 0
                 : (choice.cumulative - start) * distance * distance / (facing * a.area);
    }
    start = choice.cumulative;
  }
  return 0;
}

}  // namespace marketgen::render::raytrace
