#include "render/draft.h"

#include <cmath>
#include <optional>

#include "assets/material_texture.h"
#include "base/parallel.h"
#include "io/json.h"
#include "render/picture_cache.h"

namespace marketgen::raytrace {
namespace {

constexpr int material_texture_px = 512;

}  // namespace

std::int32_t Draft::texture(const std::string& content, std::function<Result<Image>()> draw) {
  const auto [entry, is_new] =
      texture_of_content_.try_emplace(content, static_cast<std::int32_t>(orders_.size()));
  if (is_new) orders_.push_back({content, std::move(draw)});
  return entry->second;
}

std::uint16_t Draft::material(const Material& material) {
  const auto next = static_cast<std::uint16_t>(world_.materials.size());
  if (world_.materials.size() > 65'000) fatal("more than 65,000 materials in one world");
  const bool glows = material.emission.x + material.emission.y + material.emission.z > 0;
  if (!glows) {
    const float kind = static_cast<float>(material.texture) * 2 + (material.glass ? 1.0F : 0.0F);
    const std::array<float, 6> look{material.color.x,
                                    material.color.y,
                                    material.color.z,
                                    material.roughness,
                                    material.metallic,
                                    kind};
    const auto [entry, is_new] = material_of_look_.try_emplace(look, next);
    if (!is_new) return entry->second;
  }
  world_.materials.push_back(material);
  return next;
}

const MaterialRow* Draft::row(std::string_view id) const {
  for (const MaterialRow& candidate : scene_.materials) {
    if (candidate.id == id) return &candidate;
  }
  return nullptr;
}

std::uint16_t Draft::tiled_material(std::string_view id) {
  const MaterialRow* found = row(id);
  if (found == nullptr) return material({.color = {0.8F, 0.8F, 0.78F}, .roughness = 0.8F});
  Material result{.color = {1, 1, 1},
                  .roughness = static_cast<float>(found->roughness),
                  .metallic = static_cast<float>(found->metallic)};
  const MaterialRow copy = *found;
  result.texture =
      texture("material " + std::to_string(material_texture_px) + write_json_line(copy),
              [copy] { return Result<Image>(draw_material(copy, material_texture_px)); });
  return material(result);
}

float Draft::extent_m(std::string_view id) const {
  const MaterialRow* found = row(id);
  return found == nullptr ? 1 : static_cast<float>(material_extent_m(*found));
}

Result<void> Draft::draw_textures(Progress& progress) {
  std::vector<Texture>& textures = world_.textures;
  const std::size_t done = textures.size();
  textures.resize(orders_.size());
  std::vector<std::optional<Error>> errors(orders_.size());
  progress.begin("labels", orders_.size() - done);
  parallel_for(orders_.size() - done, [&](std::size_t k) {
    const std::size_t i = done + k;
    const Result<Image> image = cached_picture(orders_[i].content, orders_[i].draw);
    if (image.ok())
      textures[i] = Texture(*image);
    else
      errors[i] = image.error();
    progress.advance();
  });
  progress.end();
  for (const std::optional<Error>& error : errors) {
    if (error) return *error;
  }
  return {};
}

}  // namespace marketgen::raytrace
