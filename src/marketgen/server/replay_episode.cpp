#include "server/replay_episode.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "episodes/track_entry.h"
#include "evaluation/motion_recorder.h"
#include "io/file.h"
#include "server/pose_packer.h"

namespace marketgen::server {
namespace {

namespace fs = std::filesystem;
using episodes::Motion;

constexpr const char* binary_type = "application/octet-stream";
constexpr std::string_view record_again =
    "run `marketgen eval --record-motion` again (policies in Python, and episodes that --resume "
    "has "
    "taken over, have no motion)";

// An id is part of the file's path: it may not lead out of the folder, nor a link.
Result<fs::path> recorded_file(const fs::path& folder, const std::string& id) {
  const fs::path file = evaluation::motion_file(folder, id);
  std::error_code failed;
  const fs::path home = fs::canonical(folder, failed);
  if (!fs::exists(file, failed))
    return Error{"results.no_motion",
                 file.string(),
                 fmt::format("there is no recorded motion of this episode: {}", record_again)};
  const fs::path real = fs::canonical(file, failed), way = real.lexically_relative(home);
  if (!failed && !way.empty() && *way.begin() != ".." && fs::is_regular_file(real, failed))
    return real;
  return Error{"results.changed", file.string(), "is no file of the folder of results"};
}

Result<void> check_is_of(const Motion& motion,
                         const episodes::EpisodeResult& result,
                         const fs::path& file) {
  if (motion.track.empty())
    return Error{
        "results.no_motion",
        file.string(),
        fmt::format("was recorded by a version that did not keep where: {}", record_again)};
  if (motion.episode == result.episode && motion.episode_hash == result.episode_hash &&
      motion.scene_hash == result.scene_hash && motion.policy == result.policy &&
      motion.realism == result.realism)
    return {};
  return Error{
      "results.changed",
      file.string(),
      fmt::format("is not the motion of that result of {}: {}", result.episode, record_again)};
}

// Error: the robot's row or its tools are others than when it was recorded.
Result<void> check_robot(const Motion& motion, const robots::Robot& robot, const fs::path& file) {
  bool same = motion.dofs.size() == robot.dof_count();
  for (std::size_t dof = 0; same && dof < motion.dofs.size(); ++dof)
    same = motion.dofs[dof] == robot.joint_of_dof(dof).name;
  if (same) return {};
  return Error{"results.changed",
               file.string(),
               fmt::format("its robot \"{}\" had other joints when it was recorded: {}",
                           motion.robot,
                           record_again)};
}

Pose pose_of(std::span<const double> numbers) {
  return {{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5], numbers[6]}};
}

}  // namespace

Result<std::shared_ptr<ReplayEpisode>> ReplayEpisode::open(
    const ReplayRuns& runs,
    std::size_t run,
    std::size_t episode,
    std::shared_ptr<const store::Store> store,
    const catalog::Catalog& catalog) {
  std::shared_ptr<ReplayEpisode> opened(new ReplayEpisode);
  const evaluation::FinishedRun& of = runs.run(run);
  const episodes::EpisodeResult& result = of.results[episode];
  opened->store_ = std::move(store);
  MARKETGEN_TRY(const fs::path file, recorded_file(of.folder, result.episode));
  MARKETGEN_TRY(opened->motion_, episodes::read_motion(file));
  MARKETGEN_CHECK(check_is_of(opened->motion_, result, file));
  MARKETGEN_TRY(const episodes::Track track, episodes::track_named(opened->motion_.track));
  MARKETGEN_TRY(const fs::path data, io::data_folder());
  const std::shared_ptr<const scene::Scene> scene(opened->store_, &opened->store_->scene);
  MARKETGEN_TRY(opened->place_,
                episodes::entry_of(track).place_of(data, opened->motion_, scene, catalog));
  MARKETGEN_CHECK(check_robot(opened->motion_, opened->place_.robot, file));
  MARKETGEN_TRY(opened->bodies_, ReplayBodies::of(opened->place_));
  MARKETGEN_CHECK(opened->find_things(result, catalog));
  opened->summarise(runs, run, episode);
  return opened;
}

Result<void> ReplayEpisode::find_things(const episodes::EpisodeResult& result,
                                        const catalog::Catalog& catalog) {
  things_ = ReplayThings(store_, catalog);
  for (const episodes::ThingMotion& thing : motion_.things) {
    if (thing.kind == episodes::ThingKind::product && thing.number >= place_.scene->products.size())
      return Error{"results.changed",
                   motion_.episode,
                   fmt::format("its motion moves product {}, its place has {}",
                               thing.number,
                               place_.scene->products.size())};
    const bool is_goal = std::ranges::find(result.goals, thing.sku, &episodes::GoalOutcome::sku) !=
                         result.goals.end();
    MARKETGEN_CHECK(things_.add(thing, is_goal, motion_.episode));
  }
  for (const episodes::JointMotion& joint : motion_.joints)
    if (joint.joint >= place_.scene->joints.size())
      return Error{"results.changed",
                   motion_.episode,
                   fmt::format("its motion moves joint {}, its place has {}",
                               joint.joint,
                               place_.scene->joints.size())};
  return {};
}

void ReplayEpisode::summarise(const ReplayRuns& runs, std::size_t run, std::size_t episode) {
  const episodes::EpisodeResult& result = runs.run(run).results[episode];
  summary_.result = runs.line_of(run, episode);
  for (RunLine& line : runs.of_store(result.scene_hash).runs)
    if (line.run == static_cast<int>(run)) summary_.run = std::move(line);
  summary_.instruction = motion_.instruction;
  summary_.cameras = episodes::entry_of(summary_.result.track).recorded_cameras();
  summary_.robot = motion_.robot;
  summary_.step_s = motion_.step_s;
  summary_.steps = static_cast<std::uint32_t>(motion_.steps());
  summary_.bodies = bodies_.names();
  summary_.events = motion_.events;
  summary_.side_effects = result.side_effects;
  summary_.things = things_.rows();
  add_goals(result);
}

void ReplayEpisode::add_goals(const episodes::EpisodeResult& result) {
  for (const episodes::GoalOutcome& goal : result.goals) {
    const auto [name, name_zh] = things_.names_of_sku(goal.sku);
    const bool rests = goal.reached > 0 && goal.rested_s > 0;
    summary_.goals.push_back({goal.sku,
                              name,
                              name_zh,
                              goal.count,
                              goal.reached,
                              rests ? result.simulated_s - goal.rested_s : -1});
  }
}

std::vector<double> ReplayEpisode::state(std::size_t step) const {
  const auto from =
      motion_.states.begin() + static_cast<std::ptrdiff_t>(step * motion_.dofs.size());
  return {from, from + static_cast<std::ptrdiff_t>(motion_.dofs.size())};
}

ViewFile ReplayEpisode::poses(std::uint32_t first, std::uint32_t count) const {
  PosePacker packer;
  const Pose frame = pose_of(motion_.store_from_robot);
  const auto end = std::min<std::size_t>(std::size_t{first} + count, motion_.steps());
  for (std::size_t step = first; step < end; ++step)
    for (const Pose& pose : bodies_.poses(place_.robot, state(step), frame))
      packer.add(pose);
  PackedSections sections;
  packer.pack(sections);
  sections.note("first", first);
  sections.note("steps", end - first);
  sections.note("bodies", bodies_.robot_bodies());
  return {"motion.bin", binary_type, sections.file()};
}

ViewFile ReplayEpisode::things() const {
  PosePacker packer;
  std::vector<std::uint32_t> range, step, joint, joint_range, joint_step;
  std::vector<float> joint_position;
  for (const episodes::ThingMotion& thing : motion_.things) {
    range.push_back(static_cast<std::uint32_t>(step.size()));
    range.push_back(static_cast<std::uint32_t>(thing.steps.size()));
    step.insert(step.end(), thing.steps.begin(), thing.steps.end());
    for (std::size_t row = 0; row < thing.steps.size(); ++row) {
      const float* p = &thing.poses[row * episodes::pose_numbers];
      packer.add({{p[0], p[1], p[2]}, {p[3], p[4], p[5], p[6]}});
    }
  }
  for (const episodes::JointMotion& moved : motion_.joints) {
    joint.push_back(moved.joint);
    joint_range.push_back(static_cast<std::uint32_t>(joint_step.size()));
    joint_range.push_back(static_cast<std::uint32_t>(moved.steps.size()));
    joint_step.insert(joint_step.end(), moved.steps.begin(), moved.steps.end());
    joint_position.insert(joint_position.end(), moved.positions.begin(), moved.positions.end());
  }
  PackedSections sections;
  sections.add("range", 2, std::span<const std::uint32_t>(range));
  sections.add("step", 1, std::span<const std::uint32_t>(step));
  packer.pack(sections);
  sections.add("joint", 1, std::span<const std::uint32_t>(joint));
  sections.add("joint_range", 2, std::span<const std::uint32_t>(joint_range));
  sections.add("joint_step", 1, std::span<const std::uint32_t>(joint_step));
  sections.add("joint_position", 1, std::span<const float>(joint_position));
  return {"things.bin", binary_type, sections.file()};
}

Result<std::unique_ptr<episodes::RecordedView>> ReplayEpisode::open_view() const {
  MARKETGEN_TRY(const episodes::Track track, episodes::track_named(motion_.track));
  MARKETGEN_TRY(const fs::path data, io::data_folder());
  return episodes::entry_of(track).open_recorded(data, motion_, place_, things_.products());
}

Result<ViewBuild::Body> ReplayEpisode::shape(const std::string& name) {
  const std::scoped_lock lock(mutex_);
  if (shapes_.empty()) {
    MARKETGEN_TRY(
        std::vector<ViewFile> files,
        product_meshes(things_.products(), store_->scene.materials, assets::Detail::middle));
    for (ViewFile& file : files)
      shapes_[file.name] = web::make_body(file.type, std::move(file.bytes));
  }
  const auto found = shapes_.find(name);
  if (found != shapes_.end()) return found->second;
  return Error{"server.not_found", name, "the episode has no such file"};
}

}  // namespace marketgen::server
