// The workbench on which archetypes build: collects triangles, then makes them one smooth mesh of
// the row's exact size.
#pragma once
#include <functional>
#include <vector>

#include "assets/print/label_sheet.h"
#include "assets/product_model.h"

namespace marketgen::assets {

struct Corner {
  Vec3f position;
  Vec2f uv;
};

enum class PackAxis { x, y, z };

class PackBuilder {
 public:
  PackBuilder(const catalog::Product& product, std::vector<Panel> panels);

  std::uint16_t add_surface(Surface surface);
  // The product's printed surface; panels give its UVs.
  std::uint16_t add_print(float roughness);
  bool is_print(std::uint16_t surface) const { return surfaces_[surface].texture == "label"; }

  // The panel of that kind, or null when the sheet has none.
  const Panel* panel(PanelKind kind) const;

  // Counter-clockwise seen from outside. What has collapsed to a line is left out.
  void add_triangle(const Corner& a, const Corner& b, const Corner& c, std::uint16_t surface);
  void add_quad(
      const Corner& a, const Corner& b, const Corner& c, const Corner& d, std::uint16_t surface);

  // ---- Features: caps, necks, handles, seals… for whoever grips or opens the pack. ----
  // State them in make_<name>, after the triangles they are measured from were added; finish scales
  // them with the mesh. Product frame (before the scaling), metres.

  // Around every triangle of that surface so far: a cap or lid with a surface of its own.
  void add_surface_feature(FeatureKind kind, std::uint16_t surface);
  // Around every triangle added since `mark` (see triangle_count): a tab, a handle, a stalk.
  void add_part_feature(FeatureKind kind, std::size_t mark);
  // Around the skin so far between two heights, or two places along another axis: a neck, a rim, an
  // end seal.
  void add_band_feature(FeatureKind kind, float low_m, float high_m, PackAxis along = PackAxis::z);
  // A box said outright: what is no part of the skin alone, such as the hole of a handle.
  void add_feature(FeatureKind kind, const Bounds3& box);

  std::size_t triangle_count() const { return triangles_.size(); }

  // Scales to the row's size, shares equal vertices and smooths normals where faces meet by less
  // than the crease angle.
  ProductModel finish(float crease_cos = 0.6F) const;

  float width() const { return size_.x; }
  float depth() const { return size_.y; }
  float height() const { return size_.z; }

 private:
  Vec3f size_;
  std::vector<Panel> panels_;
  std::vector<Surface> surfaces_;
  std::vector<std::array<Corner, 3>> triangles_;
  std::vector<std::uint16_t> triangle_surfaces_;
  std::vector<PackFeature> features_;
};

// A builder for the product with its sheet's panels. Errors: those of panels_of.
Result<PackBuilder> start_pack(const catalog::Product& product);

// From a part's own coordinates into the product frame.
using Placement = std::function<Vec3f(Vec3f)>;

// The rigid placement: where the part's origin and axes lie. The default leaves it where it is.
struct PartFrame {
  Vec3f origin{};
  Vec3f x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  Vec3f operator()(Vec3f p) const { return origin + p.x * x + p.y * y + p.z * z; }
};

// (share_u, share_v) of a panel in sheet coordinates; of the whole sheet when there is no such
// panel.
Vec2f uv_in(const Panel* panel, float share_u, float share_v);

}  // namespace marketgen::assets
