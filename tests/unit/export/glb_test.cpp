// What outside readers make of a GLB: tinygltf, and the Khronos validator where Node is installed.
#include <gtest/gtest.h>
#include <tiny_gltf.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "export/export.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

class Glb : public testing::Test {
 protected:
  Glb() { made_.stock(); }
  ~Glb() override { fs::remove(file_); }

  tinygltf::Model exported(const exporters::ExportOptions& options = {}) {
    const Result<void> written = exporters::export_scene(made_.scene, "glb", file_, options);
    EXPECT_TRUE(written.ok()) << (written.ok() ? "" : to_string(written.error()));
    tinygltf::Model model;
    std::string fault, warning;
    EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &fault, &warning, file_.string()))
        << fault;
    return model;
  }

  HandMadeScene made_;
  fs::path file_ =
      fs::temp_directory_path() / ("marketgen-glb-test-" + std::to_string(getpid()) + ".glb");
};

TEST_F(Glb, InstancedOneNodePerSkuIsDrawnAtEveryItemsPlace) {
  exporters::ExportOptions options;
  options.instanced = true;
  const tinygltf::Model model = exported(options);
  EXPECT_EQ(model.extensionsRequired, std::vector<std::string>{"EXT_mesh_gpu_instancing"});
  EXPECT_TRUE(exporters::check_export(made_.scene, "glb", file_, options).ok());
  int instanced = 0;
  for (const tinygltf::Node& node : model.nodes) {
    if (node.name != "can-cola") continue;
    ++instanced;
    ASSERT_TRUE(node.extensions.contains("EXT_mesh_gpu_instancing"));
    EXPECT_EQ(node.extras.Get("ids").ArrayLen(), 5U);
    EXPECT_EQ(node.extras.Get("ids").Get(0).Get<std::string>(),
              "dry/run-1/module-1/level-0/facing-0/item-0");
  }
  EXPECT_EQ(instanced, 1);
}

TEST_F(Glb, RootTurnsZUpIntoYUp) {
  const tinygltf::Model model = exported();
  const tinygltf::Node& root = model.nodes[static_cast<std::size_t>(model.scenes[0].nodes.at(0))];
  ASSERT_EQ(root.rotation.size(), 4U);  // x, y, z, w: minus 90 degrees about X
  EXPECT_NEAR(root.rotation[0], -0.70710678, 1e-7);
  EXPECT_NEAR(root.rotation[3], 0.70710678, 1e-7);
  EXPECT_EQ(root.rotation[1], 0);
}

TEST_F(Glb, LabelsAreEmbeddedPictures) {
  const tinygltf::Model model = exported();
  ASSERT_GE(model.images.size(), 4U);  // two labels, two price tags, perhaps materials
  for (const tinygltf::Image& image : model.images) {
    EXPECT_GE(image.height, 64);
    EXPECT_EQ(image.mimeType, "image/png");
  }
}

// Gives the room a floor of tiles, so that a tiled material is in the file.
void lay_tiles(scene::Scene& scene) {
  catalog::MaterialRow tiles;
  tiles.id = scene.layout.look.floor = "tile-test";
  tiles.pattern = catalog::MaterialPattern::tiles;
  tiles.roughness = 0.3;
  scene.materials.push_back(tiles);
}

TEST_F(Glb, TiledMaterialsHaveReliefAndGloss) {
  lay_tiles(made_.scene);
  const tinygltf::Model model = exported();
  const auto side = [&](int texture) {
    const auto source = model.textures[static_cast<std::size_t>(texture)].source;
    return model.images[static_cast<std::size_t>(source)].width;
  };
  int found = 0;
  for (const tinygltf::Material& material : model.materials) {
    if (material.name != "tile-test") continue;
    ++found;
    const auto& pbr = material.pbrMetallicRoughness;
    ASSERT_GE(pbr.baseColorTexture.index, 0);
    ASSERT_GE(pbr.metallicRoughnessTexture.index, 0);
    ASSERT_GE(material.normalTexture.index, 0);
    EXPECT_EQ(side(pbr.baseColorTexture.index), 512);
    EXPECT_EQ(side(pbr.metallicRoughnessTexture.index), 256);
    EXPECT_EQ(side(material.normalTexture.index), 256);
    EXPECT_EQ(pbr.roughnessFactor, 1);  // the texture says it all
    EXPECT_EQ(pbr.metallicFactor, 1);
  }
  EXPECT_EQ(found, 1);
}

// A clear material has values beside its textures: all of them are in the file.
TEST_F(Glb, AFloorOfGlassIsSeenThrough) {
  lay_tiles(made_.scene);
  made_.scene.materials.back().transmission = 0.75;
  const tinygltf::Model model = exported();
  int found = 0;
  for (const tinygltf::Material& material : model.materials) {
    if (material.name != "tile-test") continue;
    ++found;
    EXPECT_EQ(material.alphaMode, "BLEND");
    EXPECT_EQ(material.pbrMetallicRoughness.baseColorFactor.at(3), 0.25);
    EXPECT_GE(material.pbrMetallicRoughness.baseColorTexture.index, 0);
    EXPECT_GE(material.normalTexture.index, 0);
  }
  EXPECT_EQ(found, 1);
}

// What a viewer that knows no extension shows is the whole store.
TEST_F(Glb, ByDefaultEveryItemIsANodeAndNoExtensionIsNeeded) {
  const tinygltf::Model model = exported();
  EXPECT_TRUE(model.extensionsRequired.empty());
  EXPECT_TRUE(model.extensionsUsed.empty());
  std::set<std::string> names;
  std::set<int> meshes;
  for (const tinygltf::Node& node : model.nodes) {
    if (!node.extras.Has("sku")) continue;
    EXPECT_TRUE(names.insert(node.name).second) << node.name;
    if (node.extras.Get("sku").Get<std::string>() == "can-cola") meshes.insert(node.mesh);
  }
  EXPECT_EQ(names.size(), made_.scene.products.size());
  EXPECT_EQ(meshes.size(), 1U);  // five cans share it
  EXPECT_TRUE(exporters::check_export(made_.scene, "glb", file_).ok());
}

// The same prints at the same places, whether instanced or merged into one mesh.
TEST_F(Glb, PrintsOfOneDesignAreOneNode) {
  const scene::PriceLabel first = made_.scene.price_labels.front();
  for (int i = 1; i <= 3; ++i) {
    made_.scene.price_labels.push_back(first);
    made_.scene.price_labels.back().x_m += 0.1F * static_cast<float>(i);
  }
  const std::string name = "price/" + made_.scene.catalog[first.sku].sku;
  const auto corners_of = [&](const tinygltf::Model& model) {
    const auto node = std::ranges::find(model.nodes, name, &tinygltf::Node::name);
    const auto& mesh = model.meshes[static_cast<std::size_t>(node->mesh)];
    const int positions = mesh.primitives[0].attributes.at("POSITION");
    return model.accessors[static_cast<std::size_t>(positions)].count;
  };
  EXPECT_EQ(corners_of(exported()), 16U);
  exporters::ExportOptions instanced;
  instanced.instanced = true;
  EXPECT_EQ(corners_of(exported(instanced)), 4U);
  EXPECT_TRUE(exporters::check_export(made_.scene, "glb", file_, instanced).ok());
}

TEST_F(Glb, PassesTheKhronosValidator) {
  const std::string tool = MARKETGEN_SOURCE_DIR "/tools/node/validate_glb.mjs";
  if (!fs::exists(MARKETGEN_SOURCE_DIR "/tools/node/node_modules/gltf-validator"))
    GTEST_SKIP() << "run tools/setup test";
  lay_tiles(made_.scene);
  for (const bool instanced : {false, true}) {
    exporters::ExportOptions options;
    options.instanced = instanced;
    exported(options);
    EXPECT_EQ(std::system(("node " + tool + " " + file_.string()).c_str()), 0);
  }
}

}  // namespace
}  // namespace marketgen
