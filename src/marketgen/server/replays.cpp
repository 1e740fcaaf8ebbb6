#include "server/replays.h"

#include <algorithm>

#include <fmt/format.h>

#include "io/json.h"
#include "server/answering.h"
#include "server/camera_ask.h"

namespace marketgen::server {
namespace {

constexpr std::size_t kept_open = 8;  // episodes; what is read of one is some megabytes
constexpr std::uint64_t usual_steps = 1200, max_steps = 12000;  // of motion.bin

// A place has all that a page wants of a store, but for a folder.
std::shared_ptr<const store::Store> store_of(const store::Store& of,
                                             const episodes::RecordedPlace& place) {
  auto made = std::make_shared<store::Store>();
  made->folder = of.folder;
  made->manifest.name = of.manifest.name;
  made->manifest.seed = of.manifest.seed;
  made->manifest.brief.prompt = of.manifest.brief.prompt;
  made->scene = *place.scene;
  made->manifest.scene_hash = scene::scene_hash(made->scene);
  made->manifest.look_hash = scene::look_hash(made->scene);
  return made;
}

}  // namespace

Result<std::unique_ptr<Replays>> Replays::open(
    ReplayRuns runs,
    std::vector<std::shared_ptr<const store::Store>> stores,
    const catalog::Catalog& catalog) {
  MARKETGEN_CHECK(runs.check_shown_in(stores));
  return std::unique_ptr<Replays>(new Replays(std::move(runs), std::move(stores), catalog));
}

Result<web::HttpReply> Replays::answer(std::size_t store,
                                       const web::HttpAsk& ask,
                                       const std::vector<std::string>& words) {
  if (store >= stores_.size())  // one that was saved since: nothing has happened in it
    return words.empty() ? Result(web::json_reply(io::write_json_line(runs_.of_store(""))))
                         : no_address(ask);
  const std::string& scene = stores_[store]->manifest.scene_hash;
  if (words.empty()) return web::json_reply(io::write_json_line(runs_.of_store(scene)));
  MARKETGEN_TRY(const std::uint32_t run, row_of(ask, words[0], runs_.size()));
  if (words.size() == 1) return web::json_reply(io::write_json_line(runs_.episodes(run, scene)));
  if (words[1] != "episodes" || words.size() < 3) return no_address(ask);
  MARKETGEN_TRY(const std::uint32_t episode, row_of(ask, words[2], runs_.run(run).results.size()));
  return of_episode(store, ask, {run, episode}, {words.begin() + 3, words.end()});
}

Result<std::shared_ptr<ReplayEpisode>> Replays::episode(std::size_t store, const Key& key) {
  const episodes::EpisodeResult& result = runs_.run(key.first).results[key.second];
  const std::string& scene = stores_[store]->manifest.scene_hash;
  if (result.scene_hash != scene)
    return Error{"episode.other_store",
                 result.episode,
                 fmt::format("happened in the store \"{}\" (scene {}), not in this one (scene {}): "
                             "open it from that store",
                             result.store,
                             result.scene_hash,
                             scene)};
  const std::scoped_lock lock(mutex_);
  const auto known = std::ranges::find(opened_, key, [](const auto& entry) { return entry.first; });
  if (known != opened_.end()) {
    opened_.splice(opened_.begin(), opened_, known);
    return opened_.front().second;
  }
  MARKETGEN_TRY(std::shared_ptr<ReplayEpisode> opened,
                ReplayEpisode::open(runs_, key.first, key.second, stores_[store], catalog_));
  opened_.emplace_front(key, opened);
  if (opened_.size() > kept_open) opened_.pop_back();
  return opened;
}

Result<web::HttpReply> Replays::of_episode(std::size_t store,
                                           const web::HttpAsk& ask,
                                           const Key& key,
                                           const std::vector<std::string>& words) {
  MARKETGEN_TRY(const std::shared_ptr<ReplayEpisode> found, episode(store, key));
  if (words.empty()) return summary(store, *found);
  if (words.size() > 1) return no_address(ask);
  if (words[0] == "robot.bin") return reply_with(found->robot());
  if (words[0] == "motion.bin") return poses(*found, ask);
  if (words[0] == "things.bin") return reply_with(found->things());
  if (words[0] == "camera.jpg") return picture(found, ask);
  MARKETGEN_TRY(const ViewBuild::Body body, found->shape(words[0]));
  return web::HttpReply{.body = body};
}

Result<web::HttpReply> Replays::summary(std::size_t store, const ReplayEpisode& episode) {
  ReplaySummary summary = episode.summary();
  summary.place = number_of(store, episode.place());
  return web::json_reply(io::write_json_line(summary));
}

Result<web::HttpReply> Replays::poses(const ReplayEpisode& episode, const web::HttpAsk& ask) {
  const std::uint64_t last = episode.motion().steps() - 1;
  MARKETGEN_TRY(const std::uint64_t from, number_in(ask, "from", 0, 0, last));
  MARKETGEN_TRY(const std::uint64_t steps, number_in(ask, "steps", usual_steps, 1, max_steps));
  return reply_with(
      episode.poses(static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(steps)));
}

Result<web::HttpReply> Replays::picture(const std::shared_ptr<ReplayEpisode>& episode,
                                        const web::HttpAsk& ask) {
  MARKETGEN_TRY(const CameraAsk asked, camera_ask(ask, episode->summary().cameras));
  const std::uint64_t last = episode->motion().steps() - 1;
  MARKETGEN_TRY(const std::uint64_t step, number_in(ask, "step", last, 0, last));
  const std::scoped_lock lock(taking_);
  if (taken_of_ != episode || taker_ == nullptr) {
    taker_.reset();
    taken_of_ = episode;
    MARKETGEN_TRY(taker_, episode->open_view());
  }
  return camera_reply(*taker_, static_cast<std::size_t>(step), asked);
}

int Replays::number_of(std::size_t store, const episodes::RecordedPlace& place) {
  if (place.id.empty()) return -1;
  const std::scoped_lock lock(mutex_);
  const auto known = std::ranges::find_if(
      places_, [&](const Place& other) { return other.store == store && other.id == place.id; });
  if (known != places_.end()) return static_cast<int>(known - places_.begin());
  places_.push_back({store, place.id, store_of(*stores_[store], place)});
  return static_cast<int>(places_.size()) - 1;
}

std::shared_ptr<const store::Store> Replays::place(std::size_t store, std::uint64_t number) {
  const std::scoped_lock lock(mutex_);
  if (number >= places_.size() || places_[number].store != store) return nullptr;
  return places_[number].made;
}

}  // namespace marketgen::server
