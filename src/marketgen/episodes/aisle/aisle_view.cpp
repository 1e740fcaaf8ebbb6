#include "episodes/aisle/aisle_view.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/parallel.h"
#include "episodes/field_of_view.h"
#include "render/picture_objects.h"
#include "render/stage/person_actor.h"
#include "render/stage/robot_actor.h"

namespace marketgen::episodes {
namespace {

Vec3 vec3_of_row(const robots::Triple& row) {
  return {row[0], row[1], row[2]};
}

struct FilmPlace {
  Vec3 from;        // base frame
  double nearness;  // its distance to what it looks at, of the row's
};

// The row's own first, then the other sides of the robot, then nearer.
std::vector<FilmPlace> film_places(const StationCameraRow& row) {
  const Vec3 at = vec3_of_row(row.at_m), off = vec3_of_row(row.from_m) - at;
  std::vector<FilmPlace> places;
  for (const double nearness : {1.0, 0.7})
    for (const double ahead : {1.0, -1.0})
      for (const double aside : {1.0, -1.0})
        places.push_back({at + Vec3{ahead * off.x, aside * off.y, off.z} * nearness, nearness});
  return places;
}

constexpr double posed_within_m = 6;  // of the robot

constexpr double seen_from = 1e-3;  // rad or m: what rests within that is seen at rest

std::vector<render::MovedJoint> moved_joints(const AisleWorld& world) {
  const std::vector<double> positions = world.joint_positions();
  std::vector<render::MovedJoint> moved;
  for (std::uint32_t joint = 0; joint < positions.size(); ++joint)
    if (world.store().scene.joints[joint].kind != assets::JointKind::belt &&
        std::abs(positions[joint]) > seen_from)
      moved.push_back({joint, positions[joint]});
  return moved;
}

constexpr int probe_width_px = 32, probe_height_px = 24;
constexpr double enough_of_best = 0.6;

}  // namespace

Result<std::unique_ptr<AisleView>> AisleView::create(const AisleStation& station,
                                                     const robots::Robot& robot,
                                                     const scene::Scene& scene,
                                                     const render::RendererOptions& options) {
  std::unique_ptr<AisleView> view(new AisleView);
  view->station_ = station;
  MARKETGEN_TRY(view->renderer_, render::Renderer::create(scene, silent_progress(), options));
  MARKETGEN_TRY(view->robot_, render::robot_actor(robot, robots::neutral_state(robot), {}));
  MARKETGEN_CHECK(view->renderer_->set_actors({view->robot_}));
  view->robot_object_ = render::first_actor_object(scene);
  return view;
}

Result<std::unique_ptr<AisleView>> AisleView::create(const AisleWorld& world) {
  const AisleStore& store = world.store();
  MARKETGEN_TRY(std::unique_ptr<AisleView> view, create(store.station, world.robot(), store.scene));
  MARKETGEN_CHECK(view->follow(world));
  return view;
}

Result<std::unique_ptr<TrackView>> AisleWorld::open_view() const {
  return open_view_of<AisleView>(*this);
}

Result<void> AisleView::follow(const AisleWorld& world, const Scenery& then) {
  if (!then.people.empty())
    MARKETGEN_CHECK(follow_people(world.people(), then.people, base_of(world.robot(), then.robot)));
  return follow(world.robot(), then, moved_joints(world));
}

// Meshes anew of those that are near and have moved; the others are where they are by now.
Result<void> AisleView::follow_people(const PeopleAround& people,
                                      const std::vector<PersonMoment>& moments,
                                      const Pose& world_from_base) {
  const bool first = people_.size() != moments.size();
  people_.resize(moments.size());
  std::vector<assets::PlacedPerson> placed;
  std::vector<std::size_t> anew;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Vec3 at = placed.emplace_back(people.at(i, moments[i])).world_from_person.position;
    const bool near = length(at - world_from_base.position) < posed_within_m;
    if (first || (near && people_[i].moment != moments[i])) anew.push_back(i);
  }
  const std::vector<SeenPerson> made = parallel_map(anew.size(), [&](std::size_t k) {
    return SeenPerson{moments[anew[k]],
                      render::person_actor(placed[anew[k]], assets::PersonDetail::coarse)};
  });
  for (std::size_t k = 0; k < anew.size(); ++k)
    people_[anew[k]] = made[k];
  if (!anew.empty()) {
    std::vector<render::Actor> actors{robot_};
    for (const SeenPerson& person : people_)
      actors.push_back(person.actor);
    MARKETGEN_CHECK(renderer_->set_actors(actors));
  }
  for (std::size_t i = 0; i < placed.size(); ++i)
    MARKETGEN_CHECK(renderer_->move_actor(1 + i, std::span(&placed[i].world_from_person, 1)));
  return {};
}

Result<void> AisleView::follow(const robots::Robot& robot,
                               const Scenery& then,
                               std::span<const render::MovedJoint> joints) {
  std::vector<render::MovedProduct> moved;
  for (const auto& [row, pose] : then.products)
    moved.push_back({row, pose});
  MARKETGEN_CHECK(renderer_->move_things(moved, joints));
  MARKETGEN_CHECK(renderer_->move_actor(0, render::world_link_poses(robot, then.robot, {})));
  world_from_base_ = base_of(robot, then.robot);
  for (std::size_t i = 0; i < aisle_cameras.size(); ++i) {
    const CameraMount mount = mount_of_camera(station_, aisle_cameras[i]);
    world_from_camera_[i] = robots::frame_pose(robot, then.robot, robot.find_frame(mount.frame)) *
                            mount.frame_from_camera;
  }
  return {};
}

// At the first place that sees nearly as much of the robot as the best.
Result<void> AisleView::place_film_camera(render::Camera& camera) const {
  const std::vector<FilmPlace> places = film_places(station_.film_camera);
  render::Camera probe;
  probe.name = film_camera_name;
  probe.width = probe_width_px, probe.height = probe_height_px;
  probe.fov_deg = fov_down_deg(station_.film_camera.fov_deg, probe.width, probe.height);
  probe.at = world_from_base_ * vec3_of_row(station_.film_camera.at_m);
  render::RenderOptions quick;
  quick.quality = render::Quality::fast;
  std::vector<double> seen;  // pixels of the robot, as from the row's distance
  for (const FilmPlace& place : places) {
    probe.from = world_from_base_ * place.from;
    MARKETGEN_TRY(const render::Frame frame, renderer_->render(probe, quick));
    seen.push_back(static_cast<double>(std::ranges::count(frame.instance, robot_object_)) *
                   place.nearness * place.nearness);
  }
  const double best = std::ranges::max(seen);
  const auto chosen =
      std::ranges::find_if(seen, [&](double pixels) { return pixels >= enough_of_best * best; });
  camera.from = world_from_base_ * places[static_cast<std::size_t>(chosen - seen.begin())].from;
  camera.at = probe.at;
  return {};
}

Result<render::Camera> AisleView::camera(std::string_view name, int width, int height) const {
  render::Camera camera;
  camera.name = name;
  const auto size = [&](const auto& row) {
    camera.width = width > 0 ? width : row.width;
    camera.height = height > 0 ? height : row.height;
    camera.fov_deg = fov_down_deg(row.fov_deg, camera.width, camera.height);
  };
  const auto own = std::ranges::find(aisle_cameras, name);
  if (own != aisle_cameras.end()) {
    size(station_.head_camera);
    camera.world_from_camera =
        world_from_camera_[static_cast<std::size_t>(own - aisle_cameras.begin())];
    return camera;
  }
  if (name == film_camera_name) {
    size(station_.film_camera);
    MARKETGEN_CHECK(place_film_camera(camera));
    return camera;
  }
  return Error{
      "camera.unknown",
      std::string(name),
      fmt::format("there are {} and {}", fmt::join(aisle_cameras, ", "), film_camera_name)};
}

}  // namespace marketgen::episodes
