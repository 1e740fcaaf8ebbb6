#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "render/cameras/camera.h"
#include "render/cameras/standing_room.h"

namespace marketgen::render {
namespace {

using raytrace::StandingRoom;

constexpr double eye_m = 1.65, aisle_eye_m = 1.5, shelf_eye_m = 1.45;
constexpr double wide_deg = 52, shelf_deg = 60;
constexpr double entrance_step_m = 0.9;  // inside the door
constexpr double look_down = 0.085;      // slope of the eye's line over the store: about 5 degrees
constexpr double checkout_distance_m = 4.5;
constexpr double shelf_share = 0.86;  // of the picture's height that a shelf fills
constexpr double aisle_step_m = 1.2;  // from the aisle's end, inwards or outwards
constexpr double long_aisle_m = 9;
constexpr double plan_margin = 1.04;

Vec3 unit_at(double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return {std::cos(a), std::sin(a), 0};
}
Vec3 metres(double x_mm, double y_mm, double z_m) {
  return {x_mm * 1e-3, y_mm * 1e-3, z_m};
}

// Outward direction of a fixture's front, or of its back side.
Vec3 front_of(const layout::Fixture& fixture, int side) {
  constexpr std::array<std::array<int, 2>, 4> directions{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  const auto& d = directions[static_cast<std::size_t>((fixture.yaw_deg / 90 + 2 * side) % 4)];
  return {static_cast<double>(d[0]), static_cast<double>(d[1]), 0};
}

class Photographer {
 public:
  Photographer(const scene::Scene& scene, int width, int height)
      : layout_(scene.layout), room_(scene), width_(width), height_(height) {
    const RectMm bounds = layout_.shell.outline_mm
                              ? bounds_of(*layout_.shell.outline_mm)
                              : RectMm{0, 0, layout_.shell.width_mm, layout_.shell.depth_mm};
    bounds_ = bounds;
    middle_ = metres((bounds.x0 + bounds.x1) / 2.0, (bounds.y0 + bounds.y1) / 2.0, 0);
  }

  Camera top() const {
    Camera camera = named("top");
    const double high = layout_.shell.ceiling_mm * 1e-3 + 4;
    camera.from = {middle_.x, middle_.y, high};
    camera.at = {middle_.x, middle_.y, 0};
    const double wide = bounds_.width() * 1e-3 * height_ / width_;
    camera.ortho_height_m = plan_margin * std::max(bounds_.depth() * 1e-3, wide) + 0.4;
    return camera;
  }

  Camera entrance() const {
    Vec3 door = middle_, inward{0, 1, 0};
    for (const plan::Opening& o : layout_.shell.openings) {
      if (o.kind != plan::OpeningKind::entrance) continue;
      std::tie(door, inward) = place_of(o);
      break;
    }
    const Vec3 stand = room_.nearest(door + inward * entrance_step_m);
    return looking(named("entrance"), stand, open_view(stand, inward), eye_m, wide_deg);
  }

  Camera aisle() const {
    const layout::Aisle* longest = nullptr;
    double most = 0;
    for (const layout::Aisle& aisle : layout_.aisles) {
      const double worth = goods_along(bounds_of(aisle.polygon_mm));
      if (worth > most) {
        most = worth;
        longest = &aisle;
      }
    }
    if (longest == nullptr)
      return looking(named("aisle"),
                     room_.nearest(middle_),
                     open_view(room_.nearest(middle_), {0, 1, 0}),
                     aisle_eye_m,
                     wide_deg);
    const RectMm box = bounds_of(longest->polygon_mm);
    const bool along_x = box.width() >= box.depth();
    const double x = (box.x0 + box.x1) / 2.0, y = (box.y0 + box.y1) / 2.0;
    const Vec3 low = along_x ? metres(box.x0, y, 0) : metres(x, box.y0, 0);
    const Vec3 high = along_x ? metres(box.x1, y, 0) : metres(x, box.y1, 0);
    const Vec3 forward = normalized(high - low);
    // A long aisle is seen from within, a short one from before its end.
    const double step = length(high - low) > long_aisle_m ? aisle_step_m : -aisle_step_m;
    const Vec3 from_low = room_.nearest(low + forward * step),
               from_high = room_.nearest(high - forward * step);
    const bool upward = room_.sight(from_low, forward, 60) >= room_.sight(from_high, -forward, 60);
    return looking(named("aisle"),
                   upward ? from_low : from_high,
                   upward ? forward : -forward,
                   aisle_eye_m,
                   wide_deg);
  }

  Camera checkout() const {
    Vec3 sum{0, 0, 0};
    double count = 0;
    for (const layout::Fixture& fixture : layout_.fixtures) {
      const layout::LayoutZone* zone = layout::find_zone(layout_, fixture.zone);
      if (zone == nullptr || zone->type != "checkout") continue;
      sum += metres(fixture.x_mm, fixture.y_mm, 0);
      count += 1;
    }
    if (count == 0)
      return looking(named("checkout"), room_.nearest(middle_), {0, -1, 0}, eye_m, wide_deg);
    const Vec3 lanes = sum / count;
    // From the side with the most free floor, the shop's side when equal.
    Vec3 best = lanes;
    double farthest = -1;
    for (int degrees = 0; degrees < 360; degrees += 30) {
      const Vec3 direction = unit_at(degrees);
      const Vec3 stand = room_.nearest(lanes + direction * checkout_distance_m);
      const Vec3 away = stand - lanes;
      const double distance = std::sqrt(away.x * away.x + away.y * away.y);
      const Vec3 homeward = normalized(middle_ - lanes);
      const double worth =
          std::min(distance, checkout_distance_m) +
          1.5 * dot(normalized(Vec3{away.x, away.y, 0}), homeward) +
          0.3 * std::min(room_.sight(stand, normalized(Vec3{-away.x, -away.y, 0}), distance),
                         distance);
      if (worth > farthest) {
        farthest = worth;
        best = stand;
      }
    }
    Camera camera = named("checkout");
    camera.from = {best.x, best.y, eye_m};
    camera.at = {lanes.x, lanes.y, 0.95};
    camera.fov_deg = shelf_deg;
    return camera;
  }

  Camera zone(const layout::LayoutZone& zone) const {
    std::map<std::string, std::vector<const layout::Fixture*>> runs;
    for (const layout::Fixture& fixture : layout_.fixtures) {
      if (fixture.zone == zone.id) runs[fixture.run].push_back(&fixture);
    }
    const std::vector<const layout::Fixture*>* longest = nullptr;
    int most = 0;
    for (const auto& [run, modules] : runs) {
      int length = 0;
      for (const layout::Fixture* module : modules)
        length += module->width_mm * (module->endcap_of.empty() ? 1 : 0) + 1;
      if (length > most) {
        most = length;
        longest = &modules;
      }
    }
    const std::string name = "zone:" + zone.id;
    return longest != nullptr ? before_run(name, *longest) : in_open_zone(name, zone);
  }

 private:
  Camera named(std::string name) const {
    Camera camera;
    camera.name = std::move(name);
    camera.width = width_;
    camera.height = height_;
    return camera;
  }

  static Camera looking(Camera camera, Vec3 stand, Vec3 direction, double eye, double fov_deg) {
    camera.from = {stand.x, stand.y, eye};
    camera.at = camera.from + Vec3{direction.x, direction.y, -look_down} * 4;
    camera.fov_deg = fov_deg;
    return camera;
  }

  // How much shelving lines an aisle on both its long sides, in millimetres of the barer one, plus
  // a little of the fuller.
  double goods_along(const RectMm& aisle) const {
    constexpr int beside_mm = 400, shelf_height_mm = 1200;
    const bool along_x = aisle.width() >= aisle.depth();
    const RectMm low =
        along_x ? RectMm{aisle.x0, aisle.y0 - beside_mm, aisle.x1, aisle.y0 + beside_mm / 4}
                : RectMm{aisle.x0 - beside_mm, aisle.y0, aisle.x0 + beside_mm / 4, aisle.y1};
    const RectMm high =
        along_x ? RectMm{aisle.x0, aisle.y1 - beside_mm / 4, aisle.x1, aisle.y1 + beside_mm}
                : RectMm{aisle.x1 - beside_mm / 4, aisle.y0, aisle.x1 + beside_mm, aisle.y1};
    double low_goods = 0, high_goods = 0;
    for (const layout::Fixture& fixture : layout_.fixtures) {
      const bool faces_aisle =
          fixture.yaw_deg % 180 == (along_x ? 0 : 90) && fixture.endcap_of.empty();
      if (!faces_aisle || fixture.height_mm < shelf_height_mm) continue;
      const double gondola =
          fixture.sides == 2 ? 1.0 : 0.25;  // an aisle between gondolas before one along a wall
      if (overlap(layout::footprint_of(fixture), low)) low_goods += fixture.width_mm * gondola;
      if (overlap(layout::footprint_of(fixture), high)) high_goods += fixture.width_mm * gondola;
    }
    return std::min(low_goods, high_goods) + 0.05 * std::max(low_goods, high_goods);
  }

  // Middle of an opening on the floor, and the direction into the room.
  std::pair<Vec3, Vec3> place_of(const plan::Opening& o) const {
    const double x = o.center * layout_.shell.width_mm, y = o.center * layout_.shell.depth_mm;
    switch (o.wall) {
      case plan::Wall::north:
        return {metres(x, layout_.shell.depth_mm, 0), {0, -1, 0}};
      case plan::Wall::south:
        return {metres(x, 0, 0), {0, 1, 0}};
      case plan::Wall::east:
        return {metres(layout_.shell.width_mm, y, 0), {-1, 0, 0}};
      case plan::Wall::west:
        return {metres(0, y, 0), {1, 0, 0}};
    }
    return {middle_, {0, 1, 0}};
  }

  // The direction, within a right angle or so of `wanted`, in which a picture shows the most of the
  // shop.
  Vec3 open_view(Vec3 stand, Vec3 wanted) const {
    const double start = std::atan2(wanted.y, wanted.x) * 180 / std::numbers::pi;
    double most = -1;
    Vec3 best = wanted;
    for (const int turn : {0, 10, -10, 20, -20, 30, -30, 40, -40, 50, -50, 60, -60}) {
      double worth = 0;
      for (int ray = -35; ray <= 35; ray += 5)
        worth += std::min(room_.sight(stand, unit_at(start + turn + ray), 14), 14.0);
      worth += 6 * dot(unit_at(start + turn),
                       normalized(Vec3{middle_.x - stand.x, middle_.y - stand.y, 0}));
      if (worth > most + 0.5) {
        most = worth;
        best = unit_at(start + turn);
      }
    }
    return best;
  }

  // Before the side of a run that has the most room, so far off that the shelf fills the picture.
  Camera before_run(const std::string& name, const std::vector<const layout::Fixture*>& run) const {
    const layout::Fixture* middle = run[run.size() / 2];
    const double high = middle->height_mm * 1e-3;
    // What is low is looked into from above and needs more distance than its height says.
    const double wanted =
        std::max(1.7, high / shelf_share / 2 / std::tan(shelf_deg * std::numbers::pi / 360));
    double most = -1;
    Vec3 stand, front;
    for (int side = 0; side < (middle->sides == 2 ? 2 : 1); ++side) {
      const Vec3 direction = front_of(*middle, side);
      const double half = middle->depth_mm * 0.5e-3;
      const Vec3 edge = metres(middle->x_mm, middle->y_mm, 0) + direction * half;
      constexpr double start = 0.5;  // clear of the fixture itself
      const double free = room_.free_way(edge + direction * start, direction, wanted - start);
      if (free > most + 0.01) {
        most = free;
        front = direction;
        stand = edge + direction * (start + free);
      }
    }
    if (!room_.is_free(stand)) stand = room_.nearest(stand);
    const Vec3 along{-front.y, front.x, 0};
    const Vec3 aside = stand + along * 0.5;  // a little from the side: packs show their depth
    if (room_.is_free(aside)) stand = aside;
    Camera camera = named(name);
    const double eye = high < 1.2 ? eye_m : shelf_eye_m;
    camera.from = {stand.x, stand.y, eye};
    const Vec3 target =
        metres(middle->x_mm, middle->y_mm, 0) + front * (middle->depth_mm * 0.25e-3);
    camera.at = {target.x, target.y, high < 1.2 ? high * 0.75 : high * 0.5};
    camera.fov_deg = shelf_deg;
    return camera;
  }

  Camera in_open_zone(const std::string& name, const layout::LayoutZone& zone) const {
    const RectMm box = bounds_of(zone.polygon_mm);
    const Vec3 center = metres((box.x0 + box.x1) / 2.0, (box.y0 + box.y1) / 2.0, 0);
    const Vec3 stand = room_.nearest(center);
    const Vec3 inward = length(middle_ - stand) > 0.1 ? normalized(middle_ - stand) : Vec3{0, 1, 0};
    return looking(
        named(name), stand, open_view(stand, Vec3{inward.x, inward.y, 0}), eye_m, shelf_deg);
  }

  const layout::Layout& layout_;
  StandingRoom room_;
  int width_, height_;
  RectMm bounds_;
  Vec3 middle_;
};

}  // namespace

std::vector<Camera> standard_cameras(const scene::Scene& scene, int width, int height) {
  const Photographer photographer(scene, std::max(1, width), std::max(1, height));
  std::vector<Camera> cameras{
      photographer.top(), photographer.entrance(), photographer.aisle(), photographer.checkout()};
  for (const layout::LayoutZone& zone : scene.layout.zones)
    cameras.push_back(photographer.zone(zone));
  return cameras;
}

}  // namespace marketgen::render
