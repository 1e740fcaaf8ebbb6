#include "intake/drawn_shell.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/floor_plan.h"
#include "intake/offline_planner.h"
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
    constexpr int least_mm = 600;
    const bool along_x = opening.wall == plan::Wall::south || opening.wall == plan::Wall::north;
    const double least = std::min(1.0, along_x ? by[0] : by[1]);
    opening.width_mm = std::max(least_mm, stretched(opening.width_mm, least));
  }
}

// Whose walls and doors the shell has, for a person.
std::string drawing_of(const Brief& brief) {
  return brief.floor_plan.value_or(brief.image_files.empty() ? "drawing" : brief.image_files[0]);
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

// The zones of the brief's picture, and its shell where no floor plan gives one.
Result<void> read_zones(Brief& brief,
                        const catalog::Catalog& catalog,
                        std::vector<std::string>& warnings) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const Language loaded, Language::load(data));
  const Language language = loaded.with_words_of(catalog);
  const Understanding found = understand(brief.prompt, language, catalog);
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
  MARKETGEN_TRY(drawing::ZoneDrawing read,
                drawing::read_zone_drawing(brief.image_files[0], options));
  brief.zones = named_by_words(read, language, catalog, profile.zones);
  if (brief.zones->types.empty())
    return Error{"drawing.no_zones",
                 brief.image_files[0],
                 "nothing written on it names a zone of a shop; write on each zone what it is, as "
                 "in \"bakery\" (reference photos are not read yet)"};
  add_warnings(warnings, brief.image_files[0], read.warnings);
  add_warnings(warnings, brief.image_files[0], read.floor.warnings);
  add_warnings(warnings, brief.image_files[0], brief.zones->warnings);
  if (read.scale_is_guessed)
    add_warnings(
        warnings,
        brief.image_files[0],
        {"nothing says how large it is, so it is as large as such shops are; give its size"});
  if (brief.floor_plan || brief.shell) return {};
  brief.shell = std::move(read.floor.shell);
  brief.shell_confidence = read.floor.outline_confidence;
  return {};
}

}  // namespace

Result<Drawn> with_drawing(Brief brief, const catalog::Catalog& catalog) {
  Drawn drawn;
  if (brief.image_files.size() > 1) {
    return Error{"usage.bad_flag",
                 "--image " + brief.image_files[1],
                 "a store has one drawing of zones; give one --image"};
  }
  if (!brief.image_files.empty() && !brief.zones) {
    MARKETGEN_CHECK(read_zones(brief, catalog, drawn.warnings));
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
