#include "assets/materials/produce_skin.h"

#include <algorithm>
#include <array>
#include <string>

#include "assets/materials/baked_skin.h"
#include "assets/materials/skin_marks.h"
#include "assets/print/plu_sticker.h"
#include "base/text.h"

namespace marketgen::assets {
namespace {

struct SkinRecipe {
  SkinTexture texture = SkinTexture::smooth;
  Color stem, body, end, mark;
  double strength = 0.5;
};

struct SkinRow {
  std::string_view words;
  SkinRecipe recipe;
};

constexpr SkinRow skin_rows[] = {
#define SKIN(words, texture, stem, body, end, mark, strength) \
  {words, {SkinTexture::texture, rgb(stem), rgb(body), rgb(end), rgb(mark), strength}},
#include "assets/materials/produce_skins.inc"
#undef SKIN
};

const SkinRow* row_for(const std::string& text) {
  for (const SkinRow& row : skin_rows) {
    for (const std::string& word : marketgen::split(row.words, '|')) {
      if (text.find(word) != std::string::npos) return &row;
    }
  }
  return nullptr;
}

// The recipe's colours moved towards the row's: the body takes the row's primary colour, the rest
// follows by the given shares.
SkinRecipe tinted(SkinRecipe recipe, const Color& body) {
  constexpr double ends_follow = 0.6, mark_follows = 0.35;
  const Color from = recipe.body;
  const auto moved = [&](const Color& c, double share) {
    const auto component = [share](double value, double was, double now) {
      return std::clamp(value + share * (now - was), 0.0, 1.0);
    };
    return Color{component(c.r, from.r, body.r),
                 component(c.g, from.g, body.g),
                 component(c.b, from.b, body.b)};
  };
  recipe.stem = moved(recipe.stem, ends_follow);
  recipe.end = moved(recipe.end, ends_follow);
  recipe.mark = moved(recipe.mark, mark_follows);
  recipe.body = body;
  return recipe;
}

// By the product's words, otherwise by the shape it has.
SkinRecipe recipe_of(const PackArt& art) {
  const catalog::Product& product = *art.product;
  const SkinRow* row = row_for(lower_ascii(product.variant + " " + product.name));
  if (row == nullptr) row = row_for(product.archetype);
  if (row != nullptr) return tinted(row->recipe, art.primary);
  return {
      SkinTexture::smooth, art.secondary, art.primary, art.accent, darker(art.primary, 0.3), 0.3};
}

// Colour of the bare body at v: the stem's within the first eighth, the other end's within the
// last.
Color body_at(const SkinRecipe& recipe, double v) {
  const auto share = [](double low, double high, double x) {
    return static_cast<double>(
        smooth_step(static_cast<float>(low), static_cast<float>(high), static_cast<float>(x)));
  };
  const Color upper = blend(recipe.stem, recipe.body, share(0.02, 0.26, v));
  return blend(upper, recipe.end, share(0.78, 0.99, v));
}

Image draw_grown_skin(const PackArt& art, int width_px, int height_px) {
  const SkinRecipe recipe = recipe_of(art);
  const Seed seed = art.seed.child("skin");
  const TextureField mark = mark_field(recipe.texture, width_px, height_px, seed.child("mark"));
  const TextureField shade =
      noise_field(width_px, height_px, {5, 4, 5, 0.55F}, seed.child("shade"));
  constexpr float shade_depth = 0.22F;
  Image image(width_px, height_px);
  const auto strength = static_cast<float>(recipe.strength);
  for (int y = 0; y < height_px; ++y) {
    const Color body = body_at(recipe, (y + 0.5) / height_px);
    const std::array<float, 3> ground{
        static_cast<float>(body.r), static_cast<float>(body.g), static_cast<float>(body.b)};
    const std::array<float, 3> marked{static_cast<float>(recipe.mark.r),
                                      static_cast<float>(recipe.mark.g),
                                      static_cast<float>(recipe.mark.b)};
    const float* mark_row = mark.row(y);
    const float* shade_row = shade.row(y);
    std::uint8_t* to = image.at(0, y);
    for (int x = 0; x < width_px; ++x, to += 3) {
      const float share = mark_row[x] * strength;
      const float light = 1 + (shade_row[x] - 0.5F) * 2 * shade_depth;
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = (ground[c] + (marked[c] - ground[c]) * share) * light;
        to[c] = byte_of(value);
      }
    }
  }
  return image;
}

}  // namespace

Image draw_produce_skin(const PackArt& art, int width_px, int height_px) {
  if (is_baked(*art.product)) return draw_baked_skin(art, width_px, height_px);
  Image image = draw_grown_skin(art, width_px, height_px);
  if (carries_plu_sticker(*art.product)) put_plu_sticker(image, art);
  return image;
}

}  // namespace marketgen::assets
