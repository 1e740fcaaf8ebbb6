#include "environments/observation_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "base/hash.h"
#include "episodes/track_world.h"

namespace marketgen::environments {
namespace {

constexpr int pose_numbers = 7;
constexpr double limit_margin = 0.02;     // rad or m: how far a servo gives at its stop
constexpr double velocity_margin = 2;     // a push may turn a joint faster than its drive
constexpr double reach_m = 3;             // farther than any arm of ours, on its lift
constexpr double fastest_thing_m_s = 10;  // what falls from a shelf meets the floor at 6
constexpr double largest_thing_m = 3;
constexpr double max_external_force_n = 1000;        // ten times what stops a robot
constexpr std::uint64_t instruction_ids = 1U << 24;  // a float32 holds each of them exactly

class PartBuilder {
 public:
  explicit PartBuilder(std::string group) : group_(std::move(group)) {}

  // Bounds of one of the innermost rows, repeated.
  void add(std::string name,
           std::vector<int> shape,
           const std::vector<double>& low,
           const std::vector<double>& high,
           std::vector<std::string> names = {}) {
    ObservationPart part{group_, std::move(name), std::move(shape), {}, {}, std::move(names)};
    for (std::size_t i = 0; i < count_of(part); ++i) {
      part.low.push_back(low[i % low.size()]);
      part.high.push_back(high[i % high.size()]);
    }
    parts_.push_back(std::move(part));
  }
  void add_poses(std::string name,
                 std::vector<int> shape,
                 double far_m,
                 std::vector<std::string> names = {}) {
    add(std::move(name),
        std::move(shape),
        {-far_m, -far_m, -far_m, -1, -1, -1, -1},
        {far_m, far_m, far_m, 1, 1, 1, 1},
        std::move(names));
  }
  void add_flags(std::string name, int count, std::vector<std::string> names = {}) {
    add(std::move(name), {count}, {0}, {1}, std::move(names));
  }
  std::vector<ObservationPart> take() { return std::move(parts_); }

 private:
  std::string group_;
  std::vector<ObservationPart> parts_;
};

bool has_cup(const robots::Robot& robot) {
  return std::ranges::find(robot.tools, robots::ToolKind::suction, &robots::Tool::kind) !=
         robot.tools.end();
}

// A row a tool; of a robot with one tool no rows.
std::vector<int> for_each_tool(const robots::Robot& robot, std::vector<int> shape) {
  if (robot.tools.size() > 1) shape.insert(shape.begin(), static_cast<int>(robot.tools.size()));
  return shape;
}

// "left_tool_opening", or of a pose "left_tool_x", "left_tool_y", ...: tool by tool.
std::vector<std::string> tool_names(const robots::Robot& robot,
                                    const std::vector<std::string>& numbers) {
  std::vector<std::string> names;
  for (const robots::Tool& tool : robot.tools)
    for (const std::string& number : numbers)
      names.push_back(tool_prefix(tool) + number);
  return names;
}

std::vector<std::string> force_names(const robots::Robot& robot) {
  std::vector<std::string> names;
  for (const robots::ContactLimit& limit : robot.contact_limits)
    names.push_back(robot.links[static_cast<std::size_t>(limit.link)].name);
  return names;
}

double half_turn_within(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

void add_pose(const Pose& p, std::vector<double>& into) {
  into.insert(into.end(),
              {p.position.x,
               p.position.y,
               p.position.z,
               p.rotation.w,
               p.rotation.x,
               p.rotation.y,
               p.rotation.z});
}

void add_vector(Vec3 v, std::vector<double>& into) {
  into.insert(into.end(), {v.x, v.y, v.z});
}

}  // namespace

std::string tool_prefix(const robots::Tool& tool) {
  return tool.prefix.empty() ? "tool_" : tool.prefix;
}

std::size_t count_of(const ObservationPart& part) {
  std::size_t count = 1;
  for (const int length : part.shape)
    count *= static_cast<std::size_t>(length);
  return count;
}

std::vector<ObservationPart> robot_parts(const robots::Robot& robot,
                                         const ObservationBounds& bounds) {
  std::vector<double> low, high, speed;
  std::vector<std::string> names;
  for (const int dof : episodes::commanded_dofs(robot)) {
    const robots::Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
    low.push_back(joint.lower - limit_margin);
    high.push_back(joint.upper + limit_margin);
    speed.push_back(velocity_margin * joint.velocity);
    names.push_back(joint.name);
  }
  const auto joints = static_cast<int>(speed.size()), tools = static_cast<int>(robot.tools.size());
  std::vector<double> back(speed.size());
  std::ranges::transform(speed, back.begin(), std::negate<>());
  for (const robots::Tool& tool : robot.tools) {
    low.push_back(0);
    high.push_back(tool.kind == robots::ToolKind::suction ? agent::cup_off_m
                                                          : tool.opening + limit_margin);
  }
  std::vector<std::string> positions = names;
  std::ranges::move(tool_names(robot, {"opening"}), std::back_inserter(positions));
  PartBuilder agent("agent"), extra("extra"), signals("agent");
  agent.add("qpos", {joints + tools}, low, high, positions);
  agent.add("qvel", {joints}, back, speed, names);
  extra.add_poses("tcp_pose",
                  for_each_tool(robot, {pose_numbers}),
                  reach_m,
                  tool_names(robot, {"x", "y", "z", "qw", "qx", "qy", "qz"}));
  const double far = bounds.ground_m, half = std::numbers::pi;
  extra.add("base_pose", {3}, {-far, -far, -half}, {far, far, half}, {"x", "y", "heading"});
  if (has_cup(robot)) signals.add_flags("sealed", tools, tool_names(robot, {"sealed"}));
  signals.add("external_force",
              {static_cast<int>(robot.contact_limits.size())},
              {0},
              {max_external_force_n},
              force_names(robot));
  signals.add_flags("stopped", 1, {"stopped"});
  std::vector<ObservationPart> parts = agent.take();
  for (PartBuilder* more : {&extra, &signals})
    std::ranges::move(more->take(), std::back_inserter(parts));
  return parts;
}

std::vector<ObservationPart> privileged_parts(const robots::Robot& robot,
                                              int items,
                                              const ObservationBounds& bounds) {
  PartBuilder parts("privileged");
  const double far = bounds.things_m, size = largest_thing_m, fast = fastest_thing_m_s;
  const double way = far + reach_m;
  parts.add_poses("item_pose", {items, pose_numbers}, far);
  parts.add("item_size", {items, 3}, {0}, {size});
  parts.add("item_velocity", {items, 3}, {-fast}, {fast});
  for (const char* flag : {"item_present", "item_goal", "item_held", "item_in_place"})
    parts.add_flags(flag, items);
  parts.add("tcp_to_item", for_each_tool(robot, {items, 3}), {-way}, {way});
  parts.add("goal_position", {3}, {-far}, {far});
  parts.add("goal_size", {3}, {0}, {size});
  parts.add_poses("basket_pose", {pose_numbers}, far);
  parts.add("instruction_id", {1}, {0}, {static_cast<double>(instruction_ids - 1)});
  return parts.take();
}

void add_robot_numbers(const robots::Robot& robot,
                       const RobotSeen& seen,
                       std::vector<double>& into) {
  const auto add_all = [&](const auto& values) {
    into.insert(into.end(), values.begin(), values.end());
  };
  add_all(seen.now.position);
  add_all(seen.now.openings_m);
  add_all(seen.now.velocity);
  for (const Pose& tool : seen.tools)
    add_pose(tool, into);
  into.insert(into.end(),
              {seen.now.base.x_m, seen.now.base.y_m, half_turn_within(seen.now.base.heading)});
  if (has_cup(robot)) add_all(seen.now.sealed);
  for (const double force : seen.now.external_force_n)
    into.push_back(std::min(force, max_external_force_n));
  into.push_back(seen.now.stopped ? 1 : 0);
}

void add_privileged_numbers(const std::vector<EnvironmentItem>& items,
                            int rows,
                            const EnvironmentPlace& place,
                            const std::vector<Pose>& tools,
                            const std::string& instruction,
                            std::vector<double>& into) {
  const auto room = static_cast<std::size_t>(rows);
  const std::size_t known = std::min(items.size(), room);
  const auto rows_of = [&](std::size_t width, const auto& add) {
    for (std::size_t i = 0; i < known; ++i)
      add(items[i]);
    into.resize(into.size() + (room - known) * width);
  };
  rows_of(pose_numbers, [&](const EnvironmentItem& item) { add_pose(item.pose, into); });
  rows_of(3, [&](const EnvironmentItem& item) { add_vector(item.size_m, into); });
  rows_of(3, [&](const EnvironmentItem& item) { add_vector(item.velocity_m_s, into); });
  rows_of(1, [&](const EnvironmentItem&) { into.push_back(1); });
  for (const auto flag :
       {&EnvironmentItem::wanted, &EnvironmentItem::held, &EnvironmentItem::in_place})
    rows_of(1, [&](const EnvironmentItem& item) { into.push_back(item.*flag ? 1 : 0); });
  for (const Pose& tool : tools)
    rows_of(3, [&](const EnvironmentItem& item) { add_vector(item.middle - tool.position, into); });
  add_vector(place.middle, into);
  add_vector(place.size_m, into);
  add_pose(place.basket, into);
  into.push_back(static_cast<double>(hash64(instruction) % instruction_ids));
}

}  // namespace marketgen::environments
