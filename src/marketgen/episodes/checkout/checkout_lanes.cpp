#include "episodes/checkout/checkout_lanes.h"

#include <cmath>

#include <fmt/format.h>

#include "base/seed.h"
#include "geometry/box_extents.h"
#include "physics/world/shell_pieces.h"

namespace marketgen::episodes {
namespace {

constexpr char lane_generator[] = "checkout_lane";  // assets/fixtures/fixture_generators.inc

// Where the arm may come to, in the station's x and y, and over the floor. A Panda reaches 0.855 m
// from its shoulder (Franka Emika, data sheet), its flange and long hand 0.25 m further; its work
// lies before it, so that behind it there is only the elbow. Its shoulder is 0.33 m over a counter
// of 0.88 m: stretched upwards it ends at 2.1 m and the fingers.
constexpr Vec3 arm_room_low_m{-0.6, -1.1, 0}, arm_room_high_m{1.1, 1.1, 2.2};
constexpr double touching_m = 0.001;  // what stands flush is not in the way

struct StoreBox {
  Vec3 middle, half;
};

StoreBox box_around(const Pose& store_from_box, Vec3 half) {
  return {store_from_box.position, box_half_extents(store_from_box.rotation, half)};
}

bool overlap(const StoreBox& a, const StoreBox& b) {
  const auto common = [](double from, double to, double both) {
    return std::abs(to - from) < both - touching_m;
  };
  return common(a.middle.x, b.middle.x, a.half.x + b.half.x) &&
         common(a.middle.y, b.middle.y, a.half.y + b.half.y) &&
         common(a.middle.z, b.middle.z, a.half.z + b.half.z);
}

StoreBox arm_room(const StationPlace& place) {
  const Pose store_from_floor{place.origin, yaw_from_quarter_turns(place.quarter_turns)};
  const Vec3 middle = (arm_room_low_m + arm_room_high_m) * 0.5;
  return box_around(store_from_floor * Pose{middle, {}}, arm_room_high_m - middle);
}

// Empty when nothing is.
std::string obstacle_in(const StoreBox& room, const scene::Scene& store, std::uint32_t lane) {
  for (const scene::ScenePart& part : store.parts) {
    if (part.fixture == lane) continue;
    const Pose pose =
        scene::world_from_fixture(store, part.fixture) * scene::fixture_from_part(part);
    const auto& [x, y, z] = part.half_size_m;
    if (overlap(room, box_around(pose, {x, y, z}))) return store.layout.fixtures[part.fixture].id;
  }
  for (const physics::ShellPiece& piece : physics::shell_pieces(store.layout.shell))
    if (overlap(room, box_around(piece.pose, piece.half_size))) return piece.id;
  return {};
}

}  // namespace

StationPlace place_at_lane(const CheckoutStation& station, const layout::Fixture& lane) {
  const bool along_x = lane.width_mm >= lane.depth_mm;  // as the lane's generator has it
  StationPlace place;
  place.quarter_turns = (lane.yaw_deg / 90 + (along_x ? 3 : 0)) % 4;
  const CounterRow& c = station.counter;
  const Vec3 middle{(c.low_m[0] + c.high_m[0]) / 2, (c.low_m[1] + c.high_m[1]) / 2, 0};
  place.origin = Vec3{lane.x_mm * 1e-3, lane.y_mm * 1e-3, 0} -
                 rotate(yaw_from_quarter_turns(place.quarter_turns), middle);
  return place;
}

CheckoutLanes checkout_lanes(const scene::Scene& store,
                             const catalog::Catalog& catalog,
                             const CheckoutStation& station) {
  CheckoutLanes lanes;
  for (std::uint32_t row = 0; row < store.layout.fixtures.size(); ++row) {
    const layout::Fixture& fixture = store.layout.fixtures[row];
    const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
    if (kind == nullptr || kind->generator != lane_generator) continue;
    const std::string obstacle = obstacle_in(arm_room(place_at_lane(station, fixture)), store, row);
    if (obstacle.empty())
      lanes.suited.push_back(fixture.id);
    else
      lanes.left_out.push_back(
          {fixture.id, fmt::format("{} stands where the arm may come to", obstacle)});
  }
  return lanes;
}

EpisodeSpec at_a_lane(EpisodeSpec spec, const CheckoutLanes& lanes) {
  if (lanes.suited.empty()) return spec;
  Stream draw = Seed(spec.seed).child("lane").stream();
  const int last = static_cast<int>(lanes.suited.size()) - 1;
  spec.lane = lanes.suited[static_cast<std::size_t>(draw.integer(0, last))];
  return spec;
}

}  // namespace marketgen::episodes
