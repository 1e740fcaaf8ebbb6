#include <map>

#include "export/price_prints.h"
#include "export/usd_layers.h"
#include "scene/placements.h"

namespace marketgen::exporters {
namespace {

constexpr const char* placed_group = "placed";  // of items that a plan put to an exact place

// By fixture; -1: in no block of a shelf.
std::map<int, std::vector<std::uint32_t>> rows_by_fixture(const scene::Scene& scene) {
  std::map<int, std::vector<std::uint32_t>> rows;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    const std::uint32_t facing = scene.products[row].facing;
    rows[facing == scene::no_facing
             ? -1
             : static_cast<int>(scene.shelves[scene.facings[facing].shelf].fixture)]
        .push_back(row);
  }
  return rows;
}

class GoodsWriter {
 public:
  explicit GoodsWriter(UsdParts& parts) : parts_(parts) {}

  Result<std::string> write() {
    const scene::Scene& scene = parts_.scene;
    out_.append(usd_head("Shop"));
    out_.open("over \"Shop\"");
    out_.open("def Xform \"goods\"", {"kind = \"group\""});
    UsdNames groups;
    for (const auto& [fixture, rows] : rows_by_fixture(scene)) {
      const std::string id =
          fixture < 0 ? "" : scene.layout.fixtures[static_cast<std::size_t>(fixture)].id;
      write_group(groups.of(id.empty() ? placed_group : id), id, rows);
    }
    out_.close();
    MARKETGEN_CHECK(write_prints());
    out_.close();
    return out_.take();
  }

 private:
  void write_group(const std::string& group,
                   const std::string& fixture,
                   const std::vector<std::uint32_t>& rows) {
    UsdNames names;
    std::vector<std::pair<std::string, std::uint32_t>> hooks;
    out_.open(fmt::format("def Xform \"{}\"", group), {"kind = \"group\""});
    for (const std::uint32_t row : rows) {
      const std::string id = scene::product_id(parts_.scene, row);
      const bool inside = !fixture.empty() && id.starts_with(fixture + "/");
      const std::string name = names.of(inside ? id.substr(fixture.size() + 1) : id);
      write_item(row, name, id);
      if (hangs_free(row)) hooks.emplace_back(name, row);
    }
    for (const auto& [name, row] : hooks)
      write_hook(names.of("hook/" + name), fmt::format("/Shop/goods/{}/{}", group, name), row);
    out_.close();
  }

  void write_item(std::uint32_t row, const std::string& name, const std::string& id) {
    const scene::SceneProduct& item = parts_.scene.products[row];
    const Pose pose = scene::world_from_product(item);
    // Most of a store's text: on as few lines as its grammar allows, and not indented inside.
    out_.line(
        "def \"{}\" (displayName = {}; instanceable = true; "
        "prepend references = @./products.usda@</Products/{}>{})",
        name,
        usd_quoted(id),
        usd_identifier(parts_.scene.catalog[item.sku].sku),
        parts_.free[row] ? "; variants = { string physics = \"free\" }" : "");
    out_.append(fmt::format("{{\nquatd xformOp:orient = {}\ndouble3 xformOp:translate = {}\n}}\n",
                            usd_orient(pose.rotation),
                            usd_vector(pose.position)));
  }

  bool hangs_free(std::uint32_t row) const {
    return parts_.free[row] && hangs_on_peg(parts_.scene, row);
  }

  // Free goods on pegs hang from the middle of their upper edge; a robot takes one by switching the
  // joint off.
  void write_hook(const std::string& name, const std::string& item, std::uint32_t row) {
    const scene::SceneProduct& product = parts_.scene.products[row];
    const Vec3 edge{0, 0, parts_.scene.catalog[product.sku].height_m()};
    const Pose pose = scene::world_from_product(product);
    out_.open(fmt::format("def PhysicsSphericalJoint \"{}\"", name));
    out_.line("rel physics:body1 = <{}>", item);
    out_.line("point3f physics:localPos0 = {}", usd_vector(pose * edge));
    out_.line("point3f physics:localPos1 = {}", usd_vector(edge));
    out_.line("quatf physics:localRot0 = {}", usd_quaternion(pose.rotation));
    out_.line("quatf physics:localRot1 = (1, 0, 0, 0)");
    out_.close();
  }

  // All prints of one design are one mesh.
  Result<void> write_prints() {
    MARKETGEN_TRY(const PricePrints prints, price_prints(parts_.scene));
    constexpr std::string_view path = "/Shop/price_labels";
    std::vector<std::string> files;
    for (std::size_t i = 0; i < prints.pictures.size(); ++i)
      files.push_back(parts_.pictures.add(fmt::format("price_{}", i), ".png", prints.pictures[i]));
    UsdLooks looks(parts_.pictures);
    UsdNames names;
    out_.open("def Xform \"price_labels\"", {"kind = \"group\""});
    for (const auto* list : {&prints.tags, &prints.cards}) {
      for (const PricePrint& print : *list) {
        const int look =
            looks.add({.color = {1, 1, 1}, .roughness = print_roughness, .texture = ""},
                      files[print.picture]);
        const UsdShape shape = parts_.geometry.add("print", usd_meshes(mesh_of_all(print), {true}));
        out_.open(fmt::format("def Xform \"{}\"", names.of(print.name)),
                  {"prepend references = " + shape.reference});
        UsdLooks::write_bindings(out_, path, shape, {look});
        out_.close();
      }
    }
    looks.write(out_, path);
    out_.close();
    return {};
  }

  UsdParts& parts_;
  UsdText out_;
};

}  // namespace

Result<std::string> usd_goods(UsdParts& parts) {
  return GoodsWriter(parts).write();
}

}  // namespace marketgen::exporters
