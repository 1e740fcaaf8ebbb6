#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"

namespace marketgen::assets {

// One strand: from an end on the belly through the twist, round both loops and the thick belly, and
// back.
Result<ProductModel> make_pretzel(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t skin = pack.add_print(0.4F);
  const Vec3f half = Vec3f{pack.width(), pack.depth(), pack.height()} * 0.5F;
  const float thick = 0.62F * half.z;
  TubeForm strand;
  const auto knot = [&](float x, float y, float z, float share) {
    strand.knots.push_back(
        {{x * 0.84F * half.x, y * 0.84F * half.y, z * half.z}, share * thick, share * thick});
  };
  constexpr float rest = 0.62F, over = 1.25F;  // height of the strand's middle, in half heights
  knot(-0.5F, -0.68F, 1.1F, 0.42F);
  knot(-0.34F, -0.42F, 0.95F, 0.52F);
  knot(-0.10F, -0.10F, rest, 0.58F);
  knot(0.10F, 0.14F, over, 0.62F);
  knot(0.26F, 0.52F, rest, 0.72F);
  knot(0.60F, 0.95F, rest, 0.85F);
  knot(0.98F, 0.62F, rest, 0.92F);
  knot(0.95F, -0.10F, rest, 1.0F);
  knot(0.58F, -0.74F, rest, 1.12F);
  knot(0.0F, -0.98F, 1.15F * rest, 1.3F);
  knot(-0.58F, -0.74F, rest, 1.12F);
  knot(-0.95F, -0.10F, rest, 1.0F);
  knot(-0.98F, 0.62F, rest, 0.92F);
  knot(-0.60F, 0.95F, rest, 0.85F);
  knot(-0.26F, 0.52F, rest, 0.72F);
  knot(-0.10F, 0.14F, 0.8F * rest, 0.62F);
  knot(0.10F, -0.10F, over, 0.58F);
  knot(0.34F, -0.42F, 0.95F, 0.52F);
  knot(0.5F, -0.68F, 1.1F, 0.42F);
  strand.low_round_m = strand.high_round_m = 0.5F * thick;
  add_tube(pack, {skin}, 18, 84, strand);
  return pack.finish(0.2F);
}

CollisionPrimitive collision_pretzel(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
