#include "episodes/aisle/mapped_store.h"

#include <array>
#include <cmath>

namespace marketgen::episodes {
namespace {

constexpr std::array map_shares{1.0, 0.5, 0.25};

struct ShiftMm {
  int x = 0, y = 0;
};

ShiftMm shift_of(const layout::Fixture& fixture, double place_m, Seed seed) {
  Stream draw = seed.child(fixture.endcap_of.empty() ? fixture.run : fixture.endcap_of).stream();
  const auto mm = [&] {
    return static_cast<int>(std::lround(1e3 * draw.uniform(-place_m, place_m)));
  };
  const int x = mm();
  return {x, mm()};
}

void displace(scene::Scene& scene, double place_m, Seed seed) {
  for (std::size_t f = 0; f < scene.fixtures.size(); ++f) {
    layout::Fixture& row = scene.layout.fixtures[f];
    const ShiftMm shift = shift_of(row, place_m, seed);
    row.x_mm += shift.x;
    row.y_mm += shift.y;
    scene.fixtures[f].position_m[0] += 1e-3F * static_cast<float>(shift.x);
    scene.fixtures[f].position_m[1] += 1e-3F * static_cast<float>(shift.y);
  }
}

}  // namespace

Result<std::shared_ptr<const AisleStore>> mapped_store(std::shared_ptr<const AisleStore> store,
                                                       const MapDials& dials,
                                                       Seed seed,
                                                       PointMm start) {
  if (dials.place_m <= 0) return store;
  MARKETGEN_TRY(const motion::BaseEnvelope envelope,
                motion::base_envelope(store->robot, store->driving));
  for (const double share : map_shares) {
    auto made = std::make_shared<AisleStore>(*store);
    displace(made->scene, share * dials.place_m, seed);
    MARKETGEN_TRY(made->ways, collect::drive_graph(made->scene, envelope));
    if (made->ways.space().free(start)) return std::shared_ptr<const AisleStore>(std::move(made));
  }
  return store;
}

}  // namespace marketgen::episodes
