#include "export/nav2_waypoints.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "export/robot_floor.h"
#include "layout/route.h"
#include "plan/bsp.h"
#include "plan/floor_places.h"
#include "scene/bays.h"
#include "scene/standing_place.h"

namespace marketgen::exporters {
namespace {

constexpr int door_reach_mm = 1500;  // how far from a door's middle its place may be
constexpr int till_reach_mm = 500;   // and from where shoppers queue and pay

class Finder {
 public:
  Finder(const scene::Scene& scene, const catalog::Catalog& catalog, const ExportOptions& options)
      : scene_(scene),
        catalog_(catalog),
        radius_mm_(static_cast<int>(std::lround(options.robot_radius_m * 1000))),
        reached_(robot_floor(scene, catalog, options)),
        items_(scene.shelves.size()) {
    for (const scene::Facing& facing : scene.facings) {
      if (facing.product_count > 0)
        items_[facing.shelf][scene.catalog[facing.sku].category] += facing.product_count;
    }
  }

  Waypoints find() {
    add_doors();
    add_tills();
    add_shelves();
    sort_categories();
    return std::move(found_);
  }

 private:
  struct BayItems {
    std::string name;
    std::uint64_t items;
  };

  std::optional<PointMm> place_near(PointMm wanted, int reach_mm) const {
    const auto cell = navigation::nearest_free(reached_, wanted, reach_mm);
    if (!cell) return std::nullopt;
    const auto columns = static_cast<std::size_t>(reached_.columns);
    return reached_.center(static_cast<int>(*cell % columns), static_cast<int>(*cell / columns));
  }

  // Looks along `direction` from the place near `wanted`.
  bool add(Waypoint waypoint, PointMm wanted, int reach_mm, Vec2 direction) {
    const std::optional<PointMm> at = place_near(wanted, reach_mm);
    if (!at) return false;
    waypoint.x_m = (*at)[0] * 1e-3, waypoint.y_m = (*at)[1] * 1e-3;
    waypoint.yaw = std::atan2(direction.y, direction.x);
    found_.places.push_back(std::move(waypoint));
    return true;
  }

  void add_doors() {
    const plan::Shell& shell = scene_.layout.shell;
    for (const plan::Opening& opening : shell.openings) {
      const bool in = opening.kind == plan::OpeningKind::entrance;
      if (!in && opening.kind != plan::OpeningKind::exit) continue;
      const PointMm inward = plan::inward_from(opening.wall);
      const double sign = in ? 1 : -1;
      const PointMm inside = plan::point_inside(plan::shell_rect(shell), opening, radius_mm_ + 100);
      const WaypointKind kind = in ? WaypointKind::entrance : WaypointKind::exit;
      if (!add({opening.id, kind, 0, 0, 0, {}, {}, {}},
               inside,
               door_reach_mm,
               {sign * inward[0], sign * inward[1]}))
        found_.unreachable.push_back(opening.id);
    }
  }

  void add_tills() {
    for (const layout::PayingPlace& paying : layout::paying_places(scene_.layout, catalog_)) {
      const layout::Fixture* till = layout::find_fixture(scene_.layout, paying.fixture);
      const auto towards = [](PointMm from, PointMm to) {
        return Vec2{double(to[0] - from[0]), double(to[1] - from[1])};
      };
      const auto add_place = [&](const char* what, PointMm at, Vec2 direction) {
        Waypoint place{
            paying.fixture + what, WaypointKind::checkout, 0, 0, 0, paying.fixture, till->zone, {}};
        const std::string name = place.name;
        if (!add(std::move(place), at, till_reach_mm, direction))
          found_.unreachable.push_back(name);
      };
      if (paying.queue != paying.till)
        add_place("/queue", paying.queue, towards(paying.queue, paying.till));
      add_place("/till", paying.till, towards(paying.till, {till->x_mm, till->y_mm}));
    }
  }

  // Items of each category on the bay, the most first.
  std::vector<std::pair<std::string, std::uint64_t>> goods_on(const scene::BayRef& bay) const {
    std::map<std::string, std::uint64_t> items;
    for (const std::uint32_t shelf : bay.shelves) {
      for (const auto& [category, count] : items_[shelf])
        items[category] += count;
    }
    std::vector<std::pair<std::string, std::uint64_t>> goods(items.begin(), items.end());
    std::ranges::stable_sort(goods, std::greater<>(), [](const auto& g) { return g.second; });
    return goods;
  }

  void add_shelves() {
    for (const scene::BayRef& bay : scene::bays_of(scene_)) {
      const layout::Fixture& fixture = scene_.layout.fixtures[bay.fixture];
      Waypoint place{fixture.id + "/side-" + std::to_string(bay.side),
                     WaypointKind::shelf,
                     0,
                     0,
                     0,
                     fixture.id,
                     fixture.zone,
                     {}};
      const std::string name = place.name;
      const auto goods = goods_on(bay);
      for (const auto& [category, items] : goods)
        place.categories.push_back(category);
      if (!add_before_shelves(std::move(place), bay)) {
        found_.unreachable.push_back(name);
        continue;
      }
      for (const auto& [category, items] : goods)
        bays_[category].push_back({name, items});
    }
  }

  // Before the lowest of its shelves that can be got to.
  bool add_before_shelves(Waypoint place, const scene::BayRef& bay) {
    return std::ranges::any_of(bay.shelves, [&](std::uint32_t shelf) {
      const Vec3 inward = rotate(scene::world_from_shelf(scene_, shelf).rotation, {0, 1, 0});
      return add(place,
                 scene::standing_point(scene_, shelf),
                 scene::standing_reach_mm,
                 {inward.x, inward.y});
    });
  }

  void sort_categories() {
    for (auto& [category, bays] : bays_) {
      std::ranges::stable_sort(bays, std::greater<>(), [](const BayItems& b) { return b.items; });
      for (BayItems& bay : bays)
        found_.by_category[category].push_back(std::move(bay.name));
    }
  }

  const scene::Scene& scene_;
  const catalog::Catalog& catalog_;
  int radius_mm_;
  navigation::OccupancyGrid reached_;
  std::vector<std::map<std::string, std::uint64_t>> items_;  // by shelf, of each category
  std::map<std::string, std::vector<BayItems>> bays_;        // by category
  Waypoints found_;
};

}  // namespace

Waypoints find_waypoints(const scene::Scene& scene,
                         const catalog::Catalog& catalog,
                         const ExportOptions& options) {
  return Finder(scene, catalog, options).find();
}

}  // namespace marketgen::exporters
