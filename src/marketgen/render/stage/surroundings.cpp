#include "render/stage/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

// The street as someone at eye height sees it, metres. Places along it are angles times the
// distance, so that it closes to a ring of whole houses, cars and lanterns.
constexpr float eye_height_m = 1.6F;
constexpr float facade_m = 16, car_m = 10.5F, kerb_m = 4;
constexpr int houses = 11, windows_a_house = 4, car_places = 13, lanterns = 9;
constexpr float storey_m = 3.2F, car_height_m = 1.45F, car_half_m = 2.1F;
// Over the shop's white paper. By day the street is two stops brighter than the room.
constexpr float sky_over_white = 4.5F, horizon_over_white = 3.4F, facade_over_white = 4;
constexpr float pavement_over_white = 2.2F, road_over_white = 1.2F;
constexpr float mean_day_over_white = 1.6F;
constexpr float night_facade = 0.018F, night_pavement = 0.05F, night_road = 0.022F;
constexpr float mean_night_over_white = 0.05F;
const Vec3f night_sky{0.006F, 0.008F, 0.018F};
const Vec3f sodium{1.0F, 0.62F, 0.30F};  // street lanterns
const Vec3f lamplight{1.0F, 0.78F, 0.52F};
const Vec3f dark_glass{0.15F, 0.15F, 0.15F};

const std::array<Vec3f, 6> facade_colors{Vec3f{0.62F, 0.56F, 0.46F},
                                         {0.46F, 0.26F, 0.19F},
                                         {0.66F, 0.64F, 0.60F},
                                         {0.50F, 0.50F, 0.48F},
                                         {0.68F, 0.58F, 0.40F},
                                         {0.40F, 0.33F, 0.28F}};
const std::array<Vec3f, 5> car_colors{Vec3f{0.26F, 0.27F, 0.28F},
                                      {0.06F, 0.06F, 0.065F},
                                      {0.52F, 0.52F, 0.51F},
                                      {0.08F, 0.10F, 0.15F},
                                      {0.17F, 0.06F, 0.055F}};

// A place's number on the ring and how far along it a direction points, 0..1.
struct RingPlace {
  std::uint32_t number = 0;
  float along = 0;
};
RingPlace ring_place(float turn, int count) {
  const float at = turn * static_cast<float>(count);
  const float whole = std::floor(at);
  return {static_cast<std::uint32_t>(whole), at - whole};
}

float chance(std::uint32_t number, std::uint32_t salt) {
  return unit_float(hashed(number * 0x9E3779B9U ^ hashed(salt)));
}

template <std::size_t count>
Vec3f picked(const std::array<Vec3f, count>& colors, std::uint32_t number, std::uint32_t salt) {
  return colors[std::min(count - 1, static_cast<std::size_t>(chance(number, salt) * float{count}))];
}

// A surface of the street: its colour by day, and what it shows by night.
struct StreetSpot {
  Vec3f day, night;
};

StreetSpot sky(float rise) {
  const float high = std::sqrt(std::clamp(rise, 0.0F, 1.0F));
  const float over = horizon_over_white + (sky_over_white - horizon_over_white) * high;
  return {Vec3f{1, 1, 1} * over, night_sky * (1.5F - high)};
}

// A window of a flat: some are lit, none alike.
StreetSpot window_spot(std::uint32_t window) {
  const bool lit = chance(window, 7) < 0.3F;
  const float bright = 0.05F + 0.2F * chance(window, 8);
  return {dark_glass * facade_over_white * (0.6F + chance(window, 9)),
          lit ? lamplight * bright : Vec3f{0.008F, 0.009F, 0.012F}};
}

// A shop window, `across` its panes and `rise` of its height: what stands in it is a pattern of
// lighter and darker things, brighter towards its ceiling.
StreetSpot shop_spot(std::uint32_t house, float across, float rise) {
  constexpr float columns = 22, rows = 5;
  const bool lit = chance(house, 7) < 0.55F;
  const auto cell =
      static_cast<std::uint32_t>(across * columns) + 64 * static_cast<std::uint32_t>(rise * rows);
  const float things = 0.35F + 0.65F * chance(house * 977 + cell, 10);
  const float bright = (lit ? 0.16F : 0.012F) * things * (0.4F + 0.9F * rise);
  return {dark_glass * (facade_over_white * (0.2F + 0.5F * things + 0.35F * rise)),
          lamplight * bright};
}

// The house front at `up` metres above the pavement.
StreetSpot facade(const RingPlace& house, float up) {
  const Vec3f color = picked(facade_colors, house.number, 1);
  const bool ground_floor = up < storey_m;
  const float column = house.along * windows_a_house;
  const float across = column - std::floor(column),
              rise = up / storey_m - std::floor(up / storey_m);
  const bool in_shop = ground_floor && up > 0.5F && up < 2.6F && house.along > 0.06F &&
                       house.along < 0.94F && across > 0.04F;
  const bool fascia = ground_floor && up > 2.6F && house.along > 0.04F && house.along < 0.96F;
  const bool in_window =
      !ground_floor && across > 0.27F && across < 0.73F && rise > 0.25F && rise < 0.78F;
  if (in_shop) return shop_spot(house.number, house.along, (up - 0.5F) / 2.1F);
  if (fascia) {
    const Vec3f sign = picked(car_colors, house.number, 11);
    return {sign * facade_over_white, sign * 0.05F};
  }
  if (in_window) {
    const auto number = static_cast<std::uint32_t>(column) +
                        8 * static_cast<std::uint32_t>(up / storey_m) + house.number * 64;
    return window_spot(number);
  }
  const bool sill = !ground_floor && rise > 0.19F && rise < 0.25F;  // a course of light stone
  const float lantern_glow = std::max(0.0F, 1 - up / 8);
  return {(sill ? color * 1.25F : color) * facade_over_white,
          color * sodium * (night_facade * (1 + 3 * lantern_glow))};
}

// A parked car in side view, `x` metres from its middle and `up` above the road.
bool in_car(float x, float up) {
  const float side = std::fabs(x);
  if (up < 0.02F || up > car_height_m || side > car_half_m) return false;
  if (up < 0.25F) return std::fabs(side - 1.3F) < 0.3F;  // wheels
  if (up < 0.85F) return side < car_half_m - 0.3F * std::fabs(up - 0.5F);
  return side < 1.5F - 1.1F * (up - 0.85F);  // the cabin narrows upwards
}

StreetSpot car_spot(std::uint32_t number, float x, float up) {
  const bool window = up > 0.92F && up < 1.33F && std::fabs(x) > 0.06F;
  const bool wheel = std::hypot(std::fabs(x) - 1.3F, up - 0.32F) < 0.31F;
  if (wheel) return {Vec3f{0.05F, 0.05F, 0.05F}, Vec3f{0.002F, 0.002F, 0.002F}};
  const Vec3f color = picked(car_colors, number, 3);
  if (window) return {dark_glass * 1.6F, Vec3f{0.008F, 0.009F, 0.012F}};
  return {color * (1.3F + 0.9F * up), color * sodium * 0.05F + Vec3f{0.003F, 0.003F, 0.004F}};
}

StreetSpot ground(float distance) {
  const bool kerb = distance > kerb_m && distance < kerb_m + 0.2F;
  const bool road = distance > kerb_m && distance < facade_m - 3;
  const float day = kerb ? 2.8F : road ? road_over_white : pavement_over_white;
  return {Vec3f{0.97F, 0.99F, 1.0F} * day, sodium * (road ? night_road : night_pavement)};
}

StreetSpot street_spot(Vec3f direction) {
  const float level = std::max(std::hypot(direction.x, direction.y), 1e-4F);
  const float slope = direction.z / level;
  const float turn = std::atan2(direction.y, direction.x) / two_pi + 0.5F;
  const RingPlace lantern = ring_place(turn, lanterns);
  const float lantern_x = (lantern.along - 0.5F) * two_pi * 12 / lanterns;
  const float lantern_up = slope * 12 + eye_height_m;
  if (std::hypot(lantern_x, lantern_up - 5.2F) < 0.16F)
    return {Vec3f{1, 1, 1} * facade_over_white, sodium * 7};
  const RingPlace place = ring_place(turn, car_places);
  const float car_x = (place.along - 0.5F) * two_pi * car_m / car_places;
  const float car_up = slope * car_m + eye_height_m;
  if (chance(place.number, 2) < 0.7F && in_car(car_x, car_up))
    return car_spot(place.number, car_x, car_up);
  const float up = slope * facade_m + eye_height_m;
  const RingPlace house = ring_place(turn, houses);
  if (up > 7 + 6 * chance(house.number, 4)) return sky(direction.z);
  if (up > 0) return facade(house, up);
  return ground(eye_height_m / -slope);
}

// The street as a lens has it that is focused on the shop: out of focus. By turn and by height over
// the horizon, up to 45 degrees; what is steeper looks as it does there.
class Panorama {
 public:
  Panorama() : spots_(std::size_t{across} * down) {
    for (int row = 0; row < down; ++row) {
      for (int column = 0; column < across; ++column)
        spots_[place(column, row)] = street_spot(direction_of(column, row));
    }
    blur(1, 0, blur_rad * across / two_pi);
    blur(0, 1, blur_rad * down / span_rad);
  }

  StreetSpot at(Vec3f direction) const {
    const float turn = std::atan2(direction.y, direction.x) / two_pi + 0.5F;
    const float rise = std::atan2(direction.z, std::hypot(direction.x, direction.y));
    const float x = turn * across - 0.5F, y = (rise / span_rad + 0.5F) * down - 0.5F;
    const float column = std::floor(x), row = std::floor(std::clamp(y, 0.0F, float{down - 2}));
    const float right = x - column, up = std::clamp(y - row, 0.0F, 1.0F);
    const auto mixed = [&](int k) {
      const int j = static_cast<int>(row) + k;
      return mix(spots_[place(static_cast<int>(column), j)],
                 spots_[place(static_cast<int>(column) + 1, j)],
                 right);
    };
    return mix(mixed(0), mixed(1), up);
  }

 private:
  static constexpr int across = 1024, down = 160;
  static constexpr float span_rad = pi / 2;
  static constexpr float blur_rad = 0.011F;  // standard deviation: 18 cm of a house front

  static StreetSpot mix(const StreetSpot& a, const StreetSpot& b, float share) {
    return {raytrace::mix(a.day, b.day, share), raytrace::mix(a.night, b.night, share)};
  }
  static std::size_t place(int column, int row) {
    return static_cast<std::size_t>(std::clamp(row, 0, down - 1)) * across +
           static_cast<std::size_t>((column + across) % across);
  }
  static Vec3f direction_of(int column, int row) {
    const float turn = ((static_cast<float>(column) + 0.5F) / across - 0.5F) * two_pi;
    const float rise = ((static_cast<float>(row) + 0.5F) / down - 0.5F) * span_rad;
    return {std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise), std::sin(rise)};
  }

  // By a Gaussian of so many places along (step_x, step_y).
  void blur(int step_x, int step_y, float spread) {
    const std::vector<StreetSpot> sharp = spots_;
    const int reach = static_cast<int>(std::ceil(3 * spread));
    for (int row = 0; row < down; ++row) {
      for (int column = 0; column < across; ++column) {
        StreetSpot sum{};
        float weights = 0;
        for (int k = -reach; k <= reach; ++k) {
          const float far = static_cast<float>(k) / spread, weight = std::exp(-0.5F * far * far);
          const StreetSpot& spot = sharp[place(column + k * step_x, row + k * step_y)];
          sum.day += spot.day * weight;
          sum.night += spot.night * weight;
          weights += weight;
        }
        spots_[place(column, row)] = {sum.day / weights, sum.night / weights};
      }
    }
  }

  std::vector<StreetSpot> spots_;
};

const Panorama& panorama() {
  static const Panorama street;
  return street;
}

}  // namespace

Vec3f Surroundings::radiance(Vec3f direction) const {
  if (white <= 0) return even;
  const StreetSpot spot = panorama().at(direction);
  return even + (spot.day * day_tint * daylight + spot.night * (1 - daylight)) * white;
}

Vec3f Surroundings::mean_radiance() const {
  return (day_tint * (mean_day_over_white * daylight) +
          sodium * (mean_night_over_white * (1 - daylight))) *
         white;
}

}  // namespace marketgen::render::raytrace
