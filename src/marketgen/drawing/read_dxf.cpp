// ASCII DXF of any release: the tags of Autodesk's DXF Reference, of which only those of lines
// count.
//
// Our own reader: the C++ libraries for DXF in Debian (dxflib, libdxfrw, LibreDWG) are under the
// GPL, and GDAL brings 54 packages with it.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "base/safe_line.h"
#include "drawing/curves.h"
#include "drawing/sketch.h"

namespace marketgen::drawing {
namespace {

constexpr double dxf_degree = std::numbers::pi / 180;
constexpr int max_insert_depth = 8;
constexpr double largest_number = 1e9;

struct Tag {
  int code = 0;
  std::string_view value;
  int line = 0;  // of the value
};

struct Entity {
  std::string_view type;
  std::vector<Tag> tags;

  const Tag* find(int code) const {
    const auto tag = std::ranges::find(tags, code, &Tag::code);
    return tag == tags.end() ? nullptr : &*tag;
  }
  double number(int code, double fallback = 0) const;
  int whole(int code, int fallback = 0) const { return static_cast<int>(number(code, fallback)); }
  std::string_view text(int code) const {
    const Tag* tag = find(code);
    return tag != nullptr ? tag->value : std::string_view{};
  }
  Vec2 point(int code) const { return {number(code), number(code + 10)}; }
};

struct Block {
  Vec2 base;
  std::vector<Entity> entities;
};

double number_of(std::string_view text, double fallback) {
  while (!text.empty() && text.front() == ' ')
    text.remove_prefix(1);
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good =
      failed == std::errc{} && std::isfinite(value) && std::abs(value) <= largest_number;
  return good ? value : fallback;
}

double Entity::number(int code, double fallback) const {
  const Tag* tag = find(code);
  return tag != nullptr ? number_of(tag->value, fallback) : fallback;
}

// $INSUNITS of the DXF Reference.
struct Unit {
  int code;
  double mm;
  std::string_view name;
};
constexpr Unit dxf_units[] = {{1, 25.4, "inches"},
                              {2, 304.8, "feet"},
                              {4, 1, "millimetres"},
                              {5, 10, "centimetres"},
                              {6, 1000, "metres"},
                              {10, 914.4, "yards"},
                              {14, 100, "decimetres"},
                              {15, 10000, "decametres"},
                              {21, 304.8006096, "survey feet"}};

std::string_view trimmed(std::string_view line) {
  while (!line.empty() && (line.front() == ' ' || line.front() == '\t'))
    line.remove_prefix(1);
  while (!line.empty() && (line.back() == ' ' || line.back() == '\t' || line.back() == '\r'))
    line.remove_suffix(1);
  return line;
}

Result<std::vector<Tag>> read_tags(std::string_view text, const std::string& where) {
  std::vector<Tag> tags;
  int line = 0;
  const auto next_line = [&] {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view one = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line;
    return one;
  };
  while (!text.empty()) {
    const std::string_view code = next_line();
    if (code.empty() && text.empty()) break;
    Tag tag;
    const auto [end, failed] = std::from_chars(code.data(), code.data() + code.size(), tag.code);
    if (failed != std::errc{} || end != code.data() + code.size())
      return Error{"drawing.bad_file",
                   fmt::format("{}:{}", where, line),
                   fmt::format("\"{}\" is no group code; save the drawing as ASCII DXF",
                               safe_line(code.substr(0, 40)))};
    tag.value = next_line();
    tag.line = line;
    tags.push_back(tag);
    if (tag.code == 0 && tag.value == "EOF") break;
  }
  return tags;
}

class DxfReader {
 public:
  DxfReader(const std::vector<Tag>& tags, std::string where)
      : tags_(tags), where_(std::move(where)) {}

  Result<Sketch> run() {
    while (at_ < tags_.size()) {
      const Tag& tag = tags_[at_++];
      if (tag.code != 0 || tag.value != "SECTION" || at_ >= tags_.size()) continue;
      const std::string_view section = tags_[at_++].value;
      if (section == "HEADER") read_header();
      if (section == "BLOCKS") read_blocks();
      if (section == "ENTITIES") entities_ = read_entities();
    }
    if (entities_.empty())
      return Error{
          "drawing.bad_file",
          where_,
          "there is nothing in its ENTITIES section; save the drawing as ASCII DXF with its "
          "model space"};
    for (const Entity& entity : entities_)
      MARKETGEN_CHECK(draw(entity, {}, Role::unknown, "", -1, 0));
    return std::move(sketch_);
  }

 private:
  void read_header() {
    for (; at_ < tags_.size() && tags_[at_].code != 0; ++at_) {
      if (tags_[at_].code != 9 || tags_[at_].value != "$INSUNITS" || at_ + 1 >= tags_.size())
        continue;
      const int code = static_cast<int>(number_of(tags_[at_ + 1].value, 0));
      for (const Unit& unit : dxf_units) {
        if (unit.code != code) continue;
        sketch_.mm_per_unit = unit.mm;
        sketch_.units = fmt::format("$INSUNITS {} ({})", code, unit.name);
      }
    }
  }

  // Up to the end of the section.
  std::vector<Entity> read_entities() {
    std::vector<Entity> entities;
    while (at_ < tags_.size()) {
      const Tag& tag = tags_[at_];
      if (tag.code != 0) {
        ++at_;
        continue;
      }
      if (tag.value == "ENDSEC" || tag.value == "ENDBLK" || tag.value == "EOF") break;
      ++at_;
      Entity& entity = entities.emplace_back();
      entity.type = tag.value;
      while (at_ < tags_.size() && tags_[at_].code != 0)
        entity.tags.push_back(tags_[at_++]);
    }
    return entities;
  }

  void read_blocks() {
    while (at_ < tags_.size() && tags_[at_].value != "ENDSEC") {
      if (tags_[at_].code != 0 || tags_[at_].value != "BLOCK") {
        ++at_;
        continue;
      }
      ++at_;
      Entity head;
      while (at_ < tags_.size() && tags_[at_].code != 0)
        head.tags.push_back(tags_[at_++]);
      blocks_[std::string(head.text(2))] = {head.point(10), read_entities()};
      if (at_ < tags_.size() && tags_[at_].value == "ENDBLK") ++at_;
    }
  }

  Result<void> draw(const Entity& e,
                    const Affine& place,
                    Role role,
                    const std::string& name,
                    int symbol,
                    int depth) {
    if (++drawn_ > max_points) return too_many_lines(where_);
    if (e.whole(67) == 1) return {};  // paper space
    const std::string layer(e.text(8));
    if (const Role said = role_of(layer); said != Role::unknown) role = said;
    from_ = {role, name.empty() ? layer : name + "/" + layer, symbol};
    const bool mirrored = e.number(230, 1) < 0;
    const Affine at = mirrored && e.type != "LINE" ? place * scaled(-1, 1) : place;
    if (e.type == "INSERT") return insert(e, at, depth);
    if (e.type == "LINE") return add({e.point(10), e.point(11)}, false, at);
    if (e.type == "LWPOLYLINE") return polyline(e, vertices_of(e), (e.whole(70) & 1) != 0, at);
    if (e.type == "POLYLINE") return begin_polyline(e, at);
    if (e.type == "VERTEX") return vertex(e);
    if (e.type == "SEQEND") return end_polyline();
    if (e.type == "CIRCLE" || e.type == "ARC") return arc(e, at);
    if (e.type == "ELLIPSE") return ellipse(e, at);
    if (e.type == "SOLID" || e.type == "TRACE")
      return add({e.point(10), e.point(11), e.point(13), e.point(12)}, true, at);
    if (e.type == "SPLINE") return spline(e, at);
    return {};
  }

  Result<void> insert(const Entity& e, const Affine& place, int depth) {
    const std::string name(e.text(2));
    const auto found = blocks_.find(name);
    if (found == blocks_.end()) return {};
    if (depth >= max_insert_depth) {
      return Error{
          "drawing.bad_file",
          fmt::format("{}:{}", where_, e.tags.empty() ? 0 : e.tags[0].line),
          fmt::format("the block \"{}\" stands in itself, or blocks nest more than {} deep",
                      safe_line(name),
                      max_insert_depth)};
    }
    const Role named = role_of(name);
    const Role role = named != Role::unknown ? named : from_.role;
    const std::string full = from_.name + "/" + name;
    const int symbol = symbols_++;
    const int columns = std::clamp(e.whole(70, 1), 1, 400),
              rows = std::clamp(e.whole(71, 1), 1, 400);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const Affine at = place * moved(e.number(10), e.number(20)) *
                          rotated(e.number(50) * dxf_degree) *
                          moved(column * e.number(44), row * e.number(45)) *
                          scaled(e.number(41, 1), e.number(42, 1)) *
                          moved(-found->second.base.x, -found->second.base.y);
        if (++drawn_ > max_points) return too_many_lines(where_);
        const int own = row + column == 0 ? symbol : symbols_++;
        for (const Entity& inner : found->second.entities)
          MARKETGEN_CHECK(draw(inner, at, role, full, own, depth + 1));
      }
    }
    return {};
  }

  struct Vertex {
    Vec2 at;
    double bulge = 0;
  };

  static std::vector<Vertex> vertices_of(const Entity& e) {
    std::vector<Vertex> vertices;
    for (const Tag& tag : e.tags) {
      if (tag.code == 10) vertices.push_back({{number_of(tag.value, 0), 0}, 0});
      if (vertices.empty()) continue;
      if (tag.code == 20) vertices.back().at.y = number_of(tag.value, 0);
      if (tag.code == 42) vertices.back().bulge = number_of(tag.value, 0);
    }
    return vertices;
  }

  // A bulge is the tangent of a quarter of the arc's angle.
  static std::vector<Vec2> bulged(const Vertex& from, Vec2 to) {
    const double sweep = 4 * std::atan(from.bulge);
    const Vec2 chord = to - from.at;
    const double length = std::hypot(chord.x, chord.y);
    if (length == 0) return {from.at, to};
    const double radius = length / (2 * std::sin(std::abs(sweep) / 2));
    const double away = radius * std::cos(std::abs(sweep) / 2) * (sweep > 0 ? 1 : -1);
    const Vec2 middle = (from.at + to) * 0.5;
    const Vec2 centre{middle.x - chord.y / length * away, middle.y + chord.x / length * away};
    const double start = std::atan2(from.at.y - centre.y, from.at.x - centre.x);
    return arc_points(centre, radius, start, sweep);
  }

  Result<void> polyline(const Entity& e,
                        const std::vector<Vertex>& vertices,
                        bool closed,
                        const Affine& place) {
    const double width = e.number(43, e.number(40));
    if (vertices.size() < 2) return {};
    const bool straight =
        std::ranges::all_of(vertices, [](const Vertex& v) { return std::abs(v.bulge) < 1e-9; });
    if (straight) {
      std::vector<Vec2> points;
      for (const Vertex& v : vertices)
        points.push_back(v.at);
      return add(std::move(points), closed, place, width);
    }
    const std::size_t edges = closed ? vertices.size() : vertices.size() - 1;
    const bool circle = closed && vertices.size() == 2;
    std::vector<Vec2> round;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vertex& from = vertices[i];
      const Vec2 to = vertices[(i + 1) % vertices.size()].at;
      const bool curved = std::abs(from.bulge) >= 1e-9;
      std::vector<Vec2> points = curved ? bulged(from, to) : std::vector{from.at, to};
      if (circle) {
        round.insert(round.end(), points.begin(), points.end() - 1);
        continue;
      }
      MARKETGEN_CHECK(add(std::move(points), false, place, width, curved));
    }
    return circle ? add(std::move(round), true, place, width) : Result<void>();
  }

  Result<void> begin_polyline(const Entity& e, const Affine& place) {
    open_ = &e;
    open_place_ = place;
    open_vertices_.clear();
    return {};
  }
  Result<void> vertex(const Entity& e) {
    if (open_ != nullptr) open_vertices_.push_back({e.point(10), e.number(42)});
    return {};
  }
  Result<void> end_polyline() {
    if (open_ == nullptr) return {};
    const Entity& e = *std::exchange(open_, nullptr);
    return polyline(e, open_vertices_, (e.whole(70) & 1) != 0, open_place_);
  }

  Result<void> arc(const Entity& e, const Affine& place) {
    const double radius = e.number(40);
    if (radius <= 0) return {};
    if (e.type == "CIRCLE") {
      std::vector<Vec2> points = arc_points(e.point(10), radius, 0, 2 * std::numbers::pi);
      points.pop_back();
      return add(std::move(points), true, place);
    }
    double sweep = e.number(51) - e.number(50);
    while (sweep <= 0)
      sweep += 360;
    return add(
        arc_points(
            e.point(10), radius, e.number(50) * dxf_degree, std::min(sweep, 360.0) * dxf_degree),
        false,
        place,
        0,
        true);
  }

  Result<void> ellipse(const Entity& e, const Affine& place) {
    const Vec2 major = e.point(11);
    const double ratio = e.number(40, 1);
    const double start = e.number(41), end = e.number(42, 2 * std::numbers::pi);
    const bool whole = std::abs(end - start) > 2 * std::numbers::pi - 1e-6;
    std::vector<Vec2> points;
    for (const Vec2& p : arc_points({0, 0}, 1, start, end - start))
      points.push_back(e.point(10) + major * p.x + Vec2{-major.y, major.x} * (ratio * p.y));
    if (whole) points.pop_back();
    return add(std::move(points), whole, place, 0, !whole);
  }

  // Near enough: through its fit points, or along its control points.
  Result<void> spline(const Entity& e, const Affine& place) {
    std::vector<Vec2> points;
    const int code = e.find(11) != nullptr ? 11 : 10;
    for (const Tag& tag : e.tags) {
      if (tag.code == code) points.push_back({number_of(tag.value, 0), 0});
      if (tag.code == code + 10 && !points.empty()) points.back().y = number_of(tag.value, 0);
    }
    return add(std::move(points), (e.whole(70) & 1) != 0, place);
  }

  Result<void> add(std::vector<Vec2> points,
                   bool closed,
                   const Affine& place,
                   double width = 0,
                   bool curved = false) {
    points_ += points.size();
    if (sketch_.strokes.size() >= max_strokes || points_ > max_points)
      return too_many_lines(where_);
    if (points.size() < 2) return {};
    Stroke stroke;
    for (Vec2& p : points) {
      p = place * p;
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {};
    }
    stroke.points = std::move(points);
    stroke.closed = closed;
    stroke.line_width = width * place.scale();
    stroke.role = from_.role;
    stroke.name = from_.name;
    stroke.symbol = from_.symbol;
    if (curved) stroke.arc = arc_through(stroke.points);
    sketch_.strokes.push_back(std::move(stroke));
    return {};
  }

  struct From {
    Role role = Role::unknown;
    std::string name;
    int symbol = -1;
  };

  const std::vector<Tag>& tags_;
  std::string where_;
  std::size_t at_ = 0;
  Sketch sketch_;
  std::map<std::string, Block> blocks_;
  std::vector<Entity> entities_;
  From from_;
  const Entity* open_ = nullptr;
  Affine open_place_;
  std::vector<Vertex> open_vertices_;
  int symbols_ = 0;
  std::size_t points_ = 0, drawn_ = 0;
};

}  // namespace

Result<Sketch> read_dxf(std::string_view text, const std::string& where) {
  if (text.starts_with("AutoCAD Binary DXF"))
    return Error{"drawing.bad_file", where, "this is a binary DXF; save it as ASCII DXF"};
  if (text.starts_with("AC10"))
    return Error{"drawing.bad_file", where, "this is a DWG; save it as ASCII DXF"};
  MARKETGEN_TRY(const std::vector<Tag> tags, read_tags(text, where));
  return DxfReader(tags, where).run();
}

}  // namespace marketgen::drawing
