#include "intake/drawn_shell.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/floor_plan.h"
#include "intake/offline_planner.h"
#include "intake/photo_wishes.h"
#include "intake/store_program.h"
#include "intake/store_size.h"
#include "io/file.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

constexpr double same_size = 0.02;  // sizes are said in rounded numbers

struct SaidSize {
  double width_mm = 0, depth_mm = 0;  // 0: not said
  double area_m2 = 0;
  std::string text;
};

SaidSize said_size(const Brief& brief, const Understanding& found) {
  if (brief.size_mm) {
    const auto [width, depth] = *brief.size_mm;
    return {static_cast<double>(width),
            static_cast<double>(depth),
            0,
            "--size " + metres(width) + " x " + metres(depth) + " m"};
  }
  if (const plan::Requirement* size = found.find(Kind::size))
    return {size->value, size->second_value, 0, size->text};
  for (const plan::Requirement& wish : found.requirements) {
    const bool whole = wish.kind == Kind::area && wish.subject.empty() &&
                       wish.comparison != plan::Comparison::at_least &&
                       wish.comparison != plan::Comparison::at_most;
    if (whole) return {0, 0, wish.value, wish.text};
  }
  return {};
}

// How much wider and deeper the drawing must be.
std::array<double, 2> stretch_of(const SaidSize& said, const plan::Shell& drawn) {
  const double x = said.width_mm / drawn.width_mm, y = said.depth_mm / drawn.depth_mm;
  if (x > 0 && y > 0) return {x, y};
  if (x > 0 || y > 0) return {x + y, x + y};
  const double both =
      said.area_m2 > 0 ? std::sqrt(said.area_m2 / area_m2(plan::floor_of(drawn))) : 1;
  return {both, both};
}

int stretched(int mm, double by) {
  return static_cast<int>(std::lround(mm * by));
}

void stretch(plan::Shell& shell, std::array<double, 2> by) {
  shell.width_mm = stretched(shell.width_mm, by[0]);
  shell.depth_mm = stretched(shell.depth_mm, by[1]);
  if (shell.outline_mm) {
    for (PointMm& p : *shell.outline_mm)
      p = {stretched(p[0], by[0]), stretched(p[1], by[1])};
  }
  for (plan::Column& column : shell.columns) {
    column.x_mm = stretched(column.x_mm, by[0]);
    column.y_mm = stretched(column.y_mm, by[1]);
  }
  for (plan::Opening& opening :
       shell.openings) {  // doors keep their width where the wall allows it
    constexpr int min_mm = 600;
    const bool along_x = opening.wall == plan::Wall::south || opening.wall == plan::Wall::north;
    const double least = std::min(1.0, along_x ? by[0] : by[1]);
    opening.width_mm = std::max(min_mm, stretched(opening.width_mm, least));
  }
}

// The picture that is a drawing of zones: the first one that is no photo.
std::string zone_drawing_of(const Brief& brief) {
  const auto is_drawing = [&](const std::string& file) {
    return std::ranges::find(brief.photos, file, &photo::PhotoReading::file) == brief.photos.end();
  };
  const auto file = std::ranges::find_if(brief.image_files, is_drawing);
  return file == brief.image_files.end() ? "drawing" : *file;
}

// Whose walls and doors the shell has, for a person.
std::string drawing_of(const Brief& brief) {
  return brief.floor_plan.value_or(zone_drawing_of(brief));
}

void settle_size(const Brief& brief, plan::Shell& shell, Understanding& found) {
  const SaidSize said = said_size(brief, found);
  const std::array<double, 2> by = stretch_of(said, shell);
  if (std::abs(by[0] - 1) <= same_size && std::abs(by[1] - 1) <= same_size) return;
  found.conflicts.push_back(
      {"size",
       said.text,
       drawing_of(brief) + ": " + metres(shell.width_mm) + " x " + metres(shell.depth_mm) + " m",
       brief.size_mm ? "a flag wins over a drawing; it is stretched"
                     : "words win over a drawing; it is stretched"});
  stretch(shell, by);
}

// The first opening of that kind; end() when there is none.
auto first_of(plan::Shell& shell, plan::OpeningKind kind) {
  return std::ranges::find(shell.openings, kind, &plan::Opening::kind);
}

// A door of this kind that is said to be in another wall.
void settle_door(const Brief& brief,
                 plan::Shell& shell,
                 Understanding& found,
                 plan::OpeningKind kind) {
  for (const plan::Requirement& wish : found.requirements) {
    if (wish.kind != Kind::opening || wish.subject != name_of(kind)) continue;
    const auto wall = value_named<plan::Wall>(wish.object);
    const auto drawn = first_of(shell, kind);
    if (!wall || drawn == shell.openings.end() || drawn->wall == *wall) continue;
    const auto there = std::ranges::find_if(shell.openings, [&](const plan::Opening& other) {
      return other.wall == *wall && other.kind != plan::OpeningKind::window;
    });
    found.conflicts.push_back(
        {"opening " + wish.subject,
         wish.text,
         drawing_of(brief) + ": in the " + std::string(name_of(drawn->wall)) + " wall",
         there != shell.openings.end()
             ? "words win over a drawing; it is another of the drawn doors"
             : "words win over a drawing, which has no door in that wall"});
    if (there != shell.openings.end()) {
      std::swap(there->kind, drawn->kind);
      std::swap(there->id, drawn->id);
    } else {
      std::erase_if(shell.openings, [&](const plan::Opening& one) { return one.kind == kind; });
    }
    return;
  }
}

// Entrances and exits first, as plans have them.
void sort_openings(plan::Shell& shell) {
  std::ranges::stable_sort(shell.openings, {}, [](const plan::Opening& opening) {
    return static_cast<int>(opening.kind);
  });
}

// What the words say of the size of the shop.
Result<drawing::ReadOptions> size_in_words(const Brief& brief, const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const Language language, Language::load(data));
  const Understanding found = understand(brief.prompt, language.with_words_of(catalog), catalog);
  drawing::ReadOptions options;
  if (const plan::Requirement* size = found.find(Kind::size)) {
    options.width_mm = size->value;
    options.depth_mm = size->second_value;
  }
  return options;
}

void add_warnings(std::vector<std::string>& all,
                  const std::string& file,
                  const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    all.push_back(fmt::format("{}: {}", file, warning));
}

// The zones of a picture, and the brief's shell where no floor plan gives one.
Result<void> read_zones(const std::string& file,
                        Brief& brief,
                        const catalog::Catalog& catalog,
                        std::vector<std::string>& warnings) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const Language loaded, Language::load(data));
  const Language language = loaded.with_words_of(catalog);
  Understanding found = understand(brief.prompt, language, catalog);
  apply_photos(brief, catalog, found);
  drawing::ReadOptions options;
  if (brief.size_mm) {
    options.width_mm = (*brief.size_mm)[0];
    options.depth_mm = (*brief.size_mm)[1];
  } else if (const plan::Requirement* size = found.find(Kind::size)) {
    options.width_mm = size->value;
    options.depth_mm = size->second_value;
  }
  const catalog::ProfileRow& profile = profile_of(brief, found, catalog);
  options.usual_area_m2 =
      1e-6 * profile.default_size_mm[0] * profile.default_size_mm[1] * found.size_factor;
  MARKETGEN_TRY(drawing::ZoneDrawing read, drawing::read_zone_drawing(file, options));
  DrawnZones zones = named_by_words(read, language, catalog, profile.zones);
  if (zones.types.empty())
    return Error{"drawing.no_zones",
                 file,
                 "nothing written on it names a zone of a shop; write on each zone what it is, as "
                 "in \"bakery\""};
  add_warnings(warnings, file, read.warnings);
  add_warnings(warnings, file, read.floor.warnings);
  add_warnings(warnings, file, zones.warnings);
  if (read.scale_is_guessed)
    add_warnings(
        warnings,
        file,
        {"nothing says how large it is, so it is as large as such shops are; give its size"});
  brief.zones = std::move(zones);
  if (brief.floor_plan || brief.shell) return {};
  brief.shell = std::move(read.floor.shell);
  brief.shell_confidence = read.floor.outline_confidence;
  return {};
}

// What the pictures of a brief are, at first sight.
struct Pictures {
  std::vector<std::string> drawings;          // of zones; what no photo can be is one, too
  std::vector<photo::PhotoReading> doubtful;  // photos, unless they can be read as drawings
};

// Puts what is surely a photo of a shop among the brief's photos.
Result<Pictures> sorted_pictures(Brief& brief) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const photo::Bank bank, photo::load_bank(data));
  Pictures pictures;
  for (const std::string& file : brief.image_files) {
    Result<photo::PhotoReading> read = photo::read_photo(file, bank);
    if (!read.ok() || read->subject == "drawing") {  // whose reader says what is wrong with it
      pictures.drawings.push_back(file);
      continue;
    }
    const bool surely_room = read->subject == "room" && read->subject_confidence >= photo::sure;
    (surely_room ? brief.photos : pictures.doubtful).push_back(std::move(*read));
  }
  return pictures;
}

// What no drawing was read from is a photo of a shop, or nothing that helps.
Result<void> take_photo(photo::PhotoReading photo, Brief& brief) {
  if (photo.subject == "other" && photo.subject_confidence >= photo::sure)
    return Error{"photo.not_a_shop",
                 photo.file,
                 "this looks like neither a photo of a shop nor a drawing of zones; take the photo "
                 "at eye level along an aisle, with floor and ceiling in it, or draw the walls and "
                 "write a name on each zone"};
  brief.photos.push_back(std::move(photo));
  return {};
}

void warn_of_doubts(const Brief& brief, std::vector<std::string>& warnings) {
  for (const photo::PhotoReading& photo : brief.photos) {
    const std::string doubtful = not_sure_of(photo);
    if (!doubtful.empty()) add_warnings(warnings, photo.file, {"not sure of " + doubtful});
  }
}

// In the order of --image, whatever was found out first.
void sort_photos(Brief& brief) {
  std::ranges::stable_sort(brief.photos, {}, [&](const photo::PhotoReading& photo) {
    return std::ranges::find(brief.image_files, photo.file) - brief.image_files.begin();
  });
}

Result<void> read_pictures(Brief& brief,
                           const catalog::Catalog& catalog,
                           std::vector<std::string>& warnings) {
  MARKETGEN_TRY(Pictures pictures, sorted_pictures(brief));
  if (pictures.drawings.size() > 1)
    return Error{"usage.bad_flag",
                 "--image " + pictures.drawings[1],
                 "a store has one drawing of zones; give one, and photos of shops beside it"};
  for (const std::string& file : pictures.drawings)
    MARKETGEN_CHECK(read_zones(file, brief, catalog, warnings));
  for (photo::PhotoReading& photo : pictures.doubtful) {
    if (brief.zones) {
      MARKETGEN_CHECK(take_photo(std::move(photo), brief));
      continue;
    }
    const Result<void> drawn = read_zones(photo.file, brief, catalog, warnings);
    if (!drawn.ok() && drawn.error().code == "drawing.chart") return drawn.error();
    if (!drawn.ok()) MARKETGEN_CHECK(take_photo(std::move(photo), brief));
  }
  sort_photos(brief);
  warn_of_doubts(brief, warnings);
  return {};
}

}  // namespace

Result<Drawn> with_drawing(Brief brief, const catalog::Catalog& catalog) {
  Drawn drawn;
  const bool unread = !brief.zones && brief.photos.empty();
  if (!brief.image_files.empty() && unread) {
    MARKETGEN_CHECK(read_pictures(brief, catalog, drawn.warnings));
  }
  if (!brief.floor_plan || brief.shell) {
    drawn.brief = std::move(brief);
    return drawn;
  }
  drawing::ReadOptions options;
  if (brief.floor_plan_scale) {
    MARKETGEN_TRY(options.scale,
                  drawing::parse_scale(*brief.floor_plan_scale, "--floor-plan-scale"));
  }
  if (brief.size_mm) {
    options.width_mm = (*brief.size_mm)[0];
    options.depth_mm = (*brief.size_mm)[1];
  }
  Result<drawing::FloorPlan> read = drawing::read_floor_plan(*brief.floor_plan, options);
  const bool unscaled = !read.ok() && read.error().code == "drawing.no_scale" && !options.scale;
  if (unscaled && !brief.size_mm) {
    MARKETGEN_TRY(const drawing::ReadOptions said, size_in_words(brief, catalog));
    if (said.width_mm > 0 || said.depth_mm > 0)
      read = drawing::read_floor_plan(*brief.floor_plan, said);
  }
  MARKETGEN_TRY(drawing::FloorPlan plan, std::move(read));
  add_warnings(drawn.warnings, *brief.floor_plan, plan.warnings);
  brief.shell = std::move(plan.shell);
  brief.shell_confidence = plan.outline_confidence;
  drawn.brief = std::move(brief);
  return drawn;
}

plan::Shell settled_shell(const Brief& brief, Understanding& found) {
  plan::Shell shell = *brief.shell;
  settle_size(brief, shell, found);
  settle_door(brief, shell, found, plan::OpeningKind::entrance);
  settle_door(brief, shell, found, plan::OpeningKind::exit);
  sort_openings(shell);
  const auto entrance = first_of(shell, plan::OpeningKind::entrance);
  if (entrance != shell.openings.end()) found.drawn_front = entrance->wall;
  return shell;
}

}  // namespace marketgen::intake
