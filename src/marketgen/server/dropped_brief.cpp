#include "server/dropped_brief.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "io/file.h"
#include "io/scratch_folder.h"
#include "net/http.h"
#include "web/folder_name.h"

namespace marketgen::server {
namespace {

// Each in a folder of its own, so that two may be called alike.
class DroppedFiles {
 public:
  explicit DroppedFiles(io::ScratchFolder folder) : folder_(std::move(folder)) {}

  Result<std::string> write(const DroppedFile& file) {
    MARKETGEN_CHECK(web::check_folder_name(file.name));
    MARKETGEN_TRY(const std::string bytes, net::bytes_of_base64(file.base64, file.name));
    const std::filesystem::path own = folder_.path() / fmt::format("{}", names_.size());
    std::error_code failed;
    std::filesystem::create_directory(own, failed);
    if (failed) return Error{"io.cannot_write", own.string(), failed.message()};
    const std::filesystem::path place = own / file.name;
    MARKETGEN_CHECK(io::write_file(place, bytes));
    names_.emplace_back(place.string(), file.name);
    return place.string();
  }

  // A text that names files by where they were for a moment.
  std::string by_name(std::string text) const {
    for (const auto& [place, name] : names_)
      for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place))
        text.replace(at, place.size(), name);
    return text;
  }

 private:
  io::ScratchFolder folder_;
  std::vector<std::pair<std::string, std::string>> names_;  // place, as it was called
};

Result<intake::Brief> plain_brief(const TryAsk& ask) {
  intake::Brief brief;
  brief.prompt = ask.words;
  if (!ask.size.empty()) {
    MARKETGEN_TRY(brief.size_mm, intake::parse_size(ask.size, "size"));
  }
  if (!ask.profile.empty()) brief.profile = ask.profile;
  if (!ask.style.empty()) brief.style = ask.style;
  return brief;
}

Result<intake::Drawn> read_drawn(const TryAsk& ask,
                                 intake::Brief brief,
                                 DroppedFiles& files,
                                 const catalog::Catalog& catalog) {
  if (ask.floor_plan) {
    MARKETGEN_TRY(brief.floor_plan, files.write(*ask.floor_plan));
    if (!ask.floor_plan_scale.empty()) brief.floor_plan_scale = ask.floor_plan_scale;
  }
  for (const DroppedFile& image : ask.images) {
    MARKETGEN_TRY(std::string place, files.write(image));
    brief.image_files.push_back(std::move(place));
  }
  return intake::with_drawing(std::move(brief), catalog);
}

}  // namespace

Result<intake::Drawn> brief_asked(const TryAsk& ask, const catalog::Catalog& catalog) {
  MARKETGEN_TRY(intake::Brief brief, plain_brief(ask));
  if (!ask.floor_plan && ask.images.empty()) return intake::with_drawing(std::move(brief), catalog);
  MARKETGEN_TRY(io::ScratchFolder folder, io::ScratchFolder::make("dropped"));
  DroppedFiles files(std::move(folder));
  Result<intake::Drawn> drawn = read_drawn(ask, std::move(brief), files, catalog);
  if (!drawn.ok()) {
    Error error = drawn.error();
    error.where = files.by_name(error.where);
    error.message = files.by_name(error.message);
    return error;
  }
  if (drawn->brief.floor_plan) drawn->brief.floor_plan = files.by_name(*drawn->brief.floor_plan);
  for (std::string& file : drawn->brief.image_files)
    file = files.by_name(file);
  for (photo::PhotoReading& photo : drawn->brief.photos)
    photo.file = files.by_name(photo.file);
  for (std::string& warning : drawn->warnings)
    warning = files.by_name(warning);
  return drawn;
}

}  // namespace marketgen::server
