#include "server/dropped_brief.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "assets/usable_catalog.h"
#include "io/file.h"
#include "io/scratch_folder.h"
#include "net/http.h"
#include "plan/store_time.h"
#include "plan/vary.h"
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
  if (!ask.country.empty()) brief.country = ask.country;
  if (!ask.skin.empty()) brief.skin = ask.skin;
  if (!ask.planner.empty()) brief.planner = ask.planner;
  if (!ask.time.empty()) {
    MARKETGEN_CHECK(plan::parse_store_time(ask.time, "brief.bad_time", "time"));
    brief.time = ask.time;
  }
  for (const std::string& axis : ask.vary) {
    if (!brief.vary) brief.vary.emplace();
    MARKETGEN_CHECK(plan::add_vary(*brief.vary, axis, "brief.bad_vary", "vary"));
  }
  return brief;
}

Result<std::shared_ptr<const catalog::Catalog>> with_own(
    const TryAsk& ask, DroppedFiles& files, std::shared_ptr<const catalog::Catalog> catalog) {
  if (ask.catalogs.empty()) return catalog;
  std::vector<std::filesystem::path> own;
  for (const DroppedFile& file : ask.catalogs) {
    MARKETGEN_TRY(own.emplace_back(), files.write(file));
  }
  MARKETGEN_TRY(catalog::Catalog rows, assets::usable_catalog(own));
  return std::make_shared<const catalog::Catalog>(std::move(rows));
}

Result<AskedStore> read_dropped(const TryAsk& ask,
                                intake::Brief brief,
                                DroppedFiles& files,
                                std::shared_ptr<const catalog::Catalog> catalog) {
  MARKETGEN_TRY(catalog, with_own(ask, files, std::move(catalog)));
  if (ask.floor_plan) {
    MARKETGEN_TRY(brief.floor_plan, files.write(*ask.floor_plan));
    if (!ask.floor_plan_scale.empty()) brief.floor_plan_scale = ask.floor_plan_scale;
  }
  for (const DroppedFile& image : ask.images) {
    MARKETGEN_TRY(std::string place, files.write(image));
    brief.image_files.push_back(std::move(place));
  }
  MARKETGEN_TRY(intake::Drawn drawn, intake::with_drawing(std::move(brief), *catalog));
  return AskedStore{std::move(drawn), std::move(catalog)};
}

void name_as_called(intake::Drawn& drawn, const DroppedFiles& files) {
  if (drawn.brief.floor_plan) drawn.brief.floor_plan = files.by_name(*drawn.brief.floor_plan);
  for (std::string& file : drawn.brief.image_files)
    file = files.by_name(file);
  for (photo::PhotoReading& photo : drawn.brief.photos)
    photo.file = files.by_name(photo.file);
  for (std::string& warning : drawn.warnings)
    warning = files.by_name(warning);
}

}  // namespace

Result<AskedStore> store_asked(const TryAsk& ask, std::shared_ptr<const catalog::Catalog> catalog) {
  MARKETGEN_TRY(intake::Brief brief, plain_brief(ask));
  MARKETGEN_TRY(io::ScratchFolder folder, io::ScratchFolder::make("dropped"));
  DroppedFiles files(std::move(folder));
  Result<AskedStore> asked = read_dropped(ask, std::move(brief), files, std::move(catalog));
  if (!asked.ok()) {
    Error error = asked.error();
    error.where = files.by_name(error.where);
    error.message = files.by_name(error.message);
    return error;
  }
  name_as_called(asked->drawn, files);
  return asked;
}

}  // namespace marketgen::server
