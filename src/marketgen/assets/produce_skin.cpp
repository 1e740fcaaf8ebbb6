#include "assets/produce_skin.h"

#include <algorithm>
#include <array>
#include <string>

#include "assets/texture_field.h"
#include "base/text.h"

namespace marketgen {
namespace {

// How the mark colour lies on the body colour.
enum class SkinTexture {
  smooth,
  streaked,
  specks,
  peel,
  striped,
  netted,
  scales,
  ringed,
  ridged,
  fibres,
  ripening,
  blotched,
  kernels,
  florets,
  leafy
};

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
#include "assets/produce_skins.inc"
#undef SKIN
};

SkinRecipe recipe_of(const PackArt& art) {
  const std::string text = lower_ascii(art.product->variant + " " + art.product->name);
  for (const SkinRow& row : skin_rows) {
    for (const std::string& word : split(row.words, '|')) {
      if (text.find(word) != std::string::npos) return row.recipe;
    }
  }
  return {
      SkinTexture::smooth, art.secondary, art.primary, art.accent, darker(art.primary, 0.3), 0.3};
}

// Maps every value of a field.
template <class Function>
TextureField mapped(TextureField field, Function function) {
  for (float& value : field.values)
    value = function(value);
  return field;
}

template <class Function>
TextureField combined(TextureField a, const TextureField& b, Function function) {
  for (std::size_t i = 0; i < a.values.size(); ++i)
    a.values[i] = function(a.values[i], b.values[i]);
  return a;
}

TextureField streaks(int w, int h, const Seed& seed) {
  const TextureField fine = noise_field(w, h, {48, 2, 3, 0.7F}, seed.child("fine"));
  const TextureField wide = noise_field(w, h, {3, 2, 2, 0.5F}, seed.child("wide"));
  return combined(
      fine, wide, [](float f, float b) { return smooth_step(0.45F, 0.75F, f * 0.75F + b * 0.4F); });
}

TextureField rings(int w, int h, const Seed& seed) {
  const TextureField lines = noise_field(w, h, {3, 34, 3, 0.6F}, seed.child("lines"));
  const TextureField where = noise_field(w, h, {6, 12, 2, 0.5F}, seed.child("where"));
  return combined(lines, where, [](float l, float o) {
    return smooth_step(0.60F, 0.78F, l * 0.75F + o * 0.35F);
  });
}

// A wave of `count` crests along x, warped by noise: 1 on a crest.
TextureField crests(int w, int h, int count, float warp, const Seed& seed) {
  TextureField field = noise_field(w, h, {count * 2, 6, 3, 0.6F}, seed);
  for (int y = 0; y < h; ++y) {
    float* row = field.row(y);
    for (int x = 0; x < w; ++x) {
      const float at = static_cast<float>(x) * static_cast<float>(count) / static_cast<float>(w) +
                       (row[x] - 0.5F) * warp;
      const float turn = at - static_cast<float>(static_cast<int>(at + 8) - 8);
      const float triangle = turn < 0.5F ? turn * 2 : 2 - turn * 2;
      row[x] = triangle;
    }
  }
  return field;
}

TextureField leaf_veins(int w, int h, const Seed& seed) {
  TextureField ribs = mapped(crests(w, h, 9, 0.7F, seed.child("ribs")),
                             [](float c) { return smooth_step(0.80F, 1.0F, c); });
  const TextureField folds = noise_field(w, h, {10, 9, 4, 0.6F}, seed.child("folds"));
  return combined(ribs, folds, [](float r, float f) {
    return std::min(1.0F, r * 0.8F + smooth_step(0.42F, 0.7F, f) * 0.45F);
  });
}

TextureField banana_marks(int w, int h, const Seed& seed) {
  TextureField specks = bump_field(w, h, {30, 40, 0.35F, 0.9F, 0.8F, 0.10F}, seed.child("specks"));
  const TextureField edges = crests(w, h, 5, 0.05F, seed.child("edges"));
  return combined(specks, edges, [](float s, float e) {
    return std::min(1.0F, smooth_step(0.0F, 0.8F, s) * 0.6F + smooth_step(0.96F, 1.0F, e) * 0.35F);
  });
}

// Share of the mark colour everywhere, 0..1.
TextureField mark_field(SkinTexture texture, int w, int h, const Seed& seed) {
  switch (texture) {
    case SkinTexture::smooth:
      return mapped(noise_field(w, h, {2, 2, 4, 0.45F}, seed),
                    [](float n) { return smooth_step(0.48F, 0.72F, n); });
    case SkinTexture::streaked:
      return streaks(w, h, seed);
    case SkinTexture::specks:
      return mapped(bump_field(w, h, {56, 34, 0.20F, 0.9F, 0.6F, 0.75F}, seed),
                    [](float b) { return smooth_step(0.0F, 0.7F, b); });
    case SkinTexture::peel:
      return mapped(bump_field(w, h, {110, 62, 0.42F, 0.7F, 0.4F, 0.9F}, seed),
                    [](float b) { return smooth_step(0.1F, 1.0F, b); });
    case SkinTexture::striped:
      return mapped(crests(w, h, 10, 0.9F, seed),
                    [](float c) { return smooth_step(0.45F, 0.75F, c); });
    case SkinTexture::netted:
      return mapped(noise_field(w, h, {26, 14, 2, 0.5F}, seed), [](float n) {
        return 1 - smooth_step(0.0F, 0.055F, n > 0.5F ? n - 0.5F : 0.5F - n);
      });
    case SkinTexture::scales:
      return mapped(bump_field(w, h, {14, 14, 0.74F, 0.0F, 0.0F, 1.0F}, seed),
                    [](float b) { return 1 - smooth_step(0.05F, 0.6F, b); });
    case SkinTexture::ringed:
      return rings(w, h, seed);
    case SkinTexture::ridged:
      return mapped(crests(w, h, 12, 0.25F, seed),
                    [](float c) { return smooth_step(0.55F, 1.0F, c); });
    case SkinTexture::fibres:
      return mapped(noise_field(w, h, {90, 24, 2, 0.8F}, seed),
                    [](float n) { return smooth_step(0.45F, 0.75F, n); });
    case SkinTexture::ripening:
      return banana_marks(w, h, seed);
    case SkinTexture::blotched: {
      const TextureField eyes =
          bump_field(w, h, {9, 7, 0.22F, 0.9F, 0.5F, 0.5F}, seed.child("eyes"));
      const TextureField dirt = noise_field(w, h, {8, 6, 5, 0.65F}, seed.child("dirt"));
      return combined(eyes, dirt, [](float e, float d) {
        return std::min(1.0F,
                        smooth_step(0.1F, 0.9F, e) * 0.9F + smooth_step(0.5F, 0.8F, d) * 0.5F);
      });
    }
    case SkinTexture::kernels:
      return mapped(bump_field(w, h, {18, 40, 0.62F, 0.1F, 0.0F, 1.0F}, seed),
                    [](float b) { return 1 - smooth_step(0.05F, 0.55F, b); });
    case SkinTexture::florets:
      return mapped(bump_field(w, h, {34, 24, 0.85F, 0.8F, 0.35F, 1.0F}, seed),
                    [](float b) { return 1 - smooth_step(0.15F, 0.95F, b); });
    case SkinTexture::leafy:
      return leaf_veins(w, h, seed);
  }
  return TextureField(w, h);
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

}  // namespace

Image draw_produce_skin(const PackArt& art, int width_px, int height_px) {
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

}  // namespace marketgen
