#include "server/drive.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "base/text.h"
#include "episodes/track_entry.h"
#include "io/file.h"
#include "io/json.h"
#include "server/answering.h"
#include "server/view_files.h"

namespace marketgen::server {
namespace {

constexpr std::chrono::microseconds control_step{50'000};
static_assert(control_step.count() == episodes::control_step_s * 1e6);
constexpr std::chrono::milliseconds rest_time{500};  // in which a robot stops whose driver has gone
constexpr std::size_t timed_steps = 20;
constexpr std::chrono::seconds pause_time{1};  // between two steps that are not timed together
constexpr int max_logs_of_one = 10'000;
constexpr const char* message_name = "message";  // in errors

// A reader's message may quote half a letter of what a page has sent; notes are texts.
DriveNote error_note(const Error& error) {
  const std::string message = fmt::format("{}: {}", error.where, error.message);
  return {"error", false, false, {}, error.code, is_utf8(message) ? message : "is no such message"};
}

Error no_episode(const std::string& where) {
  return {"server.not_found", where, "no episode is open: POST /api/stores/N/drive/begin"};
}

// Tools and joints stay as they are.
robots::TeleopCommand still(const robots::TeleopCommand& held) {
  robots::TeleopCommand command;
  command.arm = held.arm;
  command.axes = held.axes;
  command.grip = held.grip;
  return command;
}

std::vector<DriveTrack> tracks_of(const std::filesystem::path& data) {
  std::vector<DriveTrack> tracks;
  for (const episodes::Track track : episodes::all_tracks)
    if (const auto robot = episodes::entry_of(track).robot(data); robot.ok())
      tracks.push_back({std::string(name_of(track)), robot->tools});
  return tracks;
}

}  // namespace

class Drive::Peer : public SocketPeer {
 public:
  explicit Peer(Drive& drive) : drive_(drive), page_(drive.pages_.join()) {}
  ~Peer() override { drive_.leave(page_); }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  void opened(std::weak_ptr<SocketSender> page) override {
    drive_.pages_.greet(page_, std::move(page));
    drive_.wake_.notify_all();
  }
  void received(std::string_view text) override { drive_.hear(page_, text); }

 private:
  Drive& drive_;
  int page_;
};

Drive::Drive(DriveGround ground) : ground_(std::move(ground)), pages_(ground_.watched) {
  status_.watched = ground_.watched;
  if (ground_.watched) return;
  status_.logs = ground_.logs.string();
  if (ground_.file != nullptr) {
    for (const episodes::EpisodeSpec& spec : ground_.file->episodes())
      if (spec.scene_hash == ground_.store->manifest.scene_hash)
        status_.offers.push_back({spec.id, std::string(name_of(spec.track)), spec.instruction});
  }
  offers_ = !status_.offers.empty();
  if (!offers_)
    if (const auto data = io::data_folder(); data.ok()) status_.tracks = tracks_of(*data);
  thread_ = std::thread([this] { run(); });
}

Drive::~Drive() {
  stop();
}

void Drive::stop() {
  pages_.end();
  {
    const std::scoped_lock lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

std::unique_ptr<SocketPeer> Drive::peer() {
  return std::make_unique<Peer>(*this);
}

void Drive::hear(int page, std::string_view text) {
  const auto message = io::read_json<web::DriveMessage>(text, message_name);
  if (!message.ok()) return pages_.tell(page, error_note(message.error()));
  if (message->verb == web::DriveVerb::take) return pages_.take(page);
  if (!pages_.drives(page))
    return pages_.tell(
        page,
        error_note({"server.drive_taken", message_name, "another page drives; this one looks on"}));
  {
    const std::scoped_lock lock(mutex_);
    if (message->verb == web::DriveVerb::move) {
      const robots::TeleopGrip before = held_.grip;
      held_ = message->command;
      if (held_.grip == robots::TeleopGrip::keep) held_.grip = before;
      heard_ = Clock::now();
      begun_ = begun_ || message->command.moves();
    } else {
      verbs_.push_back(message->verb);
    }
  }
  wake_.notify_all();
}

void Drive::leave(int page) {
  const bool drove = pages_.drives(page);
  pages_.leave(page);
  if (!drove) return;
  const std::scoped_lock lock(mutex_);
  heard_ = {};
  rest_until_ = Clock::now() + rest_time;
}

bool Drive::time_runs(Clock::time_point now) const {
  return status_.phase == DrivePhase::driving && begun_ && !paused_ && !over_ &&
         (pages_.taken() || now < rest_until_);
}

robots::TeleopCommand Drive::command_now(Clock::time_point now) {
  const bool heard = now - heard_ <= dead_man_time;
  robots::TeleopCommand command = heard ? held_ : still(held_);
  held_.grip = robots::TeleopGrip::keep;  // told once
  return command;
}

Drive::Turn Drive::next_turn() {
  std::unique_lock lock(mutex_);
  while (true) {
    const Clock::time_point now = Clock::now();
    const bool runs = time_runs(now);
    Turn turn;
    turn.end = ending_;
    turn.order = std::exchange(order_, std::nullopt);
    turn.verbs = std::exchange(verbs_, {});
    turn.steps = runs && now >= due_ && !turn.order && turn.verbs.empty();  // these may end it
    if (turn.steps) {
      turn.command = command_now(now);
      due_ = std::max(due_ + control_step, now);  // what was missed is not made up for
    }
    if (turn.end || turn.order || turn.steps || !turn.verbs.empty()) return turn;
    if (runs)
      wake_.wait_until(lock, due_);
    else
      wake_.wait(lock);
  }
}

void Drive::run() {
  while (true) {
    const Turn turn = next_turn();
    if (turn.end) return;
    const Result<void> done = until_interrupted([&]() -> Result<void> {
      if (turn.order) open(*turn.order);
      for (const web::DriveVerb verb : turn.verbs)
        act(verb);
      if (turn.steps) step(turn.command, false);
      return {};
    });
    if (!done.ok()) return;  // the program ends
  }
}

void Drive::fail(const Error& error) {
  {
    const std::scoped_lock lock(mutex_);
    status_.phase = DrivePhase::failed;
    status_.error_code = error.code;
    status_.error = fmt::format("{}: {}", error.where, error.message);
    status_.episode.reset();
    shown_.reset();
  }
  pages_.tell_all(error_note(error));
}

Result<episodes::EpisodeSpec> Drive::spec_of(const DriveAsk& ask,
                                             std::shared_ptr<environments::EpisodeGround>& ground) {
  if (!ask.episode.empty()) {
    ground = ground_.file;
    for (const episodes::EpisodeSpec& spec : ground->episodes())
      if (spec.id == ask.episode) return spec;
  }
  if (drawing_ == nullptr) {
    MARKETGEN_TRY(drawing_, environments::EpisodeGround::of_store(ground_.store, ground_.rows));
  }
  ground = drawing_;
  MARKETGEN_TRY(const episodes::Track track, episodes::track_named(ask.track));
  return drawing_->draw(track, ask.seed, ask.tools);
}

Result<std::unique_ptr<DrivenEpisode>> Drive::opened(const DriveAsk& ask) {
  std::shared_ptr<environments::EpisodeGround> ground;
  MARKETGEN_TRY(const episodes::EpisodeSpec spec, spec_of(ask, ground));
  return DrivenEpisode::open(ground, spec, ground_.store, *ground_.catalog);
}

void Drive::open(const DriveAsk& ask) {
  episode_.reset();
  Result<std::unique_ptr<DrivenEpisode>> made = opened(ask);
  if (!made.ok()) return fail(made.error());
  episode_ = std::move(made).value();
  show(episode_->shown(), episode_->told());
  publish();
  pages_.tell_all({"opened", false, false, {}, {}, {}});
}

void Drive::show(const ShownEpisode& episode, DriveEpisode told) {
  auto shown = std::make_shared<Shown>();
  shown->place = episode.place();
  shown->robot = episode.bodies().file();
  shown->track = told.track;
  told.place = ground_.number_of_place(shown->place);
  const std::scoped_lock lock(mutex_);
  status_.phase = DrivePhase::driving;
  status_.episode = std::move(told);
  shown_ = std::move(shown);
  begun_ = paused_ = over_ = false;
  held_ = {};
}

Result<void> Drive::watch(environments::Environment& environment,
                          environments::EpisodeGround& ground,
                          bool began) {
  if (!began) {
    MARKETGEN_CHECK(watched_->look());
    publish(*watched_, {});
    return {};
  }
  MARKETGEN_TRY(watched_, ShownEpisode::of(environment, ground, ground_.store, *ground_.catalog));
  show(*watched_, watched_->told());
  {
    const std::scoped_lock lock(mutex_);
    status_.generation += 1;
    begun_ = true;
  }
  publish(*watched_, {});
  return {};
}

void Drive::act(web::DriveVerb verb) {
  if (episode_ == nullptr) return pages_.tell_driver(error_note(no_episode(message_name)));
  if (verb == web::DriveVerb::done && episode_->running()) return step({}, true);
  if (verb == web::DriveVerb::save) {
    const Result<std::string> file = save();
    return file.ok() ? pages_.tell_driver({"saved", false, false, *file, {}, {}})
                     : pages_.tell_driver(error_note(file.error()));
  }
  if (verb == web::DriveVerb::reset) {
    if (const auto done = episode_->restart(); !done.ok()) return fail(done.error());
  }
  {
    const std::scoped_lock lock(mutex_);
    if (verb == web::DriveVerb::reset) begun_ = paused_ = over_ = false;
    if (verb == web::DriveVerb::go) begun_ = true;
    if (verb == web::DriveVerb::go || verb == web::DriveVerb::pause)
      paused_ = verb == web::DriveVerb::pause;
  }
  publish();
}

void Drive::step(const robots::TeleopCommand& command, bool done) {
  if (const auto made = episode_->step(command, done); !made.ok()) return fail(made.error());
  publish();
}

// Over the last steps without a pause; 0: there are none.
double Drive::speed_now(Clock::time_point now) {
  if (!stepped_.empty() && now - stepped_.back() > pause_time) stepped_.clear();
  stepped_.push_back(now);
  if (stepped_.size() > timed_steps) stepped_.pop_front();
  const double took_s = std::chrono::duration<double>(now - stepped_.front()).count();
  return took_s > 0 ? static_cast<double>(stepped_.size() - 1) * episodes::control_step_s / took_s
                    : 0;
}

void Drive::publish() {
  publish(episode_->shown(), episode_->openings());
}

void Drive::publish(const ShownEpisode& episode, std::span<const double> openings) {
  DriveMoment head;
  head.speed = speed_now(Clock::now());
  head.openings.assign(openings.begin(), openings.end());
  {
    const std::scoped_lock lock(mutex_);
    if (!status_.episode) return;  // another one was asked for
    over_ = !episode.running();
    head.generation = status_.generation;
    head.runs = begun_ && !paused_ && !over_;
    now_ = episode.now();
    products_ = episode.things().products();
    status_.episode->things = episode.things().rows();
  }
  pages_.show(std::make_shared<const std::string>(episode.message(head)));
}

// Beside those that are there already.
Result<std::string> Drive::save() const {
  MARKETGEN_TRY(const episodes::DriveFile file, episode_->log());
  const std::string& id = file.episode.episodes.front().id;
  std::string stem = id;
  std::ranges::replace(stem, '/', '-');
  for (int number = 1; number <= max_logs_of_one; ++number) {
    const std::filesystem::path path =
        ground_.logs / fmt::format("{}-{}.drive.jsonl.gz", stem, number);
    std::error_code failed;
    if (std::filesystem::exists(path, failed)) continue;
    MARKETGEN_CHECK(io::write_file(path, episodes::pack_drive(file)));
    return path.string();
  }
  return Error{
      "io.cannot_write",
      ground_.logs.string(),
      fmt::format(
          "there are {} logs of {}: name another folder with --drives", max_logs_of_one, id)};
}

Result<web::HttpReply> Drive::begin(const web::HttpAsk& ask) {
  MARKETGEN_TRY(const DriveAsk wanted, io::read_json<DriveAsk>(ask.body, "request"));
  if (pages_.taken())
    return Error{"server.drive_taken",
                 "begin",
                 "a page drives: another episode is opened once it has closed"};
  {
    const std::scoped_lock lock(mutex_);
    const auto offered = [&] {
      return std::ranges::find(status_.offers, wanted.episode, &DriveOffer::id) !=
             status_.offers.end();
    };
    if (wanted.episode.empty() ? status_.tracks.empty() : !offered())
      return Error{"server.bad_request",
                   "episode",
                   fmt::format("\"{}\" is none that is offered", wanted.episode)};
    if (wanted.episode.empty())
      if (const auto track = episodes::track_named(wanted.track); !track.ok()) return track.error();
    status_.phase = DrivePhase::opening;
    status_.generation += 1;
    status_.error_code = status_.error = "";
    status_.episode.reset();
    shown_.reset();
    order_ = wanted;
  }
  pages_.show(nullptr);
  wake_.notify_all();
  return get(ask, {});
}

Result<web::HttpReply> Drive::get(const web::HttpAsk& ask, const std::vector<std::string>& words) {
  if (words.empty()) {
    const bool taken = pages_.taken();
    const std::scoped_lock lock(mutex_);
    status_.taken = taken;
    return web::json_reply(io::write_json_line(status_));
  }
  if (words.size() == 3 && words[0] == "shapes") return shape(ask, words[1], words[2]);
  if (words.size() != 1) return no_address(ask);
  if (words[0] == "camera.jpg") return picture(ask);
  if (words[0] != "robot.bin") return no_address(ask);
  const std::scoped_lock lock(mutex_);
  if (shown_ == nullptr) return no_episode(ask.path);
  return reply_with(shown_->robot);
}

// meshes.bin and goods-P.jpg of a run of products, "0-12": the first, and the one after the last.
Result<web::HttpReply> Drive::shape(const web::HttpAsk& ask,
                                    const std::string& rows,
                                    const std::string& name) {
  std::vector<catalog::Product> some;
  {
    const std::scoped_lock lock(mutex_);
    const std::size_t dash = std::min(rows.find('-'), rows.size());
    MARKETGEN_TRY(const std::uint32_t first,
                  row_of(ask, std::string_view(rows).substr(0, dash), products_.size()));
    MARKETGEN_TRY(const std::uint32_t end,
                  row_of(ask,
                         std::string_view(rows).substr(std::min(dash + 1, rows.size())),
                         products_.size() + 1));
    if (first >= end) return no_address(ask);
    some.assign(products_.begin() + first, products_.begin() + end);
  }
  MARKETGEN_TRY(std::vector<ViewFile> files,
                product_meshes(some, ground_.store->scene.materials, assets::Detail::middle));
  const auto file = std::ranges::find(files, name, &ViewFile::name);
  if (file == files.end()) return no_address(ask);
  return reply_with(std::move(*file));
}

Result<web::HttpReply> Drive::picture(const web::HttpAsk& ask) {
  const std::scoped_lock taking(taking_);
  std::shared_ptr<const Shown> shown;
  episodes::Motion now;
  std::vector<catalog::Product> products;
  {
    const std::scoped_lock lock(mutex_);
    if (shown_ == nullptr) return no_episode(ask.path);
    shown = shown_;
    now = now_;
    products = products_;
  }
  MARKETGEN_TRY(const episodes::Track track, episodes::track_named(shown->track));
  const episodes::TrackEntry& entry = episodes::entry_of(track);
  MARKETGEN_TRY(const CameraAsk asked, camera_ask(ask, entry.recorded_cameras()));
  taker_.now = std::move(now);
  if (taker_.of != shown || taker_.view == nullptr) {
    taker_.view.reset();
    taker_.of = shown;
    MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
    MARKETGEN_TRY(taker_.view, entry.open_recorded(data, taker_.now, taker_.of->place, products));
  }
  return camera_reply(*taker_.view, 0, asked);
}

}  // namespace marketgen::server
