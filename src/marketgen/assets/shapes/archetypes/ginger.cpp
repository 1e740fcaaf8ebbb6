#include <array>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"

namespace marketgen::assets {
namespace {

// A finger of the root: its line in half sizes of the pack, its radius in half heights.
struct Finger {
  Vec3f from, knee, to;
  float radius;
};
constexpr std::array<Finger, 6> fingers{
    {{{-0.95F, -0.1F, -0.1F}, {-0.2F, 0.1F, 0}, {0.55F, -0.1F, 0}, 0.72F},
     {{0.3F, 0, 0}, {0.65F, 0.35F, 0.1F}, {0.95F, 0.6F, 0}, 0.56F},
     {{-0.55F, 0, 0}, {-0.5F, -0.5F, 0}, {-0.68F, -0.92F, -0.1F}, 0.54F},
     {{0.1F, 0, 0}, {0.2F, -0.45F, 0}, {0.42F, -0.95F, -0.15F}, 0.6F},
     {{-0.25F, 0, 0}, {-0.2F, 0.5F, 0.1F}, {-0.42F, 0.93F, 0}, 0.56F},
     {{0, 0, 0.1F}, {0.08F, -0.05F, 0.5F}, {0.2F, -0.1F, 0.75F}, 0.45F}}};

}  // namespace

Result<ProductModel> make_ginger(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  Stream draw = growth_seed(product).stream();
  const std::uint16_t skin = pack.add_print(0.8F);
  const Vec3f half = Vec3f{pack.width(), pack.depth(), pack.height()} * 0.5F;
  for (const Finger& finger : fingers) {
    const Vec3f stray{0.1F * static_cast<float>(draw.uniform(-1, 1)),
                      0.08F * static_cast<float>(draw.uniform(-1, 1)),
                      0};
    const Vec3f to = (finger.to + stray) * half, knee = finger.knee * half,
                from = finger.from * half;
    const float radius = finger.radius * half.z;
    const auto own = [&](double low, double high) {
      return radius * static_cast<float>(draw.uniform(low, high));
    };
    TubeForm form;
    form.up = {0.1F, 0.15F, 1};
    // Knuckles: thick and thin by turns.
    for (const Vec3f at : {from, (from + knee) * 0.5F, knee, (knee + to) * 0.5F, to}) {
      const bool waist = form.knots.size() % 2 == 1;
      const float thick = waist ? own(0.72, 0.86) : own(0.95, 1.15);
      form.knots.push_back({at, thick, 0.92F * thick});
    }
    form.low_round_m = form.high_round_m = 1.3F * radius;
    add_tube(pack, {skin}, 18, 10, form);
  }
  return pack.finish(0.2F);
}

CollisionPrimitive collision_ginger(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
