#include "drawing/svg_path.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace marketgen::drawing {
namespace {

constexpr double largest_coordinate = 1e9;

class Scanner {
 public:
  explicit Scanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  void skip_blanks() {
    while (at_ != end_ &&
           (*at_ == ' ' || *at_ == '\t' || *at_ == '\n' || *at_ == '\r' || *at_ == ','))
      ++at_;
  }
  bool done() {
    skip_blanks();
    return at_ == end_;
  }
  std::optional<char> letter() {
    skip_blanks();
    if (at_ == end_ || !((*at_ >= 'a' && *at_ <= 'z') || (*at_ >= 'A' && *at_ <= 'Z')))
      return std::nullopt;
    return *at_++;
  }
  std::optional<double> number() {
    skip_blanks();
    const char* from = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
    double value = 0;
    const auto [after, failed] = std::from_chars(from, end_, value);
    if (failed != std::errc{} || !std::isfinite(value) || std::abs(value) > largest_coordinate)
      return std::nullopt;
    at_ = after;
    return value;
  }
  // Of an arc, which may be written without blanks: 0 or 1.
  std::optional<bool> flag() {
    skip_blanks();
    if (at_ == end_ || (*at_ != '0' && *at_ != '1')) return std::nullopt;
    return *at_++ == '1';
  }
  std::string_view word_until(char stop) {
    skip_blanks();
    const char* from = at_;
    while (at_ != end_ && *at_ != stop)
      ++at_;
    const std::string_view word(from, static_cast<std::size_t>(at_ - from));
    if (at_ != end_) ++at_;
    return word;
  }
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

 private:
  const char* at_;
  const char* end_;
};

// SVG 1.1, appendix F.6: an elliptical arc by its ends. Points without the first.
std::vector<Vec2> ellipse_points(
    Vec2 from, double rx, double ry, double turned_deg, bool large, bool forward, Vec2 to) {
  rx = std::abs(rx);
  ry = std::abs(ry);
  if (rx == 0 || ry == 0 || from == to) return {to};
  const double phi = turned_deg * std::numbers::pi / 180;
  const double c = std::cos(phi), s = std::sin(phi);
  const Vec2 half = (from - to) * 0.5;
  const Vec2 p{c * half.x + s * half.y, -s * half.x + c * half.y};
  const double size = p.x * p.x / (rx * rx) + p.y * p.y / (ry * ry);
  if (size > 1) {
    rx *= std::sqrt(size);
    ry *= std::sqrt(size);
  }
  const double below = rx * rx * p.y * p.y + ry * ry * p.x * p.x;
  const double k = below == 0 ? 0
                              : (large == forward ? -1 : 1) *
                                    std::sqrt(std::max(0.0, rx * rx * ry * ry / below - 1));
  const Vec2 q{k * rx * p.y / ry, -k * ry * p.x / rx};
  const Vec2 middle = (from + to) * 0.5;
  const Vec2 centre{c * q.x - s * q.y + middle.x, s * q.x + c * q.y + middle.y};
  const double start = std::atan2((p.y - q.y) / ry, (p.x - q.x) / rx);
  double sweep = std::atan2((-p.y - q.y) / ry, (-p.x - q.x) / rx) - start;
  if (forward && sweep < 0) sweep += 2 * std::numbers::pi;
  if (!forward && sweep > 0) sweep -= 2 * std::numbers::pi;
  std::vector<Vec2> points;
  for (const Vec2& unit : arc_points({0, 0}, 1, start, sweep)) {
    const Vec2 e{unit.x * rx, unit.y * ry};
    points.push_back({c * e.x - s * e.y + centre.x, s * e.x + c * e.y + centre.y});
  }
  points.erase(points.begin());
  if (!points.empty()) points.back() = to;
  return points;
}

class PathReader {
 public:
  explicit PathReader(std::string_view text) : scan_(text) {}

  PathData run() {
    char command = 0;
    while (!scan_.done() && data_.pieces.size() < max_strokes) {
      if (const auto next = scan_.letter()) {
        command = *next;
      } else if (command == 0 || command == 'Z' || command == 'z') {
        data_.fault = true;
        break;
      }
      if (!step(command)) {
        data_.fault = true;
        break;
      }
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    end_piece();
    return std::move(data_);
  }

 private:
  std::optional<Vec2> point(bool relative) {
    const auto x = scan_.number();
    const auto y = x ? scan_.number() : std::nullopt;
    if (!y) return std::nullopt;
    return relative ? Vec2{*x + now_.x, *y + now_.y} : Vec2{*x, *y};
  }

  void end_piece(bool closed = false) {
    if (line_.size() > 1) data_.pieces.push_back({line_, closed, false});
    line_.clear();
  }
  void line_to(Vec2 to) {
    if (line_.empty()) line_.push_back(now_);
    line_.push_back(to);
    now_ = to;
  }
  // `points` start after the current point.
  void curve(const std::vector<Vec2>& points) {
    whole_ = false;
    end_piece();
    PathPiece piece{{now_}, false, true};
    piece.points.insert(piece.points.end(), points.begin(), points.end());
    now_ = piece.points.back();
    data_.pieces.push_back(std::move(piece));
  }
  void close() {
    if (!line_.empty() && whole_) {
      end_piece(true);
    } else if (!(now_ == start_)) {
      line_to(start_);
      end_piece();
    }
    now_ = start_;
    whole_ = true;
  }

  bool step(char command) {
    const bool relative = command >= 'a';
    const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
    std::optional<Vec2> bend;
    const bool good = kind == 'Z' ? (close(), true) : draw(kind, relative, bend);
    last_bend_ = bend;
    last_kind_ = kind;
    return good;
  }

  bool draw(char kind, bool relative, std::optional<Vec2>& bend) {
    switch (kind) {
      case 'M':
        if (const auto to = point(relative)) {
          end_piece();
          start_ = now_ = *to;
          whole_ = true;
          return true;
        }
        return false;
      case 'L':
        if (const auto to = point(relative)) return line_to(*to), true;
        return false;
      case 'H':
        if (const auto x = scan_.number())
          return line_to({relative ? now_.x + *x : *x, now_.y}), true;
        return false;
      case 'V':
        if (const auto y = scan_.number())
          return line_to({now_.x, relative ? now_.y + *y : *y}), true;
        return false;
      case 'C':
      case 'S':
        return cubic(kind, relative, bend);
      case 'Q':
      case 'T':
        return quadratic(kind, relative, bend);
      case 'A':
        return arc(relative);
      default:
        return false;
    }
  }

  Vec2 mirrored_bend(std::initializer_list<char> kinds) const {
    const bool goes_on = last_bend_ && std::ranges::find(kinds, last_kind_) != kinds.end();
    return goes_on ? now_ * 2 - *last_bend_ : now_;
  }

  bool cubic(char kind, bool relative, std::optional<Vec2>& bend) {
    const auto c1 = kind == 'C' ? point(relative) : mirrored_bend({'C', 'S'});
    const auto c2 = c1 ? point(relative) : std::nullopt;
    const auto to = c2 ? point(relative) : std::nullopt;
    if (!to) return false;
    std::vector<Vec2> points;
    append_cubic(points, now_, *c1, *c2, *to);
    bend = c2;
    curve(points);
    return true;
  }

  bool quadratic(char kind, bool relative, std::optional<Vec2>& bend) {
    const auto c = kind == 'Q' ? point(relative) : mirrored_bend({'Q', 'T'});
    const auto to = c ? point(relative) : std::nullopt;
    if (!to) return false;
    std::vector<Vec2> points;
    append_cubic(points, now_, now_ + (*c - now_) * (2.0 / 3), *to + (*c - *to) * (2.0 / 3), *to);
    bend = c;
    curve(points);
    return true;
  }

  bool arc(bool relative) {
    const auto rx = scan_.number();
    const auto ry = rx ? scan_.number() : std::nullopt;
    const auto turned = ry ? scan_.number() : std::nullopt;
    const auto large = turned ? scan_.flag() : std::nullopt;
    const auto forward = large ? scan_.flag() : std::nullopt;
    const auto to = forward ? point(relative) : std::nullopt;
    if (!to) return false;
    curve(ellipse_points(now_, *rx, *ry, *turned, *large, *forward, *to));
    return true;
  }

  Scanner scan_;
  PathData data_;
  std::vector<Vec2> line_;
  Vec2 now_, start_;
  bool whole_ = true;  // the subpath is straight so far
  std::optional<Vec2> last_bend_;
  char last_kind_ = 0;
};

Affine transform_of(std::string_view name, const std::vector<double>& v) {
  const double one_degree = std::numbers::pi / 180;
  if (name == "matrix" && v.size() == 6) return {v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && !v.empty()) return moved(v[0], v.size() > 1 ? v[1] : 0);
  if (name == "scale" && !v.empty()) return scaled(v[0], v.size() > 1 ? v[1] : v[0]);
  if (name == "rotate" && v.size() == 3)
    return moved(v[1], v[2]) * rotated(v[0] * one_degree) * moved(-v[1], -v[2]);
  if (name == "rotate" && v.size() == 1) return rotated(v[0] * one_degree);
  if (name == "skewX" && v.size() == 1) return {1, 0, std::tan(v[0] * one_degree), 1, 0, 0};
  if (name == "skewY" && v.size() == 1) return {1, std::tan(v[0] * one_degree), 0, 1, 0, 0};
  return {std::nan(""), 0, 0, 1, 0, 0};
}

}  // namespace

PathData read_path(std::string_view text) {
  return PathReader(text).run();
}

std::vector<Vec2> read_points(std::string_view text) {
  Scanner scan(text);
  std::vector<Vec2> points;
  while (const auto x = scan.number()) {
    const auto y = scan.number();
    if (!y) break;
    points.push_back({*x, *y});
  }
  return points;
}

std::optional<Affine> read_transform(std::string_view text) {
  Scanner scan(text);
  Affine all;
  while (!scan.done()) {
    std::string_view name = scan.word_until('(');
    while (!name.empty() && name.back() == ' ')
      name.remove_suffix(1);
    std::vector<double> values;
    while (const auto value = scan.number())
      values.push_back(*value);
    scan.word_until(')');
    all = all * transform_of(name, values);
    if (!all.finite()) return std::nullopt;
  }
  return all;
}

std::optional<Length> read_length(std::string_view text) {
  struct Unit {
    std::string_view name;
    double mm;
  };
  constexpr std::array units = {Unit{"mm", 1},
                                Unit{"cm", 10},
                                Unit{"in", 25.4},
                                Unit{"m", 1000},
                                Unit{"pt", 25.4 / 72},
                                Unit{"pc", 25.4 / 6},
                                Unit{"px", 0},
                                Unit{"", 0}};
  Scanner scan(text);
  const auto value = scan.number();
  if (!value || *value <= 0) return std::nullopt;
  std::string_view rest = scan.rest();
  while (!rest.empty() && rest.back() == ' ')
    rest.remove_suffix(1);
  for (const Unit& unit : units)
    if (rest == unit.name) return Length{*value, unit.mm};
  return std::nullopt;
}

}  // namespace marketgen::drawing
