#include "assets/materials/baked_skin.h"

#include <algorithm>
#include <array>
#include <optional>

#include "assets/materials/texture_field.h"
#include "assets/shapes/archetypes/crusty_loaf.h"
#include "base/text.h"

namespace marketgen::assets {
namespace {

// What lies on the crust.
enum class Topping { bare, flour, seeds, salt, chips, sprinkles, layers };

struct BakedRow {
  std::string_view archetype, words;
  Color top, side, foot;
  Topping topping;
  Color topping_color;
};
constexpr BakedRow baked_rows[] = {
#define BAKED(archetype, words, top, side, foot, topping, color) \
  {#archetype, words, rgb(top), rgb(side), rgb(foot), Topping::topping, rgb(color)},
#include "assets/materials/baked_skins.inc"
#undef BAKED
};

const BakedRow& row_of(const catalog::Product& product) {
  const std::string text = lower_ascii(product.variant + " " + product.name);
  const BakedRow* plain = nullptr;
  for (const BakedRow& row : baked_rows) {
    if (row.archetype != product.archetype) continue;
    for (const std::string& word : marketgen::split(row.words, '|')) {
      if (!word.empty() && text.find(word) != std::string::npos) return row;
    }
    plain = &row;
  }
  return *plain;  // every archetype's last row is for all words
}

// How the skin lies: a dome from v = 0; a ring with its glaze above v = 0.6; a strand whose upper
// side is u = 0.5.
enum class CrustShape { dome, ring, strand };

CrustShape shape_of(const BakedRow& row) {
  if (row.archetype == "donut") return CrustShape::ring;
  const bool strand = row.archetype == "croissant" || row.archetype == "pretzel";
  return strand ? CrustShape::strand : CrustShape::dome;
}

constexpr float glaze_v = 0.6F;         // of a donut's skin, see baked_skins.inc
constexpr float topping_low_v = 0.42F;  // toppings stay on the upper side

// Share of the topping at each texel.
TextureField topping_field(Topping topping, int w, int h, const Seed& seed) {
  const auto spots = [&](const BumpShape& shape, float low, float high) {
    TextureField field = bump_field(w, h, shape, seed.child("spots"));
    for (float& value : field.values)
      value = smooth_step(low, high, value);
    return field;
  };
  const auto noise = [&](const NoiseShape& shape, float low, float high) {
    TextureField field = noise_field(w, h, shape, seed.child("dust"));
    for (float& value : field.values)
      value = smooth_step(low, high, value);
    return field;
  };
  switch (topping) {
    case Topping::bare:
      return TextureField(w, h);
    case Topping::flour:
      return noise({9, 7, 6, 0.7F}, 0.46F, 0.70F);
    case Topping::seeds:
      return spots({56, 30, 0.34F, 0.8F, 0.3F, 0.7F}, 0.2F, 0.5F);
    case Topping::salt:
      return spots({26, 90, 0.24F, 0.9F, 0.5F, 0.3F}, 0.25F, 0.5F);
    case Topping::chips:
      return spots({15, 13, 0.34F, 0.8F, 0.4F, 0.6F}, 0.15F, 0.4F);
    case Topping::sprinkles:
      return spots({70, 26, 0.30F, 0.9F, 0.2F, 0.45F}, 0.3F, 0.5F);
    case Topping::layers:
      return noise({4, 54, 3, 0.6F}, 0.52F, 0.72F);
  }
  return TextureField(w, h);
}

// How far the topping lies at v: most of the way over croissants, on the upper side elsewhere.
float topping_reach(Topping topping, CrustShape shape, float v, float u) {
  if (topping == Topping::layers) return 0.55F;
  if (shape == CrustShape::ring) return v < glaze_v ? 1.0F : 0.0F;
  if (shape == CrustShape::strand) {
    const float off = u < 0.5F ? 0.5F - u : u - 0.5F;
    return 1 - smooth_step(0.10F, 0.2F, off);
  }
  return 1 - smooth_step(topping_low_v - 0.1F, topping_low_v + 0.06F, v);
}

// The bare crust at (u, v).
Color crust_at(const BakedRow& row, CrustShape shape, float v, float u) {
  const auto step = [](float low, float high, float x) {
    return static_cast<double>(smooth_step(low, high, x));
  };
  if (shape == CrustShape::ring) {
    if (v < glaze_v) return row.top;
    const double pale = row.topping == Topping::seeds
                            ? 0.0
                            : 1 - step(0.0F, 0.05F, v < 0.69F ? 0.69F - v : v - 0.69F);
    return blend(blend(row.side, row.foot, step(0.68F, 0.9F, v)), rgb("#ecd3a0"), 0.7 * pale);
  }
  if (shape == CrustShape::strand) {
    const float off = u < 0.5F ? 0.5F - u : u - 0.5F;  // of the upper side
    return blend(
        blend(row.top, row.side, step(0.08F, 0.26F, off)), row.foot, step(0.3F, 0.48F, off));
  }
  return blend(blend(row.top, row.side, step(0.12F, 0.44F, v)), row.foot, step(0.5F, 0.66F, v));
}

constexpr Color crumb_color = rgb("#efd6a2");
constexpr std::array<Color, 4> sprinkle_colors{
    rgb("#f7f2e4"), rgb("#f4c430"), rgb("#58b6e0"), rgb("#d6336c")};

}  // namespace

bool is_baked(const catalog::Product& product) {
  return std::any_of(std::begin(baked_rows), std::end(baked_rows), [&](const BakedRow& row) {
    return row.archetype == product.archetype;
  });
}

Image draw_baked_skin(const PackArt& art, int width_px, int height_px) {
  const BakedRow& row = row_of(*art.product);
  const Seed seed = art.seed.child("crust");
  const TextureField topping =
      topping_field(row.topping, width_px, height_px, seed.child("topping"));
  const TextureField mottle =
      noise_field(width_px, height_px, {7, 6, 6, 0.62F}, seed.child("mottle"));
  constexpr float mottle_depth = 0.45F;
  const CrustShape shape = shape_of(row);
  std::optional<CrustyLoaf> cut_loaf;  // whose cuts show the crumb
  if (row.archetype == "bread_roll" || row.archetype == "round_bread")
    cut_loaf.emplace(*art.product);
  constexpr float cuts_end_v = 0.5F;
  Image image(width_px, height_px);
  for (int y = 0; y < height_px; ++y) {
    const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(height_px);
    std::uint8_t* to = image.at(0, y);
    for (int x = 0; x < width_px; ++x, to += 3) {
      const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(width_px);
      const bool smooth = shape == CrustShape::ring && v < glaze_v;
      const float light = 1 + (mottle.row(y)[x] - 0.5F) * (smooth ? 0.05F : mottle_depth);
      const double crumb = cut_loaf && v < cuts_end_v
                               ? static_cast<double>(cut_loaf->crumb(static_cast<double>(u),
                                                                     1 - static_cast<double>(v)))
                               : 0.0;
      const Color bare = blend(crust_at(row, shape, v, u), crumb_color, 0.8 * crumb);
      const float over = topping.row(y)[x] * topping_reach(row.topping, shape, v, u) *
                         static_cast<float>(1 - crumb);
      const std::size_t patch =
          static_cast<std::size_t>(x / 9 + y / 9 * 3) % sprinkle_colors.size();
      const Color& top =
          row.topping == Topping::sprinkles ? sprinkle_colors[patch] : row.topping_color;
      const std::array<double, 3> ground{bare.r, bare.g, bare.b}, mark{top.r, top.g, top.b};
      for (std::size_t c = 0; c < 3; ++c) {
        const float crust = static_cast<float>(ground[c]) * light;
        to[c] = byte_of(crust + (static_cast<float>(mark[c]) - crust) * over);
      }
    }
  }
  return image;
}

}  // namespace marketgen::assets
