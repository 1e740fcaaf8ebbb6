#include "drawing/zone_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "base/text.h"
#include "drawing/curves.h"
#include "drawing/recognise.h"
#include "drawing/shell_of.h"
#include "drawing/zone_chart.h"
#include "drawing/zone_hatching.h"
#include "drawing/zone_picture.h"
#include "drawing/zone_segments.h"
#include "drawing/zone_shelves.h"
#include "drawing/zone_words.h"
#include "geometry/image.h"
#include "io/file.h"
#include "io/png.h"

namespace marketgen::drawing {
namespace {

constexpr double cell_mm = 100;

Tolerance tolerance_at(double px_mm) {
  return {std::max(20.0, 2 * px_mm), std::max(10.0, 1.5 * px_mm)};
}

Found scaled_by(Found found, double by) {
  for (Vec2& p : found.outline)
    p = p * by;
  for (FoundOpening& one : found.openings) {
    one.from = one.from * by;
    one.to = one.to * by;
  }
  for (FoundColumn& one : found.columns) {
    one.centre = one.centre * by;
    one.size_mm *= by;
  }
  return found;
}

// Walls that make no rectangle are read as those of a floor plan, at a size as shops have it, for
// the true one is not known yet.
Result<Found> found_as_floor_plan(const ZonePicture& picture, const std::string& where) {
  constexpr double usual_side_mm = 20'000;
  const double mm = usual_side_mm / picture.longer_side;
  Image walls(picture.ink.cols, picture.ink.rows, 1);
  for (int y = 0; y < walls.height; ++y)
    for (int x = 0; x < walls.width; ++x)
      *walls.at(x, y) = picture.ink.at<std::uint8_t>(y, x) == 0 ? 255 : 0;
  MARKETGEN_TRY(const std::string png, io::encode_png(walls));
  MARKETGEN_TRY(Sketch sketch, read_picture(png, where));
  for (Stroke& stroke : sketch.strokes)
    for (Vec2& p : stroke.points)
      p = (p + Vec2{0, static_cast<double>(picture.ink.rows)}) * mm;
  sketch.precision *= mm;
  MARKETGEN_TRY(Found found, recognise(sketch, tolerance_at(mm), where));
  found.warnings.clear();  // they speak of sizes
  found.columns.clear();   // letters are small shapes too
  return scaled_by(std::move(found), 1 / mm);
}

// The floor as walls make it, in pixels of the picture, y up from its lower edge.
Result<Found> found_in(const ZonePicture& picture, const std::string& where) {
  const double height = picture.bgr.rows;
  const cv::Rect2d& f = picture.floor;
  if (picture.rectangle) {
    Found found;
    const double south = height - (f.y + f.height), north = height - f.y;
    const double west = f.x, east = f.x + f.width;
    found.outline = {{west, south}, {east, south}, {east, north}, {west, north}};
    for (const Gap& gap : picture.gaps) {
      FoundOpening one;
      one.edge = static_cast<std::size_t>(gap.side);
      const bool along_x = gap.side == 0 || gap.side == 2;
      const double level = gap.side == 0   ? south
                           : gap.side == 2 ? north
                           : gap.side == 1 ? east
                                           : west;
      one.from = along_x ? Vec2{west + gap.from, level} : Vec2{level, south + gap.from};
      one.to = along_x ? Vec2{west + gap.to, level} : Vec2{level, south + gap.to};
      found.openings.push_back(one);
    }
    return found;
  }
  return found_as_floor_plan(picture, where);
}

struct KnownSize {
  double mm_per_px = 0;
  std::string from;
  bool guessed = false;
};

constexpr double longest_shop_mm = 200'000;

// "20 m" above or below the plan is its width, beside it its depth.
std::optional<double> written_scale(const ZonePicture& picture,
                                    const std::vector<WrittenLine>& lines) {
  const cv::Rect2d& f = picture.floor;
  for (const WrittenLine& line : lines) {
    const auto mm = dimension_mm(line.words);
    if (!mm) continue;
    const cv::Point2d at = (cv::Point2d(line.box.tl()) + cv::Point2d(line.box.br())) / 2;
    const bool over_x =
        at.x > f.x && at.x<f.x + f.width, over_y = at.y> f.y && at.y < f.y + f.height;
    if (over_x == over_y) continue;
    const double mm_per_px = *mm / (over_x ? f.width : f.height);
    // "18.7 m" may be read as 187 m.
    if (mm_per_px * std::max(f.width, f.height) <= longest_shop_mm) return mm_per_px;
  }
  return std::nullopt;
}

Result<KnownSize> size_of(const ZonePicture& picture,
                          const ReadOptions& options,
                          const std::vector<WrittenLine>& lines,
                          const std::string& where) {
  const cv::Rect2d& f = picture.floor;
  if (options.scale && options.scale->mm_per_unit > 0)
    return KnownSize{options.scale->mm_per_unit * picture.px_of_file, "--floor-plan-scale"};
  const double by_width = options.width_mm / f.width, by_depth = options.depth_mm / f.height;
  if (by_width > 0 && by_depth > 0)
    return KnownSize{(by_width + by_depth) / 2, "the size of the shop"};
  if (by_width + by_depth > 0) return KnownSize{by_width + by_depth, "the size of the shop"};
  if (const auto written = written_scale(picture, lines))
    return KnownSize{*written, "a dimension written on it"};
  if (options.usual_area_m2 > 0)
    return KnownSize{
        std::sqrt(options.usual_area_m2 * 1e6 / f.area()), "the usual size of such a shop", true};
  return Error{"drawing.no_scale",
               where,
               "a picture does not say how large a pixel is on the floor: write the width of the "
               "shop along it (\"20 m\"), say --floor-plan-scale \"1 px = 10 mm\", or the inner "
               "size of the shop in words or with --size"};
}

// What a person is told of a size whose sides are not as those of the drawing; else empty.
std::string other_proportions(const ZonePicture& picture, const ReadOptions& options) {
  constexpr double alike = 0.06;  // a photo shows sides up to 5 % off
  const double width = options.width_mm / 1000, depth = options.depth_mm / 1000;
  if (!picture.rectangle || width <= 0 || depth <= 0) return "";
  const double said = width / depth, seen = picture.seen_aspect;
  if (std::abs(std::log(said / seen)) < alike) return "";
  const bool turned = std::abs(std::log(said * seen)) < alike;
  return fmt::format(
      "it is drawn {:.2f} times as wide as deep, but the size of {:g} x {:g} m is {:.2f} times as "
      "wide as deep: all that is drawn is stretched; {}x{}m would keep its sides",
      seen,
      width,
      depth,
      said,
      fmt::format("{:g}", turned ? depth : width),
      turned ? fmt::format("{:g}", width) : fmt::format("{:.1f}", width / seen));
}

// What the word beside a door says it is for, as names of blocks do.
void name_openings(Found& found,
                   const ZonePicture& picture,
                   const std::vector<WrittenLine>& lines) {
  for (const WrittenLine& line : lines) {
    if (role_of(line.words) != Role::door) continue;
    const Vec2 at{line.box.x + line.box.width / 2.0,
                  picture.bgr.rows - (line.box.y + line.box.height / 2.0)};
    FoundOpening* nearest = nullptr;
    double near = 0.1 * picture.longer_side;
    for (FoundOpening& one : found.openings) {
      const double d = distance(at, Segment{one.from, one.to});
      if (d >= near) continue;
      near = d;
      nearest = &one;
    }
    if (nearest != nullptr) nearest->name = line.words;
  }
}

bool holds(const cv::Rect2d& box, const cv::Rect& line) {
  return box.contains((cv::Point2d(line.tl()) + cv::Point2d(line.br())) / 2);
}

// Pixels where one part ends and the next begins.
cv::Mat borders_of(const Segments& segments) {
  const cv::Mat& label = segments.label;
  cv::Mat borders = cv::Mat::zeros(label.size(), CV_8UC1);
  for (int y = 1; y < label.rows; ++y) {
    for (int x = 1; x < label.cols; ++x) {
      const int here = label.at<int>(y, x);
      if (here != label.at<int>(y, x - 1) || here != label.at<int>(y - 1, x))
        borders.at<std::uint8_t>(y, x) = 255;
    }
  }
  return borders;
}

// The part that a line stands on: the one under most of its box.
int part_under(const Segments& segments, const cv::Rect& box) {
  std::vector<int> under(segments.parts.size());
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x)
      if (const int i = segments.label.at<int>(y, x); i >= 0) ++under[i];
  const auto most = std::ranges::max_element(under);
  return most == under.end() || *most == 0 ? -1 : static_cast<int>(most - under.begin());
}

std::vector<DrawnZone> zones_of(const ZonePicture& picture,
                                const Segments& segments,
                                std::vector<WrittenLine> lines) {
  std::vector<DrawnZone> zones(segments.parts.size());
  std::vector<int> counts(zones.size());
  std::ranges::stable_sort(lines, {}, [](const WrittenLine& line) { return line.box.y; });
  for (const WrittenLine& line : lines) {
    if (line.words.empty() || !holds(picture.floor, line.box)) continue;
    const int i = part_under(segments, line.box);
    if (i < 0) continue;
    zones[i].words += (zones[i].words.empty() ? "" : " ") + line.words;
    zones[i].words_confidence += (line.confidence - zones[i].words_confidence) / ++counts[i];
  }
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const cv::Vec3b& c = segments.parts[i].bgr;
    zones[i].rgb = {c[2], c[1], c[0]};
  }
  return zones;
}

// The line of a legend that stands right of a square.
const WrittenLine* line_beside(const Swatch& swatch, const std::vector<WrittenLine>& lines) {
  const WrittenLine* best = nullptr;
  int nearest = 4 * std::max(swatch.box.width, swatch.box.height);
  for (const WrittenLine& line : lines) {
    const int middle = line.box.y + line.box.height / 2;
    const int right = line.box.x - (swatch.box.x + swatch.box.width);
    const bool beside = middle > swatch.box.y && middle < swatch.box.y + swatch.box.height;
    if (!beside || line.words.empty() || right < -swatch.box.width / 4 || right >= nearest)
      continue;
    nearest = right;
    best = &line;
  }
  return best;
}

void add_legend(std::vector<DrawnZone>& zones,
                const ZonePicture& picture,
                const Segments& segments,
                const std::vector<WrittenLine>& lines) {
  if (!segments.coloured) return;
  const std::vector<Swatch> swatches = swatches_of(picture.bgr, picture.floor, picture.longer_side);
  for (std::size_t i = 0; i < zones.size(); ++i) {
    if (!zones[i].words.empty() || segments.parts[i].bare) continue;
    double near = 14;
    for (const Swatch& swatch : swatches) {
      const double d = cv::norm(swatch.ab - segments.parts[i].ab);
      const WrittenLine* line = line_beside(swatch, lines);
      if (d >= near || line == nullptr) continue;
      near = d;
      zones[i].words = line->words;
      zones[i].words_confidence = line->confidence;
      zones[i].from_legend = true;
    }
  }
}

// The labels of the picture on squares of the floor; parts that are no zones become bare.
ZoneMap map_of(const FloorPlan& floor,
               const Segments& segments,
               const std::vector<int>& zone_of,
               Vec2 corner,
               double mm_per_px,
               int rows_px,
               double turned) {
  ZoneMap map;
  map.cell_mm = cell_mm;
  map.columns = static_cast<int>(std::ceil(floor.shell.width_mm / cell_mm));
  map.rows = static_cast<int>(std::ceil(floor.shell.depth_mm / cell_mm));
  map.zone.assign(static_cast<std::size_t>(map.columns) * map.rows, ZoneMap::outside);
  const PolygonMm outline = floor.shell.outline_mm.value_or(
      polygon_of(RectMm{0, 0, floor.shell.width_mm, floor.shell.depth_mm}));
  Polygon polygon;
  for (const PointMm& p : outline)
    polygon.push_back({double(p[0]), double(p[1])});
  const Affine back = rotated(turned);
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const Vec2 at{std::min((column + 0.5) * cell_mm, floor.shell.width_mm - 1.0),
                    std::min((row + 0.5) * cell_mm, floor.shell.depth_mm - 1.0)};
      if (!contains(polygon, at)) continue;
      const Vec2 px = (back * (at + corner)) * (1 / mm_per_px);
      const int x = std::clamp(static_cast<int>(px.x), 0, segments.label.cols - 1);
      const int y = std::clamp(static_cast<int>(rows_px - px.y), 0, segments.label.rows - 1);
      const int part = segments.label.at<int>(y, x);
      map.zone[static_cast<std::size_t>(row) * map.columns + column] =
          static_cast<std::int16_t>(part < 0 ? ZoneMap::bare : zone_of[part]);
    }
  }
  return map;
}

Polygon in_picture(const Found& found, double rows_px) {
  Polygon polygon;
  for (const Vec2& p : found.outline)
    polygon.push_back({p.x, rows_px - p.y});
  return polygon;
}

cv::Mat mask_of(const Found& found, const cv::Mat& bgr) {
  std::vector<cv::Point> corners;
  for (const Vec2& p : in_picture(found, bgr.rows))
    corners.emplace_back(cvRound(p.x), cvRound(p.y));
  cv::Mat mask = cv::Mat::zeros(bgr.size(), CV_8UC1);
  cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{corners}, 255);
  return mask;
}

Error no_zones(const std::string& where) {
  return {"drawing.no_zones",
          where,
          "nothing within the outline tells one part of the floor from another; colour or hatch "
          "the zones, or draw lines between them"};
}

// Zones are what has colour, lines around it, or a name.
std::vector<int> kept_zones(std::vector<DrawnZone>& zones, const Segments& segments) {
  std::vector<int> zone_of(zones.size(), ZoneMap::bare);
  std::vector<DrawnZone> kept;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    if (segments.parts[i].bare && zones[i].words.empty()) continue;
    zone_of[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(zones[i]));
  }
  zones = std::move(kept);
  return zone_of;
}

void add_areas(ZoneDrawing& drawing) {
  for (const std::int16_t i : drawing.map.zone)
    if (i >= 0) drawing.zones[i].area_m2 += cell_mm * cell_mm * 1e-6;
}

// How far the longest wall is off the nearer of the picture's sides, as the picture has it, y down.
double angle_of_walls(const Found& found) {
  Vec2 longest{1, 0};
  double most = 0;
  for (std::size_t i = 0; i < found.outline.size(); ++i) {
    const Vec2 way = found.outline[(i + 1) % found.outline.size()] - found.outline[i];
    const double length = std::hypot(way.x, way.y);
    if (length > most) longest = way;
    most = std::max(most, length);
  }
  const double angle = std::atan2(-longest.y, longest.x), right = std::numbers::pi / 2;
  return angle - std::round(angle / right) * right;
}

// Zones and words are read as if there were none.
ZonePicture without_shelves(ZonePicture picture, const std::vector<ShelfStroke>& shelves) {
  const cv::Mat places = places_of(shelves, picture.bgr.size());
  picture.bgr = without_places(picture.bgr, places);
  picture.ink &= ~places;
  return picture;
}

Result<ZoneDrawing> drawing_of(ZonePicture picture,
                               const std::string& where,
                               const ReadOptions& options) {
  MARKETGEN_TRY(Found found, found_in(picture, where));
  ZoneDrawing drawing;
  const cv::Mat floor = mask_of(found, picture.bgr);
  const double walls_turned = angle_of_walls(found);
  const std::vector<ShelfStroke> shelves =
      shelf_strokes(picture.bgr, floor, picture.longer_side, walls_turned);
  picture = without_shelves(std::move(picture), shelves);
  const Segments segments = segments_of(picture.bgr, picture.ink, floor, picture.longer_side);
  if (segments.parts.size() < 2) return no_zones(where);
  const bool black_hatching = segments.hatched && !segments.coloured;
  cv::Mat letters =
      letter_ink(picture.bgr, picture.longer_side, segments.hatched && segments.coloured);
  if (black_hatching) letters = letters_on_hatching(letters, picture.longer_side);
  const std::vector<cv::Rect> boxes =
      lines_of_writing(letters, borders_of(segments), picture.longer_side);
  std::vector<WrittenLine> lines;
  if (auto read = read_lines(picture.bgr, letters, boxes, picture.longer_side); read.ok())
    lines = std::move(*read);
  else
    drawing.warnings.push_back(to_string(read.error()));
  const bool frame = picture.rectangle && picture.gaps.empty();
  if (frame && is_bar_chart(segments, picture.floor, lines)) return chart("bar chart", where);
  if (const std::string other = other_proportions(picture, options); !other.empty())
    drawing.warnings.push_back(other);
  MARKETGEN_TRY(const KnownSize size, size_of(picture, options, lines, where));
  name_openings(found, picture, lines);
  const Found in_mm = scaled_by(found, size.mm_per_px);
  const double px_mm = size.mm_per_px;
  MARKETGEN_TRY(drawing.floor, shell_of(in_mm, tolerance_at(px_mm), where));
  drawing.floor.mm_per_unit = px_mm / picture.px_of_file;
  drawing.floor.scale_from = size.from;
  drawing.scale_is_guessed = size.guessed;
  constexpr double by_pixels = 0.7;
  drawing.floor.outline_confidence = drawing.floor.openings_confidence =
      drawing.floor.columns_confidence = by_pixels;
  drawing.zones = zones_of(picture, segments, lines);
  add_legend(drawing.zones, picture, segments, lines);
  const auto runs = runs_on(segments, shelves, picture.longer_side, walls_turned);
  for (std::size_t i = 0; i < runs.size(); ++i)
    drawing.zones[i].runs = runs[i];
  const std::vector<int> zone_of = kept_zones(drawing.zones, segments);
  if (drawing.zones.empty()) return no_zones(where);
  const double turned = drawing.floor.turned_deg * std::numbers::pi / 180;
  Vec2 corner{1e18, 1e18};
  for (const Vec2& p : in_mm.outline) {
    const Vec2 q = rotated(-turned) * p;
    corner = {std::min(corner.x, q.x), std::min(corner.y, q.y)};
  }
  drawing.map = map_of(drawing.floor, segments, zone_of, corner, px_mm, picture.bgr.rows, turned);
  add_areas(drawing);
  return drawing;
}

}  // namespace

Result<ZoneDrawing> read_zone_drawing_bytes(std::string_view bytes,
                                            const std::string& where,
                                            const ReadOptions& options) {
  const double aspect =
      options.width_mm > 0 && options.depth_mm > 0 ? options.width_mm / options.depth_mm : 0;
  MARKETGEN_TRY(ZonePicture picture, zone_picture(bytes, where, aspect));
  try {
    return drawing_of(std::move(picture), where, options);
  } catch (const cv::Exception& fault) {
    return Error{
        "drawing.bad_file", where, std::string("the picture cannot be looked at: ") + fault.what()};
  }
}

Result<ZoneDrawing> read_zone_drawing(const std::filesystem::path& path,
                                      const ReadOptions& options) {
  MARKETGEN_TRY(const std::string bytes, io::read_file(path, max_drawing_bytes));
  return read_zone_drawing_bytes(bytes, path.string(), options);
}

}  // namespace marketgen::drawing
