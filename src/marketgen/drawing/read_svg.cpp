// SVG 1.1: shapes, groups, transforms, <use>. XML comes from tinyxml2, which knows no external
// references and expands no entities of a document's own.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <tinyxml2.h>

#include "base/safe_line.h"
#include "drawing/sketch.h"
#include "drawing/svg_path.h"

namespace marketgen::drawing {
namespace {

using tinyxml2::XMLElement;

constexpr int max_use_depth = 8;
constexpr double px_mm = 25.4 / 96;  // CSS
constexpr double min_scale = 1e-9;

std::string_view text_of(const XMLElement& e, const char* name) {
  const char* text = e.Attribute(name);
  return text != nullptr ? text : std::string_view{};
}

// A property, as an attribute or in style="...".
std::string_view property(const XMLElement& e, const char* name) {
  std::string_view style = text_of(e, "style");
  while (!style.empty()) {
    const std::size_t end = std::min(style.find(';'), style.size());
    std::string_view one = style.substr(0, end);
    style.remove_prefix(std::min(end + 1, style.size()));
    while (!one.empty() && one.front() == ' ')
      one.remove_prefix(1);
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos || one.substr(0, colon) != name) continue;
    one.remove_prefix(colon + 1);
    while (!one.empty() && one.front() == ' ')
      one.remove_prefix(1);
    return one;
  }
  return text_of(e, name);
}

double number_in(const XMLElement& e, const char* name, double fallback = 0) {
  const std::vector<Vec2> pair = read_points(std::string(text_of(e, name)) + " 0");
  return pair.empty() ? fallback : pair[0].x;
}

// What an element has of those around it.
struct Around {
  Affine place;
  Role role = Role::unknown;
  std::string name;
  double stroke_width = 1;
  bool stroked = false;
  int symbol = -1;
};

std::string name_of_element(const XMLElement& e) {
  std::string name;
  for (const char* attribute : {"inkscape:label", "data-name", "class", "id"}) {
    const std::string_view text = text_of(e, attribute);
    if (text.empty()) continue;
    if (!name.empty()) name += ' ';
    name += text;
  }
  if (const XMLElement* title = e.FirstChildElement("title"); title && title->GetText()) {
    name += ' ';
    name += title->GetText();
  }
  return name;
}

class SvgReader {
 public:
  explicit SvgReader(std::string where) : where_(std::move(where)) {}

  Result<Sketch> run(std::string_view text) {
    tinyxml2::XMLDocument document;
    if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
      return Error{"drawing.bad_file",
                   fmt::format("{}:{}", where_, document.ErrorLineNum()),
                   fmt::format("the text is not XML ({}); save the drawing as SVG again",
                               document.ErrorName())};
    const XMLElement* root = document.RootElement();
    const std::string_view tag = root != nullptr ? root->Name() : "";
    if (tag != "svg" && tag != "svg:svg")
      return Error{
          "drawing.bad_file", where_, "there is no <svg> element; is this an SVG drawing?"};
    find_ids(*root);
    Around all;
    all.place = scaled(1, -1) * read_view(*root);
    MARKETGEN_CHECK(children_of(*root, all, 0));
    return std::move(sketch_);
  }

 private:
  void warn(const std::string& text) {
    if (warned_.insert(text).second) sketch_.warnings.push_back(text);
  }

  void find_ids(const XMLElement& e) {
    if (const char* id = e.Attribute("id")) ids_.emplace(id, &e);
    for (const XMLElement* c = e.FirstChildElement(); c; c = c->NextSiblingElement())
      find_ids(*c);
  }

  // Millimetres of a user unit, from a width and height in units of length.
  Affine read_view(const XMLElement& svg) {
    const auto width = read_length(text_of(svg, "width"));
    const auto height = read_length(text_of(svg, "height"));
    const std::vector<Vec2> box = read_points(text_of(svg, "viewBox"));
    const bool has_box = box.size() == 2 && box[1].x > 0 && box[1].y > 0;
    const auto unit_of = [&](const std::optional<Length>& length, double user) {
      if (!length || length->unit_mm == 0) return 0.0;
      return has_box ? length->value * length->unit_mm / user : px_mm;
    };
    const double by_width = unit_of(width, has_box ? box[1].x : 1);
    const double by_height = unit_of(height, has_box ? box[1].y : 1);
    const double unit = by_width > 0 && by_height > 0 ? std::min(by_width, by_height)  // "meet"
                                                      : std::max(by_width, by_height);
    if (unit > min_scale) {
      sketch_.mm_per_unit = unit;
      sketch_.paper_mm_per_unit = unit;
      sketch_.units = fmt::format("width=\"{}\"", safe_line(text_of(svg, "width")));
    }
    return {};
  }

  Result<void> children_of(const XMLElement& e, const Around& around, int uses) {
    for (const XMLElement* c = e.FirstChildElement(); c; c = c->NextSiblingElement())
      MARKETGEN_CHECK(element(*c, around, uses));
    return {};
  }

  Result<void> element(const XMLElement& e, const Around& around, int uses) {
    if (++elements_ > max_strokes) return too_many_lines(where_);
    std::string_view tag = e.Name();
    if (tag.starts_with("svg:")) tag.remove_prefix(4);
    if (note_unread(e, tag)) return {};
    if (property(e, "display") == "none" || property(e, "visibility") == "hidden") return {};
    MARKETGEN_TRY(const Around inner, inside(e, around));
    if (tag == "g" || tag == "a" || tag == "switch") return children_of(e, inner, uses);
    if (tag == "svg") return nested(e, inner, uses);
    if (tag == "use") return use(e, inner, uses);
    return shape(e, tag, inner);
  }

  bool note_unread(const XMLElement& e, std::string_view tag) {
    if (tag == "script") {
      warn(fmt::format("line {}: a script, which is not run", e.GetLineNum()));
      return true;
    }
    if (tag == "image" || tag == "foreignObject") {
      warn(
          fmt::format("line {}: <{}> is left out; nothing outside the lines of the drawing is read",
                      e.GetLineNum(),
                      tag));
      return true;
    }
    constexpr std::string_view silent[] = {"defs",
                                           "symbol",
                                           "style",
                                           "metadata",
                                           "title",
                                           "desc",
                                           "marker",
                                           "pattern",
                                           "clipPath",
                                           "mask",
                                           "text"};
    return std::ranges::find(silent, tag) != std::ranges::end(silent);
  }

  Result<Around> inside(const XMLElement& e, const Around& around) {
    Around inner = around;
    if (const std::string_view transform = text_of(e, "transform"); !transform.empty()) {
      const auto read = read_transform(transform);
      if (!read)
        return Error{"drawing.bad_file",
                     fmt::format("{}:{}", where_, e.GetLineNum()),
                     fmt::format("the transform \"{}\" cannot be read", safe_line(transform))};
      inner.place = around.place * *read;
    }
    const std::string name = name_of_element(e);
    if (!name.empty()) {
      inner.name = around.name.empty() ? name : around.name + "/" + name;
      if (const Role role = role_of(name); role != Role::unknown) {
        const bool own_symbol = role != around.role || around.symbol < 0 || e.FirstChildElement();
        inner.role = role;
        if (own_symbol) inner.symbol = symbols_++;
      }
    }
    if (const auto width = read_length(property(e, "stroke-width")))
      inner.stroke_width = width->value * (width->unit_mm > 0 ? width->unit_mm / px_mm : 1);
    if (const std::string_view stroke = property(e, "stroke"); !stroke.empty())
      inner.stroked = stroke != "none";
    return inner;
  }

  Result<void> nested(const XMLElement& e, Around inner, int uses) {
    inner.place = inner.place * moved(number_in(e, "x"), number_in(e, "y"));
    const std::vector<Vec2> box = read_points(text_of(e, "viewBox"));
    const double width = number_in(e, "width"), height = number_in(e, "height");
    if (box.size() == 2 && box[1].x > 0 && box[1].y > 0 && width > 0 && height > 0) {
      const double by = std::min(width / box[1].x, height / box[1].y);
      inner.place = inner.place * scaled(by, by) * moved(-box[0].x, -box[0].y);
    }
    return children_of(e, inner, uses);
  }

  Result<void> use(const XMLElement& e, Around inner, int uses) {
    std::string_view link = text_of(e, "href");
    if (link.empty()) link = text_of(e, "xlink:href");
    if (!link.starts_with('#')) {
      warn(fmt::format("line {}: a reference to another file, which is not fetched",
                       e.GetLineNum()));
      return {};
    }
    const auto found = ids_.find(std::string(link.substr(1)));
    if (found == ids_.end() || uses >= max_use_depth) {
      warn(fmt::format("line {}: <use> of \"{}\" is left out: {}",
                       e.GetLineNum(),
                       safe_line(link),
                       uses >= max_use_depth ? "it uses itself" : "there is nothing of this id"));
      return {};
    }
    inner.place = inner.place * moved(number_in(e, "x"), number_in(e, "y"));
    inner.symbol = symbols_++;
    const XMLElement& target = *found->second;
    const std::string_view tag = target.Name();
    if (tag != "symbol") return element(target, inner, uses + 1);
    MARKETGEN_TRY(const Around symbol, inside(target, inner));
    return children_of(target, symbol, uses + 1);
  }

  Result<void> shape(const XMLElement& e, std::string_view tag, const Around& around) {
    if (tag == "path") {
      const PathData data = read_path(text_of(e, "d"));
      if (data.fault)
        warn(fmt::format("line {}: the path is read up to its first fault only", e.GetLineNum()));
      for (const PathPiece& piece : data.pieces)
        MARKETGEN_CHECK(add(piece.points, piece.closed, piece.curved, around));
      return {};
    }
    if (tag == "rect") return rectangle(e, around);
    if (tag == "circle" || tag == "ellipse") return ellipse(e, tag == "circle", around);
    if (tag == "line")
      return add(
          {{number_in(e, "x1"), number_in(e, "y1")}, {number_in(e, "x2"), number_in(e, "y2")}},
          false,
          false,
          around);
    if (tag == "polyline" || tag == "polygon")
      return add(read_points(text_of(e, "points")), tag == "polygon", false, around);
    return {};
  }

  Result<void> rectangle(const XMLElement& e, const Around& around) {
    const double x = number_in(e, "x"), y = number_in(e, "y");
    const double w = number_in(e, "width"), h = number_in(e, "height");
    if (w <= 0 || h <= 0) return {};
    return add({{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true, false, around);
  }

  Result<void> ellipse(const XMLElement& e, bool circle, const Around& around) {
    const double rx = number_in(e, circle ? "r" : "rx"), ry = number_in(e, circle ? "r" : "ry");
    if (rx <= 0 || ry <= 0) return {};
    std::vector<Vec2> points;
    for (const Vec2& p : arc_points({0, 0}, 1, 0, 2 * std::numbers::pi))
      points.push_back({number_in(e, "cx") + rx * p.x, number_in(e, "cy") + ry * p.y});
    points.pop_back();
    return add(std::move(points), true, false, around);
  }

  Result<void> add(std::vector<Vec2> points, bool closed, bool curved, const Around& around) {
    if (points.size() < 2) return {};
    points_ += points.size();
    if (sketch_.strokes.size() >= max_strokes || points_ > max_points)
      return too_many_lines(where_);
    Stroke stroke;
    for (Vec2& p : points)
      p = around.place * p;
    for (const Vec2& p : points)
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {};
    stroke.points = std::move(points);
    stroke.closed = closed;
    stroke.role = around.role;
    stroke.symbol = around.symbol;
    stroke.name = around.name;
    if (curved) stroke.arc = arc_through(stroke.points);
    if (around.stroked) stroke.line_width = around.stroke_width * around.place.scale();
    sketch_.strokes.push_back(std::move(stroke));
    return {};
  }

  std::string where_;
  Sketch sketch_;
  std::set<std::string> warned_;
  std::map<std::string, const XMLElement*> ids_;
  int symbols_ = 0;
  std::size_t points_ = 0, elements_ = 0;
};

}  // namespace

Result<Sketch> read_svg(std::string_view text, const std::string& where) {
  return SvgReader(where).run(text);
}

}  // namespace marketgen::drawing
