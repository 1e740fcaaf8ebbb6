#include "collect/standing_robot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "io/file.h"
#include "motion/collision_world.h"

namespace marketgen::collect {
namespace {

constexpr double sunk_m = 0.03;     // below the floor, of a middle: it is not on it but in it
constexpr double support_m = 0.02;  // a base rests on what is this near below it
constexpr double probe_m = 0.005;
constexpr int support_bisections = 6;
constexpr double farthest_part_m = 4;  // from a robot's base: its reach and the search
constexpr double search_step_m = 0.1, search_m = 1.5;  // for a free place
constexpr int search_directions = 16;

struct WorldSphere {
  Vec3 center;
  double radius = 0;
  int link = 0;
};

// Those of the foot end at the plane on which it stands.
std::vector<WorldSphere> spheres_in_store(const robots::PlacedRobot& placed) {
  const std::vector<Pose> base_from_link = robots::link_poses(placed.robot, placed.q);
  const double ground = placed.world_from_base.position.z;
  std::vector<WorldSphere> spheres;
  for (std::size_t link = 0; link < base_from_link.size(); ++link) {
    const Pose world_from_link = placed.world_from_base * base_from_link[link];
    for (const robots::Sphere& sphere : placed.robot.links[link].spheres) {
      const Vec3 center = world_from_link * sphere.center;
      double radius = sphere.radius;
      if (link == 0) radius = std::min(radius, center.z - ground);
      if (radius > 0) spheres.push_back({center, radius, static_cast<int>(link)});
    }
  }
  return spheres;
}

// What is built in a store, as obstacles that know their names.
class StoreObstacles {
 public:
  // Only of what stands near to one of the robots.
  static Result<StoreObstacles> make(const scene::Scene& scene,
                                     std::span<const robots::PlacedRobot> robots) {
    StoreObstacles made;
    made.floor_mm_ = plan::floor_of(scene.layout.shell);
    motion::Obstacles obstacles;
    std::vector<std::string> cylinder_names;
    for (const scene::ScenePart& part : scene.parts) {
      const Pose pose =
          scene::world_from_fixture(scene, part.fixture) * scene::fixture_from_part(part);
      const auto [x, y, z] = part.half_size_m;
      const double reach = farthest_part_m + std::hypot(x, y, z);
      const bool near =
          std::any_of(robots.begin(), robots.end(), [&](const robots::PlacedRobot& placed) {
            return length(placed.world_from_base.position - pose.position) < reach;
          });
      if (!near) continue;
      const std::string& name = scene.layout.fixtures[part.fixture].id;
      if (part.shape == assets::PartShape::cylinder) {
        obstacles.cylinders.push_back({pose, x, z});
        cylinder_names.push_back(name);
      } else {
        obstacles.boxes.push_back({pose, {x, y, z}});
        made.names_.push_back(name);
      }
    }
    made.add_columns(scene.layout.shell, obstacles);
    made.names_.insert(made.names_.end(), cylinder_names.begin(), cylinder_names.end());
    MARKETGEN_TRY(made.world_, motion::CollisionWorld::make(obstacles));
    return made;
  }

  bool on_floor(Vec3 p) const { return contains(floor_mm_, floor_mm(p)); }

  // Clear of the walls, too: its four sides.
  bool on_floor(Vec3 center, double radius) const {
    return on_floor(center + Vec3{radius, 0, 0}) && on_floor(center - Vec3{radius, 0, 0}) &&
           on_floor(center + Vec3{0, radius, 0}) && on_floor(center - Vec3{0, radius, 0});
  }

  // The name of something that the sphere overlaps.
  std::optional<std::string> hit(Vec3 center, double radius) const {
    const std::vector<motion::SphereBlock> block =
        motion::packed(std::vector<motion::PlainSphere>{{center, radius}});
    std::vector<std::uint32_t> shapes;
    world_.touched(block.front(), shapes);
    if (shapes.empty()) return {};
    return names_[shapes.front()];
  }

  // The height of what is highest under `p`; 0 is the floor, p.z when `p` touches something.
  double support_below(Vec3 p) const {
    const auto touches = [&](double z) { return hit({p.x, p.y, z}, probe_m).has_value(); };
    if (touches(p.z)) return p.z;
    double low = p.z;
    while (low > 0 && !touches(low))
      low -= probe_m;
    if (low <= 0) return 0;
    double high = low + probe_m;
    for (int k = 0; k < support_bisections; ++k) {
      const double middle = (low + high) / 2;
      (touches(middle) ? low : high) = middle;
    }
    return high - probe_m;
  }

 private:
  void add_columns(const plan::Shell& shell, motion::Obstacles& obstacles) {
    for (const plan::Column& column : shell.columns) {
      const double half = column.size_mm * 0.0005, height = shell.ceiling_mm * 0.0005;
      obstacles.boxes.push_back(
          {{{column.x_mm * 1e-3, column.y_mm * 1e-3, height}, {}}, {half, half, height}});
      names_.emplace_back("a column");
    }
  }

  PolygonMm floor_mm_;
  motion::CollisionWorld world_;
  std::vector<std::string> names_;  // of each shape: boxes, then cylinders
};

// What keeps a robot from standing somewhere, and which of its links.
struct Conflict {
  int link = 0;
  std::string with;  // empty: a wall
};

std::optional<Conflict> conflict_of(const std::vector<WorldSphere>& spheres,
                                    const StoreObstacles& store,
                                    std::span<const std::vector<WorldSphere>> others,
                                    std::span<const robots::PlacedRobot> robots) {
  for (const WorldSphere& sphere : spheres) {
    if (!store.on_floor(sphere.center, sphere.radius) || sphere.center.z < -sunk_m)
      return Conflict{sphere.link, {}};
    if (auto name = store.hit(sphere.center, sphere.radius)) return Conflict{sphere.link, *name};
    for (std::size_t k = 0; k < others.size(); ++k) {
      const bool meets = std::any_of(others[k].begin(), others[k].end(), [&](const auto& other) {
        return length(other.center - sphere.center) < other.radius + sphere.radius;
      });
      if (meets) return Conflict{sphere.link, "the robot " + robots[k].robot.name};
    }
  }
  return {};
}

class StandingCheck {
 public:
  StandingCheck(const StoreObstacles& store, std::span<const robots::PlacedRobot> robots)
      : store_(store), robots_(robots) {}

  Result<void> run() {
    for (const robots::PlacedRobot& placed : robots_) {
      const std::vector<WorldSphere> spheres = spheres_in_store(placed);
      MARKETGEN_CHECK(check(placed, spheres));
      spheres_.push_back(spheres);
    }
    return {};
  }

 private:
  Result<void> check(const robots::PlacedRobot& placed,
                     const std::vector<WorldSphere>& spheres) const {
    const Vec3 base = placed.world_from_base.position;
    if (!store_.on_floor(base) || base.z < 0)
      return Error{"robot.outside_store",
                   placed.where,
                   fmt::format("x {:.2f}, y {:.2f}, z {:.2f} is not in the store; give metres from "
                               "its south-west floor corner",
                               base.x,
                               base.y,
                               base.z)};
    if (const auto conflict = conflict_of(spheres, store_, spheres_, robots_))
      return conflict_error(placed, spheres, *conflict);
    return check_support(placed);
  }

  Error conflict_error(const robots::PlacedRobot& placed,
                       const std::vector<WorldSphere>& spheres,
                       const Conflict& conflict) const {
    const std::string& link = placed.robot.links[static_cast<std::size_t>(conflict.link)].name;
    const std::string hint = place_hint(placed, spheres);
    if (conflict.with.empty())
      return {"robot.outside_store",
              placed.where,
              fmt::format("its {} would be outside the walls or the floor; {}", link, hint)};
    return {"robot.blocked",
            placed.where,
            fmt::format("its {} would be in {}; {}", link, conflict.with, hint)};
  }

  // Looks in rings round the place, on the same height and with the same posture.
  std::string place_hint(const robots::PlacedRobot& placed,
                         const std::vector<WorldSphere>& spheres) const {
    const Vec3 base = placed.world_from_base.position;
    for (int ring = 1; ring * search_step_m <= search_m; ++ring) {
      for (int k = 0; k < search_directions; ++k) {
        const double turn = 2 * std::numbers::pi * k / search_directions;
        const Vec3 by{std::round(100 * ring * search_step_m * std::cos(turn)) / 100,
                      std::round(100 * ring * search_step_m * std::sin(turn)) / 100,
                      0};
        std::vector<WorldSphere> moved = spheres;
        for (WorldSphere& sphere : moved)
          sphere.center = sphere.center + by;
        if (store_.on_floor(base + by) && supported(base + by) &&
            !conflict_of(moved, store_, spheres_, robots_))
          return fmt::format("it is clear at {:.2f},{:.2f}", base.x + by.x, base.y + by.y);
      }
    }
    return fmt::format("move it: no place within {:.1f} m is clear", search_m);
  }

  bool supported(Vec3 base) const { return base.z - store_.support_below(base) <= support_m; }

  Result<void> check_support(const robots::PlacedRobot& placed) const {
    const Vec3 base = placed.world_from_base.position;
    if (supported(base)) return {};
    return Error{"robot.no_support",
                 placed.where,
                 fmt::format("its base would hang in the air at z {:.2f}; what is under it is "
                             "{:.3f} m high: write z={:.3f}, or take a robot on a stand",
                             base.z,
                             store_.support_below(base),
                             store_.support_below(base))};
  }

  const StoreObstacles& store_;
  std::span<const robots::PlacedRobot> robots_;
  std::vector<std::vector<WorldSphere>> spheres_;  // of the robots checked so far
};

}  // namespace

Result<void> check_standing(const scene::Scene& scene,
                            std::span<const robots::PlacedRobot> robots) {
  if (robots.empty()) return {};
  MARKETGEN_TRY(const StoreObstacles store, StoreObstacles::make(scene, robots));
  return StandingCheck(store, robots).run();
}

Result<std::vector<robots::PlacedRobot>> standing_robots(const scene::Scene& scene,
                                                         std::span<const std::string> texts,
                                                         const std::string& where) {
  std::vector<robots::PlacedRobot> placed;
  for (const std::string& text : texts) {
    MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
    MARKETGEN_TRY(const robots::RobotSpec spec, robots::parse_robot_spec(text, where + text));
    MARKETGEN_TRY(robots::PlacedRobot robot, robots::place_robot(data, spec, where + text));
    placed.push_back(std::move(robot));
  }
  MARKETGEN_CHECK(check_standing(scene, placed));
  return placed;
}

}  // namespace marketgen::collect
