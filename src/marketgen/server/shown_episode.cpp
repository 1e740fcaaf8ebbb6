#include "server/shown_episode.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "episodes/track_entry.h"
#include "io/json.h"
#include "server/pose_packer.h"

namespace marketgen::server {
namespace {

constexpr std::size_t told_events = 6;
constexpr std::uint32_t count_every = 5;  // steps: goals take a look at where everything is

}  // namespace

Result<std::unique_ptr<ShownEpisode>> ShownEpisode::of(environments::Environment& environment,
                                                       environments::EpisodeGround& ground,
                                                       std::shared_ptr<const store::Store> store,
                                                       const catalog::Catalog& catalog) {
  std::unique_ptr<ShownEpisode> shown(new ShownEpisode(environment));
  const std::shared_ptr<const scene::Scene> scene(store, &store->scene);
  shown->things_ = ReplayThings(std::move(store), catalog);
  MARKETGEN_CHECK(shown->begin());
  MARKETGEN_TRY(shown->place_,
                episodes::entry_of(shown->spec().track)
                    .place_of(ground.data(), shown->now_, scene, ground.catalog()));
  MARKETGEN_TRY(shown->bodies_, ReplayBodies::of(shown->place_));
  return shown;
}

Result<void> ShownEpisode::begin() {
  events_.begin(environment_.world());
  put_back();
  rest_joints_ = environment_.world().joint_positions();
  moved_joints_.clear();
  reached_.assign(spec().goals.size(), 0);
  MARKETGEN_CHECK(count_goals());
  return see();
}

Result<void> ShownEpisode::look() {
  events_.look(steps());
  if (steps() % count_every == 0 || !running()) MARKETGEN_CHECK(count_goals());
  return see();
}

// Products that were pushed before stand where they stood; all else, and what they are, the world
// says.
void ShownEpisode::put_back() {
  for (const auto& [thing, row] : rows_)
    if (thing.first == episodes::ThingKind::product)
      thing_poses_[row] = scene::world_from_product(place_.scene->products[thing.second]);
}

bool ShownEpisode::is_goal(const std::string& sku) const {
  return std::ranges::find(spec().goals, sku, &episodes::EpisodeGoal::sku) != spec().goals.end();
}

// A recording that has just begun is how things are.
Result<void> ShownEpisode::see() {
  const episodes::TrackWorld& world = environment_.world();
  evaluation::MotionRecorder recorder;
  MARKETGEN_CHECK(recorder.begin(world));
  now_ = recorder.motion();
  see_joints();
  for (const episodes::MovedThing& thing : world.things()) {
    const auto [row, is_new] = rows_.try_emplace({thing.kind, thing.number}, thing_poses_.size());
    if (is_new) {
      MARKETGEN_CHECK(things_.add(
          {thing.kind, thing.number, thing.sku, {}, {}}, is_goal(thing.sku), spec().id));
      thing_poses_.emplace_back();
    }
    thing_poses_[row->second] = thing.store_from_thing;
  }
  return {};
}

void ShownEpisode::see_joints() {
  const std::vector<double> now = environment_.world().joint_positions();
  for (std::uint32_t joint = 0; joint < now.size(); ++joint) {
    if (std::abs(now[joint] - rest_joints_[joint]) > episodes::joint_moved)
      moved_joints_.insert(joint);
    if (moved_joints_.contains(joint))
      now_.joints.push_back({joint, {0}, {static_cast<float>(now[joint])}});
  }
}

Result<void> ShownEpisode::count_goals() {
  MARKETGEN_TRY(const std::vector<environments::EnvironmentItem> items, environment_.items());
  for (std::size_t goal = 0; goal < spec().goals.size(); ++goal) {
    const auto in_place = std::ranges::count_if(items, [&](const auto& item) {
      return item.in_place && item.sku == spec().goals[goal].sku;
    });
    reached_[goal] = std::min(static_cast<int>(in_place), spec().goals[goal].count);
  }
  return {};
}

DriveEpisode ShownEpisode::told() const {
  const robots::Robot& robot = environment_.world().robot();
  DriveEpisode told;
  told.id = spec().id;
  told.instruction = spec().instruction;
  told.robot = spec().robot;
  told.tools = spec().tools;
  told.track = name_of(spec().track);
  told.step_s = episodes::control_step_s;
  told.limit_s = spec().limit_s;
  told.has_base = robot.drive.has_value();
  for (const robots::Tool& tool : robot.tools)
    told.arms.push_back(tool.prefix);
  told.bodies = bodies_.names();
  told.cameras = episodes::entry_of(spec().track).recorded_cameras();
  for (const episodes::EpisodeGoal& goal : spec().goals) {
    const auto [name, name_zh] = things_.names_of_sku(goal.sku);
    told.goals.push_back({goal.sku, name, name_zh, goal.count});
  }
  told.things = things_.rows();
  return told;
}

std::string ShownEpisode::message(DriveMoment head) const {
  const episodes::TrackWorld& world = environment_.world();
  PosePacker packer;
  for (const Pose& pose :
       bodies_.poses(place_.robot, world.robot_state(), world.store_from_robot()))
    packer.add(pose);
  for (const Pose& pose : thing_poses_)
    packer.add(pose);
  std::vector<std::uint32_t> joints;
  std::vector<float> positions;
  for (const episodes::JointMotion& joint : now_.joints) {
    joints.push_back(joint.joint);
    positions.push_back(joint.positions.front());
  }
  head.step = steps();
  head.time_s = world.time_s();
  head.bodies = bodies_.robot_bodies();
  head.things = thing_poses_.size();
  head.stopped = running() && environment_.robot_stopped();
  head.reached = reached_;
  head.side_effects = world.watch().effects();
  head.events = events_.events();
  if (head.events.size() > told_events)
    head.events.erase(head.events.begin(),
                      head.events.end() - static_cast<std::ptrdiff_t>(told_events));
  if (const auto result = environment_.result())
    head.verdict = DriveVerdict{
        result->success_strict, result->hits, result->asked, std::string(name_of(result->failure))};
  PackedSections sections;
  packer.pack(sections);
  sections.add("joint", 1, std::span<const std::uint32_t>(joints));
  sections.add("joint_position", 1, std::span<const float>(positions));
  const auto notes = nlohmann::ordered_json::parse(io::write_json_line(head));
  for (const auto& [name, value] : notes.items())
    sections.note(name, value);
  return sections.file();
}

}  // namespace marketgen::server
