#include "render/stage/item_look.h"

#include <cmath>

namespace marketgen::render::raytrace {
namespace {

constexpr float brightness_spread = 0.04F;  // between items of one SKU, each way
// Amplitude of the colour cast of a batch: print runs are held within a colour difference of about
// 3 to 5 (ISO 12647-2's tolerances for solids), as 4 % of one channel is. Fruit varies more.
constexpr float print_cast = 0.04F, grown_cast = 0.08F;
constexpr std::uint32_t batches = 3;  // of one SKU that stand on the shelf together
constexpr float as_new_share = 0.5F;  // of items nobody has touched
constexpr float min_turnover_wear = 0.5F;

// Independent numbers of one thing, by what they are for.
enum class Draw : std::uint32_t { brightness = 1, batch, cast, turn, wear, turnover };
float drawn(std::uint32_t row, Draw what) {
  return unit_float(hashed(row + hashed(static_cast<std::uint32_t>(what))));
}

// Of unit luminance; `turn` is which way on the colour circle.
Vec3f cast_of(float turn, float amplitude) {
  const auto channel = [&](float place) {
    return 1 + amplitude * std::cos(two_pi * (turn - place / 3));
  };
  const Vec3f cast{channel(0), channel(1), channel(2)};
  return cast / luminance(cast);
}

// Slow sellers gather dust; of every product, most copies look new.
float wear_of(std::uint32_t item, std::uint32_t sku) {
  const float rank = drawn(item, Draw::wear);
  if (rank < as_new_share) return 0;
  const float age = (rank - as_new_share) / (1 - as_new_share);
  const float slow = drawn(sku, Draw::turnover);
  return std::min(1.0F, age * age * age * (min_turnover_wear + slow));
}

}  // namespace

ItemLook look_of_item(std::size_t item, std::uint32_t sku, ItemKind kind) {
  const auto row = static_cast<std::uint32_t>(item);
  const float brightness = 1 + brightness_spread * (2 * drawn(row, Draw::brightness) - 1);
  if (kind == ItemKind::grown) {
    const Vec3f cast = cast_of(drawn(row, Draw::turn), grown_cast * drawn(row, Draw::cast));
    return {cast * brightness, 0};
  }
  const auto pick = static_cast<std::uint32_t>(drawn(row, Draw::batch) * batches);
  const std::uint32_t batch = sku * batches + pick;
  const Vec3f cast = cast_of(drawn(batch, Draw::turn), print_cast * drawn(batch, Draw::cast));
  return {cast * brightness, wear_of(row, sku)};
}

}  // namespace marketgen::render::raytrace
