// The addresses below /api/stores/N/drive: a person drives an episode's robot in live physics,
// others look on (docs/viewer.md).
//
// A thread of its own steps the world once every control step, no faster than time; what the pages
// are shown goes to them over websockets. Who has not been heard of for `dead_man_time` moves
// nothing. Thread-safe.
#pragma once
#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/result.h"
#include "environments/episode_ground.h"
#include "robots/teleop_command.h"
#include "server/camera_ask.h"
#include "server/drive_documents.h"
#include "server/drive_pages.h"
#include "server/driven_episode.h"
#include "server/web_socket.h"
#include "web/drive_message.h"
#include "web/http_message.h"

namespace marketgen::server {

struct DriveGround {
  std::shared_ptr<const store::Store> store;
  std::shared_ptr<const catalog::Catalog> rows;            // that the store was made of
  const catalog::Catalog* catalog = nullptr;               // of all goods; outlives the drive
  std::shared_ptr<environments::EpisodeGround> file = {};  // whose episodes are offered, if any
  std::filesystem::path logs = "drives";                   // folder, made when it is needed
  // Below places; -1: the store itself. Thread-safe.
  std::function<int(const episodes::RecordedPlace&)> number_of_place = {};
  bool watched = false;  // nobody drives: watch() says what is to be seen
};

class Drive {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds dead_man_time{300};

  explicit Drive(DriveGround ground);
  ~Drive();
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;
  // Steps no more, and sends nothing any more.
  void stop();

  bool offers_episodes() const { return offers_; }  // of the file

  // What is below drive. `words`: the path's parts behind it. Errors: server.not_found,
  // server.bad_request; those of the pictures.
  Result<web::HttpReply> get(const web::HttpAsk& ask, const std::vector<std::string>& words);
  // Opens an episode (DriveAsk), which takes seconds: the status says when it is there. Errors:
  // server.drive_taken while somebody drives; json.*, server.bad_request, episode.unknown_track.
  Result<web::HttpReply> begin(const web::HttpAsk& ask);
  // Of a page that drives, or looks on where another one does.
  std::unique_ptr<SocketPeer> peer();
  // Shows an episode as it is now that somebody else steps; `began`: it is another one, or was set
  // to another state. Of one thread. Precondition: DriveGround::watched, and `environment` is that
  // of the last call that began. Errors: those of ShownEpisode.
  Result<void> watch(environments::Environment& environment,
                     environments::EpisodeGround& ground,
                     bool began);

 private:
  class Peer;
  // What answers need of the episode that is open; never changed.
  struct Shown {
    episodes::RecordedPlace place;
    ViewFile robot;
    std::string track;
  };
  // Who took the last picture: a renderer is large.
  struct Taker {
    std::shared_ptr<const Shown> of;
    episodes::Motion now;
    std::unique_ptr<episodes::RecordedView> view;  // reads `of` and `now`
  };
  struct Turn {
    bool end = false, steps = false;
    std::optional<DriveAsk> order;
    std::deque<web::DriveVerb> verbs;
    robots::TeleopCommand command;
  };

  void hear(int page, std::string_view text);
  void leave(int page);

  // Of the thread.
  void run();
  Turn next_turn();
  bool time_runs(Clock::time_point now) const;
  robots::TeleopCommand command_now(Clock::time_point now);
  void open(const DriveAsk& ask);
  Result<std::unique_ptr<DrivenEpisode>> opened(const DriveAsk& ask);
  Result<episodes::EpisodeSpec> spec_of(const DriveAsk& ask,
                                        std::shared_ptr<environments::EpisodeGround>& ground);
  void act(web::DriveVerb verb);
  void step(const robots::TeleopCommand& command, bool done);
  Result<std::string> save() const;
  void show(const ShownEpisode& episode, DriveEpisode told);
  void publish();
  void publish(const ShownEpisode& episode, std::span<const double> openings);
  double speed_now(Clock::time_point now);
  void fail(const Error& error);

  Result<web::HttpReply> picture(const web::HttpAsk& ask);
  Result<web::HttpReply> shape(const web::HttpAsk& ask,
                               const std::string& rows,
                               const std::string& name);

  DriveGround ground_;
  bool offers_ = false;
  DrivePages pages_;
  std::shared_ptr<environments::EpisodeGround> drawing_;  // of the store, once one is drawn
  std::unique_ptr<DrivenEpisode> episode_;                // of the thread alone
  std::unique_ptr<ShownEpisode> watched_;                 // of who calls watch()
  std::deque<Clock::time_point> stepped_;                 // the last steps; of the thread

  std::mutex mutex_;  // of all that follows
  std::condition_variable wake_;
  bool ending_ = false;
  DriveStatus status_;
  std::optional<DriveAsk> order_;
  std::deque<web::DriveVerb> verbs_;
  robots::TeleopCommand held_;
  Clock::time_point heard_, due_, rest_until_;
  bool begun_ = false, paused_ = false, over_ = false;
  std::shared_ptr<const Shown> shown_;
  episodes::Motion now_;
  std::vector<catalog::Product> products_;

  std::mutex taking_;
  Taker taker_;
  std::thread thread_;  // last: it uses all of this
};

}  // namespace marketgen::server
