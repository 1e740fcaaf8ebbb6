#include "assets/materials/cells.h"
#include "assets/materials/pieces.h"

namespace marketgen::assets {
namespace {

// Fibres as short bent lines of random direction, drawn into a field of their own: 0..1, brighter
// where they cross.
TextureField fibres(const PatternSheet& sheet,
                    std::string_view name,
                    float length_mm,
                    float width_mm,
                    float per_mm2) {
  TextureField field(sheet.size_px, sheet.size_px);
  Stream draw = sheet.seed.child(name).stream();
  const int count = static_cast<int>(sheet.side_mm * sheet.side_mm * per_mm2);
  const int n = sheet.size_px;
  const float step = std::max(0.5F, width_mm / sheet.mm_per_px / 2);  // texels
  const int steps = std::max(2, static_cast<int>(length_mm / sheet.mm_per_px / step));
  for (int k = 0; k < count; ++k) {
    auto x = static_cast<float>(draw.uniform()) * static_cast<float>(n);
    auto y = static_cast<float>(draw.uniform()) * static_cast<float>(n);
    auto dx = static_cast<float>(draw.uniform(-1, 1)), dy = static_cast<float>(draw.uniform(-1, 1));
    const auto bend = static_cast<float>(draw.uniform(-1, 1)) * 1.6F / static_cast<float>(steps);
    const auto strength = static_cast<float>(draw.uniform(0.2, 1));
    for (int s = 0; s < steps; ++s) {
      const float length = std::sqrt(dx * dx + dy * dy) + 1e-6F;
      dx /= length, dy /= length;
      const float turned = dx - dy * bend;
      dy += dx * bend;
      dx = turned;
      x += dx * step, y += dy * step;
      const int px = ((static_cast<int>(std::floor(x)) % n) + n) % n;
      const int py = ((static_cast<int>(std::floor(y)) % n) + n) % n;
      float& value = field.row(py)[px];
      value = std::min(1.0F, value + strength * 0.45F);
    }
  }
  return field;
}

struct Thread {
  float height = 0;  // 0..1 over the cloth's lowest level
  float across = 0;  // -1..1 over the thread on top
  float along = 0;
  bool warp = false;
};

}  // namespace

void draw_paper(PatternSheet& sheet) {
  const TextureField clouds = sheet.noise("clouds", 8, 4);
  const TextureField light = fibres(sheet, "light", 2.2F, 0.1F, 1.1F);
  const TextureField dark = fibres(sheet, "dark", 1.5F, 0.1F, 0.25F);
  for (std::size_t i = 0; i < clouds.values.size(); ++i) {
    const Texel t = sheet.texel(i);
    t.mark = std::clamp(0.35F * clouds.values[i] + 0.55F * dark.values[i], 0.0F, 1.0F);
    t.light += 0.07F * light.values[i] - 0.02F;
    t.height_mm = 0.03F * (light.values[i] + dark.values[i]) + 0.05F * clouds.values[i];
  }
}

// Liner over flutes: it sinks a little between them, which the light shows more than the ruler.
void draw_corrugated(PatternSheet& sheet) {
  const TextureField clouds = sheet.noise("clouds", 16, 4);
  const TextureField streak = sheet.streaks("streak", 2.5F, 60, 3);
  const TextureField dark = fibres(sheet, "dark", 2.5F, 0.15F, 0.10F);
  sheet.each_texel([&](Texel t, int x, int y) {
    const std::size_t i = sheet.index(x, y);
    const float u = (static_cast<float>(x) + 0.5F) * sheet.mm_per_px * 2 / sheet.period_mm();
    const float flute = wave(u + (streak.values[i] - 0.5F) * 0.12F);
    t.height_mm = 0.22F * flute + 0.04F * clouds.values[i];
    t.mark = std::clamp(0.30F * clouds.values[i] + 0.22F * (1 - flute) + 0.5F * dark.values[i] +
                            0.25F * (streak.values[i] - 0.4F),
                        0.0F,
                        1.0F);
  });
}

void draw_felt(PatternSheet& sheet) {
  const TextureField long_fibres = fibres(sheet, "long", 9, 0.25F, 0.85F);
  const TextureField short_fibres = fibres(sheet, "short", 4, 0.2F, 1.1F);
  const TextureField clouds = sheet.noise("clouds", 18, 4);
  const TextureField fuzz = sheet.noise("fuzz", 1.2F, 2);
  for (std::size_t i = 0; i < clouds.values.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float pile = 0.5F * long_fibres.values[i] + 0.3F * short_fibres.values[i];
    t.mark = std::clamp(0.55F * short_fibres.values[i] + 0.3F * clouds.values[i], 0.0F, 1.0F);
    t.light +=
        0.22F * (pile - 0.3F) + 0.12F * (fuzz.values[i] - 0.5F) + 0.10F * (clouds.values[i] - 0.5F);
    t.height_mm = 0.35F * pile + 0.2F * fuzz.values[i];
  }
}

namespace {

// Cloth of round threads; over(i, j) says whether the upright thread i lies over the level thread
// j.
template <class Over>
void weave_threads(PatternSheet& sheet, int threads, const Over& over) {
  const float pitch = sheet.side_mm / static_cast<float>(threads);
  const TextureField twist = sheet.noise("twist", pitch * 0.35F, 2, 0.7F);
  const Seed tones = sheet.seed.child("threads");
  const auto wrap = [&](int i) { return (i + threads) % threads; };
  sheet.each_texel([&](Texel t, int x, int y) {
    const float u = (static_cast<float>(x) + 0.5F) * sheet.mm_per_px / pitch;
    const float v = (static_cast<float>(y) + 0.5F) * sheet.mm_per_px / pitch;
    const int i = std::min(static_cast<int>(u), threads - 1);
    const int j = std::min(static_cast<int>(v), threads - 1);
    const float du = u - static_cast<float>(i) - 0.5F, dv = v - static_cast<float>(j) - 0.5F;
    const bool upright = over(i, j);
    const float across = upright ? du : dv, along = upright ? dv : du;
    // The thread dips where its next crossing goes under.
    const int step = along > 0 ? 1 : -1;
    const bool stays = upright ? over(i, wrap(j + step)) : !over(wrap(i + step), j);
    const float dip = stays ? 0.0F : 4 * along * along;
    const float round = std::sqrt(std::max(0.0F, 1 - 3.2F * across * across));
    const float fibre = twist.values[sheet.index(x, y)];
    const auto id = static_cast<std::uint32_t>(upright ? i : threads + j);
    const float tone = piece_number(tones, id) - 0.5F;
    t.height_mm = pitch * (0.30F * round * (1 - 0.75F * dip) + 0.05F * fibre);
    t.mark = upright ? 0.0F : 1.0F;
    t.light = 0.62F + 0.42F * round * (1 - 0.45F * dip) + 0.16F * (fibre - 0.5F) +
              0.08F * tone * sheet.variation;
  });
}

}  // namespace

void draw_weave(PatternSheet& sheet) {
  weave_threads(sheet, sheet.periods * 8, [](int i, int j) { return (i + j) % 2 == 0; });
}

void draw_twill(PatternSheet& sheet) {
  weave_threads(sheet, sheet.periods * 8, [](int i, int j) { return (i + j) % 4 < 3; });
}

// Loops in rows, each a small dome that leans its own way.
void draw_carpet(PatternSheet& sheet) {
  const auto loops = scatter_cells(sheet, "loops", 4.2F, 0.55F);
  const TextureField clouds = sheet.noise("clouds", 70, 4);
  const TextureField fibre = sheet.noise("fibre", 1.1F, 2, 0.7F);
  const Seed kinds = sheet.seed.child("kinds");
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float dome = smooth_step(0, 1.6F, loops[i].border_mm);
    const float kind = piece_number(kinds, loops[i].id);
    t.height_mm = 1.4F * dome + 0.3F * fibre.values[i] + 0.4F * kind;
    t.mark = kind > 0.62F ? 0.8F : 0.12F;
    if (!sheet.row.third_color.empty()) t.third = kind < 0.10F ? 0.9F : 0;
    t.light =
        0.60F + 0.42F * dome + 0.16F * (fibre.values[i] - 0.5F) + 0.10F * (clouds.values[i] - 0.5F);
  }
}

void draw_leather(PatternSheet& sheet) {
  const auto pebbles = scatter_cells(sheet, "pebbles", 3.2F, 1);
  const TextureField clouds = sheet.noise("clouds", 40, 4);
  const TextureField creases = sheet.noise("creases", 24, 4);
  for (std::size_t i = 0; i < pebbles.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float groove = 1 - smooth_step(0, 0.75F, pebbles[i].border_mm);
    const float crease = 1 - smooth_step(0, 0.025F, std::fabs(creases.values[i] - 0.5F));
    t.height_mm = -0.28F * groove - 0.15F * crease + 0.05F * clouds.values[i];
    t.mark = std::clamp(0.6F * groove + 0.3F * clouds.values[i], 0.0F, 1.0F);
    t.light += 0.05F * (clouds.values[i] - 0.5F) - 0.06F * crease;
    t.roughness = 0.12F * groove;
  }
}

}  // namespace marketgen::assets
