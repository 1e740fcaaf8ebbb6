#include "assets/materials/pattern_sheet.h"

namespace marketgen::assets {

PatternSheet::PatternSheet(const catalog::MaterialRow& material,
                           int side_px,
                           const Seed& material_seed)
    : row(material),
      size_px(side_px),
      periods(periods_in_texture(material.pattern)),
      side_mm(static_cast<float>(material.period_mm * periods)),
      mm_per_px(side_mm / static_cast<float>(side_px)),
      variation(static_cast<float>(material.variation)),
      seed(material_seed),
      look(side_px) {}

TextureField PatternSheet::noise(std::string_view name,
                                 float size_mm,
                                 int octaves,
                                 float falloff) const {
  const int cells = count_of(size_mm);
  return noise_field(size_px, size_px, {cells, cells, octaves, falloff}, seed.child(name));
}

TextureField PatternSheet::streaks(std::string_view name,
                                   float x_mm,
                                   float y_mm,
                                   int octaves) const {
  return noise_field(
      size_px, size_px, {count_of(x_mm), count_of(y_mm), octaves, 0.55F}, seed.child(name));
}

float PatternSheet::to_line_mm(int i, int parts) const {
  const float part = static_cast<float>(size_px) / static_cast<float>(parts);
  const float at = static_cast<float>(i) + 0.5F;
  const float from = at - part * static_cast<float>(static_cast<int>(at / part));
  return std::min(from, part - from) * mm_per_px;
}

float PatternSheet::line(float distance_mm, float width_mm) const {
  const float half = std::max(width_mm, mm_per_px) / 2;
  return 1 - smooth_step(half - mm_per_px / 2, half + mm_per_px / 2, distance_mm);
}

float PatternSheet::inside(float distance_mm) const {
  return 1 - smooth_step(-mm_per_px / 2, mm_per_px / 2, distance_mm);
}

void add_centred(TextureField& to, const TextureField& field, float depth) {
  for (std::size_t i = 0; i < field.values.size(); ++i)
    to.values[i] += (field.values[i] - 0.5F) * 2 * depth;
}

float piece_number(const Seed& seed, std::uint32_t id) {
  std::uint64_t x = seed.value() + std::uint64_t{id} * 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;  // SplitMix64's finaliser, as in base/seed.h
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return static_cast<float>((x ^ (x >> 31)) >> 40) * (1.0F / 16777216.0F);
}

}  // namespace marketgen::assets
