#include "episodes/checkout/checkout_scene.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "episodes/checkout/checkout_lanes.h"
#include "scene/crop.h"
#include "scene/placements.h"

namespace marketgen::episodes {
namespace {

constexpr int room_mm = 5000, ceiling_mm = 3000;
constexpr StationPlace place_in_room{{2.2, 2.5, 0}};
// From the lane's footprint to that of whatever is there too. The arm reaches 1.1 m; both cameras
// look down on the counter, and past it as far as the lanes beside it and the shelves behind those.
constexpr double surroundings_mm = 4000;
constexpr double layer_m = 0.001;  // thickness of belt and mat
// Belt, mat and top are let into one another: between them is as much as tells them apart in a
// picture, and nothing on which goods would catch.
constexpr double flush_m = 0.0001;
constexpr float belt_m_s = 0.25F;  // as assets/fixtures/checkout_counter.cpp
constexpr std::array<float, 3> laminate{0.42F, 0.43F, 0.44F}, body{0.10F, 0.11F, 0.12F},
    rubber{0.02F, 0.02F, 0.022F}, mat{0.10F, 0.22F, 0.30F}, steel{0.6F, 0.6F, 0.6F};

// The counter as the scene's last fixture, at the station's origin on the floor.
class CounterBuilder {
 public:
  CounterBuilder(scene::Scene& scene, double top_m)
      : scene_(scene), top_m_(top_m), row_(static_cast<std::uint32_t>(scene.fixtures.size())) {
    fixture_.first_part = static_cast<std::uint32_t>(scene.parts.size());
    fixture_.first_shelf = static_cast<std::uint32_t>(scene.shelves.size());
    fixture_.first_joint = static_cast<std::uint32_t>(scene.joints.size());
  }

  // `low` and `high` over the counter's top.
  scene::ScenePart& add(
      Vec3 low, Vec3 high, std::array<float, 3> color, float roughness, float metallic = 0) {
    const Vec3 middle = (low + high) * 0.5, half = (high - low) * 0.5;
    scene::ScenePart part;
    part.fixture = row_;
    part.position_m = {static_cast<float>(middle.x),
                       static_cast<float>(middle.y),
                       static_cast<float>(middle.z + top_m_)};
    part.half_size_m = {
        static_cast<float>(half.x), static_cast<float>(half.y), static_cast<float>(half.z)};
    part.color = color;
    part.roughness = roughness;
    part.metallic = metallic;
    return scene_.parts.emplace_back(part);
  }

  // Its top is the part's. Y runs away from the cashier, goods come the other way.
  void make_belt(scene::ScenePart& part) {
    part.unit = assets::UnitKind::belt;
    part.joint = static_cast<std::int32_t>(scene_.joints.size());
    scene::SceneJoint belt;
    belt.fixture = row_;
    belt.name = "belt";
    belt.kind = assets::JointKind::belt;
    belt.position_m = part.position_m;
    const float half_turn = std::sqrt(0.5F);
    belt.rotation_wxyz = {half_turn, half_turn, 0, 0};
    belt.upper = belt_m_s;
    scene_.joints.push_back(belt);
  }

  // `row`: all of its row in the layout but place and measures.
  void finish(const CounterRow& counter, const StationPlace& place, layout::Fixture row) {
    fixture_.part_count = static_cast<std::uint32_t>(scene_.parts.size()) - fixture_.first_part;
    fixture_.joint_count = static_cast<std::uint32_t>(scene_.joints.size()) - fixture_.first_joint;
    fixture_.position_m = {
        static_cast<float>(place.origin.x), static_cast<float>(place.origin.y), 0};
    fixture_.quarter_turns = place.quarter_turns;
    scene_.fixtures.push_back(fixture_);
    const Pose store_from_floor{place.origin, yaw_from_quarter_turns(place.quarter_turns)};
    const Vec3 middle = store_from_floor * Vec3{(counter.low_m[0] + counter.high_m[0]) / 2,
                                                (counter.low_m[1] + counter.high_m[1]) / 2,
                                                0};
    const auto mm = [](double m) { return static_cast<int>(std::lround(m * 1000)); };
    row.x_mm = mm(middle.x);
    row.y_mm = mm(middle.y);
    row.yaw_deg = 90 * place.quarter_turns;
    row.width_mm = mm(counter.high_m[0] - counter.low_m[0]);
    row.depth_mm = mm(counter.high_m[1] - counter.low_m[1]);
    row.height_mm = mm(counter.height_m);
    scene_.layout.fixtures.push_back(std::move(row));
  }

 private:
  scene::Scene& scene_;
  double top_m_;
  std::uint32_t row_;
  scene::SceneFixture fixture_;
};

void add_counter(scene::Scene& scene,
                 const CheckoutStation& station,
                 const StationPlace& place,
                 layout::Fixture row) {
  const CounterRow& c = station.counter;
  CounterBuilder counter(scene, c.height_m);
  constexpr double plinth_m = 0.05;  // the cabinet stands back under the top
  counter.add({c.low_m[0] + plinth_m, c.low_m[1] + plinth_m, -c.height_m},
              {c.high_m[0] - plinth_m, c.high_m[1] - plinth_m, -c.thickness_m},
              body,
              0.6F);
  counter.add({c.low_m[0], c.low_m[1], -c.thickness_m},
              {c.high_m[0], c.high_m[1], -flush_m},
              laminate,
              0.4F);
  const AreaRow &belt = station.belt, area = station.unloading.area();
  counter.make_belt(counter.add(
      {belt.low_m[0], belt.low_m[1], -layer_m}, {belt.high_m[0], belt.high_m[1], 0}, rubber, 0.8F));
  counter.add({area.low_m[0], area.low_m[1], -layer_m},
              {area.high_m[0], area.high_m[1], flush_m},
              mat,
              0.9F);
  for (const physics::ContainerBox& lip : station.lip())
    counter.add(lip.container_from_box.position - lip.half_size,
                lip.container_from_box.position + lip.half_size,
                steel,
                0.3F,
                1);
  counter.finish(c, place, std::move(row));
}

Pose store_from_station(const CheckoutStation& station, const StationPlace& place) {
  return {place.origin + Vec3{0, 0, station.counter.height_m},
          yaw_from_quarter_turns(place.quarter_turns)};
}

// Of what stands near to the lane but for itself.
std::vector<std::uint32_t> neighbours_of(const layout::Fixture& lane, const scene::Scene& store) {
  std::vector<std::uint32_t> rows;
  const RectMm place = layout::footprint_of(lane);
  for (std::uint32_t row = 0; row < store.layout.fixtures.size(); ++row) {
    const layout::Fixture& fixture = store.layout.fixtures[row];
    if (fixture.id != lane.id &&
        distance_mm(place, layout::footprint_of(fixture)) <= surroundings_mm)
      rows.push_back(row);
  }
  return rows;
}

Result<void> check_lane(const CheckoutLanes& lanes,
                        const std::string& lane,
                        const std::string& where) {
  if (std::ranges::find(lanes.suited, lane) != lanes.suited.end()) return {};
  const std::string remedy = lanes.suited.empty()
                                 ? "leave the lane out, for a room of its own"
                                 : fmt::format("name one of: {}", fmt::join(lanes.suited, ", "));
  const auto left_out = std::ranges::find(lanes.left_out, lane, &LaneExclusion::lane);
  if (left_out != lanes.left_out.end())
    return Error{
        "episode.impossible",
        where,
        fmt::format("the robot has no room at \"{}\": {}; {}", lane, left_out->reason, remedy)};
  return Error{"episode.other_store",
               where,
               fmt::format("the store has no checkout lane \"{}\"; {}", lane, remedy)};
}

}  // namespace

CheckoutPlace checkout_room(const CheckoutStation& station) {
  CheckoutPlace room;
  room.store_from_station = store_from_station(station, place_in_room);
  plan::Shell& shell = room.surroundings.layout.shell;
  shell.width_mm = shell.depth_mm = room_mm;
  shell.ceiling_mm = ceiling_mm;
  layout::Fixture counter;
  counter.id = "checkout/counter";
  counter.run = counter.zone = "checkout";
  counter.kind = "checkout_lane";
  add_counter(room.surroundings, station, place_in_room, std::move(counter));
  return room;
}

Result<CheckoutPlace> checkout_at_lane(const CheckoutStation& station,
                                       const scene::Scene& store,
                                       const catalog::Catalog& catalog,
                                       const std::string& lane,
                                       const std::string& where) {
  MARKETGEN_CHECK(check_lane(checkout_lanes(store, catalog, station), lane, where));
  layout::Fixture counter = *layout::find_fixture(store.layout, lane);
  const StationPlace stands = place_at_lane(station, counter);
  CheckoutPlace place;
  place.lane = lane;
  place.store_from_station = store_from_station(station, stands);
  place.surroundings = scene::cropped(store, neighbours_of(counter, store));
  counter.levels = 0;
  add_counter(place.surroundings, station, stands, std::move(counter));
  return place;
}

std::unique_ptr<scene::Scene> checkout_scene(const CheckoutPlace& place,
                                             const Pose& station_from_basket,
                                             const EpisodeSpec& spec,
                                             const std::vector<SharedEpisodeGoods>& goods) {
  auto scene = std::make_unique<scene::Scene>(place.surroundings);
  scene->layout.name = spec.id;
  const Pose store_from_basket = place.store_from_station * station_from_basket;
  for (std::size_t i = 0; i < goods.size(); ++i)
    add_item(*scene, goods[i]->product, store_from_basket * spec.items[i].pose());
  return scene;
}

void add_item(scene::Scene& scene,
              const catalog::Product& product,
              const Pose& store_from_product) {
  scene::SceneProduct item;
  item.sku = static_cast<std::uint32_t>(scene.catalog.size());
  item.facing = scene::no_facing;
  scene::place(item, store_from_product);
  scene.catalog.push_back(product);
  scene.products.push_back(item);
}

}  // namespace marketgen::episodes
