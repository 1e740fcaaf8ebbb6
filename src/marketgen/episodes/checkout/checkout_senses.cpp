#include "episodes/checkout/checkout_senses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/fields.h"
#include "episodes/camera_senses.h"

namespace marketgen::episodes {
namespace {

std::vector<int> items_in(const render::Frame& frame, const CheckoutWorld& world) {
  const std::uint32_t first = CheckoutView::object_of_item(world, 0),
                      end = CheckoutView::object_of_item(world, world.item_count());
  std::vector<int> items;
  for (const std::uint32_t object : frame.instance)
    items.push_back(object >= first && object < end ? static_cast<int>(object - first) : -1);
  return items;
}

}  // namespace

const std::vector<int>& CheckoutEyes::items_shown(const std::string& camera) const {
  static const std::vector<int> none;
  const auto found = items_shown_.find(camera);
  return found == items_shown_.end() ? none : found->second;
}

Result<agent::View> CheckoutEyes::look(std::string_view camera) {
  const auto which = value_named<StationCamera>(camera);
  if (!which)
    return Error{"usage.bad_flag",
                 std::string(camera),
                 "the agent has no such camera; it has scene_camera and wrist_camera"};
  if (!view_) {
    MARKETGEN_TRY(view_, CheckoutView::create(world_));
  }
  const Scenery then = world_.pictured();
  MARKETGEN_CHECK(view_->follow(world_, then));
  const render::Camera taken = view_->camera(*which);
  MARKETGEN_TRY(render::Frame frame, sensed_picture(world_, camera, view_->renderer(), taken, {}));
  items_shown_.insert_or_assign(std::string(camera), items_in(frame, world_));
  agent::View view;
  view.camera = camera;
  view.time_s = then.time_s;
  const render::Intrinsics lens = render::intrinsics_of(taken);
  view.lens = {lens.fx, lens.fy, lens.cx, lens.cy};
  view.base_from_camera = inverse(view_->world_from_station()) * render::opencv_pose_of(taken);
  view.color = std::move(frame.color);
  view.depth_m = std::move(frame.depth_m);
  return view;
}

agent::Workplace workplace_of(const CheckoutStation& station) {
  const auto area = [](const AreaRow& row) { return agent::WorkArea{row.low_m, row.high_m}; };
  agent::Workplace place;
  place.counter = {station.counter.low_m, station.counter.high_m};
  place.unloading = area(station.unloading.area());
  place.set_aside = area(station.set_aside);
  place.base_from_basket = station.basket_pose();
  place.rim_m = station.basket.height_m;
  place.inner_half = {station.basket.top_m[0] / 2, station.basket.top_m[1] / 2, 0};
  place.wall_m = station.basket.wall_m;
  for (const physics::ContainerBox& box : physics::boxes_of(station.container())) {
    const bool is_wall = std::abs(box.half_size.x - station.basket.wall_m / 2) < 1e-9;
    (is_wall ? place.walls : place.ledges).push_back({box.container_from_box, box.half_size});
  }
  return place;
}

}  // namespace marketgen::episodes
