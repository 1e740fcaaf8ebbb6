// The shape of a product, made from its row: a closed mesh with UVs for its label, and a convex
// primitive for contact.
//
// Product frame: origin at the middle of the footprint, on the surface it stands on; Z up; the
// front (label) faces -Y.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/product.h"
#include "geometry/mesh.h"

namespace marketgen::assets {

enum class SurfaceKind { opaque, glass, emissive };
constexpr std::array<std::string_view, 3> names_of(SurfaceKind) {
  return {"opaque", "glass", "emissive"};
}

// What a triangle looks like. Colours are linear RGB 0..1. The wall of a clear pack and what stands
// behind it are one surface: `color` is what both look like from afar, `refraction` a clear
// liquid's index.
struct Surface {
  Vec3f color{0.8F, 0.8F, 0.8F};
  float roughness = 0.5F;
  float metallic = 0.0F;
  SurfaceKind kind = SurfaceKind::opaque;
  std::string texture =
      {};  // "" none, "label" the product's label image, "contents" its pieces behind a wall
           // (assets/contents.h), otherwise a material id; the last two are tiled by UV
  float refraction = 0;  // 0: not clear
  float fill = 0;        // of a wall that shows contents: share of its height below their level
  bool empty = false;    // a clear wall above that level
};

enum class CollisionShape { box, cylinder, ellipsoid };
constexpr std::array<std::string_view, 3> names_of(CollisionShape) {
  return {"box", "cylinder", "ellipsoid"};
}

// Centred at `center` in the product frame; axes along the frame's (cylinder: Z, or X for lying
// goods).
struct CollisionPrimitive {
  CollisionShape shape = CollisionShape::box;
  Vec3f center;
  Vec3f half_size;  // box and ellipsoid: half extents; cylinder: radius, radius, half length along
                    // its axis
  bool lying = false;  // cylinder along X
};

// A convex piece of a pack's contact shape. `hull`: the convex hull of `points`; otherwise a
// primitive, see CollisionPrimitive.
enum class PieceShape { box, cylinder, ellipsoid, hull };
constexpr std::array<std::string_view, 4> names_of(PieceShape) {
  return {"box", "cylinder", "ellipsoid", "hull"};
}
struct ContactPiece {
  PieceShape shape = PieceShape::box;
  Vec3f center, half_size;
  bool lying = false;              // cylinder along X
  std::vector<Vec3f> points = {};  // hull only, product frame
};

// A part of a pack that a hand may use or must mind: where it is and how large, product frame.
enum class FeatureKind { cap, lid, neck, tab, handle, seam, trigger, pump, rim, hang_hole, stem };
constexpr std::array<std::string_view, 11> names_of(FeatureKind) {
  return {
      "cap", "lid", "neck", "tab", "handle", "seam", "trigger", "pump", "rim", "hang_hole", "stem"};
}
struct PackFeature {
  FeatureKind kind = FeatureKind::cap;
  Vec3f center, half_size;  // its box: what fingers close on is twice the smaller half size
};

// How many triangles a mesh may take: a pack in the hand, on the shelf, across the aisle.
enum class Detail { near, middle, far };
constexpr std::array<std::string_view, 3> names_of(Detail) {
  return {"near", "middle", "far"};
}

struct ProductModel {
  Mesh mesh;  // surfaces index `surfaces`
  std::vector<Surface> surfaces;
  CollisionPrimitive collision;            // encloses the pack: spacing on shelves, audits
  std::vector<PackFeature> features = {};  // as the archetype states them, see PackBuilder
  float level_m = 0;  // of the contents, where the clear walls are parted; 0: none are seen
};

// What the physics needs of a pack. The pieces together have the mesh's volume within 5 % (15 % for
// produce); `center_of_mass` is that of the filled pack.
struct ProductBody {
  std::vector<ContactPiece> pieces;
  Vec3f center_of_mass;
  std::array<float, 6> inertia_kg_m2{};  // about it, product axes: xx yy zz xy xz yz
  std::vector<PackFeature> features;
};

// The sizes of the mesh's bounds are the row's sizes within 1 mm. Errors: assets.bad_row,
// catalog.unknown_kind (archetype).
Result<ProductModel> make_product_model(const catalog::Product& product,
                                        Detail detail = Detail::near);

// Errors: as make_product_model.
Result<ProductBody> make_product_body(const catalog::Product& product);
// The same, made once in a process for each row (30 to 100 ms). Thread-safe.
Result<std::shared_ptr<const ProductBody>> product_body(const catalog::Product& product);

// The contact primitive alone: cheap, for physics and audit of whole stores.
Result<CollisionPrimitive> collision_of(const catalog::Product& product);

struct ArchetypeInfo {
  std::string_view name, description;
};
std::vector<ArchetypeInfo> archetypes();  // in the order of archetypes.inc

}  // namespace marketgen::assets
