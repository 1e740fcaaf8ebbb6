#include "drawing/zone_shelves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "drawing/zone_hatching.h"
#include "drawing/zone_marks.h"

namespace marketgen::drawing {
namespace {

// Shares of the floor's longer side: a shop is 10 to 60 m long, a shelf 0.4 to 1.5 m deep.
constexpr double shortest = 0.035, shortest_cut = 0.018, deepest = 0.085, longest = 0.9;
constexpr double closest = 0.026;   // from run to run; what is closer on both sides is hatching
constexpr double reach = 0.014;     // a line that ends so near to another one meets it
constexpr float hatched_from = 36;  // strokes on the length of the longer side
constexpr double off_axis = 12 * CV_PI / 180;

struct Body {
  cv::Point2d centre, way;     // way: along it, of length 1
  double half = 0, width = 0;  // of its length; across it
};

// The smallest box, about as long as its points lie along the line through them.
Body body_of(const std::vector<cv::Point>& points) {
  cv::Vec4f line;
  cv::fitLine(points, line, cv::DIST_L2, 0, 0.01, 0.01);
  const cv::Point2d way(line[0], line[1]), at(line[2], line[3]);
  double low = 0, high = 0, left = 0, right = 0;
  for (const cv::Point& p : points) {
    const cv::Point2d d = cv::Point2d(p) - at;
    const double along = d.dot(way), across = way.x * d.y - way.y * d.x;
    low = std::min(low, along), high = std::max(high, along);
    left = std::min(left, across), right = std::max(right, across);
  }
  const cv::Point2d normal(-way.y, way.x);
  return {at + way * ((low + high) / 2) + normal * ((left + right) / 2),
          way,
          (high - low + 1) / 2,
          right - left + 1};
}

bool marked_near(const cv::Mat& marks, cv::Point2d at, int within) {
  const cv::Rect box =
      cv::Rect(cvRound(at.x) - within, cvRound(at.y) - within, 2 * within + 1, 2 * within + 1) &
      cv::Rect(0, 0, marks.cols, marks.rows);
  return !box.empty() && cv::countNonZero(marks(box)) > 0;
}

// Both long sides are drawn: of bars, of boxes, and of boxes with cells.
bool has_sides(const cv::Mat& marks, const Body& body) {
  constexpr int samples = 24;
  constexpr double least = 0.75;
  const cv::Point2d normal(-body.way.y, body.way.x);
  for (const double side : {-1.0, 1.0}) {
    int drawn = 0;
    for (int i = 0; i < samples; ++i) {
      const double t = body.half * (2 * (i + 0.5) / samples - 1);
      const cv::Point2d at = body.centre + body.way * t + normal * (side * (body.width / 2 - 1));
      drawn += marked_near(marks, at, 2) ? 1 : 0;
    }
    if (drawn < least * samples) return false;
  }
  return true;
}

// Ink is all over it, or there is next to none between its sides: a row of letters is neither.
bool is_full_or_hollow(const cv::Mat& raw, const Body& body) {
  constexpr int along = 60, across = 5;
  constexpr double hollow = 0.2, full = 0.96;
  const cv::Point2d normal(-body.way.y, body.way.x);
  int inked = 0;
  for (int i = 0; i < along; ++i) {
    for (int k = 0; k < across; ++k) {
      const double u = 0.9 * body.half * (2 * (i + 0.5) / along - 1);
      const double v = 0.25 * body.width * (2 * (k + 0.5) / across - 1);
      const cv::Point2d at = body.centre + body.way * u + normal * v;
      inked += marked_near(raw, at, 0) ? 1 : 0;
    }
  }
  const double share = 1.0 * inked / (along * across);
  return share < hollow || share > full;
}

// Off the nearer of the two directions of the walls.
double off_walls(cv::Point2d way, double turned) {
  const double angle = std::atan2(way.y, way.x) - turned;
  return std::abs(angle - std::round(angle / (CV_PI / 2)) * (CV_PI / 2));
}

bool lies_along_x(cv::Point2d way, double turned) {
  return std::abs(way.dot({std::cos(turned), std::sin(turned)})) > std::sqrt(0.5);
}

// A line or the wall goes on where the body ends.
bool ends_at_line(
    const cv::Mat& lines, const cv::Mat& floor, const Body& body, double sign, int px) {
  for (int t = 2; t <= px; ++t) {
    const cv::Point2d at = body.centre + body.way * (sign * (body.half + t));
    const cv::Point p(cvRound(at.x), cvRound(at.y));
    if (!p.inside(cv::Rect(0, 0, floor.cols, floor.rows)) || floor.at<std::uint8_t>(p) == 0)
      return true;
    if (marked_near(lines, at, 1)) return true;
  }
  return false;
}

struct Piece {
  Body body;
  bool box = false;
  bool whole = true;  // false: of a box that something written cuts in two
};

std::vector<cv::Point> points_of(const cv::Mat& labels, int label, const cv::Rect& box) {
  std::vector<cv::Point> points;
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x)
      if (labels.at<int>(y, x) == label) points.emplace_back(x, y);
  return points;
}

bool is_thin(const Body& body) {
  return body.width <= std::max(5.0, 0.06 * 2 * body.half);
}

// A straight stroke along the walls, or a narrow box.
std::optional<Piece> piece_of(const std::vector<cv::Point>& points,
                              const cv::Mat& marks,
                              const cv::Mat& raw,
                              double side,
                              double turned) {
  const Body body = body_of(points);
  const double length = 2 * body.half;
  constexpr double slender = 2.6, slender_cut = 1.25;
  const bool whole = length > slender * body.width && length > shortest * side;
  if (length < shortest_cut * side || length > longest * side || body.width > deepest * side ||
      length < slender_cut * body.width || off_walls(body.way, turned) > off_axis)
    return std::nullopt;
  const bool thin = is_thin(body);
  const bool box = has_sides(marks, body) && is_full_or_hollow(raw, body);
  if (thin ? !whole : !box) return std::nullopt;
  return Piece{body, !thin, whole};
}

// Everything drawn that is as long as a line, and no candidate.
cv::Mat lines_beside(const cv::Mat& labels, const cv::Mat& stats, double side) {
  std::vector<std::uint8_t> line(static_cast<std::size_t>(stats.rows));
  for (int i = 1; i < stats.rows; ++i)
    line[i] = std::max(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT)) >
                      0.09 * side
                  ? 255
                  : 0;
  cv::Mat lines = cv::Mat::zeros(labels.size(), CV_8UC1);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      lines.at<std::uint8_t>(y, x) = line[labels.at<int>(y, x)];
  return lines;
}

std::vector<Piece> pieces_in(
    const cv::Mat& marks, const cv::Mat& raw, const cv::Mat& floor, double side, double turned) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(marks, labels, stats, centres, 8, CV_32S);
  const cv::Mat lines = lines_beside(labels, stats, side);
  std::vector<Piece> pieces;
  for (int i = 1; i < count; ++i) {
    const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT),
                       stats.at<int>(i, cv::CC_STAT_TOP),
                       stats.at<int>(i, cv::CC_STAT_WIDTH),
                       stats.at<int>(i, cv::CC_STAT_HEIGHT));
    if (std::max(box.width, box.height) < shortest_cut * side) continue;
    if (std::min(box.width, box.height) > 0.85 * std::max(box.width, box.height)) continue;
    const auto piece = piece_of(points_of(labels, i, box), marks, raw, side, turned);
    if (!piece || !floor.at<std::uint8_t>(piece->body.centre)) continue;
    const int px = cvRound(reach * side);
    const bool divides = !piece->box && ends_at_line(lines, floor, piece->body, -1, px) &&
                         ends_at_line(lines, floor, piece->body, 1, px);
    if (!divides) pieces.push_back(*piece);
  }
  return pieces;
}

ShelfStroke stroke_of(const Piece& piece, double turned) {
  const Body& b = piece.body;
  return {
      b.centre - b.way * b.half, b.centre + b.way * b.half, b.width, lies_along_x(b.way, turned)};
}

// A stroke as numbers along the walls: from, to, and where it lies across.
struct Lane {
  double from = 0, to = 0, at = 0, width = 0;
  double length() const { return to - from; }
};

Lane lane_of(const ShelfStroke& stroke, double turned) {
  const cv::Point2d x(std::cos(turned), std::sin(turned)), y(-x.y, x.x);
  const cv::Point2d &along = stroke.along_x ? x : y, &across = stroke.along_x ? y : x;
  const double a = stroke.from.dot(along), b = stroke.to.dot(along);
  return {std::min(a, b), std::max(a, b), (stroke.from + stroke.to).dot(across) / 2, stroke.width};
}

// Side by side over at least so much of the shorter one.
bool beside(const Lane& a, const Lane& b) {
  constexpr double least = 0.3;
  const double over = std::min(a.to, b.to) - std::max(a.from, b.from);
  return over > least * std::min(a.length(), b.length());
}

// Of a box that is cut in two.
bool has_other_half(std::size_t one,
                    const std::vector<ShelfStroke>& strokes,
                    const std::vector<Lane>& lanes,
                    double side) {
  constexpr double nearest = 0.022, farthest = 0.2;  // from letter to letter; as long as a word
  const Lane& a = lanes[one];
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const Lane& b = lanes[i];
    const double apart = std::max(a.from, b.from) - std::min(a.to, b.to);
    if (i != one && strokes[i].along_x == strokes[one].along_x &&
        std::abs(a.at - b.at) < 0.25 * a.width && std::abs(a.width - b.width) < 0.25 * a.width &&
        apart > nearest * side && apart < farthest * side)
      return true;
  }
  return false;
}

// Words stand in rows, too, but not so close to others of just their length.
bool has_twin_beside(std::size_t one,
                     const std::vector<ShelfStroke>& strokes,
                     const std::vector<Lane>& lanes,
                     double side) {
  constexpr double farthest = 0.2, alike = 0.15;
  const Lane& a = lanes[one];
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const Lane& b = lanes[i];
    const double apart = std::abs(a.at - b.at);
    if (strokes[i].along_x == strokes[one].along_x && beside(a, b) && apart > 0.5 * a.width &&
        apart < farthest * side && std::abs(a.length() - b.length()) < alike * a.length())
      return true;
  }
  return false;
}

// Of the strokes of each direction: which of them have neighbours as shelves have them.
std::vector<bool> are_shelves(const std::vector<ShelfStroke>& strokes,
                              const std::vector<Piece>& pieces,
                              double side,
                              double turned) {
  constexpr double farthest = 0.4;
  std::vector<Lane> lanes;
  for (const ShelfStroke& stroke : strokes)
    lanes.push_back(lane_of(stroke, turned));
  std::vector<bool> shelf(strokes.size()), hatch(strokes.size());
  const auto near = [&](std::size_t i, std::size_t k) {
    return i != k && strokes[i].along_x == strokes[k].along_x && beside(lanes[i], lanes[k]);
  };
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    bool below = false, above = false, peer = pieces[i].box;
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      if (!near(i, k)) continue;
      const double d = lanes[k].at - lanes[i].at;
      below = below || (d < 0 && d > -closest * side);
      above = above || (d > 0 && d < closest * side);
      peer = peer || (std::abs(d) > 0.01 * side && std::abs(d) < farthest * side);
    }
    hatch[i] = below && above;
    shelf[i] = peer;
  }
  for (std::size_t i = 0; i < strokes.size(); ++i)
    if (!pieces[i].whole)
      shelf[i] =
          has_other_half(i, strokes, lanes, side) && has_twin_beside(i, strokes, lanes, side);
  for (std::size_t i = 0; i < strokes.size(); ++i)
    for (std::size_t k = 0; k < strokes.size(); ++k)
      if (hatch[k] &&
          (i == k || (near(i, k) && std::abs(lanes[k].at - lanes[i].at) < closest * side)))
        shelf[i] = false;
  return shelf;
}

// The part under most of a stroke.
int part_under(const Segments& segments, const ShelfStroke& stroke) {
  constexpr int samples = 21;
  std::vector<int> under(segments.parts.size());
  for (int i = 0; i < samples; ++i) {
    const cv::Point2d at = stroke.from + (stroke.to - stroke.from) * ((i + 0.5) / samples);
    const cv::Point p(cvRound(at.x), cvRound(at.y));
    if (!p.inside(cv::Rect(0, 0, segments.label.cols, segments.label.rows))) continue;
    if (const int part = segments.label.at<int>(p); part >= 0) ++under[part];
  }
  const auto most = std::ranges::max_element(under);
  return most == under.end() || 2 * *most <= samples ? -1 : static_cast<int>(most - under.begin());
}

// Pieces of one run made one, from one side of the zone to the other.
std::vector<Lane> joined(std::vector<Lane> lanes, double side) {
  std::ranges::sort(lanes, {}, &Lane::at);
  std::vector<Lane> runs;
  for (const Lane& lane : lanes) {
    const bool same =
        !runs.empty() && lane.at - runs.back().at < std::max(0.008 * side, 0.5 * runs.back().width);
    if (!same) {
      runs.push_back(lane);
      continue;
    }
    runs.back().from = std::min(runs.back().from, lane.from);
    runs.back().to = std::max(runs.back().to, lane.to);
    runs.back().width = std::max(runs.back().width, lane.width);
  }
  constexpr double as_long = 0.35;  // of the longest: shorter ones are something else
  double longest_run = 0;
  for (const Lane& run : runs)
    longest_run = std::max(longest_run, run.length());
  std::erase_if(runs, [&](const Lane& run) { return run.length() < as_long * longest_run; });
  return runs;
}

// Lines two by two, each pair closer than the aisle to the next: sides of shelves.
bool are_pairs(const std::vector<Lane>& runs, double side) {
  if (runs.size() < 4 || runs.size() % 2 != 0) return false;
  double inner = 0, outer = 1e9;
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    if (runs[i].width > 0.012 * side) return false;
    const double gap = runs[i + 1].at - runs[i].at;
    if (i % 2 == 0)
      inner = std::max(inner, gap);
    else
      outer = std::min(outer, gap);
  }
  constexpr double clearly = 0.65;
  return inner < clearly * outer && inner < deepest * side;
}

std::optional<DrawnRuns> runs_of(const std::vector<Lane>& lanes, bool along_x, double side) {
  const std::vector<Lane> runs = joined(lanes, side);
  if (runs.empty()) return std::nullopt;
  constexpr double regular = 0.9, several = 0.7, lone = 0.5;
  DrawnRuns drawn;
  drawn.count = static_cast<int>(are_pairs(runs, side) ? runs.size() / 2 : runs.size());
  drawn.along_x = along_x;
  drawn.confidence = drawn.count >= 3 ? regular : drawn.count == 2 ? several : lone;
  return drawn;
}

}  // namespace

std::vector<ShelfStroke> shelf_strokes(const cv::Mat& bgr,
                                       const cv::Mat& floor,
                                       double longer_side,
                                       double turned) {
  const cv::Mat raw = grey_marks(bgr, longer_side), marks = mended(raw);
  std::vector<Piece> pieces = pieces_in(marks, raw, floor, longer_side, turned);
  const cv::Mat density = stroke_density(marks, longer_side);
  std::erase_if(pieces, [&](const Piece& piece) {
    return !piece.box && density.at<float>(piece.body.centre) > hatched_from;
  });
  std::vector<ShelfStroke> strokes, shelves;
  for (const Piece& piece : pieces)
    strokes.push_back(stroke_of(piece, turned));
  const std::vector<bool> shelf = are_shelves(strokes, pieces, longer_side, turned);
  for (std::size_t i = 0; i < strokes.size(); ++i)
    if (shelf[i]) shelves.push_back(strokes[i]);
  return shelves;
}

cv::Mat places_of(const std::vector<ShelfStroke>& strokes, cv::Size size) {
  constexpr double rim = 3;  // how far ink is smeared
  cv::Mat places = cv::Mat::zeros(size, CV_8UC1);
  for (const ShelfStroke& stroke : strokes) {
    const cv::Point2d way = (stroke.to - stroke.from) / cv::norm(stroke.to - stroke.from);
    const cv::Point2d along = way * rim,
                      across = cv::Point2d(-way.y, way.x) * (stroke.width / 2 + rim);
    const std::vector<cv::Point> corners{stroke.from - along - across,
                                         stroke.to + along - across,
                                         stroke.to + along + across,
                                         stroke.from - along + across};
    cv::fillConvexPoly(places, corners, 255);
  }
  return places;
}

cv::Mat without_places(const cv::Mat& bgr, const cv::Mat& places) {
  if (cv::countNonZero(places) == 0) return bgr;
  cv::Mat depth, nearest, clear = bgr.clone();
  cv::distanceTransform(places, depth, nearest, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
  std::vector<cv::Vec3b> of_seed(bgr.total() + 1);
  for (int y = 0; y < bgr.rows; ++y)
    for (int x = 0; x < bgr.cols; ++x)
      if (places.at<std::uint8_t>(y, x) == 0)
        of_seed[nearest.at<int>(y, x)] = bgr.at<cv::Vec3b>(y, x);
  for (int y = 0; y < bgr.rows; ++y)
    for (int x = 0; x < bgr.cols; ++x)
      if (places.at<std::uint8_t>(y, x) != 0)
        clear.at<cv::Vec3b>(y, x) = of_seed[nearest.at<int>(y, x)];
  return clear;
}

std::vector<std::optional<DrawnRuns>> runs_on(const Segments& segments,
                                              const std::vector<ShelfStroke>& strokes,
                                              double longer_side,
                                              double turned) {
  struct OnPart {
    std::array<std::vector<Lane>, 2> lanes;  // along y, along x
    std::array<double, 2> length{};
  };
  std::vector<OnPart> parts(segments.parts.size());
  for (const ShelfStroke& stroke : strokes) {
    const int part = part_under(segments, stroke);
    if (part < 0) continue;
    const Lane lane = lane_of(stroke, turned);
    parts[part].lanes[stroke.along_x ? 1 : 0].push_back(lane);
    parts[part].length[stroke.along_x ? 1 : 0] += lane.length();
  }
  constexpr double clearly = 0.75;  // of all that is drawn in the zone
  std::vector<std::optional<DrawnRuns>> runs;
  for (const OnPart& part : parts) {
    const std::size_t most = part.length[1] > part.length[0] ? 1 : 0;
    const double all = part.length[0] + part.length[1];
    runs.push_back(part.length[most] > clearly * all
                       ? runs_of(part.lanes[most], most == 1, longer_side)
                       : std::nullopt);
  }
  return runs;
}

}  // namespace marketgen::drawing
