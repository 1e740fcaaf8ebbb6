#include "render/stage/draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "assets/materials/material_texture.h"
#include "assets/print/color.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "io/json.h"
#include "render/picture_cache.h"

namespace marketgen::render::raytrace {
namespace {

constexpr int material_texture_px = 512;
// Panes let rays straight through; glass rougher than this is milky: some of its diffuse light
// leaves on the far side.
constexpr double clearest_frost = 0.3;

// Colour, the normal's x and y, roughness and metallic, one byte each.
Image interleaved(const assets::MaterialMaps& maps) {
  constexpr std::size_t channels = 7;
  Image image(maps.base_color.width, maps.base_color.height, channels);
  std::uint8_t* to = image.pixels.data();
  for (std::size_t i = 0; i < maps.roughness.pixels.size(); ++i, to += channels) {
    std::copy_n(&maps.base_color.pixels[3 * i], 3, to);
    std::copy_n(&maps.normal.pixels[3 * i], 2, to + 3);
    to[5] = maps.roughness.pixels[i];
    to[6] = maps.metallic.pixels[i];
  }
  return image;
}

}  // namespace

std::int32_t Draft::add_order(Order wanted) {
  const auto [entry, is_new] =
      texture_of_content_.try_emplace(wanted.content, static_cast<std::int32_t>(orders_.size()));
  if (is_new) orders_.push_back(std::move(wanted));
  return entry->second;
}

std::int32_t Draft::texture(const std::string& content, std::function<Result<Image>()> draw) {
  return add_order({content, std::move(draw), false, {}});
}

std::int32_t Draft::relief_texture(const std::string& content,
                                   std::function<Result<Image>()> draw) {
  return add_order({content, std::move(draw), true, {}, detail_.coarser});
}

std::int32_t Draft::print_texture(const std::string& content,
                                  std::function<Result<assets::PrintedPicture>()> draw) {
  return add_order({content, {}, false, std::move(draw)});
}

std::int32_t Draft::label_texture(const std::string& content,
                                  std::function<Result<assets::PrintedPicture>()> draw) {
  return add_order({content, {}, false, std::move(draw), detail_.coarser});
}

std::uint16_t Draft::material(const Material& material) {
  const auto next = static_cast<std::uint16_t>(world_.materials.size());
  if (world_.materials.size() > 65'000) fatal("more than 65,000 materials in one world");
  const bool glows = material.emission.x + material.emission.y + material.emission.z > 0;
  if (!glows) {
    const float kind = static_cast<float>(material.texture) * 4 + (material.glass ? 1.0F : 0.0F) +
                       (material.clear ? 2.0F : 0.0F);
    const MaterialLook look{material.color.x,
                            material.color.y,
                            material.color.z,
                            material.roughness,
                            material.metallic,
                            material.roughness_scale,
                            kind,
                            material.refraction,
                            material.absorption_per_m.x,
                            material.absorption_per_m.y,
                            material.absorption_per_m.z,
                            material.coat,
                            material.coat_roughness,
                            material.translucency,
                            material.scatter_m};
    const auto [entry, is_new] = material_of_look_.try_emplace(look, next);
    if (!is_new) return entry->second;
  }
  world_.materials.push_back(material);
  return next;
}

const catalog::MaterialRow* Draft::row(std::string_view id) const {
  for (const catalog::MaterialRow& candidate : scene_.materials) {
    if (candidate.id == id) return &candidate;
  }
  return nullptr;
}

std::uint16_t Draft::pane(const catalog::MaterialRow& row) {
  const Result<Vec3f> tint = assets::linear_from_hex(row.color);
  const auto through = static_cast<float>(row.transmission);
  const Vec3f color = (tint.ok() ? *tint : Vec3f{1, 1, 1}) * through;
  // A pane is a box with two faces: each takes half of the tint.
  return material({.color = {std::sqrt(color.x), std::sqrt(color.y), std::sqrt(color.z)},
                   .roughness = static_cast<float>(row.roughness),
                   .glass = true});
}

// What cannot be drawn is seen, and said.
std::uint16_t Draft::missing_material(std::string_view id) {
  if (missing_.insert(std::string(id)).second)
    log_warning(fmt::format("material \"{}\" is not among the store's: drawn as a checker", id));
  Material checker{.color = {1, 1, 1}, .roughness = 0.8F};
  checker.texture = texture("missing material", [] {
    constexpr int side = 64, square = 8;
    Image image(side, side);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const bool dark = (x / square + y / square) % 2 != 0;
        const std::array<std::uint8_t, 3> color = dark ? std::array<std::uint8_t, 3>{20, 20, 20}
                                                       : std::array<std::uint8_t, 3>{255, 0, 220};
        std::copy(color.begin(), color.end(), image.at(x, y));
      }
    }
    return Result<Image>(std::move(image));
  });
  return material(checker);
}

std::uint16_t Draft::tiled_material(std::string_view id) {
  const catalog::MaterialRow* found = row(id);
  if (found == nullptr && (id.empty() || scene_.materials.empty()))
    return material({.color = {0.8F, 0.8F, 0.78F}, .roughness = 0.8F});
  if (found == nullptr) return missing_material(id);
  return tiled_material(*found);
}

std::uint16_t Draft::tiled_material(const catalog::MaterialRow& row) {
  const bool clear = row.transmission > 0 && row.roughness < clearest_frost;
  if (clear && row.pattern == catalog::MaterialPattern::smooth) return pane(row);
  Material result{.color = {1, 1, 1},
                  .roughness = static_cast<float>(row.roughness),
                  .metallic = static_cast<float>(row.metallic)};
  if (!clear) result.translucency = static_cast<float>(row.transmission);  // milky
  const catalog::MaterialRow copy = row;
  result.texture = relief_texture(
      "material maps " + std::to_string(material_texture_px) + io::write_json_line(copy), [copy] {
        return Result<Image>(interleaved(assets::draw_material_maps(copy, material_texture_px)));
      });
  result.relief = result.texture;
  if (clear) {  // patterned glass: tinted by its texture, each of a pane's faces by half
    const auto through = static_cast<float>(std::sqrt(row.transmission));
    result.color = {through, through, through};
    result.glass = true;
  }
  return material(result);
}

float Draft::extent_m(std::string_view id) const {
  const catalog::MaterialRow* found = row(id);
  return found == nullptr ? 1 : static_cast<float>(assets::material_extent_m(*found));
}

Result<void> Draft::carry_out(std::size_t order) {
  const Order& wanted = orders_[order];
  if (wanted.print) {
    MARKETGEN_TRY(Print print, cached_print(wanted.content, wanted.print));
    world_.textures[order] = wanted.coarser > 0 ? Texture(print.blocks.coarser(wanted.coarser))
                                                : Texture(std::move(print.blocks), print.bars);
    return {};
  }
  MARKETGEN_TRY(const Image image, cached_picture(wanted.content, wanted.draw));
  Texture texture(image);
  world_.textures[order] =
      wanted.coarser > 0 ? texture.coarser(wanted.coarser) : std::move(texture);
  if (!wanted.relief) return {};
  ReliefTexture relief(image, 3);
  world_.reliefs[order] = wanted.coarser > 0 ? relief.coarser(wanted.coarser) : std::move(relief);
  return {};
}

void Draft::remember_whole_tiles(std::size_t from) {
  for (std::size_t order = from; order < orders_.size(); ++order) {
    const Order& tile = orders_[order];
    if (!tile.relief || tile.coarser == 0) continue;
    world_.whole_tiles[order] = {material_texture_px,
                                 material_texture_px,
                                 [content = tile.content, draw = tile.draw]() -> Result<Texture> {
                                   MARKETGEN_TRY(const Image image, cached_picture(content, draw));
                                   return Texture(image);
                                 }};
  }
}

Result<void> Draft::draw_textures(Progress& progress) {
  const std::size_t done = world_.textures.size();
  world_.textures.resize(orders_.size());
  world_.reliefs.resize(orders_.size());
  remember_whole_tiles(done);
  std::vector<std::optional<Error>> errors(orders_.size());
  progress.begin("labels", orders_.size() - done);
  parallel_for(orders_.size() - done, [&](std::size_t k) {
    const Result<void> drawn = carry_out(done + k);
    if (!drawn.ok()) errors[done + k] = drawn.error();
    progress.advance();
  });
  progress.end();
  for (const std::optional<Error>& error : errors) {
    if (error) return *error;
  }
  Hasher contents;
  for (const Order& order : orders_) {
    contents.add(order.content);
    if (order.coarser > 0) contents.add(std::to_string(order.coarser));
  }
  world_.art_key = contents.hex();
  return {};
}

}  // namespace marketgen::render::raytrace
