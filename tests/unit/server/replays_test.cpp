// Recorded episodes as a page is given them: what is served is what was recorded.
#include "server/replays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "environments/travelling_stores.h"
#include "episodes/checkout/checkout_lanes.h"
#include "episodes/episode_header.h"
#include "episodes/track_view.h"
#include "evaluation/evaluate.h"
#include "evaluation/motion_recorder.h"
#include "evaluation/run_recorded.h"
#include "io/gzip.h"
#include "io/jpeg.h"
#include "render/stage/robot_actor.h"
#include "support/committed_catalog.h"
#include "support/drawn_checkout.h"
#include "support/packed_container.h"
#include "support/pool_ground.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using episodes::Track;
using Json = nlohmann::json;
using SharedStore = std::shared_ptr<const store::Store>;

constexpr double limit_s = 2;

SharedStore pool_store(Track track) {
  const std::string hash = pool_episode(track, limit_s).scene_hash;
  const auto scene = pool_ground(track)->arena().scene(hash);
  if (!scene.ok()) fatal(to_string(scene.error()).c_str());
  auto made = std::make_shared<store::Store>();
  made->folder = "pool";
  made->manifest.name = "Pool";
  made->manifest.scene_hash = hash;
  made->scene = **scene;
  return made;
}

void evaluate_in(const fs::path& folder,
                 Track track,
                 const std::string& policy,
                 bool record,
                 const std::vector<episodes::EpisodeSpec>& specs) {
  evaluation::EvaluationOptions options;
  options.policy = policy;
  options.folder = folder;
  options.jobs = 1;
  options.record_motion = record;
  const episodes::EpisodeFile file{pool_ground(track)->arena().header(), specs};
  const auto done =
      evaluation::evaluate(data_rows(), file, committed_catalog(), options, silent_progress());
  if (!done.ok()) fatal(to_string(done.error()).c_str());
}

Result<std::unique_ptr<server::Replays>> opened_replays(const std::vector<std::string>& folders,
                                                        std::vector<SharedStore> stores) {
  MARKETGEN_TRY(server::ReplayRuns runs, server::ReplayRuns::read(folders));
  return server::Replays::open(std::move(runs), std::move(stores), committed_catalog());
}

struct Shown {
  SharedStore store;
  std::unique_ptr<server::Replays> replays;

  Shown(Track track, const std::vector<std::string>& folders) : store(pool_store(track)) {
    auto opened = opened_replays(folders, {store});
    if (!opened.ok()) fatal(to_string(opened.error()).c_str());
    replays = std::move(opened).value();
  }
  Result<web::HttpReply> ask(const std::vector<std::string>& words,
                             const std::map<std::string, std::string>& query = {}) const {
    web::HttpAsk asked;
    asked.method = "GET";
    asked.query = query;
    return replays->answer(0, asked, words);
  }
  std::string bytes(const std::vector<std::string>& words,
                    const std::map<std::string, std::string>& query = {}) const {
    const auto reply = ask(words, query);
    if (!reply.ok()) fatal(to_string(reply.error()).c_str());
    const web::HttpBody& body = *reply->body;
    return body.packed ? *io::gunzip(body.bytes, "body") : body.bytes;
  }
  Json json(const std::vector<std::string>& words) const { return Json::parse(bytes(words)); }
  Container container(const std::vector<std::string>& words,
                      const std::map<std::string, std::string>& query = {}) const {
    return container_of(bytes(words, query));
  }
  std::string code(const std::vector<std::string>& words,
                   const std::map<std::string, std::string>& query = {}) const {
    const auto reply = ask(words, query);
    return reply.ok() ? "ok" : reply.error().code;
  }
};

class Replayed : public testing::TestWithParam<Track> {};

TEST_P(Replayed, IsWhatWasRecorded) {
  const ScratchFolder scratch;
  const episodes::EpisodeSpec spec = pool_episode(GetParam(), limit_s);
  evaluate_in(scratch.path(), GetParam(), "random", true, {spec});
  const Shown shown(GetParam(), {scratch.path().string()});
  const auto motion = episodes::read_motion(evaluation::motion_file(scratch.path(), spec.id));
  ASSERT_TRUE(motion.ok()) << to_string(motion.error());

  const Json list = shown.json({"0"});
  ASSERT_EQ(list["episodes"].size(), 1U);
  EXPECT_EQ(list["episodes"][0]["id"], spec.id);
  EXPECT_EQ(list["episodes"][0]["failure"], "Timeout");
  EXPECT_EQ(list["episodes"][0]["recorded"], true);
  const std::vector<std::string> episode{"0", "episodes", "0"};
  const Json summary = shown.json(episode);
  EXPECT_EQ(summary["instruction"], spec.instruction);
  EXPECT_EQ(summary["steps"], motion->steps());
  EXPECT_EQ(summary["things"].size(), motion->things.size());
  EXPECT_EQ(summary["events"].size(), motion->events.size());
  EXPECT_EQ(summary["goals"].size(), spec.goals.size());
  EXPECT_EQ(summary["place"], GetParam() == Track::aisle ? -1 : 0);

  // Every row of every thing.
  std::vector<std::string> path = episode;
  path.emplace_back("things.bin");
  const Container things = shown.container(path);
  const auto positions = things.numbers<float>("position");
  const auto range = things.numbers<std::uint32_t>("range");
  for (std::size_t i = 0; i < motion->things.size(); ++i) {
    const episodes::ThingMotion& thing = motion->things[i];
    ASSERT_EQ(range[2 * i + 1], thing.steps.size());
    for (std::size_t row = 0; row < thing.steps.size(); ++row)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_EQ(positions[(range[2 * i] + row) * 3 + axis], thing.poses[row * 7 + axis]);
  }
}

TEST_P(Replayed, ItsRobotStandsAsForwardKinematicsSays) {
  const ScratchFolder scratch;
  const episodes::EpisodeSpec spec = pool_episode(GetParam(), limit_s);
  evaluate_in(scratch.path(), GetParam(), "random", true, {spec});
  const Shown shown(GetParam(), {scratch.path().string()});
  const Json summary = shown.json({"0", "episodes", "0"});
  const auto world = pool_ground(GetParam())->arena().open(spec);
  ASSERT_TRUE(world.ok()) << to_string(world.error());
  const robots::Robot& robot = (*world)->robot();
  const auto motion = episodes::read_motion(evaluation::motion_file(scratch.path(), spec.id));
  const std::size_t last = motion->steps() - 1;
  const Container poses = shown.container({"0", "episodes", "0", "motion.bin"},
                                          {{"from", std::to_string(last)}, {"steps", "50"}});
  EXPECT_EQ(poses.head["first"], last);
  EXPECT_EQ(poses.head["steps"], 1);
  const auto dofs = static_cast<std::ptrdiff_t>(motion->dofs.size());
  const std::vector<double> state(motion->states.end() - dofs, motion->states.end());
  const auto links = render::world_link_poses(robot, state, (*world)->store_from_robot());
  const auto positions = poses.numbers<float>("position");
  const auto bodies = poses.head["bodies"].get<std::size_t>();
  ASSERT_GT(bodies, 5U);
  for (std::size_t body = 0; body < bodies; ++body) {
    const int link = robot.find_link(summary["bodies"][body].get<std::string>());
    ASSERT_GE(link, 0);
    const Vec3 at = links[static_cast<std::size_t>(link)].position;
    EXPECT_NEAR(positions[body * 3], at.x, 1e-5);
    EXPECT_NEAR(positions[body * 3 + 1], at.y, 1e-5);
    EXPECT_NEAR(positions[body * 3 + 2], at.z, 1e-5);
  }
}

// All of the robot is there once: as many triangles as the renderer has of it, and of the basket.
TEST_P(Replayed, HasAllShapes) {
  const ScratchFolder scratch;
  const episodes::EpisodeSpec spec = pool_episode(GetParam(), limit_s);
  evaluate_in(scratch.path(), GetParam(), "stop", true, {spec});
  const Shown shown(GetParam(), {scratch.path().string()});
  const Container robot = shown.container({"0", "episodes", "0", "robot.bin"});
  const auto world = pool_ground(GetParam())->arena().open(spec);
  ASSERT_TRUE(world.ok()) << to_string(world.error());
  const auto actor = render::robot_actor((*world)->robot(), (*world)->robot_state(), {});
  ASSERT_TRUE(actor.ok());
  std::size_t triangles = 0;
  for (const render::ActorBody& body : actor->bodies)
    triangles += body.mesh.triangles.size();
  const auto range = robot.numbers<std::uint32_t>("range");
  const bool basket = GetParam() == Track::checkout;
  const std::size_t of_robot = basket ? range[range.size() - 2] : robot.rows("index");
  EXPECT_EQ(of_robot, triangles * 3);
  EXPECT_EQ(basket,
            range.back() > 0 && shown.json({"0", "episodes", "0"})["bodies"].back() == "basket");
  if (!basket) return;
  const Container meshes = shown.container({"0", "episodes", "0", "meshes.bin"});
  const Json things = shown.json({"0", "episodes", "0"})["things"];
  for (const Json& thing : things) {
    if (thing["kind"] == "item") {
      EXPECT_LT(thing["mesh"], meshes.rows("range"));
    }
  }
  EXPECT_EQ(shown.ask({"0", "episodes", "0", "goods-0.jpg"})->body->type, "image/jpeg");
}

// A camera's picture of the last step is that of the world when it had come so far.
TEST_P(Replayed, ItsPicturesAreThoseOfTheWorld) {
  class Last : public environments::EpisodeWatcher {
   public:
    Result<void> begin(const episodes::TrackWorld& world) override {
      world_ = &world;
      return {};
    }
    Result<void> step() override {
      if (world_->steps() < static_cast<int>(limit_s / episodes::control_step_s)) return {};
      MARKETGEN_TRY(const auto view, world_->open_view());
      const bool aisle = world_->spec().track == Track::aisle;
      MARKETGEN_TRY(const render::Camera camera,
                    view->camera(aisle ? "head_camera" : "wrist_camera", 160, 120));
      MARKETGEN_TRY(render::Frame frame, view->renderer().render(camera, {}));
      picture = std::move(frame.color);
      return {};
    }
    Image picture;

   private:
    const episodes::TrackWorld* world_ = nullptr;
  };
  const ScratchFolder scratch;
  const episodes::EpisodeSpec spec = pool_episode(GetParam(), limit_s);
  evaluate_in(scratch.path(), GetParam(), "random", true, {spec});
  Last last;
  ASSERT_TRUE(
      evaluation::run_recorded(pool_ground(GetParam())->arena(), spec, "random", {}, {}, &last)
          .ok());
  const Shown shown(GetParam(), {scratch.path().string()});
  const std::vector<std::string> path{"0", "episodes", "0", "camera.jpg"};
  const bool aisle = GetParam() == Track::aisle;
  const std::string camera = aisle ? "head_camera" : "wrist_camera";
  const std::string jpeg = shown.bytes(path, {{"camera", camera}, {"width", "160"}});
  const auto seen = io::decode_jpeg(jpeg, "camera.jpg");
  ASSERT_TRUE(seen.ok()) << to_string(seen.error());
  ASSERT_EQ(seen->pixels.size(), last.picture.pixels.size());
  double apart = 0;
  for (std::size_t i = 0; i < seen->pixels.size(); ++i)
    apart += std::abs(static_cast<double>(seen->pixels[i]) -
                      static_cast<double>(last.picture.pixels[i]));
  EXPECT_LT(apart / static_cast<double>(seen->pixels.size()), 4) << "bytes, what JPEG loses";
  EXPECT_NE(shown.bytes(path, {{"camera", camera}, {"width", "160"}, {"step", "0"}}), jpeg);
  EXPECT_EQ(shown.code(path, {{"camera", "other"}}), "server.bad_request");
  EXPECT_EQ(shown.code(path, {{"step", "9999"}}), "server.bad_request");
  EXPECT_EQ(shown.code(path, {{"width", "9999"}}), "server.bad_request");
}

INSTANTIATE_TEST_SUITE_P(OfEachTrack,
                         Replayed,
                         testing::Values(Track::checkout, Track::aisle),
                         [](const auto& track) { return std::string(name_of(track.param)); });

// One recorded and one run that was not, at a counter.
class ReplaysOfTwo : public testing::Test {
 protected:
  ReplaysOfTwo() : spec_(pool_episode(Track::checkout, limit_s)) {
    evaluate_in(recorded_, Track::checkout, "stop", true, {spec_});
    evaluate_in(plain_, Track::checkout, "random", false, {spec_});
  }
  fs::path file() const { return evaluation::motion_file(recorded_, spec_.id); }
  std::string code() const {
    return Shown(Track::checkout, {recorded_.string()}).code({"0", "episodes", "0"});
  }
  ScratchFolder scratch_;
  episodes::EpisodeSpec spec_;
  fs::path recorded_ = scratch_.path() / "recorded", plain_ = scratch_.path() / "plain";
};

TEST_F(ReplaysOfTwo, AreListed) {
  const Shown shown(Track::checkout, {recorded_.string(), plain_.string()});
  const Json runs = shown.json({})["runs"];
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0]["policy"], "stop");
  EXPECT_EQ(runs[0]["folder"], "recorded");
  EXPECT_EQ(runs[1]["failures"][0]["code"], "Timeout");
  EXPECT_EQ(shown.json({"1"})["episodes"][0]["recorded"], false);
  EXPECT_EQ(shown.code({"1", "episodes", "0"}), "results.no_motion");
  EXPECT_EQ(shown.code({"2"}), "server.not_found");
  EXPECT_EQ(shown.code({"0", "episodes", "7"}), "server.not_found");
  EXPECT_EQ(shown.code({"0", "episodes", "0", "nothing.bin"}), "server.not_found");
  EXPECT_EQ(shown.code({"0", "episodes", "0", "motion.bin"}, {{"from", "1000000"}}),
            "server.bad_request");
}

TEST_F(ReplaysOfTwo, PlacesAreKnownOnceTheyWereAskedFor) {
  const Shown shown(Track::checkout, {recorded_.string()});
  EXPECT_EQ(shown.replays->place(0, 0), nullptr);
  shown.json({"0", "episodes", "0"});
  const SharedStore place = shown.replays->place(0, 0);
  ASSERT_NE(place, nullptr);
  EXPECT_EQ(place->scene.fixtures.size(), 1U) << "the counter, in a room of its own";
  EXPECT_EQ(shown.replays->place(0, 1), nullptr);
}

TEST_F(ReplaysOfTwo, AtALaneTheyStandInTheStore) {
  const SharedStore store = pool_store(Track::checkout);
  const auto station = episodes::load_checkout_station(data_rows());
  const auto lanes = episodes::checkout_lanes(store->scene, committed_catalog(), *station);
  if (lanes.suited.empty()) GTEST_SKIP() << "the pool's store has no lane with room";
  spec_.lane = lanes.suited.front();
  const fs::path folder = scratch_.path() / "lane";
  evaluate_in(folder, Track::checkout, "stop", true, {spec_});
  const Shown shown(Track::checkout, {folder.string()});
  shown.json({"0", "episodes", "0"});
  const SharedStore place = shown.replays->place(0, 0);
  ASSERT_NE(place, nullptr);
  EXPECT_EQ(place->scene.layout.fixtures.back().id, *spec_.lane);
  EXPECT_EQ(place->scene.layout.shell.width_mm, store->scene.layout.shell.width_mm);
}

// The pool's store is in no folder: its plan travels with the episodes.
TEST_F(ReplaysOfTwo, OfASetAreShownInItsStores) {
  auto runs = server::ReplayRuns::read({recorded_.string(), plain_.string()});
  ASSERT_TRUE(runs.ok()) << to_string(runs.error());
  const std::set<std::string> scenes = runs->scenes_without({});
  EXPECT_EQ(scenes, std::set<std::string>{spec_.scene_hash});
  auto opened = environments::with_travelling_stores(
      store::opened_stores({}, catalog::Catalog(committed_catalog())), scenes, "");
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());
  ASSERT_EQ(opened->stores.size(), 1U);
  EXPECT_EQ(scene::scene_hash(opened->stores[0]->scene), spec_.scene_hash);
  EXPECT_EQ(opened->stores[0]->folder, "pool");
  EXPECT_TRUE(runs->scenes_without(opened->stores).empty());
  const auto replays = server::Replays::open(*std::move(runs), opened->stores, opened->catalog);
  ASSERT_TRUE(replays.ok()) << to_string(replays.error());
  for (const std::string run : {"0", "1"})
    EXPECT_TRUE((*replays)->answer(0, {}, {run}).ok());
  EXPECT_TRUE((*replays)->answer(0, {}, {"0", "episodes", "0"}).ok());
}

TEST_F(ReplaysOfTwo, OfAnotherStoreAreRefused) {
  auto other = std::make_shared<store::Store>(*pool_store(Track::checkout));
  other->manifest.scene_hash = "0123";
  const auto opened = opened_replays({recorded_.string()}, {other});
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().code, "episode.other_store");
  auto both = opened_replays({recorded_.string()}, {other, pool_store(Track::checkout)});
  ASSERT_TRUE(both.ok());
  const auto reply = (*both)->answer(0, {}, {"0", "episodes", "0"});
  ASSERT_FALSE(reply.ok());
  EXPECT_EQ(reply.error().code, "episode.other_store");
}

TEST_F(ReplaysOfTwo, MotionsThatAreNotTheirsAreRefused) {
  auto motion = episodes::read_motion(file());
  ASSERT_TRUE(motion.ok());
  const auto write = [&](const episodes::Motion& changed) {
    std::ofstream(file(), std::ios::binary) << episodes::pack_motion(changed);
  };
  EXPECT_EQ(code(), "ok");
  episodes::Motion changed = *motion;
  changed.policy = "oracle";
  write(changed);
  EXPECT_EQ(code(), "results.changed");
  changed = *motion;
  changed.dofs.front() = "other";
  write(changed);
  EXPECT_EQ(code(), "results.changed");
  changed = *motion;
  changed.things.front().kind = episodes::ThingKind::product;
  changed.things.front().number = 1'000'000;
  write(changed);
  EXPECT_EQ(code(), "results.changed");
  changed = *motion;
  changed.joints = {{1'000'000, {0}, {0}}};
  write(changed);
  EXPECT_EQ(code(), "results.changed");
  changed = *motion;
  changed.track.clear();
  write(changed);
  EXPECT_EQ(code(), "results.no_motion");
  std::ofstream(file(), std::ios::binary) << "nothing";
  EXPECT_NE(code(), "ok");
}

TEST_F(ReplaysOfTwo, NoLinkLeadsOutOfTheFolder) {
  const fs::path outside = scratch_.path() / "outside.bin.gz";
  fs::rename(file(), outside);
  fs::create_symlink(outside, file());
  EXPECT_EQ(code(), "results.changed");
}

}  // namespace
}  // namespace marketgen
