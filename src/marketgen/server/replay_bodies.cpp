#include "server/replay_bodies.h"

#include "render/stage/robot_actor.h"
#include "server/picture_pages.h"

namespace marketgen::server {
namespace {

// Which link's frame a link is fixed in, and where.
struct Fixed {
  std::size_t link = 0;
  Pose from_link;
};

std::vector<Fixed> fixed_links(const robots::Robot& robot) {
  std::vector<Fixed> fixed(robot.links.size());
  for (std::size_t link = 1; link < robot.links.size(); ++link) {
    const robots::Joint& joint = robot.joints[link - 1];
    const Fixed& parent = fixed[static_cast<std::size_t>(joint.parent)];
    fixed[link] = joint.kind == robots::JointType::fixed
                      ? Fixed{parent.link, parent.from_link * joint.parent_from_joint}
                      : Fixed{link, {}};
  }
  return fixed;
}

}  // namespace

void ReplayBodies::add(const render::ActorBody& body, const Pose& body_from_mesh) {
  for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t) {
    const render::ActorSurface& surface = body.surfaces[body.mesh.surfaces[t]];
    for (const std::uint32_t corner : body.mesh.triangles[t]) {
      ViewVertex vertex;
      vertex.position = to_float(body_from_mesh * to_double(body.mesh.positions[corner]));
      vertex.normal =
          to_float(rotate(body_from_mesh.rotation, to_double(body.mesh.normals[corner])));
      vertex.color = {
          srgb_byte(surface.color.x), srgb_byte(surface.color.y), srgb_byte(surface.color.z), 0};
      mesh_.indices.push_back(mesh_.add(vertex));
    }
  }
}

Result<ReplayBodies> ReplayBodies::of(const episodes::RecordedPlace& place) {
  ReplayBodies bodies;
  const robots::Robot& robot = place.robot;
  MARKETGEN_TRY(const render::Actor actor,
                render::robot_actor(robot, robots::neutral_state(robot), {}));
  const std::vector<Fixed> fixed = fixed_links(robot);
  const auto close = [&](std::size_t first, const std::string& name) {
    bodies.ranges_.push_back(static_cast<std::uint32_t>(first));
    bodies.ranges_.push_back(static_cast<std::uint32_t>(bodies.mesh_.indices.size() - first));
    bodies.names_.push_back(name);
  };
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    if (fixed[link].link != link) continue;
    const std::size_t first = bodies.mesh_.indices.size();
    bodies.mesh_.begin_part();
    for (std::size_t other = link; other < robot.links.size(); ++other)
      if (fixed[other].link == link) bodies.add(actor.bodies[other], fixed[other].from_link);
    if (bodies.mesh_.indices.size() == first) continue;
    bodies.links_.push_back(link);
    close(first, robot.links[link].name);
  }
  if (!place.basket) return bodies;
  const std::size_t first = bodies.mesh_.indices.size();
  bodies.mesh_.begin_part();
  bodies.add(place.basket->bodies.front(), {});
  close(first, place.basket->name);
  return bodies;
}

ViewFile ReplayBodies::file() const {
  PackedSections sections;
  mesh_.pack(sections);
  sections.add("range", 2, std::span<const std::uint32_t>(ranges_));
  return {"robot.bin", "application/octet-stream", sections.file()};
}

std::vector<Pose> ReplayBodies::poses(const robots::Robot& robot,
                                      std::span<const double> state,
                                      const Pose& store_from_robot) const {
  const std::vector<Pose> links = render::world_link_poses(robot, state, store_from_robot);
  std::vector<Pose> poses;
  poses.reserve(links_.size());
  for (const std::size_t link : links_)
    poses.push_back(links[link]);
  return poses;
}

}  // namespace marketgen::server
