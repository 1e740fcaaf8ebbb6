// A film of an episode: pictures as it goes on, an MP4 file and a strip of a few of them.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "environments/run_episode.h"
#include "episodes/track_view.h"
#include "episodes/track_world.h"
#include "geometry/image.h"
#include "io/output.h"
#include "io/scratch_folder.h"

namespace marketgen::evaluation {

struct FilmOptions {
  std::filesystem::path film, strip;  // MP4 and PNG; empty: none
  int width = 640, height = 480;
  double every_s = 0.2;  // simulated, between two pictures
  double frame_rate = 20;
  std::size_t strip_pictures = 6;
};

// Pictures are kept in a scratch folder until finish(). Not thread-safe.
class Film {
 public:
  // `world` was reset and must outlive the film. Errors: those of the views;
  // usage.unavailable when Python lacks PyAV, with what to install.
  static Result<std::unique_ptr<Film>> begin(const episodes::TrackWorld& world,
                                             const FilmOptions& options);

  // To be called after every control step: takes a picture when it is time for one.
  Result<void> look();
  // Puts film and strip among `outputs`. Errors: io.*, program.failed.
  Result<void> finish(io::Outputs& outputs);

 private:
  Film() = default;
  Result<void> write_film(io::Outputs& outputs) const;
  Result<void> write_strip(io::Outputs& outputs) const;

  const episodes::TrackWorld* world_ = nullptr;
  FilmOptions options_;
  std::unique_ptr<episodes::TrackView> view_;
  std::optional<io::ScratchFolder> scratch_;  // of its pictures
  std::size_t pictures_ = 0;
};

// Films an episode as it is run.
class FilmWatcher : public environments::EpisodeWatcher {
 public:
  explicit FilmWatcher(FilmOptions options) : options_(std::move(options)) {}
  Result<void> begin(const episodes::TrackWorld& world) override {
    MARKETGEN_TRY(film_, Film::begin(world, options_));
    return {};
  }
  Result<void> step() override { return film_->look(); }
  // As Film::finish, once the episode is over.
  Result<void> finish(io::Outputs& outputs) { return film_->finish(outputs); }

 private:
  FilmOptions options_;
  std::unique_ptr<Film> film_;
};

}  // namespace marketgen::evaluation
