#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/plate.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr Vec3f moulded_pulp{0.42F, 0.40F, 0.36F};
constexpr float cell_pitch_m = 0.050F;              // a size M egg is 43 to 45 mm across
constexpr float rim_low = 0.46F, rim_high = 0.52F;  // shares of the height: where the box opens
constexpr float egg_label_m = 0.0003F;
constexpr int lines_across = 20, lines_deep = 10;

struct Cups {
  int across, deep;
};

Cups cups_of(const PackBuilder& pack) {
  const auto along = [](float length) {
    return std::clamp(static_cast<int>(std::lround(length / cell_pitch_m)), 1, 6);
  };
  return {along(pack.width()), along(pack.depth())};
}

// 1 in the middle of a cup, 0 where two meet.
float cup_at(float share, int cups) {
  const float place = share * static_cast<float>(cups);
  const float in_cup = place - std::floor(std::min(place, static_cast<float>(cups) - 1e-4F));
  const float s = 2 * in_cup - 1;
  return 1 - s * s;
}

std::vector<float> cup_lines(int cups, int max_lines) {
  return even_lines(cups * std::clamp(max_lines / cups, 2, 5));
}

// The lower half: a row of cups that taper to their feet.
Vec3f base_point(Vec3f share, Vec3f size, const Cups& cups) {
  const float cx = cup_at(share.x, cups.across), cy = cup_at(share.y, cups.deep);
  const float up = share.z, taper = 0.74F + 0.22F * std::sqrt(up);
  const float scallop = 0.085F * (1 - 0.65F * up);
  const float ox = 2 * share.x - 1, oy = 2 * share.y - 1;
  const float x = ox * (taper - scallop * (1 - cy) * std::abs(ox));
  const float y = oy * (taper - 1.6F * scallop * (1 - cx) * std::abs(oy));
  // Between the cups the floor arches up; along the walls it hangs from their foot.
  const float arch = 0.52F * (1 - std::sqrt(std::max(0.0F, cx * cy)));
  const float z = (arch + (1 - arch) * up) * rim_low * size.z;
  return {x * size.x / 2, y * size.y / 2, z};
}

// The lid: walls that lean in, scalloped between the eggs, a flat top for the label.
Vec3f lid_point(Vec3f share, Vec3f size, const Cups& cups) {
  const float low = rim_high * size.z - 0.001F, high = size.z - 1.5F * egg_label_m;
  const float round = 0.36F * (high - low);
  const Vec3f box{0.965F * size.x, 0.93F * size.y, high - low};
  Vec3f p = rounded_box_point(share, {box.x, box.y, 2 * box.z}, std::min(round, 0.2F * box.y));
  p.z = std::max(0.0F, p.z - box.z);
  const float up = std::clamp(p.z / box.z, 0.0F, 1.0F);
  const float lean = 1 - 0.10F * up;
  const float groove = 0.030F * (1 - up * up);
  const float gx = 1 - groove * 0.5F * (1 - cup_at(share.y, cups.deep));
  const float gy = 1 - groove * 2.0F * (1 - cup_at(share.x, cups.across));
  return {p.x * lean * gx, p.y * lean * gy, low + p.z};
}

// Where base and lid meet: a rim with rounded corners.
void add_flange(PackBuilder& pack, std::uint16_t surface) {
  const float low = rim_low * pack.height() - 0.0004F, high = rim_high * pack.height();
  const auto section = [&](float z, float inset) {
    return Section{.z = z,
                   .half_width = pack.width() / 2 - inset,
                   .half_depth = pack.depth() / 2 - inset,
                   .surface = surface,
                   .roundness = 0.24F};
  };
  const float bevel = 0.3F * (high - low);
  add_loft(pack,
           {section(low, 2 * bevel),
            section(low + bevel, 0),
            section(high - bevel, 0),
            section(high, 2 * bevel)},
           {.triangles = 300});
}

void add_labels(PackBuilder& pack,
                const SleeveFaces& faces,
                std::uint16_t print,
                std::uint16_t edge) {
  const float d = pack.depth(), h = pack.height();
  const PartFrame top{
      .origin = {0, -faces.top.height_m / 2, h}, .x = {1, 0, 0}, .y = {0, 0, -1}, .z = {0, 1, 0}};
  add_sticker(pack,
              pack.panel(PanelKind::top),
              {faces.top.width_m, 2 * egg_label_m, faces.top.height_m},
              print,
              edge,
              top);
  // On the front wall of the lid, which leans back.
  const float rise = 0.90F, back = 0.135F * d / h;
  const float slope = std::sqrt(rise * rise + back * back);
  const Vec3f up{0, back / slope, rise / slope};
  const PartFrame front{.origin = {0, -0.478F * d, (rim_high + 0.055F) * h},
                        .x = {1, 0, 0},
                        .y = {0, up.z, -up.y},
                        .z = up};
  add_sticker(pack,
              pack.panel(PanelKind::front),
              {faces.front.width_m, 0.02F * d, faces.front.height_m},
              print,
              edge,
              front);
}

}  // namespace

// Six or ten eggs in moulded pulp: cups below, a flange, a lid with paper labels.
Result<ProductModel> make_egg_box(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t pulp = pack.add_surface({.color = moulded_pulp, .roughness = 0.95F});
  const std::uint16_t print = pack.add_print(matt_paper_roughness);
  const std::uint16_t edge = pack.add_surface(paper({0.75F, 0.74F, 0.70F}));
  const Vec3f size{pack.width(), pack.depth(), pack.height()};
  const Cups cups = cups_of(pack);
  const BoxSurfaces all{pulp, pulp, pulp, pulp, pulp, pulp};
  add_panel_box(
      pack,
      {cup_lines(cups.across, lines_across), cup_lines(cups.deep, lines_deep), {0, 0.2F, 0.6F, 1}},
      all,
      [&](Vec3f share) { return base_point(share, size, cups); });
  add_flange(pack, pulp);
  add_panel_box(pack,
                {cup_lines(cups.across, lines_across),
                 cup_lines(cups.deep, lines_deep),
                 {0, 0.5F, 0.65F, 0.8F, 0.9F, 1}},
                all,
                [&](Vec3f share) { return lid_point(share, size, cups); });
  pack.add_band_feature(FeatureKind::lid, rim_high * size.z, size.z);
  add_labels(pack, sleeve_faces_of(product), print, edge);
  return pack.finish(0.3F);
}

CollisionPrimitive collision_egg_box(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
