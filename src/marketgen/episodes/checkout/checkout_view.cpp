#include "episodes/checkout/checkout_view.h"

#include "episodes/field_of_view.h"
#include "geometry/rotation_axes.h"
#include "render/picture_objects.h"
#include "render/stage/robot_actor.h"

namespace marketgen::episodes {
namespace {

constexpr int room_mm = 5000, ceiling_mm = 3000;
constexpr Vec3 origin_in_room{2.2, 2.5, 0};  // of the station frame, on the floor
constexpr double painted_m = 0.001;          // thickness of belt and mat
constexpr std::array<float, 3> laminate{0.42F, 0.43F, 0.44F}, cabinet{0.10F, 0.11F, 0.12F},
    rubber{0.02F, 0.02F, 0.022F}, mat{0.10F, 0.22F, 0.30F}, steel{0.6F, 0.6F, 0.6F};
constexpr render::ActorSurface basket_plastic{{0.42F, 0.03F, 0.025F}, 0.45F, 0};

// The counter as a fixture at the station's origin on the floor.
class CounterBuilder {
 public:
  CounterBuilder(scene::Scene& scene, double top_m) : scene_(scene), top_m_(top_m) {}

  // `low` and `high` over the counter's top.
  void add(Vec3 low, Vec3 high, std::array<float, 3> color, float roughness, float metallic = 0) {
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
    scene_.parts.push_back(part);
  }

  void finish(const CounterRow& counter) {
    scene::SceneFixture fixture;
    fixture.part_count = static_cast<std::uint32_t>(scene_.parts.size());
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
              cabinet,
              0.6F);
  counter.add({c.low_m[0], c.low_m[1], -c.thickness_m},
              {c.high_m[0], c.high_m[1], -painted_m},
              laminate,
              0.4F);
  const auto paint = [&](const AreaRow& area, std::array<float, 3> color, float roughness) {
    counter.add({area.low_m[0], area.low_m[1], -painted_m},
                {area.high_m[0], area.high_m[1], 0},
                color,
                roughness);
  };
  paint(station.belt, rubber, 0.8F);
  const AreaRow area = station.unloading.area();
  counter.add({area.low_m[0], area.low_m[1], -painted_m / 2},
              {area.high_m[0], area.high_m[1], painted_m / 4},
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

std::unique_ptr<scene::Scene> station_scene(const CheckoutWorld& world) {
  auto scene = std::make_unique<scene::Scene>();
  scene->layout.shell.width_mm = scene->layout.shell.depth_mm = room_mm;
  scene->layout.shell.ceiling_mm = ceiling_mm;
  add_counter(*scene, world.station());
  for (std::size_t i = 0; i < world.item_count(); ++i) {
    scene::SceneProduct product;
    product.sku = static_cast<std::uint32_t>(scene->catalog.size());
    product.facing = ~0U;  // on no shelf
    scene->catalog.push_back(world.goods(i).product);
    scene->products.push_back(product);
  }
  return scene;
}

render::Actor basket_actor(const CheckoutStation& station) {
  render::ActorBody body;
  body.name = "basket";
  body.surfaces = {basket_plastic};
  for (const physics::ContainerBox& box : station.basket_boxes()) {
    Mesh part;
    add_box(part, to_float(-box.half_size), to_float(box.half_size), 0, 0);
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
      part.positions[v] = to_float(box.container_from_box * to_double(part.positions[v]));
      part.normals[v] =
          to_float(rotate(box.container_from_box.rotation, to_double(part.normals[v])));
    }
    body.mesh.append(part);
  }
  return {"basket", {std::move(body)}};
}

}  // namespace

Result<std::unique_ptr<CheckoutView>> CheckoutView::create(const CheckoutWorld& world) {
  std::unique_ptr<CheckoutView> view(new CheckoutView);
  view->station_ = world.station();
  view->world_from_station_ = {origin_in_room + Vec3{0, 0, world.station().counter.height_m}, {}};
  view->scene_ = station_scene(world);
  MARKETGEN_TRY(view->renderer_, render::Renderer::create(*view->scene_));
  MARKETGEN_TRY(render::Actor robot,
                render::robot_actor(world.robot(), world.robot_state(), view->world_from_station_));
  MARKETGEN_CHECK(view->renderer_->set_actors({basket_actor(world.station()), std::move(robot)}));
  MARKETGEN_CHECK(view->follow(world));
  return view;
}

Result<std::unique_ptr<TrackView>> CheckoutWorld::open_view() const {
  return open_view_of<CheckoutView>(*this);
}

// Behind the one fixture, as first_product_object() has it.
std::uint32_t CheckoutView::object_of_item(std::size_t item) {
  return render::first_fixture_object + 1 + static_cast<std::uint32_t>(item);
}

Result<void> CheckoutView::follow(const CheckoutWorld& world) {
  std::vector<render::MovedProduct> items;
  for (std::size_t i = 0; i < world.item_count(); ++i)
    items.push_back({static_cast<std::uint32_t>(i), world_from_station_ * world.item_pose(i)});
  MARKETGEN_CHECK(renderer_->move_things(items, {}));
  const Pose basket = world_from_station_ * world.basket_pose();
  MARKETGEN_CHECK(renderer_->move_actor(0, {&basket, 1}));
  const std::vector<Pose> links =
      render::world_link_poses(world.robot(), world.robot_state(), world_from_station_);
  MARKETGEN_CHECK(renderer_->move_actor(1, links));
  world_from_hand_ = links[static_cast<std::size_t>(world.robot().find_link("hand"))];
  return {};
}

Result<render::Camera> CheckoutView::camera(std::string_view name, int width, int height) const {
  const auto which =
      name == film_camera_name ? StationCamera::scene : value_named<StationCamera>(name);
  if (!which)
    return Error{"camera.unknown", std::string(name), "there are scene_camera and wrist_camera"};
  return camera(*which, width, height);
}

render::Camera CheckoutView::camera(StationCamera which, int width, int height) const {
  render::Camera camera;
  camera.name = name_of(which);
  const auto size = [&](const auto& row) {
    camera.width = width > 0 ? width : row.width;
    camera.height = height > 0 ? height : row.height;
    camera.fov_deg = fov_down_deg(row.fov_deg, camera.width, camera.height);
  };
  if (which == StationCamera::scene) {
    const StationCameraRow& row = station_.scene_camera;
    size(row);
    camera.from = world_from_station_ * Vec3{row.from_m[0], row.from_m[1], row.from_m[2]};
    camera.at = world_from_station_ * Vec3{row.at_m[0], row.at_m[1], row.at_m[2]};
    return camera;
  }
  const WristCameraRow& row = station_.wrist_camera;
  size(row);
  // Ahead is the hand's Z; the fingers are at the picture's lower edge: right is the hand's Y.
  const Quaternion hand_from_camera = rotation_with_axes({-1, 0, 0}, {0, 0, 1});
  camera.world_from_camera =
      world_from_hand_ * Pose{{row.hand_m[0], row.hand_m[1], row.hand_m[2]}, hand_from_camera};
  return camera;
}

}  // namespace marketgen::episodes
