#include "assets/materials/pattern_sheet.h"

namespace marketgen::assets {

void draw_plain(PatternSheet& sheet) {
  const int n = sheet.size_px;
  sheet.look.mark = noise_field(n, n, {4, 4, 5, 0.6F}, sheet.seed.child("clouds"));
  const TextureField grain = noise_field(n, n, {128, 128, 2, 0.8F}, sheet.seed.child("grain"));
  add_centred(sheet.look.light, grain, 0.02F);
  add_centred(sheet.look.height_mm, grain, 0.10F);
  add_centred(sheet.look.height_mm, sheet.look.mark, 0.4F);
  add_centred(sheet.look.roughness, sheet.look.mark, 0.05F);
}

// Even coats of paint and moulded plastic: nothing but the faint waves of a surface that flowed.
void draw_smooth(PatternSheet& sheet) {
  add_centred(sheet.look.height_mm, sheet.noise("waves", 14, 2), 0.02F);
  add_centred(sheet.look.height_mm, sheet.noise("sag", 160, 2), 0.15F);
  const TextureField wear = sheet.noise("wear", 90, 4);
  add_centred(sheet.look.roughness, wear, 0.03F);
  sheet.look.mark = sheet.noise("clouds", 250, 4);
}

// The eroded grain of matt mouldings (like VDI 3400, classes 24 to 30): fine and even.
void draw_grained(PatternSheet& sheet) {
  const TextureField grain = sheet.noise("grain", 1.1F, 2, 0.7F);
  add_centred(sheet.look.height_mm, grain, 0.09F);
  add_centred(sheet.look.light, grain, 0.035F);
  add_centred(sheet.look.roughness, grain, 0.06F);
  sheet.look.mark = sheet.noise("clouds", 60, 4);
}

}  // namespace marketgen::assets
