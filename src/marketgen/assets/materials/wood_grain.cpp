#include "assets/materials/wood_grain.h"

namespace marketgen::assets {
namespace {

constexpr float pore_depth_mm = 0.12F;

}  // namespace

WoodGrain::WoodGrain(const PatternSheet& sheet, const Seed& seed)
    : px_per_mm_(1 / sheet.mm_per_px),
      cuts_(seed.child("cuts")),
      figure_(sheet.streaks("figure", 500, 45, 3)),
      rings_(sheet.streaks("rings", 320, 7, 3)),
      pores_(sheet.streaks("pores", 40, 2, 2)) {}

float WoodGrain::at(const TextureField& field, const Piece& piece, float salt) const {
  const float cut = piece_number(cuts_, piece.id);
  const auto size = static_cast<float>(field.width);
  return field.wrapped_at(piece.along_mm * px_per_mm_ + fraction(cut * 17 + salt) * size,
                          piece.across_mm * px_per_mm_ + fraction(cut * 53 + salt) * size);
}

float WoodGrain::dark(const Piece& piece) const {
  const float broad = at(figure_, piece, 0);
  // Rings bend with the figure; wave() makes the slow rise and quick fall of late wood.
  const float rings = wave(broad * 5 + at(rings_, piece, 0.3F) * 1.4F);
  const float value =
      0.45F * rings + 0.35F * at(rings_, piece, 0.7F) + 0.4F * at(pores_, piece, 0.5F) - 0.1F;
  return std::clamp(value, 0.0F, 1.0F);
}

float WoodGrain::pores(const Piece& piece) const {
  return smooth_step(0.58F, 0.8F, at(pores_, piece, 0.5F));
}

void grow_wood(PatternSheet& sheet, const std::vector<Piece>& pieces, float contrast) {
  const WoodGrain grain(sheet, sheet.seed.child("wood"));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float dark = grain.dark(pieces[i]);
    const float pores = grain.pores(pieces[i]);
    t.mark = std::min(1.0F, t.mark + contrast * (0.75F * dark + 0.35F * pores));
    t.height_mm -= pore_depth_mm * pores;
    t.roughness += 0.08F * pores + 0.05F * (dark - 0.4F);
  }
}

}  // namespace marketgen::assets
