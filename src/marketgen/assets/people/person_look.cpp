// Who one meets in a shop: measures, skin, hair and clothes.
#include <algorithm>
#include <cmath>
#include <span>

#include "assets/people/person.h"

namespace marketgen::assets {
namespace {

// Linear RGB of sRGB numbers, near enough for rows of colours.
constexpr Vec3f linear(int r, int g, int b) {
  const auto channel = [](int v) {
    const float s = static_cast<float>(v) / 255;
    return s * s * (0.32F + 0.68F * s);  // within 0.01 of IEC 61966-2-1
  };
  return {channel(r), channel(g), channel(b)};
}

template <std::size_t N>
Vec3f one_of(const std::array<Vec3f, N>& row, Stream& draw) {
  return row[static_cast<std::size_t>(draw.integer(0, static_cast<int>(N) - 1))];
}

// From light to dark, in steps as the Monk scale's (Monk 2023). They are reflectances, and so
// darker than a chart of it on a screen: fair skin throws back two thirds of red light.
constexpr std::array<Vec3f, 9> skins{{linear(222, 184, 162),
                                      linear(213, 172, 148),
                                      linear(203, 160, 134),
                                      linear(190, 144, 114),
                                      linear(168, 122, 92),
                                      linear(142, 98, 70),
                                      linear(110, 74, 52),
                                      linear(84, 56, 41),
                                      linear(62, 43, 35)}};
constexpr std::array<Vec3f, 6> hairs{{linear(28, 22, 19),
                                      linear(44, 30, 22),
                                      linear(74, 50, 34),
                                      linear(112, 78, 48),
                                      linear(168, 130, 84),
                                      linear(120, 58, 34)}};
constexpr std::array<Vec3f, 12> tops{{linear(232, 230, 224),
                                      linear(38, 44, 58),
                                      linear(120, 30, 36),
                                      linear(60, 86, 66),
                                      linear(88, 116, 150),
                                      linear(196, 178, 148),
                                      linear(52, 52, 54),
                                      linear(150, 152, 156),
                                      linear(206, 142, 60),
                                      linear(164, 108, 116),
                                      linear(34, 72, 110),
                                      linear(110, 84, 62)}};
constexpr std::array<Vec3f, 7> legs{{linear(40, 52, 82),
                                     linear(62, 80, 112),
                                     linear(34, 35, 38),
                                     linear(78, 76, 74),
                                     linear(150, 130, 102),
                                     linear(84, 68, 52),
                                     linear(66, 74, 58)}};
constexpr std::array<Vec3f, 5> shoes{{linear(30, 28, 28),
                                      linear(70, 46, 32),
                                      linear(214, 212, 208),
                                      linear(60, 64, 72),
                                      linear(112, 36, 38)}};
constexpr std::array<Vec3f, 3> baskets{
    {linear(176, 24, 30), linear(24, 84, 50), linear(52, 56, 60)}};

double measure(Stream& draw, double low, double high) {
  return std::clamp(1 + 0.11 * draw.normal(), low, high);
}

double stature(BodyForm form, int age, Stream& draw) {
  const bool woman = form == BodyForm::woman;
  const double young = woman ? 1.628 + 0.064 * draw.normal() : 1.756 + 0.069 * draw.normal();
  const double past = std::max(age - 40, 0) / 30.0;
  return std::clamp(young - (woman ? 0.05 : 0.03) * past * past, min_stature_m, max_stature_m);
}

HairCut hair_cut(const PersonLook& look, Stream& draw) {
  constexpr std::array<double, 6> men{0.13, 0.30, 0.52, 0.0, 0.03, 0.02};
  constexpr std::array<double, 6> women{0.0, 0.03, 0.22, 0.30, 0.27, 0.18};
  return static_cast<HairCut>(
      draw.weighted(look.form == BodyForm::woman ? std::span(women) : std::span(men)));
}

Vec3f hair_color(const PersonLook& look, std::size_t tone, Stream& draw) {
  // Fair hair goes with fair skin only; from 45 on more and more of it is grey.
  const int last = tone < 4 ? 5 : tone < 6 ? 2 : 1;
  const Vec3f natural = hairs[static_cast<std::size_t>(draw.integer(0, last))];
  const double grey = std::clamp((look.age - 42) / 30.0 + 0.25 * draw.normal(), 0.0, 1.0);
  return look.age < 42 ? natural
                       : natural * static_cast<float>(1 - grey) +
                             linear(176, 174, 170) * static_cast<float>(grey);
}

void dress(PersonLook& look, Vec3f house_color, Stream& draw) {
  look.top = static_cast<TopWear>(draw.weighted(std::array<double, 4>{0.30, 0.30, 0.28, 0.12}));
  look.legs =
      look.form == BodyForm::woman && draw.chance(0.22) ? LegWear::skirt : LegWear::trousers;
  look.top_color = one_of(tops, draw);
  look.leg_color = one_of(legs, draw);
  look.shoe_color = one_of(shoes, draw);
  look.basket_color = one_of(baskets, draw);
  look.apron_color = house_color;
  if (look.role != PersonRole::staff) return;
  look.apron = true;
  look.top = draw.chance(0.35) ? TopWear::t_shirt : TopWear::shirt;
  look.legs = LegWear::trousers;
  look.top_color = draw.chance(0.6) ? linear(232, 231, 228) : linear(58, 60, 64);
  look.leg_color = linear(36, 37, 40);
  look.shoe_color = shoes[0];
}

}  // namespace

PersonLook draw_person(PersonRole role, Vec3f house_color, Seed seed) {
  Stream body = seed.child("body").stream(), clothes = seed.child("clothes").stream();
  PersonLook look;
  look.role = role;
  look.form = body.chance(0.5) ? BodyForm::woman : BodyForm::man;
  look.age = body.integer(20, role == PersonRole::staff ? 62 : 78);
  look.stature_m = stature(look.form, look.age, body);
  look.girth = std::clamp(1 + 0.09 * body.normal() + 0.0015 * (look.age - 40), 0.88, 1.25);
  look.face_width = measure(body, 0.92, 1.08);
  look.nose = measure(body, 0.8, 1.25);
  look.jaw = measure(body, 0.85, 1.15);
  look.brow = measure(body, 0.8, 1.2);
  const auto tone =
      static_cast<std::size_t>(body.weighted(std::array<double, 9>{2, 3, 3, 3, 2, 2, 2, 1.5, 1.5}));
  look.skin = skins[tone];
  look.hair = hair_cut(look, body);
  look.hair_color = hair_color(look, tone, body);
  look.beard = look.form == BodyForm::man && body.chance(0.28);
  dress(look, house_color, clothes);
  return look;
}

}  // namespace marketgen::assets
