#include "server/driven_episode.h"

#include <algorithm>
#include <array>
#include <set>

#include "base/build_info.h"
#include "environments/environment_batch.h"

namespace marketgen::server {
namespace {

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
  MARKETGEN_TRY(opened->environment_,
                environments::Environment::create(opened->ground_, spec.track, options));
  opened->seen_.resize(opened->environment_->observation_size());
  MARKETGEN_CHECK(opened->reset());
  MARKETGEN_TRY(
      opened->shown_,
      ShownEpisode::of(*opened->environment_, *opened->ground_, std::move(store), catalog));
  return opened;
}

Result<void> DrivenEpisode::reset() {
  environments::Environment* const one = environment_.get();
  MARKETGEN_CHECK(environments::reset_all({&one, 1}, {&spec_, 1}, seen_));
  hands_.emplace(*environment_);
  actions_.clear();
  return {};
}

Result<void> DrivenEpisode::restart() {
  MARKETGEN_CHECK(reset());
  return shown_->begin();
}

Result<void> DrivenEpisode::step(const robots::TeleopCommand& command, bool done) {
  const std::vector<double> numbers = hands_->numbers(command, done);
  environments::Environment* const one = environment_.get();
  std::array<double, 1> reward{};
  std::array<bool, 1> terminated{}, truncated{};
  MARKETGEN_CHECK(
      environments::step_all({&one, 1}, numbers, {seen_, reward, terminated, truncated}));
  actions_.insert(actions_.end(), numbers.begin(), numbers.end());
  return shown_->look();
}

DriveEpisode DrivenEpisode::told() const {
  DriveEpisode told = shown_->told();
  for (const environments::ActionNumber& joint : environments::teleop_joints(*environment_))
    told.joints.push_back({joint.name, std::string(joint.dimension)});
  return told;
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
