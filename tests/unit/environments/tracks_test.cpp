// The conformance test of episodes/tracks.inc: every track has all that its line promises, and it
// works: episodes are drawn and checked, worlds step and judge, views and policies are made.
#include <gtest/gtest.h>

#include "environments/environment_entry.h"
#include "episodes/check_episodes.h"
#include "episodes/track_entry.h"
#include "episodes/track_view.h"
#include "support/pool_ground.h"

namespace marketgen {
namespace {

class EachTrack : public testing::TestWithParam<episodes::Track> {
 protected:
  static episodes::Track track() { return GetParam(); }
  static environments::Arena& arena() { return pool_ground(track())->arena(); }

  static std::unique_ptr<episodes::TrackWorld> opened() {
    auto world = arena().open(pool_episode(track(), 10));
    if (!world.ok()) fatal(to_string(world.error()).c_str());
    return std::move(world).value();
  }
};

TEST_P(EachTrack, HasRowsThatItsEpisodesKeepTo) {
  const episodes::TrackEntry& entry = episodes::entry_of(track());
  const auto robot = entry.robot(pool_ground(track())->data());
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  for (const episodes::EpisodeSpec& spec : pool_ground(track())->episodes()) {
    EXPECT_EQ(spec.track, track());
    EXPECT_EQ(spec.robot, robot->robot);
    EXPECT_LE(entry.items_of(spec), entry.max_items());
    EXPECT_GE(entry.items_of(spec), 1);
    const auto checked = episodes::check_episode(spec, spec.id);
    EXPECT_TRUE(checked.ok()) << to_string(checked.error());
  }
}

TEST_P(EachTrack, OpensAWorldThatStepsAndJudges) {
  const auto world = opened();
  EXPECT_EQ(world->any().index(), static_cast<std::size_t>(track()));
  const std::string before = world->state_hash();
  const auto stepped = world->step(episodes::still_action(world->observe()));
  ASSERT_TRUE(stepped.ok()) << to_string(stepped.error());
  EXPECT_NE(world->state_hash(), before);
  EXPECT_EQ(world->steps(), 1);
  const auto met = world->goals_met();
  ASSERT_TRUE(met.ok()) << to_string(met.error());
  EXPECT_FALSE(*met);
  const auto result = world->finish();
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->hits, 0);
  EXPECT_GT(result->asked, 0);
  EXPECT_EQ(result->side_effects.dropped, 0);
}

TEST_P(EachTrack, ShowsItselfToFilmsAndAgents) {
  const auto world = opened();
  const auto view = world->open_view();
  ASSERT_TRUE(view.ok()) << to_string(view.error());
  std::vector<std::string> cameras = pool_environment(track())->cameras();
  EXPECT_EQ(cameras.size(), episodes::entry_of(track()).cameras().size());
  cameras.emplace_back(episodes::film_camera_name);
  for (const std::string& name : cameras) {
    const auto followed = (*view)->follow();
    ASSERT_TRUE(followed.ok()) << to_string(followed.error());
    const auto camera = (*view)->camera(name, 32, 24);
    ASSERT_TRUE(camera.ok()) << to_string(camera.error());
    const auto frame = (*view)->renderer().render(*camera, {});
    ASSERT_TRUE(frame.ok()) << to_string(frame.error());
    EXPECT_EQ(frame->color.width, 32) << name;
  }
  EXPECT_EQ((*view)->camera("no such camera").error().code, "camera.unknown");
}

TEST_P(EachTrack, HasEveryPolicy) {
  const auto world = opened();
  for (const char* name : {"random",
                           "stop",
                           "oracle",
                           "oracle-plain",
                           "oracle-thorough",
                           "classical",
                           "classical+masks+target+grasp",
                           "classical+language"}) {
    const auto policy = arena().policy(name, *world);
    EXPECT_TRUE(policy.ok()) << name << ": " << to_string(policy.error());
  }
  EXPECT_EQ(arena().policy("orakel", *world).error().code, "usage.bad_flag");
}

TEST_P(EachTrack, DrawsEpisodesThatCanBeOpened) {
  const episodes::EpisodeStore& store = pool_ground(track())->stores().front();
  const auto sampler = environments::environment_entry_of(track()).sampler(arena(), "");
  ASSERT_TRUE(sampler.ok()) << to_string(sampler.error());
  const auto from = (*sampler)->of_store({store.name, store.scene_hash, store.plan_hash});
  ASSERT_TRUE(from.ok()) << to_string(from.error());
  EXPECT_FALSE((*from)->products().empty());
  const auto drawn = (*from)->sample(Seed(1), 0);
  ASSERT_TRUE(drawn.ok()) << to_string(drawn.error());
  EXPECT_EQ(drawn->track, track());
  const auto checked = episodes::check_episode(*drawn, drawn->id);
  EXPECT_TRUE(checked.ok()) << to_string(checked.error());
  episodes::EpisodeHeader
      header;  // as `marketgen episodes` writes it: with rows of all that lies there
  header.stores = {store};
  header.products = (*from)->products();
  environments::Arena own(arena().data(), header, arena().catalog());
  const auto world = own.open(*drawn);
  EXPECT_TRUE(world.ok()) << to_string(world.error());
  EXPECT_GT((*from)->exclusions().on_offer, 0);
}

INSTANTIATE_TEST_SUITE_P(OfTracks,
                         EachTrack,
                         testing::ValuesIn(episodes::all_tracks),
                         [](const auto& track) { return std::string(name_of(track.param)); });

}  // namespace
}  // namespace marketgen
