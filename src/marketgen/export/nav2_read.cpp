#include "export/nav2_read.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "export/exporter.h"
#include "io/file.h"

namespace marketgen::exporters {
namespace {
using Json = nlohmann::json;

// A value is JSON, or else a plain word.
Json value_of(const std::string& text) {
  Json value = Json::parse(text, nullptr, false);
  return value.is_discarded() ? Json(text) : value;
}

struct YamlLine {
  int number = 0;
  std::size_t indent = 0;
  std::string text;  // without indent
};

// Lines that say something. A file that lacks its last line break is cut off.
Result<std::vector<YamlLine>> lines_of(const std::filesystem::path& file) {
  MARKETGEN_TRY(const std::string bytes, io::read_file(file));
  if (!bytes.ends_with('\n')) return mismatch(file.string(), "its last line is cut off");
  std::vector<YamlLine> lines;
  int number = 0;
  for (const std::string& line : split(bytes, '\n')) {
    ++number;
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos || line[indent] == '#') continue;
    lines.push_back({number, indent, line.substr(indent)});
  }
  return lines;
}

std::string place(const std::filesystem::path& file, const YamlLine& line) {
  return file.string() + ":" + std::to_string(line.number);
}

// "key: value", the key plain or in quotes; the value may be missing.
Result<std::pair<std::string, std::string>> entry_of(const std::filesystem::path& file,
                                                     const YamlLine& line) {
  std::size_t colon = line.text.find(':');
  if (line.text.starts_with('"')) {
    std::size_t end = 1;
    while (end < line.text.size() && line.text[end] != '"')
      end += line.text[end] == '\\' ? 2 : 1;
    colon = end + 1;
  }
  if (colon >= line.text.size() || line.text[colon] != ':')
    return mismatch(place(file, line), "\"" + line.text + "\" is no \"key: value\"");
  const Json key = value_of(line.text.substr(0, colon));
  if (!key.is_string()) return mismatch(place(file, line), "its key is no text");
  const std::size_t value = line.text.find_first_not_of(' ', colon + 1);
  return std::pair{key.get<std::string>(),
                   value == std::string::npos ? std::string() : line.text.substr(value)};
}

using FlatYaml = std::map<std::string, Json>;

Result<FlatYaml> read_flat(const std::filesystem::path& file) {
  MARKETGEN_TRY(const std::vector<YamlLine> lines, lines_of(file));
  FlatYaml values;
  for (const YamlLine& line : lines) {
    MARKETGEN_TRY(const auto entry, entry_of(file, line));
    if (line.indent > 0 || !values.emplace(entry.first, value_of(entry.second)).second)
      return mismatch(place(file, line), "\"" + entry.first + "\" stands where it cannot");
  }
  return values;
}

Result<double> number_in(const FlatYaml& values, const std::string& key, const std::string& where) {
  const auto found = values.find(key);
  if (found == values.end() || !found->second.is_number())
    return mismatch(where, "it has no number \"" + key + "\"");
  return found->second.get<double>();
}

Result<std::array<double, 3>> origin_in(const FlatYaml& values, const std::string& where) {
  const auto found = values.find("origin");
  if (found == values.end() || !found->second.is_array() || found->second.size() != 3)
    return mismatch(where, "it has no \"origin\" of three numbers");
  std::array<double, 3> origin{};
  for (std::size_t i = 0; i < origin.size(); ++i) {
    if (!found->second[i].is_number()) return mismatch(where, "its \"origin\" is no pose");
    origin[i] = found->second[i].get<double>();
  }
  return origin;
}

// Netpbm's P5 with a byte a pixel (netpbm.sourceforge.net/doc/pgm.html).
struct Picture {
  int columns = 0, rows = 0;
  std::string shades;  // from the top left
};

Result<Picture> read_pgm(const std::filesystem::path& file) {
  MARKETGEN_TRY(std::string bytes, io::read_file(file));
  if (!bytes.starts_with("P5")) return mismatch(file.string(), "it is no PGM (P5)");
  std::array<int, 3> numbers{};  // columns, rows, greatest shade
  const char* at = bytes.data() + 2;
  const char* const end = bytes.data() + bytes.size();
  for (int& number : numbers) {
    while (at != end && (*at == ' ' || *at == '\n'))
      ++at;
    const auto [next, failed] = std::from_chars(at, end, number);
    if (failed != std::errc() || number < 1 || number > 1'000'000)
      return mismatch(file.string(), "its header is no PGM's");
    at = next;
  }
  if (at != end) ++at;  // the one blank behind the header
  const auto cells = static_cast<std::size_t>(numbers[0]) * static_cast<std::size_t>(numbers[1]);
  if (numbers[2] != 255 || static_cast<std::size_t>(end - at) != cells)
    return mismatch(file.string(), "it has not as many pixels as its header says");
  return Picture{numbers[0], numbers[1], std::string(at, end)};
}

struct Thresholds {
  bool scale;
  double free, occupied;
};

std::int8_t value_of_shade(unsigned char shade, const Thresholds& thresholds) {
  const double occupied = 1 - shade / 255.0;
  if (thresholds.occupied < occupied) return 100;
  if (occupied < thresholds.free) return 0;
  if (!thresholds.scale) return -1;
  return static_cast<std::int8_t>(
      std::rint((occupied - thresholds.free) / (thresholds.occupied - thresholds.free) * 100));
}

Result<Thresholds> thresholds_in(const FlatYaml& values, const std::string& where) {
  const auto mode = values.find("mode");
  const Json name = mode == values.end() ? Json("trinary") : mode->second;
  if (name != "trinary" && name != "scale") return mismatch(where, "it has another \"mode\"");
  MARKETGEN_TRY(const double negate, number_in(values, "negate", where));
  if (negate != 0) return mismatch(where, "its shades are negated");
  Thresholds thresholds{name == "scale", 0, 0};
  MARKETGEN_TRY(thresholds.free, number_in(values, "free_thresh", where));
  MARKETGEN_TRY(thresholds.occupied, number_in(values, "occupied_thresh", where));
  return thresholds;
}

Result<std::vector<std::string>> texts_in(const Json& list, const std::string& where) {
  std::vector<std::string> texts;
  if (!list.is_array()) return mismatch(where, "a list is missing");
  for (const Json& text : list) {
    if (!text.is_string()) return mismatch(where, "a list holds something else than names");
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

Result<ReadWaypoint> waypoint_in(const std::string& text, const std::string& where) {
  const Json row = Json::parse(text, nullptr, false);
  ReadWaypoint read;
  const auto is_text = [&](const char* key) { return row.contains(key) && row[key].is_string(); };
  const auto is_number = [&](const char* key) { return row.contains(key) && row[key].is_number(); };
  if (!row.is_object() || !is_text("name") || !is_text("kind") || !is_number("x") ||
      !is_number("y") || !is_number("yaw"))
    return mismatch(where, "it is no waypoint");
  read.name = row["name"].get<std::string>(), read.kind = row["kind"].get<std::string>();
  read.x = row["x"].get<double>(), read.y = row["y"].get<double>();
  read.yaw = row["yaw"].get<double>();
  if (is_text("fixture")) read.fixture = row["fixture"].get<std::string>();
  if (row.contains("categories")) {
    MARKETGEN_TRY(read.categories, texts_in(row["categories"], where));
  }
  return read;
}

}  // namespace

std::size_t ReadMap::cell_at(double x_m, double y_m) const {
  const double column = std::floor((x_m - origin[0]) / resolution_m);
  const double row = std::floor((y_m - origin[1]) / resolution_m);
  if (column < 0 || row < 0 || column >= columns || row >= rows) return values.size();
  return index(static_cast<int>(column), static_cast<int>(row));
}

PointMm ReadMap::center(int column, int row) const {
  return floor_mm(Vec2{x_of(column), y_of(row)});
}

std::string ReadMap::in_words(int column, int row) const {
  return fmt::format("the cell at {:.3f}, {:.3f} m", x_of(column), y_of(row));
}

Result<std::filesystem::path> image_named_in(const std::filesystem::path& yaml) {
  MARKETGEN_TRY(const FlatYaml values, read_flat(yaml));
  const auto image = values.find("image");
  if (image == values.end() || !image->second.is_string())
    return mismatch(yaml.string(), "it names no \"image\"");
  return yaml.parent_path() / image->second.get<std::string>();
}

Result<std::vector<std::string>> masks_named_in(const std::filesystem::path& yaml) {
  MARKETGEN_TRY(const std::vector<YamlLine> lines, lines_of(yaml));
  std::vector<std::string> masks;
  for (const YamlLine& line : lines) {
    if (!line.text.starts_with("yaml_filename:")) continue;
    MARKETGEN_TRY(const auto entry, entry_of(yaml, line));
    const Json mask = value_of(entry.second);
    if (!mask.is_string()) return mismatch(place(yaml, line), "it names no map");
    masks.push_back(mask.get<std::string>());
  }
  return masks;
}

Result<ReadMap> read_nav2_map(const std::filesystem::path& yaml) {
  const std::string where = yaml.string();
  MARKETGEN_TRY(const FlatYaml values, read_flat(yaml));
  MARKETGEN_TRY(const std::filesystem::path image, image_named_in(yaml));
  MARKETGEN_TRY(const Thresholds thresholds, thresholds_in(values, where));
  ReadMap map;
  MARKETGEN_TRY(map.resolution_m, number_in(values, "resolution", where));
  MARKETGEN_TRY(map.origin, origin_in(values, where));
  if (!(map.resolution_m > 0)) return mismatch(where, "its cells have no size");
  MARKETGEN_TRY(const Picture picture, read_pgm(image));
  map.columns = picture.columns, map.rows = picture.rows;
  map.values.reserve(picture.shades.size());
  for (int row = map.rows - 1; row >= 0; --row) {
    const std::size_t from = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns);
    for (int column = 0; column < map.columns; ++column)
      map.values.push_back(value_of_shade(
          static_cast<unsigned char>(picture.shades[from + static_cast<std::size_t>(column)]),
          thresholds));
  }
  return map;
}

Result<ReadWaypoints> read_nav2_waypoints(const std::filesystem::path& yaml) {
  MARKETGEN_TRY(const std::vector<YamlLine> lines, lines_of(yaml));
  ReadWaypoints read;
  std::string part;  // the key without a value that came last
  for (const YamlLine& line : lines) {
    const std::string where = place(yaml, line);
    if (part == "waypoints" && line.indent > 0 && line.text.starts_with("- ")) {
      MARKETGEN_TRY(ReadWaypoint waypoint, waypoint_in(line.text.substr(2), where));
      read.places.push_back(std::move(waypoint));
      continue;
    }
    MARKETGEN_TRY(const auto entry, entry_of(yaml, line));
    const auto& [key, text] = entry;
    if (line.indent > 0 && part == "categories") {
      MARKETGEN_TRY(read.by_category[key], texts_in(value_of(text), where));
    } else if (line.indent == 0 && key == "robot_radius" && value_of(text).is_number()) {
      read.robot_radius = value_of(text).get<double>();
    } else if (line.indent == 0 && key == "unreachable") {
      MARKETGEN_TRY(read.unreachable, texts_in(value_of(text), where));
    } else if (line.indent > 0 || (key == "frame_id" && text != "map")) {
      return mismatch(where, "\"" + key + "\" stands where it cannot");
    }
    part = key;
    if (line.indent > 0) part = "categories";
  }
  return read;
}

}  // namespace marketgen::exporters
