#include "evaluation/film.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "episodes/track_view.h"
#include "io/file.h"
#include "io/json.h"
#include "io/picture_file.h"
#include "io/png.h"
#include "io/program.h"
#include "render/picture_grid.h"

namespace marketgen::evaluation {
namespace {

constexpr double longest_encoding_s = 600;

struct FilmRequest {
  std::string folder, film;
  int pictures = 0;
  double frame_rate = 20;
  static constexpr auto fields =
      field_list(field("folder", &FilmRequest::folder, "of 000000.png and so on"),
                 field("film", &FilmRequest::film, "MP4 file to write"),
                 field("pictures", &FilmRequest::pictures, "how many"),
                 field("frame_rate", &FilmRequest::frame_rate, "pictures a second"));
};

// The largest square in its middle.
Image middle_square(const Image& whole) {
  const int side = std::min(whole.width, whole.height);
  const int x0 = (whole.width - side) / 2, y0 = (whole.height - side) / 2;
  Image square(side, side, whole.channels);
  for (int y = 0; y < side; ++y)
    std::copy_n(
        whole.at(x0, y0 + y), static_cast<std::size_t>(side * whole.channels), square.at(0, y));
  return square;
}

Result<void> checked(const Result<std::string>& part) {
  return part.ok() ? Result<void>{} : Result<void>{part.error()};
}

std::filesystem::path picture_file(const std::filesystem::path& folder, std::size_t number) {
  return folder / fmt::format("{:06}.png", number);
}

}  // namespace

Result<std::unique_ptr<Film>> Film::begin(const episodes::TrackWorld& world,
                                          const FilmOptions& options) {
  if (!options.film.empty()) MARKETGEN_CHECK(checked(io::worker_part("av")));
  std::unique_ptr<Film> film(new Film);
  film->world_ = &world;
  film->options_ = options;
  MARKETGEN_TRY(film->view_, world.open_view());
  MARKETGEN_TRY(io::ScratchFolder scratch, io::ScratchFolder::make("film"));
  film->scratch_.emplace(std::move(scratch));
  MARKETGEN_CHECK(film->look());
  return film;
}

Result<void> Film::look() {
  const double due_s = static_cast<double>(pictures_) * options_.every_s;
  if (world_->time_s() + 1e-9 < due_s) return {};
  MARKETGEN_CHECK(view_->follow());
  MARKETGEN_TRY(const render::Camera camera,
                view_->camera(episodes::film_camera_name, options_.width, options_.height));
  render::RenderOptions quality;
  quality.quality = render::Quality::balanced;
  MARKETGEN_TRY(const render::Frame frame, view_->renderer().render(camera, quality));
  MARKETGEN_TRY(const std::string bytes, io::encode_png(frame.color));
  const std::filesystem::path file = picture_file(scratch_->path(), pictures_++);
  return io::write_new(file, bytes, io::Durable::no, file);
}

Result<void> Film::write_film(io::Outputs& outputs) const {
  const std::filesystem::path draft = scratch_->path() / "film.mp4";
  MARKETGEN_CHECK(io::run_worker("film",
                                 io::write_json_line(FilmRequest{scratch_->path().string(),
                                                                 draft.string(),
                                                                 static_cast<int>(pictures_),
                                                                 options_.frame_rate}),
                                 longest_encoding_s));
  MARKETGEN_TRY(const std::string bytes, io::read_file(draft));
  return outputs.put(options_.film, bytes);
}

Result<void> Film::write_strip(io::Outputs& outputs) const {
  const std::size_t count = std::min(options_.strip_pictures, pictures_);
  MARKETGEN_TRY(const Image strip,
                render::picture_grid(count, options_.height, [&](std::size_t i) -> Result<Image> {
                  const std::size_t at = count < 2 ? 0 : i * (pictures_ - 1) / (count - 1);
                  MARKETGEN_TRY(const Image whole,
                                io::read_png(picture_file(scratch_->path(), at)));
                  return middle_square(whole);
                }));
  return outputs.put(options_.strip,
                     [&](const auto& file) { return io::write_picture(file, strip); });
}

Result<void> Film::finish(io::Outputs& outputs) {
  if (!options_.strip.empty()) MARKETGEN_CHECK(write_strip(outputs));
  return options_.film.empty() ? Result<void>{} : write_film(outputs);
}

}  // namespace marketgen::evaluation
