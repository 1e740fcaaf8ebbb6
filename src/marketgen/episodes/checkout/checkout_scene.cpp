#include "episodes/checkout/checkout_scene.h"

#include <cmath>

#include "scene/placements.h"

namespace marketgen::episodes {
namespace {

constexpr int room_mm = 5000, ceiling_mm = 3000;
constexpr Vec3 origin_in_room{2.2, 2.5, 0};  // of the station frame, on the floor
constexpr double layer_m = 0.001;            // thickness of belt and mat
// Belt, mat and top are let into one another: between them is as much as tells them apart in a
// picture, and nothing on which goods would catch.
constexpr double flush_m = 0.0001;
constexpr float belt_m_s = 0.25F;  // as assets/fixtures/checkout_counter.cpp
constexpr std::array<float, 3> laminate{0.42F, 0.43F, 0.44F}, body{0.10F, 0.11F, 0.12F},
    rubber{0.02F, 0.02F, 0.022F}, mat{0.10F, 0.22F, 0.30F}, steel{0.6F, 0.6F, 0.6F};

// The counter as a fixture at the station's origin on the floor.
class CounterBuilder {
 public:
  CounterBuilder(scene::Scene& scene, double top_m) : scene_(scene), top_m_(top_m) {}

  // `low` and `high` over the counter's top.
  scene::ScenePart& add(
      Vec3 low, Vec3 high, std::array<float, 3> color, float roughness, float metallic = 0) {
    const Vec3 middle = (low + high) * 0.5, half = (high - low) * 0.5;
    scene::ScenePart part;
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
    belt.name = "belt";
    belt.kind = assets::JointKind::belt;
    belt.position_m = part.position_m;
    const float half_turn = std::sqrt(0.5F);
    belt.rotation_wxyz = {half_turn, half_turn, 0, 0};
    belt.upper = belt_m_s;
    scene_.joints.push_back(belt);
  }

  void finish(const CounterRow& counter) {
    scene::SceneFixture fixture;
    fixture.part_count = static_cast<std::uint32_t>(scene_.parts.size());
    fixture.joint_count = static_cast<std::uint32_t>(scene_.joints.size());
    fixture.position_m = {
        static_cast<float>(origin_in_room.x), static_cast<float>(origin_in_room.y), 0};
    scene_.fixtures.push_back(fixture);
    layout::Fixture row;
    row.id = "checkout/counter";
    row.run = row.zone = "checkout";
    row.kind = "checkout_lane";
    const auto mm = [](double m) { return static_cast<int>(std::lround(m * 1000)); };
    row.x_mm = mm(origin_in_room.x + (counter.low_m[0] + counter.high_m[0]) / 2);
    row.y_mm = mm(origin_in_room.y + (counter.low_m[1] + counter.high_m[1]) / 2);
    row.width_mm = mm(counter.high_m[0] - counter.low_m[0]);
    row.depth_mm = mm(counter.high_m[1] - counter.low_m[1]);
    row.height_mm = mm(counter.height_m);
    scene_.layout.fixtures.push_back(row);
  }

 private:
  scene::Scene& scene_;
  double top_m_;
};

void add_counter(scene::Scene& scene, const CheckoutStation& station) {
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
  counter.finish(c);
}

}  // namespace

Pose store_from_station(const CheckoutStation& station) {
  return {origin_in_room + Vec3{0, 0, station.counter.height_m}, {}};
}

std::unique_ptr<scene::Scene> checkout_scene(const CheckoutStation& station,
                                             const EpisodeSpec& spec,
                                             const std::vector<SharedEpisodeGoods>& goods) {
  auto scene = std::make_unique<scene::Scene>();
  scene->layout.name = spec.id;
  scene->layout.shell.width_mm = scene->layout.shell.depth_mm = room_mm;
  scene->layout.shell.ceiling_mm = ceiling_mm;
  add_counter(*scene, station);
  const Pose store_from_basket = store_from_station(station) * station.basket_pose();
  for (std::size_t i = 0; i < goods.size(); ++i) {
    const Pose pose = store_from_basket * spec.items[i].pose();
    const Vec3& p = pose.position;
    const Quaternion& q = pose.rotation;
    scene::SceneProduct product;
    product.sku = static_cast<std::uint32_t>(i);
    product.facing = scene::no_facing;
    product.position_m = {
        static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    product.rotation_wxyz = {static_cast<float>(q.w),
                             static_cast<float>(q.x),
                             static_cast<float>(q.y),
                             static_cast<float>(q.z)};
    scene->catalog.push_back(goods[i]->product);
    scene->products.push_back(product);
  }
  return scene;
}

}  // namespace marketgen::episodes
