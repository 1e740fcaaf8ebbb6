// A drive as pages have it: one drives and others look on, time runs with the driver, and the log
// that is kept leads to the same state again.
#include "server/drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "environments/environment_batch.h"
#include "io/file.h"
#include "io/gzip.h"
#include "io/jpeg.h"
#include "support/committed_catalog.h"
#include "support/packed_container.h"
#include "support/pool_ground.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using episodes::Track;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds patience{120};

// A page's end of a socket: keeps what it is sent.
class Page : public server::SocketSender {
 public:
  void text(std::string message) override {
    const std::scoped_lock lock(mutex_);
    notes_.push_back(Json::parse(message));
  }
  void latest(std::shared_ptr<const std::string> bytes) override {
    const std::scoped_lock lock(mutex_);
    latest_ = std::move(bytes);
  }
  Json head() const {
    const std::scoped_lock lock(mutex_);
    return latest_ == nullptr ? Json() : container_of(*latest_).head;
  }
  // The last of a kind.
  Json note(const std::string& kind) const {
    const std::scoped_lock lock(mutex_);
    for (auto note = notes_.rbegin(); note != notes_.rend(); ++note)
      if ((*note)["kind"] == kind) return *note;
    return {};
  }
  std::size_t errors() const {
    const std::scoped_lock lock(mutex_);
    return static_cast<std::size_t>(
        std::ranges::count_if(notes_, [](const Json& note) { return note["kind"] == "error"; }));
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Json> notes_;
  std::shared_ptr<const std::string> latest_;
};

template <class Holds>
bool wait_until(const Holds& holds) {
  for (const auto end = Clock::now() + patience; Clock::now() < end;) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

struct Seat {
  std::shared_ptr<Page> page = std::make_shared<Page>();
  std::unique_ptr<server::SocketPeer> peer;

  explicit Seat(server::Drive& drive) : peer(drive.peer()) { peer->opened(page); }
  void say(const Json& message) const { peer->received(message.dump()); }
  bool drives() const { return page->note("you")["drives"] == true; }
};

class Driven : public testing::Test {
 protected:
  void open(Track track) {
    const episodes::EpisodeSpec spec = pool_ground(track)->episodes().front();
    const auto scene = pool_ground(track)->arena().scene(spec.scene_hash);
    ASSERT_TRUE(scene.ok());
    auto store = std::make_shared<store::Store>();
    store->manifest.scene_hash = spec.scene_hash;
    store->scene = **scene;
    server::DriveGround ground;
    ground.store = std::move(store);
    ground.catalog = &committed_catalog();
    ground.rows = std::make_shared<const catalog::Catalog>(committed_catalog());
    ground.file = pool_ground(track);
    ground.logs = scratch_.path() / "drives";
    ground.number_of_place = [](const episodes::RecordedPlace& place) {
      return place.id.empty() ? -1 : 0;
    };
    drive_ = std::make_unique<server::Drive>(std::move(ground));
    begin(spec.id);
    ASSERT_TRUE(wait_until([&] { return status()["phase"] == "driving"; })) << status().dump();
  }
  std::string begin(const std::string& episode) {
    web::HttpAsk ask;
    ask.method = "POST";
    ask.body = Json{{"episode", episode}}.dump();
    const auto reply = drive_->begin(ask);
    return reply.ok() ? "ok" : reply.error().code;
  }
  Result<web::HttpReply> get(const std::vector<std::string>& words,
                             const std::map<std::string, std::string>& query = {}) {
    web::HttpAsk ask;
    ask.method = "GET";
    ask.query = query;
    return drive_->get(ask, words);
  }
  static std::string bytes(const web::HttpReply& reply) {
    return reply.body->packed ? *io::gunzip(reply.body->bytes, "body") : reply.body->bytes;
  }
  Json status() { return Json::parse(bytes(*get({}))); }

  ScratchFolder scratch_;
  std::unique_ptr<server::Drive> drive_;
};

Json move(const Json& command) {
  return {{"verb", "move"}, {"command", command}};
}

// Holds a key for some steps, as a page does.
bool hold(const Seat& seat, const Json& command, std::uint32_t steps) {
  if (!wait_until([&] { return !seat.page->head().is_null(); })) return false;  // its first moment
  const std::uint32_t from = seat.page->head()["step"];
  return wait_until([&] {
    seat.say(move(command));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return seat.page->head()["step"] >= from + steps;
  });
}

// Executes a log's actions in an environment of its own, made of the log alone.
std::string state_after(const episodes::DriveFile& file) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "episodes.jsonl";
  if (!io::write_file(path, episodes::write_episodes(file.episode)).ok()) fatal("not written");
  const auto ground = environments::EpisodeGround::of_file(path);
  if (!ground.ok()) fatal(to_string(ground.error()).c_str());
  const episodes::EpisodeSpec& spec = (*ground)->episodes().front();
  environments::EnvironmentOptions options;
  options.control = *value_named<environments::ControlMode>(file.log.control_mode);
  options.tools = spec.tools;
  auto made = environments::Environment::create(*ground, spec.track, options);
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  environments::Environment* const one = made->get();
  std::vector<float> seen(one->observation_size());
  if (!environments::reset_all({&one, 1}, {&spec, 1}, seen).ok()) fatal("no reset");
  const std::size_t numbers = file.log.action_names.size();
  for (std::size_t step = 0; step < file.log.steps(); ++step) {
    std::vector<double> action;  // as a reader of float32 has them
    for (std::size_t i = 0; i < numbers; ++i)
      action.push_back(static_cast<float>(file.log.actions[step * numbers + i]));
    std::array<double, 1> reward{};
    std::array<bool, 1> terminated{}, truncated{};
    const auto done =
        environments::step_all({&one, 1}, action, {seen, reward, terminated, truncated});
    if (!done.ok()) fatal(to_string(done.error()).c_str());
  }
  return one->world().state_hash();
}

TEST_F(Driven, ALogLeadsToTheSameStateAgain) {
  open(Track::checkout);
  const Seat seat(*drive_);
  ASSERT_TRUE(wait_until([&] { return seat.drives() && !seat.page->head().is_null(); }));
  EXPECT_EQ(seat.page->head()["step"], 0) << "time waits for the driver";
  ASSERT_TRUE(hold(seat, {{"move", {0.3, 0.1, -0.2}}, {"grip", "close"}}, 12));
  EXPECT_EQ(seat.page->head()["openings"][0], -1);
  ASSERT_TRUE(hold(seat, {{"twist", {0, 0, 0.5}}, {"axes", "tool"}}, 8));
  seat.say({{"verb", "done"}});
  ASSERT_TRUE(wait_until([&] { return seat.page->head().contains("verdict"); }));
  const Json last = seat.page->head();
  EXPECT_EQ(last["runs"], false);
  EXPECT_EQ(status()["phase"], "driving") << "it is still shown";
  EXPECT_EQ(last["verdict"]["success"], false);
  seat.say({{"verb", "save"}});
  ASSERT_TRUE(wait_until([&] { return !seat.page->note("saved").is_null(); }));
  const auto log = episodes::read_drive(seat.page->note("saved")["file"].get<std::string>());
  ASSERT_TRUE(log.ok()) << to_string(log.error());
  EXPECT_TRUE(log->log.over);
  EXPECT_EQ(log->log.steps(), last["step"].get<std::size_t>() + 1) << "the stop takes no time";
  EXPECT_EQ(log->episode.episodes.front().id, pool_ground(Track::checkout)->episodes().front().id);
  EXPECT_EQ(state_after(*log), log->log.state_hash);
}

TEST_F(Driven, WhoIsNotHeardOfMovesNothing) {
  open(Track::aisle);
  const Seat seat(*drive_);
  ASSERT_TRUE(wait_until([&] { return seat.drives(); }));
  ASSERT_TRUE(hold(seat, {{"drive", 0.3}}, 15));
  const std::uint32_t silent = seat.page->head()["step"];
  ASSERT_TRUE(wait_until([&] { return seat.page->head()["step"] >= silent + 30; }));
  seat.say({{"verb", "save"}});
  ASSERT_TRUE(wait_until([&] { return !seat.page->note("saved").is_null(); }));
  const auto log = episodes::read_drive(seat.page->note("saved")["file"].get<std::string>());
  ASSERT_TRUE(log.ok());
  const auto& names = log->log.action_names;
  const std::size_t drive =
      static_cast<std::size_t>(std::ranges::find(names, "drive") - names.begin());
  const auto told = [&](std::size_t step) { return log->log.actions[step * names.size() + drive]; };
  EXPECT_GT(told(10), 0.2);
  EXPECT_EQ(told(log->log.steps() - 1), 0) << "the dead man's switch";
  EXPECT_FALSE(log->log.over);
}

TEST_F(Driven, OneDrivesAndOthersLookOn) {
  open(Track::checkout);
  auto first = std::make_unique<Seat>(*drive_);
  const Seat second(*drive_);
  ASSERT_TRUE(wait_until([&] { return first->drives(); }));
  EXPECT_FALSE(second.drives());
  EXPECT_EQ(second.page->note("you")["taken"], true);
  second.say({{"verb", "done"}});
  EXPECT_EQ(second.page->note("error")["code"], "server.drive_taken");
  second.say({{"verb", "take"}});
  EXPECT_FALSE(second.drives());
  EXPECT_EQ(begin("any"), "server.drive_taken");
  first.reset();
  second.say({{"verb", "take"}});
  EXPECT_TRUE(second.drives());
  ASSERT_TRUE(hold(second, {{"move", {0, 0, 0.2}}}, 3));
}

TEST_F(Driven, TimeRunsWithTheDriver) {
  open(Track::checkout);
  auto seat = std::make_unique<Seat>(*drive_);
  const Seat other(*drive_);
  ASSERT_TRUE(hold(*seat, {{"move", {0, 0, 0.2}}}, 3));
  seat->say({{"verb", "pause"}});
  ASSERT_TRUE(wait_until([&] { return seat->page->head()["runs"] == false; }));
  const std::uint32_t paused = seat->page->head()["step"];
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(seat->page->head()["step"], paused);
  seat->say({{"verb", "go"}});
  ASSERT_TRUE(wait_until([&] { return seat->page->head()["step"] > paused; }));
  seat->say({{"verb", "reset"}});
  ASSERT_TRUE(wait_until([&] { return seat->page->head()["step"] == 0; }));
  ASSERT_TRUE(hold(*seat, {{"move", {0, 0, 0.2}}}, 3));
  seat.reset();
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));  // it comes to rest
  const std::uint32_t left = other.page->head()["step"];
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_EQ(other.page->head()["step"], left);
}

TEST_F(Driven, APageIsGivenWhatItDraws) {
  open(Track::checkout);
  EXPECT_EQ(begin("none of them"), "server.bad_request");
  const Json episode = status()["episode"];
  EXPECT_EQ(episode["arms"].size(), 1U);
  EXPECT_EQ(episode["has_base"], false);
  EXPECT_EQ(episode["place"], 0);
  const Seat seat(*drive_);
  ASSERT_TRUE(wait_until([&] { return !seat.page->head().is_null(); }));
  const Json head = seat.page->head();
  EXPECT_EQ(head["things"], episode["things"].size());
  EXPECT_EQ(head["sections"]["position"]["count"],
            head["things"].get<std::size_t>() + head["bodies"].get<std::size_t>());
  EXPECT_EQ(head["reached"].size(), episode["goals"].size());
  ASSERT_TRUE(get({"robot.bin"}).ok());
  ASSERT_TRUE(get({"shapes", "0-1", "meshes.bin"}).ok());
  EXPECT_FALSE(get({"shapes", "1-1", "meshes.bin"}).ok());
  EXPECT_FALSE(get({"shapes", "0-9999", "meshes.bin"}).ok());
  EXPECT_FALSE(get({"shapes", "x", "meshes.bin"}).ok());
  const auto picture = get({"camera.jpg"}, {{"camera", "wrist_camera"}, {"width", "64"}});
  ASSERT_TRUE(picture.ok()) << to_string(picture.error());
  const auto image = io::decode_jpeg(picture->body->bytes, "picture");
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->width, 64);
  EXPECT_EQ(get({"camera.jpg"}, {{"camera", "none"}}).error().code, "server.bad_request");
}

TEST_F(Driven, WhatIsNoMessageIsRefused) {
  open(Track::checkout);
  const Seat seat(*drive_);
  ASSERT_TRUE(wait_until([&] { return seat.drives(); }));
  std::mt19937 random(1);
  const std::string good = move({{"move", {0.1, 0, 0}}}).dump();
  for (int i = 0; i < 2000; ++i) {
    std::string text = good;
    for (int k = 0; k < 3; ++k)
      text[random() % text.size()] = static_cast<char>(random() % 256);
    seat.peer->received(text);
  }
  for (const char* text : {"",
                           "null",
                           "[]",
                           "{}x",
                           R"({"verb":"fly"})",
                           R"({"command":{"arm":-1}})",
                           R"({"command":{"move":[2,0,0]}})",
                           R"({"command":{"drive":1e999}})",
                           R"({"command":{"joints":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]}})"}) {
    const std::size_t before = seat.page->errors();
    seat.peer->received(text);
    EXPECT_EQ(seat.page->errors(), before + 1) << text;
  }
  EXPECT_EQ(status()["phase"], "driving");
}

}  // namespace
}  // namespace marketgen
