#include <fmt/format.h>

#include <map>

#include "export/exporter.h"
#include "io/file.h"
#include "physics/contact_shape.h"
#include "physics/mujoco_guard.h"

// Reads an MJCF export with MuJoCo's own compiler.
namespace marketgen {
namespace {

std::string name_of_geom(const mjModel& model, int geom) {
  const char* name = mj_id2name(&model, mjOBJ_GEOM, geom);
  return name == nullptr ? "" : name;
}

Pose pose_of_geom(const mjData& data, int geom) {
  mjtNum q[4];
  mju_mat2Quat(q, data.geom_xmat + 9 * geom);
  const mjtNum* p = data.geom_xpos + 3 * geom;
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

// Of the geom's bounding box in the store frame.
void include_geom(Bounds3& bounds, const mjModel& model, const mjData& data, int geom) {
  const Pose pose = pose_of_geom(data, geom);
  const mjtNum* box = model.geom_aabb + 6 * geom;  // centre and half extents in the geom's frame
  const ContactShape around{
      CollisionShape::box, pose * Pose{{box[0], box[1], box[2]}, {}}, {box[3], box[4], box[5]}};
  const Vec3 half = half_extents(around);
  bounds.include(to_float(around.pose.position - half));
  bounds.include(to_float(around.pose.position + half));
}

// Where the product frame lies that the geom belongs to.
class ProductFrames {
 public:
  static Result<ProductFrames> of(const std::vector<Product>& catalog) {
    ProductFrames frames;
    for (const Product& product : catalog) {
      MARKETGEN_TRY(const CollisionPrimitive primitive, collision_of(product));
      frames.shape_from_product_.emplace(product.sku, inverse(contact_shape_of(primitive).pose));
    }
    return frames;
  }

  // Null for a SKU that the scene does not have.
  const Pose* shape_from_product(const std::string& sku) const {
    const auto found = shape_from_product_.find(sku);
    return found == shape_from_product_.end() ? nullptr : &found->second;
  }

 private:
  std::map<std::string, Pose> shape_from_product_;
};

// Products carry their SKU as material; fixture parts are "<fixture>/<unit>-<n>" in group 1.
ExportContents contents_of(const mjModel& model, const mjData& data, const ProductFrames& frames) {
  ExportContents contents;
  contents.meshes = static_cast<std::uint64_t>(model.ngeom);
  contents.free_bodies = 0;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_type[geom] == mjGEOM_PLANE) continue;
    const std::string name = name_of_geom(model, geom);
    const int material = model.geom_matid[geom];
    include_geom(contents.bounds, model, data, geom);
    if (material >= 0) {
      const std::string sku = mj_id2name(&model, mjOBJ_MATERIAL, material);
      const Pose* frame = frames.shape_from_product(sku);
      const Pose pose = pose_of_geom(data, geom) * (frame != nullptr ? *frame : Pose{});
      contents.products.push_back({name, sku, pose.position});
      if (model.body_jntnum[model.geom_bodyid[geom]] > 0) ++*contents.free_bodies;
    } else if (model.geom_group[geom] == 1) {
      contents.fixtures.insert(name.substr(0, name.rfind('/')));
    }
  }
  return contents;
}

}  // namespace

Result<ExportContents> read_mjcf(const std::filesystem::path& file,
                                 const std::vector<Product>& catalog) {
  MARKETGEN_TRY(const std::string text, read_file(file));
  MARKETGEN_TRY(const ProductFrames frames, ProductFrames::of(catalog));
  route_mujoco_messages();
  char fault[1000] = "";
  const MujocoSpec spec(mj_parseXMLString(text.c_str(), nullptr, fault, sizeof fault),
                        mj_deleteSpec);
  if (spec == nullptr)
    return Error{"export.mismatch", file.string(), std::string("MuJoCo cannot read it: ") + fault};
  MujocoModel model(mj_compile(spec.get(), nullptr), mj_deleteModel);
  if (model == nullptr) {
    return Error{"export.mismatch",
                 file.string(),
                 std::string("MuJoCo cannot compile it: ") + mjs_getError(spec.get())};
  }
  MARKETGEN_TRY(const MujocoData data, make_data(*model, file.string()));
  MARKETGEN_CHECK(guarded(file.string(), [&] { mj_kinematics(model.get(), data.get()); }));
  return contents_of(*model, *data, frames);
}

}  // namespace marketgen
