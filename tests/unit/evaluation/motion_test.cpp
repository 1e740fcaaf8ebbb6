// Recorded motion: what is written is what was, and reads back; what was changed is refused.
#include "episodes/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "evaluation/motion_recorder.h"
#include "evaluation/run_recorded.h"
#include "io/flatbuffer.h"
#include "io/gzip.h"
#include "support/pool_ground.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

using episodes::Motion;

Motion small_motion() {
  Motion motion;
  motion.episode = "checkout/aa/1/0";
  motion.robot = "panda";
  motion.step_s = 0.05;
  motion.store_from_robot = {0, 0, 0, 1, 0, 0, 0};
  motion.dofs = {"a", "b"};
  motion.states = {0, 1, 2, 3, 4, 5};
  motion.things = {{episodes::ThingKind::basket, 0, "", {0, 2}, std::vector<float>(14, 0.5F)}};
  motion.joints = {{3, {0, 1}, {0, 0.5F}}};
  motion.track = "checkout";
  motion.events = {
      {episodes::MotionEventKind::contact, 1, 2, episodes::EventTarget::item, 4, "beans", 12.5}};
  return motion;
}

std::string code_of(const Motion& motion) {
  const auto read = episodes::unpack_motion(episodes::pack_motion(motion), "here");
  return read.ok() ? "none" : read.error().code;
}

TEST(Motion, ReadsWhatItWrote) {
  const Motion motion = small_motion();
  EXPECT_EQ(motion.steps(), 3U);
  const auto read = episodes::unpack_motion(episodes::pack_motion(motion), "here");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->states, motion.states);
  EXPECT_EQ(read->dofs, motion.dofs);
  ASSERT_EQ(read->things.size(), 1U);
  EXPECT_EQ(read->things[0].kind, episodes::ThingKind::basket);
  EXPECT_EQ(read->things[0].poses, motion.things[0].poses);
  EXPECT_EQ(read->joints[0].positions, motion.joints[0].positions);
  EXPECT_EQ(read->track, "checkout");
  ASSERT_EQ(read->events.size(), 1U);
  EXPECT_EQ(read->events[0].target, episodes::EventTarget::item);
  EXPECT_EQ(read->events[0].last_step, 2U);
  EXPECT_EQ(read->events[0].force_n, 12.5);
}

TEST(Motion, TablesThatDoNotFitAreRefused) {
  using Change = void (*)(Motion&);
  const std::vector<Change> changes{[](Motion& motion) { motion.states.pop_back(); },
                                    [](Motion& motion) { motion.dofs.clear(); },
                                    [](Motion& motion) { motion.store_from_robot.pop_back(); },
                                    [](Motion& motion) { motion.things[0].poses.pop_back(); },
                                    [](Motion& motion) {
                                      motion.things[0].steps = {0, 3};
                                    },
                                    [](Motion& motion) {
                                      motion.things[0].steps = {1, 1};
                                    },
                                    [](Motion& motion) { motion.joints[0].positions.push_back(1); },
                                    [](Motion& motion) { motion.events[0].last_step = 3; },
                                    [](Motion& motion) { motion.events[0].step = 3; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Motion motion = small_motion();
    changes[i](motion);
    EXPECT_EQ(code_of(motion), "scene.corrupt") << i;
  }
}

TEST(Motion, AnyCutIsAnError) {
  const std::string packed = episodes::pack_motion(small_motion());
  for (std::size_t kept = 0; kept < packed.size(); kept += 7)
    EXPECT_FALSE(episodes::unpack_motion(packed.substr(0, kept), "here").ok()) << kept;
  EXPECT_FALSE(episodes::unpack_motion(io::gzip("no motion"), "here").ok());
}

class Recorded : public testing::TestWithParam<episodes::Track> {};

// Random actions for three seconds: every step is there, and the last rows are where things are.
TEST_P(Recorded, IsWhatHappened) {
  class Last : public environments::EpisodeWatcher {
   public:
    Result<void> begin(const episodes::TrackWorld& world) override {
      world_ = &world;
      return {};
    }
    Result<void> step() override {
      things = world_->things();
      state = world_->robot_state();
      return {};
    }
    std::vector<episodes::MovedThing> things;
    std::vector<double> state;

   private:
    const episodes::TrackWorld* world_ = nullptr;
  };
  const ScratchFolder scratch;
  const episodes::EpisodeSpec spec = pool_episode(GetParam(), 3);
  Last last;
  const auto result = evaluation::run_recorded(
      pool_ground(GetParam())->arena(), spec, "random", {}, {scratch.path().string(), ""}, &last);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  const auto motion = episodes::read_motion(evaluation::motion_file(scratch.path(), spec.id));
  ASSERT_TRUE(motion.ok()) << to_string(motion.error());
  EXPECT_EQ(motion->steps(), static_cast<std::size_t>(result->steps) + 1);
  EXPECT_EQ(motion->dofs.size(), last.state.size());
  for (std::size_t dof = 0; dof < last.state.size(); ++dof)
    EXPECT_FLOAT_EQ(motion->states[motion->states.size() - last.state.size() + dof],
                    static_cast<float>(last.state[dof]))
        << motion->dofs[dof];
  ASSERT_EQ(motion->things.size(), last.things.size());
  for (const episodes::MovedThing& thing : last.things) {
    const auto at = std::ranges::find_if(motion->things, [&](const episodes::ThingMotion& row) {
      return row.kind == thing.kind && row.number == thing.number;
    });
    ASSERT_NE(at, motion->things.end());
    EXPECT_EQ(at->sku, thing.sku);
    const float* pose = &*(at->poses.end() - episodes::pose_numbers);
    const Vec3 apart = thing.store_from_thing.position - Vec3{pose[0], pose[1], pose[2]};
    EXPECT_LE(length(apart), 2 * episodes::moved_m) << thing.sku;
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachTrack,
                         Recorded,
                         testing::Values(episodes::Track::checkout, episodes::Track::aisle),
                         [](const auto& track) { return std::string(name_of(track.param)); });

// How many contacts of each class, and how much harm, the events tell of.
episodes::SideEffects counted(const std::vector<episodes::MotionEvent>& events) {
  using Kind = episodes::MotionEventKind;
  episodes::SideEffects effects;
  const std::map<Kind, int*> counts{{Kind::toppled, &effects.toppled},
                                    {Kind::dropped, &effects.dropped},
                                    {Kind::displaced, &effects.displaced},
                                    {Kind::base_collision, &effects.base_collisions},
                                    {Kind::protective_stop, &effects.protective_stops}};
  for (const episodes::MotionEvent& event : events) {
    if (const auto harm = counts.find(event.kind); harm != counts.end()) *harm->second += 1;
    if (event.kind != Kind::contact) continue;
    (event.force_n > 50   ? effects.hard_contacts
     : event.force_n > 10 ? effects.firm_contacts
                          : effects.light_contacts) += 1;
  }
  return effects;
}

// The events of what was recorded are the ledger, as it was when the agent stopped.
TEST_P(Recorded, ItsEventsAreTheLedger) {
  class Ledger : public environments::EpisodeWatcher {
   public:
    Result<void> begin(const episodes::TrackWorld& world) override {
      world_ = &world;
      return {};
    }
    Result<void> step() override {
      effects = world_->watch().effects();
      effects.protective_stops = world_->controller().stops();
      return {};
    }
    episodes::SideEffects effects;

   private:
    const episodes::TrackWorld* world_ = nullptr;
  };
  const ScratchFolder scratch;
  const episodes::EpisodeSpec spec = pool_episode(GetParam(), 40);
  Ledger last;
  const auto result = evaluation::run_recorded(
      pool_ground(GetParam())->arena(), spec, "random", {}, {scratch.path().string(), ""}, &last);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  const auto motion = episodes::read_motion(evaluation::motion_file(scratch.path(), spec.id));
  ASSERT_TRUE(motion.ok()) << to_string(motion.error());
  const episodes::SideEffects told = counted(motion->events);
  EXPECT_EQ(told.light_contacts, last.effects.light_contacts);
  EXPECT_EQ(told.firm_contacts, last.effects.firm_contacts);
  EXPECT_EQ(told.hard_contacts, last.effects.hard_contacts);
  EXPECT_EQ(told.toppled, last.effects.toppled);
  EXPECT_EQ(told.dropped, last.effects.dropped);
  EXPECT_EQ(told.displaced, last.effects.displaced);
  EXPECT_EQ(told.base_collisions, last.effects.base_collisions);
  EXPECT_EQ(told.protective_stops, last.effects.protective_stops);
  EXPECT_GT(told.light_contacts + told.firm_contacts + told.hard_contacts, 0);
  EXPECT_TRUE(std::ranges::is_sorted(motion->events, {}, &episodes::MotionEvent::step));
  for (const episodes::MotionEvent& event : motion->events) {
    if (event.target != episodes::EventTarget::item) continue;
    EXPECT_EQ(event.sku, spec.items[event.number].sku);
  }
}

// What the oracle carries is held from when it is taken until it lies there.
TEST(MotionRecorder, TellsWhatWasHeld) {
  const ScratchFolder scratch;
  const episodes::EpisodeSpec spec = pool_episode(episodes::Track::checkout, 60);
  const auto result = evaluation::run_recorded(pool_ground(episodes::Track::checkout)->arena(),
                                               spec,
                                               "oracle-plain",
                                               {},
                                               {scratch.path().string(), ""});
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  const auto motion = episodes::read_motion(evaluation::motion_file(scratch.path(), spec.id));
  ASSERT_TRUE(motion.ok()) << to_string(motion.error());
  ASSERT_GT(result->hits, 0);
  for (const episodes::GoalOutcome& goal : result->goals) {
    if (goal.reached == 0) continue;
    const auto held = std::ranges::find_if(motion->events, [&](const episodes::MotionEvent& event) {
      return event.kind == episodes::MotionEventKind::held && event.sku == goal.sku;
    });
    ASSERT_NE(held, motion->events.end()) << goal.sku;
    EXPECT_GT(held->last_step, held->step + 20) << "it was carried for a second at least";
  }
}

TEST(MotionRecorder, BeginsAnewWithEachEpisode) {
  const episodes::EpisodeSpec spec = pool_episode(episodes::Track::checkout, 1);
  auto world = pool_ground(episodes::Track::checkout)->arena().open(spec);
  ASSERT_TRUE(world.ok()) << to_string(world.error());
  evaluation::MotionRecorder recorder;
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(recorder.begin(**world).ok());
    ASSERT_TRUE(recorder.step().ok());
    const auto motion =
        episodes::unpack_motion(recorder.packed(episodes::EpisodeResult{}, ""), "here");
    ASSERT_TRUE(motion.ok()) << to_string(motion.error());
    EXPECT_EQ(motion->steps(), 2U);
    for (const episodes::ThingMotion& thing : motion->things)
      EXPECT_EQ(thing.steps, std::vector<std::uint32_t>{0}) << "nothing moved";
  }
}

}  // namespace
}  // namespace marketgen
