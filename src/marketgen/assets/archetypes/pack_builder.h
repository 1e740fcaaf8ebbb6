// The workbench on which archetypes build: collects triangles, then makes them one smooth mesh of
// the row's exact size.
#pragma once
#include <functional>
#include <vector>

#include "assets/label_sheet.h"
#include "assets/product_model.h"

namespace marketgen {

struct Corner {
  Vec3f position;
  Vec2f uv;
};

class PackBuilder {
 public:
  PackBuilder(const Product& product, std::vector<Panel> panels);

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
};

// A builder for the product with its sheet's panels. Errors: those of panels_of.
Result<PackBuilder> start_pack(const Product& product);

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

}  // namespace marketgen
