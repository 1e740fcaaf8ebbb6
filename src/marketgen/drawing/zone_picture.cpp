#include "drawing/zone_picture.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "geometry/image.h"
#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen::drawing {
namespace {

constexpr int longest_side_px = 1800;  // larger pictures are read at this size
constexpr double paper_value = 250;

cv::Mat bgr_of(const Image& image) {
  cv::Mat bgr(image.height, image.width, CV_8UC3);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      const bool see_through = image.channels == 4 || image.channels == 2;
      const int alpha = see_through ? p[image.channels - 1] : 255;
      const auto over = [&](int value) {
        return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha)) / 255);
      };
      const bool colour = image.channels >= 3;
      bgr.at<cv::Vec3b>(y, x) = {over(p[colour ? 2 : 0]), over(p[colour ? 1 : 0]), over(p[0])};
    }
  }
  return bgr;
}

cv::Mat brightest_channel(const cv::Mat& bgr) {
  std::array<cv::Mat, 3> channels;
  cv::split(bgr, channels.data());
  return cv::max(cv::max(channels[0], channels[1]), channels[2]);
}

// The sheet of paper: the largest bright part with all that lies in it. Everything when it nearly
// fills the picture.
cv::Mat sheet_of(const cv::Mat& bgr) {
  cv::Mat bright, value = brightest_channel(bgr);
  cv::GaussianBlur(value, value, {5, 5}, 0);
  cv::threshold(value, bright, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(bright, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  const cv::Mat all(bgr.size(), CV_8UC1, cv::Scalar(255));
  if (contours.empty()) return all;
  const auto largest = std::ranges::max_element(
      contours, {}, [](const std::vector<cv::Point>& c) { return cv::contourArea(c); });
  const double share = cv::contourArea(*largest) / static_cast<double>(bgr.total());
  constexpr double nearly_all = 0.97, least = 0.15;
  if (share > nearly_all || share < least) return all;
  std::vector<cv::Point> hull;
  cv::convexHull(*largest, hull);
  cv::Mat sheet = cv::Mat::zeros(bgr.size(), CV_8UC1);
  cv::fillConvexPoly(sheet, hull, 255);
  const int rim = std::max(3, std::max(bgr.rows, bgr.cols) / 150);
  cv::copyMakeBorder(sheet, sheet, rim, rim, rim, rim, cv::BORDER_CONSTANT, 0);
  cv::erode(sheet, sheet, cv::Mat::ones(2 * rim + 1, 2 * rim + 1, CV_8UC1));
  return sheet(cv::Rect(rim, rim, bgr.cols, bgr.rows)).clone();
}

// What that share of the masked pixels is darker than.
double low_value(const cv::Mat& value, const cv::Mat& mask, double share) {
  std::array<int, 256> counts{};
  int all = 0;
  for (int y = 0; y < value.rows; ++y) {
    for (int x = 0; x < value.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      ++counts[value.at<std::uint8_t>(y, x)];
      ++all;
    }
  }
  int below = 0, at = 0;
  while (at < 255 && below + counts[at] < share * all)
    below += counts[at++];
  return at;
}

struct Sample {
  double x, y;
  cv::Vec3d value;
};

cv::Mat powers(const std::vector<Sample>& samples, int terms) {
  cv::Mat rows(static_cast<int>(samples.size()), terms, CV_64F);
  for (int i = 0; i < rows.rows; ++i) {
    const double x = samples[i].x, y = samples[i].y;
    const std::array<double, 6> all{1, x, y, x * x, x * y, y * y};
    for (int k = 0; k < terms; ++k)
      rows.at<double>(i, k) = all[k];
  }
  return rows;
}

// Per channel a smooth surface through the samples.
cv::Mat surface(const std::vector<Sample>& samples, int terms) {
  cv::Mat values(static_cast<int>(samples.size()), 3, CV_64F), found;
  for (int i = 0; i < values.rows; ++i)
    for (int k = 0; k < 3; ++k)
      values.at<double>(i, k) = samples[i].value[k];
  cv::solve(powers(samples, terms), values, found, cv::DECOMP_SVD);
  return found;
}

std::vector<Sample> near_surface(const std::vector<Sample>& samples, const cv::Mat& fit) {
  constexpr double within = 0.08;
  const cv::Mat expected = powers(samples, fit.rows) * fit;
  std::vector<Sample> near;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    bool paper = true;
    for (int k = 0; k < 3; ++k) {
      const double paper_here = expected.at<double>(static_cast<int>(i), k);
      paper = paper && std::abs(samples[i].value[k] - paper_here) < within * paper_here;
    }
    if (paper) near.push_back(samples[i]);
  }
  return near;
}

std::vector<Sample> samples_of(const cv::Mat& bgr, const cv::Mat& mask) {
  cv::Mat smooth;
  cv::GaussianBlur(bgr, smooth, {7, 7}, 0);
  const int step = std::max(2, std::max(bgr.rows, bgr.cols) / 120);
  std::vector<Sample> samples;
  for (int y = step / 2; y < bgr.rows; y += step) {
    for (int x = step / 2; x < bgr.cols; x += step) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      const cv::Vec3b& p = smooth.at<cv::Vec3b>(y, x);
      samples.push_back({2.0 * x / bgr.cols - 1, 2.0 * y / bgr.rows - 1, {double(p[0]), double(p[1]), double(p[2])}});
    }
  }
  return samples;
}

// Inside the sheet along its edge.
cv::Mat ring_of(const cv::Mat& sheet) {
  cv::Mat framed, depth;
  cv::copyMakeBorder(sheet, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  cv::distanceTransform(framed, depth, cv::DIST_L2, 3);
  depth = depth(cv::Rect(1, 1, sheet.cols, sheet.rows));
  const double width = 0.07 * std::min(sheet.cols, sheet.rows);
  return (depth > 0) & (depth < width);
}

struct Ray {
  std::vector<cv::Point2f> outer, inner;
};

// Where rays from outside a side meet its wall, and where they leave it.
Ray edge_points(const cv::Mat& ink, cv::Point2d a, cv::Point2d b, double reach) {
  const cv::Point2d way = (b - a) / cv::norm(b - a);
  const cv::Point2d in(-way.y, way.x);  // clockwise in a picture: inwards
  Ray points;
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
    const cv::Point2d first = start + in * t, last = start + in * end;
    points.outer.emplace_back(static_cast<float>(first.x), static_cast<float>(first.y));
    points.inner.emplace_back(static_cast<float>(last.x), static_cast<float>(last.y));
  }
  return points;
}

struct Line {
  cv::Point2d at, way;
};

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

std::optional<cv::Point2d> meeting(const Line& a, const Line& b) {
  const double cross = a.way.x * b.way.y - a.way.y * b.way.x;
  if (std::abs(cross) < 0.3) return std::nullopt;
  const cv::Point2d to = b.at - a.at;
  return a.at + a.way * ((to.x * b.way.y - to.y * b.way.x) / cross);
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
  constexpr double wall_share = 0.2;
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
  const double level = side == 0 ? f.y + f.height : side == 2 ? f.y : side == 1 ? f.x + f.width : f.x;
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

// The floor seen from above, with what is drawn around it.
ZonePicture straightened(const cv::Mat& flat, const FourWalls& walls, double aspect) {
  const auto& c = walls.inner;
  const double width = (cv::norm(c[1] - c[0]) + cv::norm(c[2] - c[3])) / 2;
  const double depth = (cv::norm(c[3] - c[0]) + cv::norm(c[2] - c[1])) / 2;
  const double ratio = aspect > 0 ? aspect : aspect_of(c, flat.size());
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
  std::vector<cv::Point2f> sheet{{0, 0}, {float(flat.cols), 0}, {0, float(flat.rows)}, {float(flat.cols), float(flat.rows)}}, seen;
  cv::perspectiveTransform(sheet, seen, map_to(0, 0));
  const double most = 0.6 * longer;
  double left = 20, top = 20, right = 20, bottom = 20;
  for (const cv::Point2f& p : seen) {
    left = std::max(left, std::min(most, -double(p.x)));
    top = std::max(top, std::min(most, -double(p.y)));
    right = std::max(right, std::min(most, p.x - w));
    bottom = std::max(bottom, std::min(most, p.y - d));
  }
  ZonePicture picture;
  picture.rectangle = true;
  picture.floor = {left, top, w, d};
  picture.longer_side = longer;
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
  const int longer = std::max(bgr.cols, bgr.rows);
  double px = 1;
  if (longer > longest_side_px) {
    px = static_cast<double>(longer) / longest_side_px;
    cv::resize(bgr, bgr, {}, 1 / px, 1 / px, cv::INTER_AREA);
  }
  const cv::Mat flat = flattened(bgr);
  const cv::Mat ink = dark_ink(flat);
  if (const auto walls = four_walls(ink)) {
    ZonePicture picture = straightened(flat, *walls, aspect);
    picture.px_of_file *= px;
    return picture;
  }
  const std::vector<cv::Point> hull = hull_of_lines(ink);
  constexpr double least_share = 0.05;
  if (hull.size() < 3 || cv::contourArea(hull) < least_share * static_cast<double>(ink.total()))
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

cv::Mat flattened(const cv::Mat& bgr) {
  const cv::Mat sheet = sheet_of(bgr);
  const std::vector<Sample> all = samples_of(bgr, sheet);
  const std::vector<Sample> ring = samples_of(bgr, ring_of(sheet));
  if (ring.size() < 20 || all.size() < 20) return bgr;
  cv::Mat fit = surface(ring, 3);
  for (int round = 0; round < 5; ++round) {
    const std::vector<Sample> near = near_surface(round < 3 ? ring : all, fit);
    if (near.size() < 20) break;
    fit = surface(near, round < 3 ? 3 : 6);
  }
  cv::Mat flat(bgr.size(), CV_8UC3);
  for (int y = 0; y < bgr.rows; ++y) {
    const double v = 2.0 * y / bgr.rows - 1;
    for (int x = 0; x < bgr.cols; ++x) {
      const double u = 2.0 * x / bgr.cols - 1;
      const std::array<double, 6> terms{1, u, v, u * u, u * v, v * v};
      const cv::Vec3b& from = bgr.at<cv::Vec3b>(y, x);
      cv::Vec3b& to = flat.at<cv::Vec3b>(y, x);
      for (int k = 0; k < 3; ++k) {
        double paper_here = 0;
        for (int i = 0; i < fit.rows; ++i)
          paper_here += fit.at<double>(i, k) * terms[i];
        to[k] = cv::saturate_cast<std::uint8_t>(from[k] * paper_value / std::max(20.0, paper_here));
      }
    }
  }
  flat.setTo(cv::Scalar::all(paper_value), sheet == 0);
  return flat;
}

cv::Mat dark_ink(const cv::Mat& flat) {
  constexpr double grey_share = 0.4;  // of the brightest channel, between it and the darkest one
  std::array<cv::Mat, 3> channels;
  cv::split(flat, channels.data());
  const cv::Mat high = cv::max(cv::max(channels[0], channels[1]), channels[2]);
  const cv::Mat low = cv::min(cv::min(channels[0], channels[1]), channels[2]);
  cv::Mat colourful;
  cv::Mat difference = high - low, limit;
  high.convertTo(limit, CV_8U, grey_share, 8);
  cv::compare(difference, limit, colourful, cv::CMP_GT);
  constexpr int faintest = 165;
  const cv::Mat dark = (high < faintest) & ~colourful;
  // Where walls are black, what is much lighter is a coloured pen whose colour the picture lost.
  constexpr double towards_paper = 0.42;
  const double darkest = low_value(high, dark, 0.1);
  return dark & (high < std::min<double>(faintest, darkest + towards_paper * (paper_value - darkest)));
}

std::optional<FourWalls> four_walls(const cv::Mat& ink) {
  const std::vector<cv::Point> hull = hull_of_lines(ink);
  if (hull.size() < 4 || cv::contourArea(hull) < 0.05 * static_cast<double>(ink.total())) return std::nullopt;
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
    const auto out = meeting(outer[(i + 3) % 4], outer[i]), in = meeting(inner[(i + 3) % 4], inner[i]);
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
  if (!bytes.starts_with("\x89PNG") && !bytes.starts_with("\xFF\xD8\xFF"))
    return Error{"drawing.bad_file", where, "this is no PNG or JPEG; save the drawing of zones as one of these"};
  MARKETGEN_TRY(const Image image,
                bytes.starts_with("\x89PNG") ? io::decode_png(bytes, where)
                                             : io::decode_jpeg(bytes, where));
  constexpr int least_px = 120;
  if (std::min(image.width, image.height) < least_px)
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
