#include <algorithm>
#include <cmath>

#include "assets/print/color.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/film_bag.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "base/seed.h"
#include "base/text.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr float fruit_width_m = 0.064F;
constexpr float cord_half_m = 0.00055F;
constexpr int cords_each_way = 22;
constexpr int cord_steps = 11;
constexpr int max_fruits = 20;

// What comes in nets, by the first word that the row's name or variant contains.
struct NetGoods {
  std::string_view word, color;
  float width_m, long_share;  // of one piece; its length over its width
};
constexpr NetGoods net_goods[] = {
    {"sweet potato", "#b5613a", 0.062F, 1.5F},
    {"red onion", "#6e2440", 0.064F, 1.0F},
    {"shallot", "#b06a3c", 0.034F, 1.25F},
    {"onion", "#c07b2c", 0.066F, 1.0F},
    {"potato", "#b89155", 0.056F, 1.28F},
    {"garlic", "#e6dfd2", 0.052F, 0.9F},
    {"lemon", "#f0cf2d", 0.058F, 1.25F},
    {"lime", "#5f9130", 0.050F, 1.1F},
    {"mandarin", "#ee7c12", 0.058F, 0.88F},
    {"clementine", "#ee7c12", 0.054F, 0.9F},
    {"grapefruit", "#efa63f", 0.098F, 0.95F},
    {"orange", "#ee8316", 0.074F, 1.0F},
    {"chestnut", "#4a2413", 0.032F, 0.9F},
    {"avocado", "#2c3320", 0.066F, 1.4F},
    {"apple", "#b3202a", 0.070F, 0.95F},
    {"walnut", "#a97d4d", 0.036F, 1.15F},
    {"mussel", "#1d2230", 0.046F, 1.6F},
    {"beet", "#5a1f35", 0.060F, 1.0F},
};

NetGoods goods_in(const catalog::Product& product) {
  const std::string words = lower_ascii(product.variant + " " + product.name);
  for (const NetGoods& goods : net_goods) {
    if (words.find(goods.word) != std::string_view::npos) return goods;
  }
  return {"", product.label.primary, fruit_width_m, 1.0F};
}

// The filled part of the bag: half sizes at a share of its height, round below, gathered above.
class Hull {
 public:
  explicit Hull(const PackBuilder& pack)
      : half_width_(0.94F * pack.width() / 2),
        half_depth_(pack.depth() / 2),
        high_((net_header_low + 0.03F) * pack.height()) {}

  float high() const { return high_; }

  Vec2f half_at(float z) const {
    const float t = std::clamp(z / high_, 0.0F, 1.0F);
    const float below = std::clamp(1 - t / 0.30F, 0.0F, 1.0F);
    const float above = std::clamp((t - 0.55F) / 0.45F, 0.0F, 1.0F);
    const float round = std::sqrt(std::max(0.02F, 1 - 0.97F * below * below));
    const float gather = above * above * (3 - 2 * above);
    return {half_width_ * round * (1 - 0.12F * gather), half_depth_ * round * (1 - 0.80F * gather)};
  }

  Vec3f point(double turn, float z) const {
    const Vec2 d = unit_circle(turn);
    const Vec2f half = half_at(z);
    return {half.x * static_cast<float>(d.x), half.y * static_cast<float>(d.y), z};
  }

 private:
  float half_width_, half_depth_, high_;
};

void add_fruit(PackBuilder& pack, Vec3f middle, Vec3f half, double lean, std::uint16_t surface) {
  const Vec2 turn = unit_circle(lean);
  const auto c = static_cast<float>(turn.x), s = static_cast<float>(turn.y);
  add_shell(pack, {.surface = surface}, {16, even_stations(8)}, [&](double around, double along) {
    const Vec2 ring = unit_circle(around), rise = unit_circle(0.5 * along - 0.25);
    const Vec3f p{half.x * static_cast<float>(rise.x * ring.x),
                  half.y * static_cast<float>(rise.x * ring.y),
                  half.z * static_cast<float>(rise.y)};
    return middle + Vec3f{c * p.x - s * p.z, p.y, s * p.x + c * p.z};
  });
}

// Where round pieces come to rest in the hull: dropped anywhere, pushed apart, pulled down.
std::vector<Vec3f> settled(const Hull& hull, float r, int count, Stream& draw) {
  std::vector<Vec3f> at;
  for (int i = 0; i < count; ++i) {
    const auto any = [&](float half) { return half * static_cast<float>(draw.uniform(-1, 1)); };
    at.push_back({any(0.5F * hull.half_at(r).x),
                  any(0.5F * hull.half_at(r).y),
                  hull.high() * static_cast<float>(draw.uniform(0.1, 0.9))});
  }
  constexpr int rounds = 160;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Vec3f apart = at[i] - at[k];
        const float distance = std::max(length(apart), 1e-6F);
        if (distance >= 2 * r) continue;
        const Vec3f push = apart * (0.5F * (2 * r - distance) / distance);
        at[i] += push;
        at[k] += -push;
      }
    }
    for (Vec3f& p : at) {
      p.z = std::clamp(p.z - 0.02F * r, r, std::max(r, hull.high() - 0.9F * r));
      const Vec2f half = hull.half_at(p.z);
      const Vec2f room{std::max(half.x - r, 0.02F * r), std::max(half.y - r, 0.02F * r)};
      const float out = std::sqrt(p.x * p.x / (room.x * room.x) + p.y * p.y / (room.y * room.y));
      if (out > 1) p = {p.x / out, p.y / out, p.z};
    }
  }
  return at;
}

void add_fruits(PackBuilder& pack,
                const Hull& hull,
                const NetGoods& goods,
                Stream draw,
                const std::vector<std::uint16_t>& surfaces) {
  const float room = std::min({pack.width() / 2.2F, 0.92F * pack.depth(), hull.high() / 2.2F});
  constexpr float filled = 0.80F;  // share of the hull that loose round pieces take
  const float hull_volume = 0.62F * pack.width() * pack.depth() * hull.high();
  const auto pieces = [&](float r) { return filled * hull_volume / (4.19F * r * r * r); };
  const float usual = std::min(goods.width_m, room) / 2;
  // A bag of more pieces than are drawn has larger ones: it is as full.
  const float r = usual * std::max(1.0F, std::cbrt(pieces(usual) / max_fruits));
  const int count = std::clamp(static_cast<int>(pieces(r)), 1, max_fruits);
  for (const Vec3f& middle : settled(hull, r, count, draw)) {
    const float size = r * static_cast<float>(draw.uniform(0.95, 1.04));
    const float grow = std::sqrt(goods.long_share);
    const Vec3f half{size * grow, size / grow, size / std::sqrt(grow)};
    const auto skin = static_cast<std::size_t>(draw.integer(0, 2));
    add_fruit(pack, middle, half, draw.uniform(), surfaces[skin]);
  }
}

// A cord that climbs around the hull: a three-sided tube.
void add_cord(
    PackBuilder& pack, const Hull& hull, double start, double turns, std::uint16_t surface) {
  const float half = std::min(cord_half_m, 0.01F * pack.depth());
  const float low = 0.004F * hull.high(), high = hull.high();
  std::vector<std::array<Vec3f, 3>> rings;
  for (int i = 0; i <= cord_steps; ++i) {
    const float t = static_cast<float>(i) / cord_steps;
    const double turn = start + turns * static_cast<double>(t);
    const float z = low + (high - low) * t;
    const Vec3f at = hull.point(turn, z),
                ahead = hull.point(turn + turns * 0.02, z + 0.02F * (high - low));
    const Vec2f wide = hull.half_at(z);
    const Vec3f out = normalized(Vec3f{at.x / (wide.x * wide.x), at.y / (wide.y * wide.y), 0});
    const Vec3f along = normalized(ahead - at), side = normalized(cross(along, out));
    rings.push_back(
        {at + out * half, at + side * half - out * half, at - side * half - out * half});
  }
  const auto corner = [](Vec3f p) { return Corner{p, {}}; };
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t n = (k + 1) % 3;
      pack.add_quad(corner(rings[i][k]),
                    corner(rings[i][n]),
                    corner(rings[i + 1][n]),
                    corner(rings[i + 1][k]),
                    surface);
    }
  }
  const auto& first = rings.front();
  const auto& last = rings.back();
  pack.add_triangle(corner(first[0]), corner(first[2]), corner(first[1]), surface);
  pack.add_triangle(corner(last[0]), corner(last[1]), corner(last[2]), surface);
}

void add_net(PackBuilder& pack, const Hull& hull, std::uint16_t surface) {
  constexpr double climb = 0.34;  // of a turn from the foot to the header
  for (int i = 0; i < cords_each_way; ++i) {
    const double start = static_cast<double>(i) / cords_each_way;
    add_cord(pack, hull, start, climb, surface);
    add_cord(pack, hull, start + 0.37 / cords_each_way, -climb, surface);
  }
}

// The film header that closes the net: thick where it takes up the net, flat at its upper edge.
void add_header(PackBuilder& pack, std::uint16_t print, std::uint16_t edge) {
  const Vec3f size{pack.width(), 0.30F * pack.depth(), (1 - net_header_low) * pack.height()};
  const auto thickness = [](float x, float z) {
    const float open = std::max(0.0F, 1 - z / 0.55F);
    return open * open * (1 - x * x * x * x);
  };
  add_bag(pack,
          print,
          edge,
          {size, even_lines(10), {0, 0.08F, 0.18F, 0.3F, 0.42F, 0.55F, 1}, 0, thickness},
          PartFrame{.origin = {0, 0, net_header_low * pack.height()}});
}

}  // namespace

// Oranges, onions, potatoes in a knitted net under a printed header.
Result<ProductModel> make_net_bag(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const NetGoods goods = goods_in(product);
  MARKETGEN_TRY(const Vec3f skin, linear_from_hex(goods.color));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t edge = pack.add_surface(film(colors.primary));
  const std::uint16_t net = pack.add_surface(plastic(colors.accent));
  std::vector<std::uint16_t> skins;
  for (const float shade : {1.0F, 0.86F, 0.94F})
    skins.push_back(pack.add_surface({.color = skin * shade, .roughness = skin_roughness}));
  const Hull hull(pack);
  add_fruits(pack, hull, goods, Seed(0).child("net_bag", product.sku).stream(), skins);
  add_net(pack, hull, net);
  add_header(pack, print, edge);
  pack.add_surface_feature(FeatureKind::seam, print);
  return pack.finish();
}

CollisionPrimitive collision_net_bag(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
