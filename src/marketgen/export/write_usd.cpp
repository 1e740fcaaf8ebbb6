#include "export/licences.h"
#include "export/usd_layers.h"

// The root layer names the four others, of room, fixtures, goods and lights; these refer to the
// libraries of modules and products, and those to the meshes.
namespace marketgen::exporters {
namespace {

std::string root_layer(const scene::Scene& scene, const std::string& beside) {
  UsdText out;
  std::vector<std::string> layers;
  for (const char* layer : {"lights", "goods", "fixtures", "room"})
    layers.push_back(fmt::format("./{}/{}.usda", beside, layer));
  out.append(usd_head("Shop", layers));
  out.open("def Xform \"Shop\"",
           {fmt::format("displayName = {}", usd_quoted(scene.layout.name)), "kind = \"assembly\""});
  out.open("def PhysicsScene \"physics\"");
  out.line("vector3f physics:gravityDirection = (0, 0, -1)");
  out.line("float physics:gravityMagnitude = 9.81");
  out.close();
  out.close();
  return out.take();
}

}  // namespace

Result<ExportFiles> write_usd(const scene::Scene& scene, const ExportOptions& options) {
  UsdParts parts{scene, options, products_in_free_region(scene, options), {}};
  ExportFiles files;
  const auto add = [&](const char* layer, std::string text) {
    files.beside.push_back({std::string(layer) + ".usda", std::move(text)});
  };
  MARKETGEN_TRY(std::string room, usd_room(parts));
  add("room", std::move(room));
  MARKETGEN_TRY(UsdFixtures fixtures, usd_fixtures(parts));
  add("modules", std::move(fixtures.modules));
  add("fixtures", std::move(fixtures.fixtures));
  MARKETGEN_TRY(std::string products, usd_products(parts));
  add("products", std::move(products));
  MARKETGEN_TRY(std::string goods, usd_goods(parts));
  add("goods", std::move(goods));
  add("lights", usd_lights(scene));
  files.beside.push_back({usd_geometry_file, parts.geometry.finish()});
  MARKETGEN_TRY(std::vector<BesideFile> pictures, parts.pictures.take());
  for (BesideFile& picture : pictures)
    files.beside.push_back(std::move(picture));
  files.beside.push_back(licences_file(scene));
  files.main = root_layer(scene, options.beside);
  return files;
}

}  // namespace marketgen::exporters
