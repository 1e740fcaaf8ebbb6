// Every fruit and vegetable that is one body about an axis, built from its row of fruit.inc.
#include "assets/shapes/archetypes/fruit.h"

#include <algorithm>
#include <string>

#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr Vec3f beet_stalk{0.30F, 0.02F, 0.07F};

// How the body lies: its axis upright, or along X with the stem at the left.
enum class Lie { upright, along_x, longest };
// What grows at the stem's end.
enum class Top { bare, twig, button, stalk, stump, calyx, hood, tuft };

struct FruitForm {
  std::string_view archetype, words;
  Lie lie = Lie::upright;
  Top top = Top::bare;
  double top_size = 0;  // in radii of the body
  Vec3f top_color;
  double roughness = 0.4;
  BodyForm body;
};

constexpr FruitForm fruit_forms[] = {
#define FRUIT(archetype, words, lie, top, top_size, color, roughness, ...) \
  {#archetype, words, Lie::lie, Top::top, top_size, color, roughness, {__VA_ARGS__}},
#include "assets/shapes/archetypes/fruit.inc"
#undef FRUIT
};

constexpr int body_segments = 44, body_bands = 30;

// Null for an archetype that fruit.inc does not list.
const FruitForm* form_of(const catalog::Product& product) {
  const FruitForm* form =
      std::find_if(std::begin(fruit_forms), std::end(fruit_forms), [&](const FruitForm& row) {
        return row.archetype == product.archetype && has_word(product, row.words);
      });
  return form == std::end(fruit_forms) ? nullptr : form;
}

void add_tuft(PackBuilder& pack,
              std::uint16_t green,
              Vec3f top,
              float size,
              Stream draw,
              const Placement& place) {
  constexpr int stalks = 6;
  for (int i = 0; i < stalks; ++i) {
    const Vec2 out = unit_circle((i + draw.uniform(-0.25, 0.25)) / stalks);  // never two in one
    const float off = i == 0 ? 0.0F : 0.22F * size;
    const Vec2f lean{static_cast<float>(out.x), static_cast<float>(out.y)};
    add_stalk(pack,
              green,
              {.foot = top + Vec3f{lean.x * off, lean.y * off, -0.12F * size},
               .length = size * static_cast<float>(draw.uniform(0.7, 1.1)),
               .radius = 0.1F * size,
               .lean = lean * 0.35F},
              place);
  }
}

void add_top(PackBuilder& pack,
             const FruitForm& form,
             const GrownBody& body,
             float radius,
             Stream draw,
             const Placement& place) {
  if (form.top == Top::bare) return;
  const std::uint16_t green = pack.add_surface(plant(form.top_color));
  const Vec3f top = body.top();
  const float size = static_cast<float>(form.top_size) * radius;
  const Vec2 out = draw_on_circle(draw);
  const Vec2f lean{0.35F * static_cast<float>(out.x), 0.35F * static_cast<float>(out.y)};
  const auto stalk = [&](float length, float thick, float flare, Vec2f leaning) {
    add_stalk(pack,
              green,
              {.foot = top - Vec3f{0, 0, 0.15F * length},
               .length = 1.15F * length,
               .radius = thick,
               .lean = leaning,
               .flare = flare},
              place);
  };
  switch (form.top) {
    case Top::bare:
      return;
    case Top::twig:
      return stalk(size, 0.045F * radius, 1.1F, lean);
    case Top::button:
      return stalk(0.05F * size, 0.11F * size, 1.2F, {});
    case Top::stalk:
      return stalk(size, 0.12F * size, 1.5F, lean);
    case Top::stump:
      return stalk(size, 0.26F * size, 1.7F, lean * 0.6F);
    case Top::calyx:
      return add_calyx(pack,
                       green,
                       {.middle = top + Vec3f{0, 0, 0.05F * size},
                        .reach = size,
                        .half_width = 0.17F * size,
                        .drop = -0.04F * size,
                        .stalk_length = 0.45F * size,
                        .stalk_radius = 0.07F * size},
                       draw,
                       place);
    case Top::hood:
      return add_calyx(pack,
                       green,
                       {.middle = top + Vec3f{0, 0, 0.02F * size},
                        .reach = 0.72F * size,
                        .half_width = 0.3F * size,
                        .drop = 0.62F * size,
                        .stalk_length = 0.75F * size,
                        .stalk_radius = 0.17F * size},
                       draw,
                       place);
    case Top::tuft:
      return add_tuft(pack, green, top, size, draw, place);
  }
}

Result<ProductModel> fruit_model(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const FruitForm& form = *form_of(product);
  const Seed seed = growth_seed(product);
  Stream draw = seed.stream();
  const std::uint16_t skin = pack.add_print(static_cast<float>(form.roughness));

  const bool lying = lies_along_x(product);
  const float length = lying ? pack.width() : pack.height();
  const Vec3f half{0.5F * (lying ? pack.depth() : pack.width()),
                   0.5F * (lying ? pack.height() : pack.depth()),
                   0.5F * length};
  BodyForm own = form.body;
  // What depth exceeds height by is the bend of a long fruit.
  const float spare = std::max(0.0F, half.x - half.y) / length;
  own.bend = lying && own.bend > 0
                 ? std::max(1.6 * static_cast<double>(spare), own.bend * draw.uniform(0.3, 1))
                 : 0;
  const float radius = std::min(half.x, half.y);
  const GrownBody body(
      own, {own.bend > 0 ? radius : half.x, half.y, half.z}, seed.child("body").stream());
  const Placement place = lying ? lying_along_x(length) : Placement(PartFrame{});
  add_shell(
      pack, {skin}, {body_segments, even_stations(body_bands)}, [&](double turn, double along) {
        return place(body.point(turn, along));
      });
  const std::size_t mark = pack.triangle_count();
  add_top(pack, form, body, radius, seed.child("top").stream(), place);
  pack.add_part_feature(FeatureKind::stem, mark);
  return pack.finish(0.3F);
}

}  // namespace

bool lies_along_x(const catalog::Product& product) {
  constexpr int longer_percent = 112;  // what is nearly as high as long stands
  static constexpr std::string_view standing[] = {"broccoli",
                                                  "cauliflower",
                                                  "cabbage",
                                                  "lettuce_head",
                                                  "bread_roll",
                                                  "round_bread",
                                                  "donut",
                                                  "muffin",
                                                  "round_produce",
                                                  "leafy_produce"};
  if (product.archetype == "elongated_produce") return true;
  const FruitForm* form = form_of(product);
  if (form != nullptr && form->lie != Lie::longest) return form->lie == Lie::along_x;
  const bool stands =
      std::find(std::begin(standing), std::end(standing), product.archetype) != std::end(standing);
  return !stands && 100 * product.size_mm[0] > longer_percent * product.size_mm[2];
}

#define ROUND_FRUIT(name)                                                \
  Result<ProductModel> make_##name(const catalog::Product& product) {    \
    return fruit_model(product);                                         \
  }                                                                      \
  CollisionPrimitive collision_##name(const catalog::Product& product) { \
    return ellipsoid_around(product);                                    \
  }
#define LONG_FRUIT(name)                                                 \
  Result<ProductModel> make_##name(const catalog::Product& product) {    \
    return fruit_model(product);                                         \
  }                                                                      \
  CollisionPrimitive collision_##name(const catalog::Product& product) { \
    return grown_cylinder_around(product);                               \
  }

ROUND_FRUIT(apple)
ROUND_FRUIT(pear)
ROUND_FRUIT(citrus)
ROUND_FRUIT(peach)
ROUND_FRUIT(plum)
ROUND_FRUIT(mango)
ROUND_FRUIT(avocado)
ROUND_FRUIT(kiwi)
ROUND_FRUIT(melon)
ROUND_FRUIT(watermelon)
ROUND_FRUIT(coconut)
ROUND_FRUIT(tomato)
ROUND_FRUIT(bell_pepper)
ROUND_FRUIT(potato)
ROUND_FRUIT(onion)
ROUND_FRUIT(garlic)
ROUND_FRUIT(pumpkin)
ROUND_FRUIT(beetroot)
LONG_FRUIT(chili)
LONG_FRUIT(cucumber)
LONG_FRUIT(courgette)
LONG_FRUIT(aubergine)
LONG_FRUIT(carrot)
LONG_FRUIT(sweet_potato)

#undef ROUND_FRUIT
#undef LONG_FRUIT

}  // namespace marketgen::assets
