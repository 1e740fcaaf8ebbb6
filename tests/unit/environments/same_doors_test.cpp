// One stepping loop: the same actions give the same physics, bit for bit, by whatever door they
// come: a policy that is run, an environment that is stepped, many environments in one call. At any
// realism.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <tuple>

#include "base/parallel.h"
#include "environments/environment_batch.h"
#include "environments/run_episode.h"
#include "support/pool_ground.h"

namespace marketgen {
namespace {

constexpr double limit_s = 20;
constexpr int steps = 30;
using Row = std::vector<double>;

// Joints that sway about where they begin, a base that creeps, hands that open; then the stop.
std::vector<Row> swaying(const environments::Environment& begun) {
  const Row start = begun.world().observe().position;
  std::vector<Row> rows;
  for (int i = 0; i < steps; ++i) {
    Row row = start;
    for (std::size_t j = 0; j < row.size(); ++j)
      row[j] += 0.05 * std::sin(0.2 * i + static_cast<double>(j));
    row.resize(begun.action_numbers().size(), 0.1);
    row.back() = i + 1 < steps ? -1 : 1;
    rows.push_back(std::move(row));
  }
  return rows;
}

// Does what the rows say, one after another.
class Scripted : public agent::Policy {
 public:
  Scripted(const robots::Robot& robot, std::vector<Row> rows)
      : map_(robot, environments::ControlMode::pd_joint_pos), rows_(std::move(rows)) {}
  Result<void> begin(const agent::Task&, const agent::Observation&) override { return {}; }
  Result<agent::Action> act(const agent::Observation& now) override {
    seen_.push_back(now.position.front());
    MARKETGEN_TRY(const environments::MappedAction mapped,
                  map_.action(rows_.at(next_++), {}, now.position));
    return mapped.action;
  }

  const Row& seen() const { return seen_; }  // of the first joint, whenever it was asked

 private:
  environments::ActionMap map_;
  std::vector<Row> rows_;
  std::size_t next_ = 0;
  Row seen_;
};

// On a thread that steps: numbers are rounded as parallel loops round them.
template <class Work>
auto as_loops_round(const Work& work) {
  std::optional<decltype(work())> made;
  parallel_for(1, [&](std::size_t) { made = work(); });
  return *std::move(made);
}

using Door = std::tuple<episodes::Track, const char*>;  // and the realism

class EachDoor : public testing::TestWithParam<Door> {
 protected:
  static episodes::EpisodeSpec spec() { return pool_episode(std::get<0>(GetParam()), limit_s); }

  static episodes::Realism realism() {
    const std::filesystem::path data = std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
    auto read = episodes::load_realism(data, std::get<1>(GetParam()));
    if (!read.ok()) fatal(to_string(read.error()).c_str());
    return std::move(read).value();
  }

  static std::unique_ptr<environments::Environment> begun() {
    auto environment = pool_environment(
        std::get<0>(GetParam()),
        {.control = environments::ControlMode::pd_joint_pos, .realism = realism()});
    const auto reset = as_loops_round([&] { return environment->reset(spec()); });
    if (!reset.ok()) fatal(to_string(reset.error()).c_str());
    return environment;
  }

  static std::string end_of(const environments::Environment& environment) {
    return environment.result() ? environment.result()->state_hash : "still runs";
  }
};

// What the first joint's sensor says before each step comes to `seen`.
std::string by_steps(environments::Environment& environment,
                     const std::vector<Row>& rows,
                     Row& seen) {
  for (const Row& row : rows) {
    seen.push_back(environment.world().observe().position.front());
    const auto stepped = as_loops_round([&] { return environment.step(row); });
    if (!stepped.ok()) return to_string(stepped.error());
  }
  return environment.result() ? environment.result()->state_hash : "still runs";
}

std::string by_policy(const episodes::EpisodeSpec& spec,
                      const episodes::Realism& realism,
                      const std::vector<Row>& rows,
                      Row& seen) {
  const auto run = [&]() -> Result<episodes::EpisodeResult> {
    MARKETGEN_TRY(const auto world, pool_ground(spec.track)->arena().open(spec, {}, realism));
    Scripted policy(world->robot(), rows);
    auto result = environments::run_policy(*world, policy, "scripted");
    seen = policy.seen();
    return result;
  };
  const auto result = as_loops_round(run);
  return result.ok() ? result->state_hash : to_string(result.error());
}

void in_one_call(const std::vector<environments::Environment*>& environments,
                 const std::vector<Row>& rows) {
  const std::size_t count = environments.size();
  std::vector<float> seen(count * environments.front()->observation_size());
  std::vector<double> rewards(count);
  const auto flags = std::make_unique<bool[]>(2 * count);
  for (const Row& row : rows) {
    Row all;
    for (std::size_t i = 0; i < count; ++i)
      all.insert(all.end(), row.begin(), row.end());
    const auto done = environments::step_all(
        environments, all, {seen, rewards, {&flags[0], count}, {&flags[count], count}});
    ASSERT_TRUE(done.ok()) << to_string(done.error());
  }
}

TEST_P(EachDoor, LeadsToTheSameState) {
  const auto alone = begun(), one = begun(), two = begun();
  const std::vector<Row> rows = swaying(*alone);
  Row seen, seen_by_policy;
  const std::string stepped = by_steps(*alone, rows, seen);
  EXPECT_EQ(stepped.size(), 32U) << stepped;
  EXPECT_EQ(by_policy(spec(), realism(), rows, seen_by_policy), stepped);
  EXPECT_EQ(seen_by_policy, seen);
  EXPECT_EQ(alone->result()->realism, realism().name);
  in_one_call({one.get(), two.get()}, rows);
  EXPECT_EQ(end_of(*one), stepped);
  EXPECT_EQ(end_of(*two), stepped);
}

// One bad row, and none has moved.
TEST_P(EachDoor, ABatchIsRefusedAsAWhole) {
  const auto one = begun(), two = begun();
  const std::string before = one->world().state_hash();
  const std::size_t numbers = one->action_numbers().size();
  Row all(2 * numbers, 0.0);
  all[numbers] = std::nan("");
  environments::Environment* both[] = {one.get(), two.get()};
  std::vector<float> seen(2 * one->observation_size());
  double rewards[2];
  bool flags[4];
  const auto done = environments::step_all(both, all, {seen, rewards, {flags, 2}, {flags + 2, 2}});
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, "episode.bad_action");
  EXPECT_EQ(done.error().where, "action of environment 1");
  EXPECT_EQ(one->world().state_hash(), before);
}

INSTANTIATE_TEST_SUITE_P(OfTracks,
                         EachDoor,
                         testing::Combine(testing::ValuesIn(episodes::all_tracks),
                                          testing::Values("ideal", "standard")),
                         [](const auto& door) {
                           return std::string(name_of(std::get<0>(door.param))) + "_" +
                                  std::get<1>(door.param);
                         });

}  // namespace
}  // namespace marketgen
