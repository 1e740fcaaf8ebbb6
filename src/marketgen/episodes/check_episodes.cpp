#include "episodes/check_episodes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "episodes/check_witness.h"
#include "episodes/track_entry.h"

namespace marketgen::episodes {
namespace {

constexpr double unit_tolerance = 1e-3;  // of a quaternion's length
constexpr std::size_t first_line = 2;    // of the episodes: the header is the first

using Skus = std::vector<std::string_view>;  // sorted

Error bad_value(const std::string& where, std::string message) {
  return {"episode.bad_value", where, std::move(message)};
}

Result<void> check_items(const EpisodeSpec& spec, const std::string& where) {
  for (std::size_t i = 0; i < spec.items.size(); ++i) {
    const auto& [w, x, y, z] = spec.items[i].rotation_wxyz;
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    if (std::abs(length - 1) > unit_tolerance)
      return bad_value(fmt::format("{}/items/{}/rotation_wxyz", where, i),
                       fmt::format("has the length {:.4g}; expected a unit quaternion, as 1, 0, 0, "
                                   "0 for no turn",
                                   length));
  }
  return {};
}

// In words each goal has a text.
Result<void> check_told(const EpisodeSpec& spec,
                        const EpisodeGoal& goal,
                        const std::string& where) {
  if (spec.instructions == Instructions::ids) return {};
  if (goal.text && !goal.text->empty()) return {};
  return bad_value(where + "/goals",
                   "\"" + goal.sku +
                       "\" has no text, and the instructions are in words: write one, or leave "
                       "\"instructions\" out");
}

Result<void> check_goals(const EpisodeSpec& spec, const std::string& where) {
  if (spec.goals.empty())
    return Error{"episode.impossible", where + "/goals", "asks for nothing; expected a goal"};
  std::set<std::string_view> asked;
  for (const EpisodeGoal& goal : spec.goals) {
    MARKETGEN_CHECK(check_told(spec, goal, where));
    if (!asked.insert(goal.sku).second)
      return bad_value(where + "/goals",
                       "asks twice for \"" + goal.sku + "\": make it one goal with their count");
  }
  MARKETGEN_CHECK(entry_of(spec.track).check_goals(spec, where));
  for (const CategoryPlace& place : spec.categories)
    if (!asked.contains(place.sku))
      return bad_value(where + "/categories",
                       "tells of \"" + place.sku + "\", which is no goal: leave it out");
  return {};
}

// A field that the track does not have would be passed over.
Result<void> check_fields(const EpisodeSpec& spec, const std::string& where) {
  const FloorPlaceRow& start = spec.start;
  const std::map<std::string_view, bool> said{
      {"items", !spec.items.empty()},
      {"categories", !spec.categories.empty()},
      {"station", spec.station.has_value()},
      {"lane", spec.lane.has_value()},
      {"doors", spec.doors.has_value()},
      {"start", start.x_m != 0 || start.y_m != 0 || start.heading_deg != 0}};
  const auto own = entry_of(spec.track).own_fields();
  for (const auto& [field, is_there] : said)
    if (is_there && std::ranges::find(own, field) == own.end())
      return bad_value(fmt::format("{}/{}", where, field),
                       fmt::format("episodes of the track {} have none: leave it out, or correct "
                                   "the track",
                                   name_of(spec.track)));
  return {};
}

Result<void> check_cameras(const EpisodeSpec& spec, const std::string& where) {
  const auto known = entry_of(spec.track).cameras();
  for (const std::string& camera : spec.cameras)
    if (std::ranges::find(known, camera) == known.end())
      return bad_value(where + "/cameras",
                       fmt::format("the track {} has no camera \"{}\"{}; there are: {}",
                                   name_of(spec.track),
                                   camera,
                                   did_you_mean(camera, known),
                                   fmt::join(known, ", ")));
  return {};
}

Result<void> check_sku(const Skus& known, const std::string& sku, const std::string& where) {
  if (std::ranges::binary_search(known, sku)) return {};
  return Error{"catalog.unknown_sku",
               where,
               fmt::format("the header has no product \"{}\"{}", sku, did_you_mean(sku, known))};
}

Result<Skus> known_skus(const EpisodeHeader& header, const std::string& where) {
  Skus skus;
  for (const catalog::Product& product : header.products)
    skus.push_back(product.sku);
  std::ranges::sort(skus);
  if (const auto twice = std::ranges::adjacent_find(skus); twice != skus.end())
    return Error{"catalog.duplicate_sku",
                 where + "/products",
                 fmt::format("two rows are \"{}\": remove one", *twice)};
  return skus;
}

Result<void> check_stores(const EpisodeHeader& header, const std::string& where) {
  for (std::size_t i = 0; i < header.stores.size(); ++i) {
    const EpisodeStore& store = header.stores[i];
    if (store.scene) continue;  // it is not made from the plan
    if (const std::string made = plan_hash(store.plan); made != store.plan_hash)
      return Error{"episode.other_store",
                   fmt::format("{}/stores/{}", where, i),
                   fmt::format("its plan has the hash {}, the episodes are of {}: it was changed, "
                               "or another version of marketgen wrote it; draw them again",
                               made,
                               store.plan_hash)};
  }
  return {};
}

Result<void> check_against_header(const EpisodeHeader& header,
                                  const Skus& known,
                                  const EpisodeSpec& spec,
                                  const std::string& where) {
  for (const EpisodeItem& item : spec.items)
    MARKETGEN_CHECK(check_sku(known, item.sku, where + "/items"));
  for (const EpisodeGoal& goal : spec.goals)
    MARKETGEN_CHECK(check_sku(known, goal.sku, where + "/goals"));
  const bool drawn_there = std::ranges::any_of(header.stores, [&](const EpisodeStore& store) {
    return check_store(spec, store.scene_hash, store.plan_hash).ok();
  });
  if (drawn_there) return {};
  return Error{"episode.other_store", where, "its hashes are those of no store in the header"};
}

std::string line_at(const std::string& source, std::size_t line) {
  return fmt::format("{}:{}", source, line);
}

Result<void> check_robot(const TrackRobot& row, const EpisodeSpec& spec, const std::string& where) {
  if (spec.robot != row.robot)
    return Error{
        "robot.unknown",
        where + "/robot",
        fmt::format(
            "the track {} has \"{}\", not \"{}\"", name_of(spec.track), row.robot, spec.robot)};
  if (spec.tools.empty() || std::ranges::find(row.tools, spec.tools) != row.tools.end()) return {};
  const std::vector<std::string_view> known(row.tools.begin(), row.tools.end());
  return Error{"robot.unknown",
               where + "/tools",
               fmt::format("there are no tools \"{}\"{}; there are: {}",
                           spec.tools,
                           did_you_mean(spec.tools, known),
                           fmt::join(known, ", "))};
}

}  // namespace

Result<void> check_episode(const EpisodeSpec& spec, const std::string& where) {
  MARKETGEN_CHECK(check_items(spec, where));
  MARKETGEN_CHECK(check_goals(spec, where));
  MARKETGEN_CHECK(check_fields(spec, where));
  MARKETGEN_CHECK(check_certificate(spec.certificate, where + "/certificate"));
  MARKETGEN_CHECK(check_witness(spec, where));
  return check_cameras(spec, where);
}

Result<void> check_episodes(const EpisodeFile& file, const std::string& source) {
  const std::string header = line_at(source, 1);
  MARKETGEN_TRY(const Skus known, known_skus(file.header, header));
  MARKETGEN_CHECK(check_stores(file.header, header));
  std::map<std::string_view, std::size_t> lines;  // by id
  for (std::size_t i = 0; i < file.episodes.size(); ++i) {
    const EpisodeSpec& spec = file.episodes[i];
    const std::size_t line = first_line + i;
    const std::string where = line_at(source, line);
    if (const auto [before, is_new] = lines.try_emplace(spec.id, line); !is_new)
      return Error{"episode.duplicate_id",
                   where + "/id",
                   fmt::format("line {} has \"{}\" too: give each episode an id of its own",
                               before->second,
                               spec.id)};
    MARKETGEN_CHECK(check_against_header(file.header, known, spec, where));
    MARKETGEN_CHECK(check_episode(spec, where));
    if (file.header.split == Split::certified && !spec.certificate.has(shown_in_physics))
      return bad_value(
          where + "/certificate",
          "the file is said to be certified, and this episode was not done in physics: "
          "leave the header's \"split\" out, or draw the episodes again");
  }
  return {};
}

Result<void> check_robots(const EpisodeFile& file,
                          const std::string& source,
                          const std::filesystem::path& data) {
  std::map<Track, TrackRobot> rows;
  for (std::size_t i = 0; i < file.episodes.size(); ++i) {
    const EpisodeSpec& spec = file.episodes[i];
    if (!rows.contains(spec.track)) {
      MARKETGEN_TRY(rows[spec.track], entry_of(spec.track).robot(data));
    }
    MARKETGEN_CHECK(check_robot(rows[spec.track], spec, line_at(source, first_line + i)));
  }
  return {};
}

}  // namespace marketgen::episodes
