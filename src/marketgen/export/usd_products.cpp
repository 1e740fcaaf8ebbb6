#include <Eigen/Dense>

#include "base/parallel.h"
#include "export/body_inertia.h"
#include "export/goods_look.h"
#include "export/usd_layers.h"
#include "export/usd_solids.h"
#include "physics/goods/goods_body.h"
#include "physics/goods/standing_goods.h"

namespace marketgen::exporters {
namespace {

UsdLabels labels_of(const catalog::Product& product) {
  return {{"class", product.subcategory}, {"category", product.category}, {"sku", product.sku}};
}

// Principal moments, and the turn from the body's axes to theirs.
struct PrincipalInertia {
  Vec3 moments;
  Quaternion axes;
};

PrincipalInertia principal(const std::array<double, 6>& inertia) {  // xx yy zz xy xz yz
  Eigen::Matrix3d matrix;
  matrix << inertia[0], inertia[3], inertia[4], inertia[3], inertia[1], inertia[5], inertia[4],
      inertia[5], inertia[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  const Eigen::Quaterniond q(axes);
  const Eigen::Vector3d& m = solver.eigenvalues();
  return {{m.x(), m.y(), m.z()}, {q.w(), q.x(), q.y(), q.z()}};
}

class ProductWriter {
 public:
  explicit ProductWriter(UsdParts& parts) : parts_(parts) {}

  Result<std::string> write() {
    MARKETGEN_CHECK(prepare());
    UsdText out;
    out.append(usd_head("Products"));
    out.open("def Xform \"Products\"", {"kind = \"group\""});
    for (std::size_t sku = 0; sku < looks_.size(); ++sku) {
      if (!meshes_[sku].empty()) MARKETGEN_CHECK(write_product(out, sku));
    }
    out.close();
    return out.take();
  }

 private:
  // What takes time, side by side.
  Result<void> prepare() {
    const scene::Scene& scene = parts_.scene;
    looks_ = goods_looks(scene, assets::Detail::middle, LabelCoding::jpeg);
    for (const GoodsLook& look : looks_) {
      if (look.error) return *look.error;
    }
    meshes_ = parallel_map(looks_.size(), [&](std::size_t sku) {
      std::vector<bool> textured;
      for (const assets::Surface& surface : looks_[sku].model.surfaces)
        textured.push_back(!surface.texture.empty());
      return usd_meshes(looks_[sku].model.mesh, textured);
    });
    free_.resize(looks_.size());
    for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
      const std::uint32_t sku = scene.products[row].sku;
      if (!parts_.free[row] || free_[sku] != nullptr) continue;
      MARKETGEN_TRY(free_[sku],
                    physics::goods_body(scene.catalog[sku], physics::GoodsUse::stocked));
    }
    return {};
  }

  Result<void> write_product(UsdText& out, std::size_t sku) {
    const catalog::Product& product = parts_.scene.catalog[sku];
    const std::string name = usd_identifier(product.sku), path = "/Products/" + name;
    MARKETGEN_TRY(const physics::StandingGoods standing, physics::standing_goods(product));
    UsdLooks looks(parts_.pictures);
    MARKETGEN_TRY(const std::vector<int> by_surface, looks_of(product, looks_[sku], looks));
    std::vector<std::string> metadata{
        "prepend apiSchemas = [" + usd_label_schemas(labels_of(product)).substr(2) + "]",
        fmt::format("assetInfo = {{ string name = {} }}", usd_quoted(product.sku)),
        fmt::format("displayName = {}", usd_quoted(product.name)),
        "kind = \"component\""};
    if (free_[sku] != nullptr) {
      metadata.emplace_back("variants = { string physics = \"still\" }");
      metadata.emplace_back("prepend variantSets = \"physics\"");
    }
    out.open(fmt::format("def Xform \"{}\"", name), metadata);
    write_usd_labels(out, labels_of(product));
    write_usd_pose(out, {});
    const UsdShape shape = parts_.geometry.add("pack", meshes_[sku]);
    out.open("def Xform \"look\"", {"prepend references = " + shape.reference});
    UsdLooks::write_bindings(out, path, shape, by_surface);
    out.close();
    looks.write(out, path, standing.contact.sliding);
    const UsdContact contact{usd_contact_material(path), standing.mass_kg};
    if (free_[sku] == nullptr)
      write_usd_collider(out, parts_.geometry, "solid", standing.shape, contact);
    else
      write_variants(out, *free_[sku], standing, contact);
    out.close();
    return {};
  }

  Result<std::vector<int>> looks_of(const catalog::Product& product,
                                    const GoodsLook& look,
                                    UsdLooks& looks) {
    const std::string label =
        look.label.empty() ? "" : parts_.pictures.add("label_" + product.sku, ".jpg", look.label);
    return add_looks(looks, product, look.model, label);
  }

  // Still goods are one solid round the pack, free ones what they are in our own physics.
  void write_variants(UsdText& out,
                      const physics::GoodsBody& goods,
                      const physics::StandingGoods& standing,
                      const UsdContact& contact) {
    const BodyInertia body = inertia_of(goods);
    const PrincipalInertia inertia = principal(body.moments_kg_m2);
    out.open("variantSet \"physics\" =");
    out.open("\"free\"", {"prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]"});
    out.line("point3f physics:centerOfMass = {}", usd_vector(body.center));
    out.line("float3 physics:diagonalInertia = {}", usd_vector(inertia.moments));
    out.line("float physics:mass = {}", static_cast<float>(standing.mass_kg));
    out.line("quatf physics:principalAxes = {}", usd_quaternion(inertia.axes));
    for (std::size_t i = 0; i < goods.body.pieces.size(); ++i)
      write_usd_collider(out,
                         parts_.geometry,
                         fmt::format("solid_{}", i),
                         goods.body.pieces[i],
                         UsdContact{contact.material});
    out.close();
    out.open("\"still\"");
    write_usd_collider(out, parts_.geometry, "solid", standing.shape, contact);
    out.close();
    out.close();
  }

  UsdParts& parts_;
  std::vector<GoodsLook> looks_;              // these three by row of the catalogue
  std::vector<std::vector<UsdMesh>> meshes_;  // none: no item of it stands in the store
  std::vector<physics::SharedGoodsBody> free_;
};

}  // namespace

Result<std::string> usd_products(UsdParts& parts) {
  return ProductWriter(parts).write();
}

}  // namespace marketgen::exporters
