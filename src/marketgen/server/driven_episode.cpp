#include "server/driven_episode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/build_info.h"
#include "environments/environment_batch.h"
#include "episodes/track_entry.h"
#include "io/json.h"
#include "server/pose_packer.h"

namespace marketgen::server {
namespace {

constexpr std::size_t told_events = 6;
constexpr std::uint32_t count_every = 5;  // steps: goals take a look at where everything is

// The header of a log: the rows that its episode needs, of its store.
episodes::EpisodeFile file_of_one(const episodes::EpisodeHeader& header,
                                  const std::vector<catalog::Product>& products,
                                  const episodes::EpisodeSpec& spec) {
  episodes::EpisodeFile file{header, {spec}};
  const std::set<std::string> skus = episodes::skus_of(spec);
  file.header.episodes = 1;
  std::erase_if(file.header.stores, [&](const episodes::EpisodeStore& row) {
    return row.scene_hash != spec.scene_hash;
  });
  file.header.products = products;
  std::erase_if(file.header.products,
                [&](const catalog::Product& row) { return !skus.contains(row.sku); });
  return file;
}

}  // namespace

Result<std::unique_ptr<DrivenEpisode>> DrivenEpisode::open(
    std::shared_ptr<environments::EpisodeGround> ground,
    const episodes::EpisodeSpec& spec,
    std::shared_ptr<const store::Store> store,
    const catalog::Catalog& catalog) {
  std::unique_ptr<DrivenEpisode> opened(new DrivenEpisode);
  environments::EnvironmentOptions options;
  options.control = environments::ControlMode::pd_ee_delta_pose;
  options.tools = spec.tools;
  options.station = spec.station.value_or("");
  opened->ground_ = std::move(ground);
  opened->spec_ = spec;
  opened->store_ = std::move(store);
  opened->things_ = ReplayThings(opened->store_, catalog);
  MARKETGEN_TRY(opened->environment_,
                environments::Environment::create(opened->ground_, spec.track, options));
  opened->seen_.resize(opened->environment_->observation_size());
  MARKETGEN_CHECK(opened->restart());
  const std::shared_ptr<const scene::Scene> scene(opened->store_, &opened->store_->scene);
  MARKETGEN_TRY(
      opened->place_,
      episodes::entry_of(spec.track)
          .place_of(opened->ground_->data(), opened->now_, scene, opened->ground_->catalog()));
  MARKETGEN_TRY(opened->bodies_, ReplayBodies::of(opened->place_));
  return opened;
}

Result<void> DrivenEpisode::restart() {
  environments::Environment* const one = environment_.get();
  MARKETGEN_CHECK(environments::reset_all({&one, 1}, {&spec_, 1}, seen_));
  hands_.emplace(*environment_);
  actions_.clear();
  events_.begin(environment_->world());
  put_back();
  rest_joints_ = environment_->world().joint_positions();
  moved_joints_.clear();
  reached_.assign(spec_.goals.size(), 0);
  MARKETGEN_CHECK(count_goals());
  return look();
}

// Products that were pushed before stand where they stood; all else, and what they are, the world
// says.
void DrivenEpisode::put_back() {
  for (const auto& [thing, row] : rows_)
    if (thing.first == episodes::ThingKind::product)
      thing_poses_[row] = scene::world_from_product(place_.scene->products[thing.second]);
}

Result<void> DrivenEpisode::step(const environments::TeleopCommand& command, bool done) {
  const std::vector<double> numbers = hands_->numbers(command, done);
  environments::Environment* const one = environment_.get();
  std::array<double, 1> reward{};
  std::array<bool, 1> terminated{}, truncated{};
  MARKETGEN_CHECK(
      environments::step_all({&one, 1}, numbers, {seen_, reward, terminated, truncated}));
  actions_.insert(actions_.end(), numbers.begin(), numbers.end());
  events_.look(steps());
  if (steps() % count_every == 0 || !running()) MARKETGEN_CHECK(count_goals());
  return look();
}

bool DrivenEpisode::is_goal(const std::string& sku) const {
  return std::ranges::find(spec_.goals, sku, &episodes::EpisodeGoal::sku) != spec_.goals.end();
}

// A recording that has just begun is how things are.
Result<void> DrivenEpisode::look() {
  const episodes::TrackWorld& world = environment_->world();
  evaluation::MotionRecorder recorder;
  MARKETGEN_CHECK(recorder.begin(world));
  now_ = recorder.motion();
  see_joints();
  for (const episodes::MovedThing& thing : world.things()) {
    const auto [row, is_new] = rows_.try_emplace({thing.kind, thing.number}, thing_poses_.size());
    if (is_new) {
      MARKETGEN_CHECK(
          things_.add({thing.kind, thing.number, thing.sku, {}, {}}, is_goal(thing.sku), spec_.id));
      thing_poses_.emplace_back();
    }
    thing_poses_[row->second] = thing.store_from_thing;
  }
  return {};
}

void DrivenEpisode::see_joints() {
  const std::vector<double> now = environment_->world().joint_positions();
  for (std::uint32_t joint = 0; joint < now.size(); ++joint) {
    if (std::abs(now[joint] - rest_joints_[joint]) > episodes::joint_moved)
      moved_joints_.insert(joint);
    if (moved_joints_.contains(joint))
      now_.joints.push_back({joint, {0}, {static_cast<float>(now[joint])}});
  }
}

Result<void> DrivenEpisode::count_goals() {
  MARKETGEN_TRY(const std::vector<environments::EnvironmentItem> items, environment_->items());
  for (std::size_t goal = 0; goal < spec_.goals.size(); ++goal) {
    const auto in_place = std::ranges::count_if(items, [&](const auto& item) {
      return item.in_place && item.sku == spec_.goals[goal].sku;
    });
    reached_[goal] = std::min(static_cast<int>(in_place), spec_.goals[goal].count);
  }
  return {};
}

DriveEpisode DrivenEpisode::told() const {
  const robots::Robot& robot = environment_->world().robot();
  DriveEpisode told;
  told.id = spec_.id;
  told.instruction = spec_.instruction;
  told.robot = spec_.robot;
  told.tools = spec_.tools;
  told.track = name_of(spec_.track);
  told.step_s = episodes::control_step_s;
  told.limit_s = spec_.limit_s;
  told.has_base = robot.drive.has_value();
  for (const robots::Tool& tool : robot.tools)
    told.arms.push_back(tool.prefix);
  told.bodies = bodies_.names();
  told.cameras = episodes::entry_of(spec_.track).recorded_cameras();
  for (const environments::ActionNumber& joint : environments::teleop_joints(*environment_))
    told.joints.push_back({joint.name, std::string(joint.dimension)});
  for (const episodes::EpisodeGoal& goal : spec_.goals) {
    const auto [name, name_zh] = things_.names_of_sku(goal.sku);
    told.goals.push_back({goal.sku, name, name_zh, goal.count});
  }
  told.things = things_.rows();
  return told;
}

std::string DrivenEpisode::message(DriveMoment head) const {
  const episodes::TrackWorld& world = environment_->world();
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
  head.stopped = running() && environment_->robot_stopped();
  head.openings.assign(hands_->openings().begin(), hands_->openings().end());
  head.reached = reached_;
  head.side_effects = world.watch().effects();
  head.events = events_.events();
  if (head.events.size() > told_events)
    head.events.erase(head.events.begin(),
                      head.events.end() - static_cast<std::ptrdiff_t>(told_events));
  if (const auto result = environment_->result())
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

Result<episodes::DriveFile> DrivenEpisode::log() const {
  if (actions_.empty())
    return Error{"episode.impossible", spec_.id, "nothing was driven yet: there is no log to keep"};
  episodes::DriveFile file;
  file.log.program = program_version;
  file.log.control_mode = name_of(environment_->options().control);
  file.log.realism = environment_->world().realism().name;
  for (const environments::ActionNumber& number : environment_->action_numbers())
    file.log.action_names.push_back(number.name);
  file.log.actions = actions_;
  file.log.over = !running();
  file.log.success = environment_->result() && environment_->result()->success_strict;
  file.log.state_hash = environment_->world().state_hash();
  file.episode = file_of_one(ground_->arena().header(), ground_->products(), spec_);
  return file;
}

}  // namespace marketgen::server
