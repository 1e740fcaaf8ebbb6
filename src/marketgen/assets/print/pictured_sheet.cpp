// The label sheet of a pack that shows photographs: see assets/print/pack_pictures.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include "assets/print/label_sheet.h"
#include "assets/print/pack_pictures.h"
#include "assets/print/paint_color.h"
#include "assets/shapes/pack_shape.h"
#include "catalog/own_faces.h"
#include "geometry/area_filter.h"

namespace marketgen::assets {
namespace {

// A side as a person sees it who stands before it: which way its picture runs to the right and
// down, and which way the side faces. Product frame.
struct SideView {
  PanelKind kind, opposite;
  Vec3 right, down, outward;
};
constexpr SideView side_views[] = {
    {PanelKind::front, PanelKind::back, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {PanelKind::back, PanelKind::front, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
    {PanelKind::left, PanelKind::right, {0, -1, 0}, {0, 0, -1}, {-1, 0, 0}},
    {PanelKind::right, PanelKind::left, {0, 1, 0}, {0, 0, -1}, {1, 0, 0}},
    {PanelKind::top, PanelKind::bottom, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
    {PanelKind::bottom, PanelKind::top, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
};

const SideView* view_of(PanelKind kind) {
  const auto* found = std::ranges::find(side_views, kind, &SideView::kind);
  return found == std::end(side_views) ? nullptr : found;
}

// A triangle on the sheet: positions as they follow from a place in sheet pixels.
struct SheetTriangle {
  std::array<Vec2, 3> px;
  Vec3 position, position_x, position_y;  // at (0, 0), and a pixel to the right and down

  Vec3 position_at(double x, double y) const { return position + position_x * x + position_y * y; }
};

double cross_of(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

// Nothing for a triangle that has no room on the sheet.
std::optional<SheetTriangle> sheet_triangle(const Mesh& mesh, std::size_t t, const Image& sheet) {
  SheetTriangle triangle;
  std::array<Vec3, 3> positions;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t vertex = mesh.triangles[t][i];
    const Vec2f uv = mesh.uvs[vertex];
    triangle.px[i] = {static_cast<double>(uv.x) * sheet.width,
                      static_cast<double>(uv.y) * sheet.height};
    positions[i] = to_double(mesh.positions[vertex]);
  }
  constexpr double min_px2 = 1e-9;
  const Vec2 a = triangle.px[1] - triangle.px[0], b = triangle.px[2] - triangle.px[0];
  const double area = cross_of(a, b);  // twice, signed
  if (std::abs(area) < min_px2) return std::nullopt;
  const Vec3 p = positions[1] - positions[0], q = positions[2] - positions[0];
  triangle.position_x = (p * b.y - q * a.y) / area;
  triangle.position_y = (q * a.x - p * b.x) / area;
  triangle.position = positions[0] - triangle.position_x * triangle.px[0].x -
                      triangle.position_y * triangle.px[0].y;
  return triangle;
}

// Whether the pixel's middle lies in the triangle or on its edge.
bool covers(const SheetTriangle& triangle, Vec2 middle) {
  constexpr double edge_px2 = 1e-6;  // neighbours share what lies on their edge
  double low = 0, high = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 from = triangle.px[i], to = triangle.px[(i + 1) % 3];
    const double side = cross_of(to - from, middle - from);
    low = std::min(low, side);
    high = std::max(high, side);
  }
  return low >= -edge_px2 || high <= edge_px2;
}

class PicturedSheet {
 public:
  static Result<PicturedSheet> begin(const catalog::Product& product, int width, int height) {
    MARKETGEN_TRY(const Color ground, parse_color(product.label.primary, product.sku));
    MARKETGEN_TRY(std::vector<Panel> panels, panels_of(product));
    PicturedSheet sheet(product, Image(width, height), std::move(panels));
    for (std::size_t i = 0; i < sheet.image_.pixels.size(); i += 3)
      put(&sheet.image_.pixels[i], to_rgb8(ground));
    for (const catalog::FaceSlot& slot : catalog::face_slots) {
      const catalog::KeptName name = catalog::face_name(product, slot);
      if (name.name.empty()) continue;
      MARKETGEN_TRY(sheet.given_[slot.name], catalog::kept_face(name));
    }
    return sheet;
  }

  Result<Image> draw() {
    for (const Panel& panel : panels_)
      lay_flat(panel);
    MARKETGEN_TRY(const ProductModel model, make_pack_shape(product_));
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
      if (model.surfaces[model.mesh.surfaces[t]].texture != "label") continue;
      if (const auto triangle = sheet_triangle(model.mesh, t, image_)) throw_onto(*triangle);
    }
    return std::move(image_);
  }

 private:
  PicturedSheet(const catalog::Product& product, Image image, std::vector<Panel> panels)
      : product_(product), image_(std::move(image)), panels_(std::move(panels)) {}

  static void put(std::uint8_t* pixel, Rgb8 color) {
    pixel[0] = color.r;
    pixel[1] = color.g;
    pixel[2] = color.b;
  }

  const Image* given(std::string_view side) const {
    const auto found = given_.find(side);
    return found == given_.end() ? nullptr : &found->second;
  }
  // What is seen of that side: null for the ground colour.
  const Image* seen(const SideView& view) const {
    const Image* own = given(name_of(view.kind));
    return own != nullptr ? own : given(name_of(view.opposite));
  }

  PixelBox pixels_of(const Panel& panel) const {
    const auto whole = [](float share, int length) {
      return std::round(static_cast<double>(share) * length);
    };
    return {whole(panel.u0, image_.width),
            whole(panel.v0, image_.height),
            whole(panel.u1, image_.width),
            whole(panel.v1, image_.height)};
  }

  // The whole picture over its panel: all of an unrolled label, and of a side what no part of the
  // pack lies behind.
  void lay_flat(const Panel& panel) {
    const SideView* view = view_of(panel.kind);
    const Image* picture = view == nullptr ? given("wrap") : seen(*view);
    if (picture == nullptr) return;
    const PixelBox box = pixels_of(panel);
    const int x0 = static_cast<int>(box.x0), y0 = static_cast<int>(box.y0);
    const Image scaled =
        area_scaled(*picture, static_cast<int>(box.x1) - x0, static_cast<int>(box.y1) - y0);
    for (int y = 0; y < scaled.height && y0 + y < image_.height; ++y) {
      for (int x = 0; x < scaled.width && x0 + x < image_.width; ++x)
        std::copy_n(scaled.at(x, y), 3, image_.at(x0 + x, y0 + y));
    }
  }

  const Panel* panel_under(const SheetTriangle& triangle) const {
    const Vec2 middle = (triangle.px[0] + triangle.px[1] + triangle.px[2]) * (1.0 / 3);
    const double u = middle.x / image_.width, v = middle.y / image_.height;
    for (const Panel& panel : panels_) {
      if (u >= panel.u0 && u <= panel.u1 && v >= panel.v0 && v <= panel.v1) return &panel;
    }
    return nullptr;
  }

  // The side that a point of a band has its colour from: the one that it lies nearest to, in shares
  // of the pack's width and depth.
  const SideView& faced(Vec3 position) const {
    const bool four = given("left") != nullptr || given("right") != nullptr;
    const Vec3 share{position.x / product_.width_m(), position.y / product_.depth_m(), 0};
    const SideView* best = &side_views[0];
    for (const SideView& view : std::span(side_views).first(four ? 4 : 2)) {
      if (dot(share, view.outward) > dot(share, best->outward)) best = &view;
    }
    return *best;
  }

  // Colours every pixel of the triangle by what lies before it, straight from its side.
  void throw_onto(const SheetTriangle& triangle) {
    const Panel* panel = panel_under(triangle);
    if (panel == nullptr) return;
    const SideView* flat = view_of(panel->kind);
    if (flat == nullptr && given("wrap") != nullptr) return;
    const auto reach = [&](double Vec2::*axis, int length) {
      const auto [low, high] =
          std::minmax({triangle.px[0].*axis, triangle.px[1].*axis, triangle.px[2].*axis});
      return std::array<int, 2>{std::max(0, static_cast<int>(std::floor(low - 0.5))),
                                std::min(length, static_cast<int>(std::ceil(high + 0.5)))};
    };
    const auto [x0, x1] = reach(&Vec2::x, image_.width);
    const auto [y0, y1] = reach(&Vec2::y, image_.height);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const Vec2 middle{x + 0.5, y + 0.5};
        if (!covers(triangle, middle)) continue;
        const SideView& view =
            flat != nullptr ? *flat : faced(triangle.position_at(middle.x, middle.y));
        if (const Image* picture = seen(view))
          put(image_.at(x, y), area_mean(*picture, footprint(triangle, middle, view, *picture)));
      }
    }
  }

  // Which part of the picture a pixel of the sheet shows.
  PixelBox footprint(const SheetTriangle& triangle,
                     Vec2 middle,
                     const SideView& view,
                     const Image& picture) const {
    const Vec3 size{product_.width_m(), product_.depth_m(), product_.height_m()};
    const Vec3 from_centre =
        triangle.position_at(middle.x, middle.y) - Vec3{0, 0, product_.height_m() / 2};
    const auto along = [&](Vec3 axis, int length) {
      const double per_m = length / std::abs(dot(size, axis));
      const double at = length * 0.5 + dot(from_centre, axis) * per_m;
      const double half =
          (std::abs(dot(triangle.position_x, axis)) + std::abs(dot(triangle.position_y, axis))) *
          per_m / 2;
      return std::array<double, 2>{at - half, at + half};
    };
    const auto [x0, x1] = along(view.right, picture.width);
    const auto [y0, y1] = along(view.down, picture.height);
    return {x0, y0, x1, y1};
  }

  const catalog::Product& product_;
  Image image_;
  std::vector<Panel> panels_;
  std::map<std::string_view, Image> given_;  // by the names of face_slots
};

}  // namespace

Result<Image> pictured_sheet(const catalog::Product& product, int width_px, int height_px) {
  MARKETGEN_CHECK(check_faces(product));
  MARKETGEN_TRY(PicturedSheet sheet, PicturedSheet::begin(product, width_px, height_px));
  return sheet.draw();
}

}  // namespace marketgen::assets
