#include "drawing/zone_picture.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "drawing/line.h"
#include "drawing/picture.h"
#include "drawing/zone_chart.h"
#include "geometry/image.h"
#include "io/picture_file.h"
#include "io/png.h"

namespace marketgen::drawing {
namespace {

constexpr int max_side_px = 1800;  // larger pictures are read at this size

struct Ray {
  std::vector<cv::Point2f> outer, inner;
};

// Where rays from outside a side meet its wall, and where they leave it.
Ray edge_points(const cv::Mat& ink, cv::Point2d a, cv::Point2d b, double reach) {
  const cv::Point2d way = (b - a) / cv::norm(b - a);
  const cv::Point2d in(-way.y, way.x);  // clockwise in a picture: inwards
  Ray points;
  std::vector<double> thickness;
  constexpr int rays = 160;
  const auto inked = [&](cv::Point2d p) {
    const cv::Point at(cvRound(p.x), cvRound(p.y));
    return at.inside(cv::Rect(0, 0, ink.cols, ink.rows)) && ink.at<std::uint8_t>(at) != 0;
  };
  for (int i = 4; i < rays - 4; ++i) {
    const cv::Point2d start = a + (b - a) * (static_cast<double>(i) / rays);
    double t = -reach;
    while (t < reach && !inked(start + in * t))
      t += 0.5;
    if (t >= reach) continue;
    double end = t;
    while (end < 3 * reach && inked(start + in * end))
      end += 0.5;
    if (end >= 3 * reach) continue;
    const cv::Point2d first = start + in * t;
    points.outer.emplace_back(static_cast<float>(first.x), static_cast<float>(first.y));
    thickness.push_back(end - t);
  }
  if (thickness.empty()) return points;
  // Lines that end at the wall make it look thicker.
  const auto thin = thickness.begin() + static_cast<std::ptrdiff_t>(thickness.size() * 2 / 5);
  std::ranges::nth_element(thickness, thin);
  const cv::Point2f through(static_cast<float>(in.x * *thin), static_cast<float>(in.y * *thin));
  for (const cv::Point2f& p : points.outer)
    points.inner.push_back(p + through);
  return points;
}

std::optional<Line> line_through(std::vector<cv::Point2f> points) {
  constexpr std::size_t least = 20;
  Line line;
  for (int round = 0; round < 4; ++round) {
    if (points.size() < least) return std::nullopt;
    cv::Vec4f fit;
    cv::fitLine(points, fit, cv::DIST_HUBER, 0, 0.01, 0.01);
    line = {{fit[2], fit[3]}, {fit[0], fit[1]}};
    std::vector<double> off;
    for (const cv::Point2f& p : points)
      off.push_back(std::abs((p.x - fit[2]) * fit[1] - (p.y - fit[3]) * fit[0]));
    std::vector<double> sorted = off;
    std::ranges::nth_element(sorted, sorted.begin() + sorted.size() / 2);
    const double limit = std::max(1.5, 2.5 * sorted[sorted.size() / 2]);
    std::vector<cv::Point2f> near;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (off[i] <= limit) near.push_back(points[i]);
    points = std::move(near);
  }
  return line;
}

// Of all that is as long as a wall.
std::vector<cv::Point> hull_of_lines(const cv::Mat& ink) {
  cv::Mat joined, labels, stats, centres;
  cv::morphologyEx(ink, joined, cv::MORPH_CLOSE, cv::Mat::ones(3, 3, CV_8UC1));
  const int count = cv::connectedComponentsWithStats(joined, labels, stats, centres, 8, CV_32S);
  int longest = 0;
  const auto side = [&](int i) {
    return std::max(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
  };
  for (int i = 1; i < count; ++i)
    longest = std::max(longest, side(i));
  constexpr double wall_share = 0.08;
  std::vector<cv::Point> points;
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      const int i = labels.at<int>(y, x);
      if (i > 0 && side(i) > wall_share * longest) points.emplace_back(x, y);
    }
  }
  std::vector<cv::Point> hull;
  if (points.size() >= 3) cv::convexHull(points, hull);
  return hull;
}

// Four corners that hold nearly what the hull holds, from the north-west clockwise.
std::optional<std::array<cv::Point2d, 4>> four_corners(const std::vector<cv::Point>& hull) {
  const double area = cv::contourArea(hull), around = cv::arcLength(hull, true);
  for (double share = 0.01; share < 0.08; share += 0.005) {
    std::vector<cv::Point> rough;
    cv::approxPolyDP(hull, rough, share * around, true);
    if (rough.size() > 4) continue;
    if (rough.size() < 4 || std::abs(cv::contourArea(rough) / area - 1) > 0.06) return std::nullopt;
    if (cv::contourArea(rough, true) < 0) std::ranges::reverse(rough);
    const auto first = std::ranges::min_element(rough, {}, [](cv::Point p) { return p.x + p.y; });
    std::ranges::rotate(rough, first);
    return std::array<cv::Point2d, 4>{rough[0], rough[1], rough[2], rough[3]};
  }
  return std::nullopt;
}

// Openings of one side: stretches without ink across the wall.
void add_gaps(ZonePicture& picture, const cv::Mat& dark, int side, double wall_px) {
  const cv::Rect2d& f = picture.floor;
  const bool along_x = side == 0 || side == 2;
  const int length = static_cast<int>(along_x ? f.width : f.height);
  const double level = side == 0   ? f.y + f.height
                       : side == 2 ? f.y
                       : side == 1 ? f.x + f.width
                                   : f.x;
  const double out = side == 0 || side == 1 ? 1 : -1;
  const double within = std::max(1.5, 0.3 * wall_px);  // hatching ends at the wall's inner face
  std::vector<bool> open(length);
  for (int i = 0; i < length; ++i) {
    const double at = along_x ? f.x + i : f.y + f.height - i;
    bool inked = false;
    for (double t = within; t <= wall_px + 4 && !inked; t += 1) {
      const double across = level + out * t;
      const cv::Point p(cvRound(along_x ? at : across), cvRound(along_x ? across : at));
      inked = p.inside(cv::Rect(0, 0, dark.cols, dark.rows)) && dark.at<std::uint8_t>(p) != 0;
    }
    open[i] = !inked;
  }
  const double least = 0.012 * picture.longer_side;  // less is a fault of the pen
  for (int i = 0; i < length; ++i) {
    if (!open[i]) continue;
    int end = i;
    while (end < length && open[end])
      ++end;
    if (end - i >= least) picture.gaps.push_back({side, double(i), double(end)});
    i = end;
  }
}

struct Margins {
  double left = 20, top = 20, right = 20, bottom = 20;
};

// How much of the sheet to see beside a floor of that size.
Margins margins_of(cv::Size picture, const cv::Mat& map_to_floor, double width, double depth) {
  const float cols = static_cast<float>(picture.width), rows = static_cast<float>(picture.height);
  std::vector<cv::Point2f> sheet{{0, 0}, {cols, 0}, {0, rows}, {cols, rows}}, seen;
  cv::perspectiveTransform(sheet, seen, map_to_floor);
  const double most = 0.6 * std::max(width, depth);
  Margins m;
  for (const cv::Point2f& p : seen) {
    m.left = std::max(m.left, std::min(most, -double(p.x)));
    m.top = std::max(m.top, std::min(most, -double(p.y)));
    m.right = std::max(m.right, std::min(most, p.x - width));
    m.bottom = std::max(m.bottom, std::min(most, p.y - depth));
  }
  return m;
}

// The floor seen from above, with what is drawn around it.
ZonePicture straightened(const cv::Mat& flat, const FourWalls& walls, double aspect) {
  const auto& c = walls.inner;
  const double width = (cv::norm(c[1] - c[0]) + cv::norm(c[2] - c[3])) / 2;
  const double depth = (cv::norm(c[3] - c[0]) + cv::norm(c[2] - c[1])) / 2;
  const double seen_aspect = aspect_of(c, flat.size());
  const double ratio = aspect > 0 ? aspect : seen_aspect;
  const double longer_seen = std::max(width, depth);
  const double longer = std::clamp(longer_seen, 700.0, 1100.0);
  const double w = ratio >= 1 ? longer : longer * ratio, d = ratio >= 1 ? longer / ratio : longer;
  const std::vector<cv::Point2f> from{c[0], c[1], c[2], c[3]};
  const auto map_to = [&](double x, double y) {
    const std::vector<cv::Point2f> to{cv::Point2f(float(x), float(y)),
                                      cv::Point2f(float(x + w), float(y)),
                                      cv::Point2f(float(x + w), float(y + d)),
                                      cv::Point2f(float(x), float(y + d))};
    return cv::getPerspectiveTransform(from, to);
  };
  const auto [left, top, right, bottom] = margins_of(flat.size(), map_to(0, 0), w, d);
  ZonePicture picture;
  picture.rectangle = true;
  picture.floor = {left, top, w, d};
  picture.longer_side = longer;
  picture.seen_aspect = seen_aspect;
  picture.px_of_file = longer_seen / longer;
  const cv::Mat map = map_to(left, top);
  cv::warpPerspective(flat,
                      picture.bgr,
                      map,
                      {static_cast<int>(left + w + right), static_cast<int>(top + d + bottom)},
                      cv::INTER_CUBIC,
                      cv::BORDER_CONSTANT,
                      cv::Scalar::all(paper_value));
  picture.ink = dark_ink(picture.bgr);
  std::vector<cv::Point2f> outer{walls.outer[0], walls.outer[1], walls.outer[2], walls.outer[3]};
  cv::perspectiveTransform(outer, outer, map);
  const double wall_px = std::max({1.0,
                                   (top - outer[0].y + outer[2].y - (top + d)) / 2,
                                   (left - outer[0].x + outer[2].x - (left + w)) / 2});
  constexpr int wall_value = 170;  // thin walls are less dark than thick ones
  const cv::Mat dark = brightest_channel(picture.bgr) < wall_value;
  for (int side = 0; side < 4; ++side)
    add_gaps(picture, dark, side, wall_px);
  return picture;
}

Result<ZonePicture> picture_of(cv::Mat bgr, const std::string& where, double aspect) {
  const double px = shrink(bgr, max_side_px);
  const cv::Mat flat = flattened(bgr);
  if (is_pie_chart(flat)) return chart("pie chart", where);
  const cv::Mat ink = dark_ink(flat);
  if (const auto walls = four_walls(ink)) {
    ZonePicture picture = straightened(flat, *walls, aspect);
    picture.px_of_file *= px;
    return picture;
  }
  const std::vector<cv::Point> hull = hull_of_lines(ink);
  constexpr double min_share = 0.05;
  if (hull.size() < 3 || cv::contourArea(hull) < min_share * static_cast<double>(ink.total()))
    return Error{"drawing.no_outline",
                 where,
                 "no dark lines go round a floor in this picture; draw the walls of the shop as a "
                 "closed outline (doors may be gaps), and take the whole sheet into the picture"};
  ZonePicture picture;
  picture.bgr = flat;
  picture.ink = ink;
  picture.floor = cv::boundingRect(hull);
  picture.longer_side = std::max(picture.floor.width, picture.floor.height);
  picture.px_of_file = px;
  return picture;
}

}  // namespace

std::optional<FourWalls> four_walls(const cv::Mat& ink) {
  const std::vector<cv::Point> hull = hull_of_lines(ink);
  if (hull.size() < 4 || cv::contourArea(hull) < 0.05 * static_cast<double>(ink.total()))
    return std::nullopt;
  const auto corners = four_corners(hull);
  if (!corners) return std::nullopt;
  std::array<Line, 4> outer, inner;
  const double reach = 0.02 * cv::arcLength(hull, true) / 4;
  for (std::size_t i = 0; i < 4; ++i) {
    const Ray ray = edge_points(ink, (*corners)[i], (*corners)[(i + 1) % 4], reach);
    const auto first = line_through(ray.outer), last = line_through(ray.inner);
    if (!first || !last) return std::nullopt;
    outer[i] = *first;
    inner[i] = *last;
  }
  FourWalls walls;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto out = meeting(outer[(i + 3) % 4], outer[i], 0.3),
               in = meeting(inner[(i + 3) % 4], inner[i], 0.3);
    if (!out || !in || cv::norm(*out - (*corners)[i]) > 3 * reach) return std::nullopt;
    walls.outer[i] = *out;
    walls.inner[i] = *in;
  }
  return walls;
}

double aspect_of(const std::array<cv::Point2d, 4>& corners, cv::Size picture) {
  // Zhang and He, "Whiteboard scanning and image enhancement" (2007), with the principal point in
  // the middle of the picture. Where the view is too straight to tell how long the lens is, sides
  // as they are seen.
  const cv::Point2d middle(picture.width / 2.0, picture.height / 2.0);
  const double unit = std::max(picture.width, picture.height);
  std::array<cv::Vec3d, 4> m;  // north-west, north-east, south-west, south-east
  constexpr std::array<std::size_t, 4> order{0, 1, 3, 2};
  for (std::size_t i = 0; i < 4; ++i) {
    const cv::Point2d p = (corners[order[i]] - middle) / unit;
    m[i] = {p.x, p.y, 1};
  }
  const double k2 = m[0].cross(m[3]).dot(m[2]) / m[1].cross(m[3]).dot(m[2]);
  const double k3 = m[0].cross(m[3]).dot(m[1]) / m[2].cross(m[3]).dot(m[1]);
  const cv::Vec3d n2 = k2 * m[1] - m[0], n3 = k3 * m[2] - m[0];
  const double seen = (cv::norm(corners[1] - corners[0]) + cv::norm(corners[2] - corners[3])) /
                      (cv::norm(corners[3] - corners[0]) + cv::norm(corners[2] - corners[1]));
  constexpr double straight = 0.02;
  if (std::abs(n2[2]) < straight && std::abs(n3[2]) < straight) return seen;
  constexpr double usual_lens = 1.6, shortest = 0.6, longest = 5;
  double lens = usual_lens;
  if (std::abs(n2[2]) > straight && std::abs(n3[2]) > straight) {
    const double squared = -(n2[0] * n3[0] + n2[1] * n3[1]) / (n2[2] * n3[2]);
    if (squared > shortest * shortest && squared < longest * longest) lens = std::sqrt(squared);
  }
  const double width = std::hypot(n2[0] / lens, n2[1] / lens, n2[2]);
  const double depth = std::hypot(n3[0] / lens, n3[1] / lens, n3[2]);
  return width / depth;
}

Result<ZonePicture> zone_picture(std::string_view bytes, const std::string& where, double aspect) {
  if (!io::is_png(bytes) && !bytes.starts_with("\xFF\xD8\xFF"))
    return Error{"drawing.bad_file",
                 where,
                 "this is no PNG or JPEG; save the drawing of zones as one of these"};
  MARKETGEN_TRY(const Image image, io::decoded_picture(bytes, where));
  constexpr int min_px = 120;
  if (std::min(image.width, image.height) < min_px)
    return Error{"drawing.bad_file",
                 where,
                 "the picture has " + std::to_string(image.width) + " x " +
                     std::to_string(image.height) +
                     " pixels; a drawing of zones needs at least 120 x 120"};
  try {
    return picture_of(bgr_of(image), where, aspect);
  } catch (const cv::Exception& fault) {
    return Error{
        "drawing.bad_file", where, std::string("the picture cannot be looked at: ") + fault.what()};
  }
}

}  // namespace marketgen::drawing
